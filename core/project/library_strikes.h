#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/editing/hit.h"
#include "core/labelling/vocabulary.h"
#include "core/motion/motion_library.h"

namespace kumite {

/// Examples of one strike out of a library.
struct StrikeExamples {
    Striker striker = Striker::RightHand;
    std::vector<Strike> strikes;
};

/// What `--strike` may say beside the name.
struct StrikeRequest {
    std::string strike;  ///< an aspect ("right_kick", "right_kick:up") or clips, a,b,…
    std::optional<Striker> striker;  ///< the limb, where the clips do not tell the right one
    std::optional<int> player;       ///< 1 or 2: only that fighter of projects' takes
};

/// The strikes that a request means; motions that were made are no examples of a label.
/// An aspect of the vocabulary: every action whose label has it, as an attack (or with the
/// qualifier that is named); an action that goes out only ("fwd", "up") takes the next one along if
/// that brings the same limb back. Clips (as `actionNamed` knows them): the strikes in them, where
/// a clip holds several all of them. The limb is the aspect's; of clips it is the one that moves
/// fastest in most of them. Throws Error that says what there is.
StrikeExamples strikesOf(const MotionLibrary& library, const StrikeRequest& request);

/// The aspects that `strikesOf` finds examples of, in the vocabulary's order.
std::vector<std::string> strikesIn(const MotionLibrary& library, const Vocabulary& vocabulary);

/// Examples of the strike that an action is: all that are labelled with its attack; of an action
/// without such a label the strike in it alone. What a block `C@x,y,z` of a sequence blends.
StrikeExamples strikesLike(const MotionLibrary& library, const LibraryAction& action);

/// Such a block: motion on the library's rig at its rate, in the striker's frame.
struct StrikeBlock {
    LibraryMotion motion;
    HitMotion hit;  ///< what it reaches, and how
};
StrikeBlock strikeAt(const MotionLibrary& library, const LibraryAction& action,
                     const Eigen::Vector3d& target);

/// "0.1,1.4,0.7": a target in metres; nothing if it is none.
std::optional<Eigen::Vector3d> targetFrom(std::string_view text);

/// The parameter space of those strikes.
StrikeSpace strikeSpace(const StrikeExamples& examples, const StrikeSpaceSettings& settings = {},
                        const Progress& progress = {});

}  // namespace kumite
