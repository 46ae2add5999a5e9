#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/project/interaction.h"
#include "core/synthesis/bout_library.h"
#include "core/synthesis/bout_settings.h"

namespace kumite {

/// What bouts of a project are made from. Both fighters' clips stand on the skeleton of the first
/// take that has one; takes on other skeletons are left out and reported. Throws Error with the
/// sentence of whyNoModel where nothing was learnt. Cancellable.
std::shared_ptr<const BoutLibrary> boutLibrary(const Project& project, const Analysis& analysis,
                                               const Interaction& interaction,
                                               const Progress& progress = {});

/// Whether a skeleton has a rig's joints, by name and parent.
bool sameJoints(const Rig& rig, const Skeleton& skeleton);

/// A captured attack: consecutive actions of one fighter.
struct CapturedAttack {
    int attacker = 0;          ///< player
    std::vector<int> actions;  ///< of B, in order

    bool operator==(const CapturedAttack&) const = default;
};
/// Those of a fighter's labelled actions that begin in `frames` of a take. Throws Error where there
/// is none, or none that strikes.
CapturedAttack attackIn(const Interaction& interaction, int attacker, int take, FrameRange frames);
/// The ten seconds or so of all takes in which a fighter strikes most (ties: the earliest). Throws
/// Error where it never strikes.
CapturedAttack busiestAttack(const Interaction& interaction, int attacker, double seconds = 10);

/// The same, learnt as if the attack and the opponent's actions during it had not been recorded:
/// no transition touches them, and principal components do not see their frames. Actions keep their
/// numbers and the label sets are those of the whole recording. Cancellable.
Interaction interactionWithout(const Analysis& analysis, const Interaction& interaction,
                               const CapturedAttack& attack, const Progress& progress = {});
/// The actions of B, by player, that are left out then.
std::array<std::vector<char>, 2> leftOutWith(const CoupledGraph& graph,
                                             const CapturedAttack& attack);

}  // namespace kumite
