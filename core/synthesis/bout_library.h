#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/shared_value.h"
#include "core/interaction/bout_numbers.h"
#include "core/motion/contacts.h"
#include "core/motion/pose.h"
#include "core/synthesis/action_placement.h"
#include "core/synthesis/choice.h"

namespace kumite {

/// A fighter's whole take as a bout plays it: at the bout's rate, in the bout's space, the floor at
/// y = 0. All lists have one entry per frame.
struct LibraryClip {
    Clip clip;
    double offset = 0;                 ///< seconds on the take's clock of frame 0
    std::vector<Station> stations;     ///< pelvis and heading (unwrapped)
    std::vector<Eigen::Vector2d> com;  ///< on the floor
    FootContacts contacts;
    std::array<double, 2> footRest{};  ///< see LibraryFighter

    bool empty() const { return clip.frames.empty(); }
    double secondsAt(double frame) const { return offset + frame / clip.rate; }
    /// Between two frames; clamped.
    Station stationAt(double frame) const;
    Eigen::Vector2d comAt(double frame) const;
    /// The clip's frame nearest to a moment of the take's clock; clamped.
    int frameAt(double seconds) const;
};

/// What an action is to the other fighter, and the moment at which it counts (method A9).
enum class ActionRole { Neither, Strike, Reaction };

/// An action of B as a bout plays it.
struct BoutAction {
    int clip = -1;   ///< of its fighter; -1: it cannot be shown
    int begin = 0;   ///< frame of the clip
    int frames = 0;  ///< from the boundary frame at its begin to the one at its end; at least 1
    int node = kAnyNode;
    GroundFrame ground;  ///< F′: the frame of the transition into it
    ActionRole role = ActionRole::Neither;
    double moment = 0;  ///< frames from its begin: strike at its farthest, reaction at its peak
    /// Seconds by which the moment came after that of the opponent's action that it belongs to.
    std::optional<double> lag;
    int firstStance = -1;  ///< number of the stance's letter; -1: not known
    int lastStance = -1;
};

struct LibraryFighter {
    std::shared_ptr<const Rig> rig;               ///< of all clips; null: none
    SharedValue<std::vector<LibraryClip>> clips;  ///< by take
    /// Heights of the left and right foot point when that foot stands, metres.
    std::array<double, 2> footRest{};
    std::vector<BoutAction> actions;  ///< as in B
    ChoiceModel model;
    /// With the avatar's target, 38 dimensions; see withAvatar.
    std::optional<ChoiceModel> avatarModel;

    const BoutAction& action(int index) const { return actions[static_cast<std::size_t>(index)]; }
    const LibraryClip& clipOf(const BoutAction& action) const {
        return (*clips)[static_cast<std::size_t>(action.clip)];
    }
};

/// What bouts are made from: every recorded action of both fighters and what was learnt from them.
/// Made once, shared by bouts, never changed; safe to read from any thread.
struct BoutLibrary {
    double rate = 0;  ///< Hz
    int components = 3;
    GeometrySettings geometry;
    std::shared_ptr<const CoupledGraph> graph;
    std::shared_ptr<const BoutNumbers> numbers;
    std::shared_ptr<const PoseSpace> poses;
    std::array<LibraryFighter, 2> fighters;
    double typicalLag = 0;  ///< seconds, median of a reaction's moment after its strike's
    std::string hash;       ///< of what was learnt: the same hash and seed give the same bout
    Findings findings;

    const LibraryFighter& fighter(int player) const {
        return fighters[static_cast<std::size_t>(player)];
    }
    const Vocabulary& vocabulary() const { return *graph->vocabulary; }
};

/// What a library is made of. The graph's transitions are those that may be shown.
struct LibrarySource {
    double rate = 0;  ///< Hz, of all clips
    int components = 3;
    GeometrySettings geometry;
    std::shared_ptr<const CoupledGraph> graph;
    std::shared_ptr<const BoutNumbers> numbers;
    std::shared_ptr<const PoseSpace> poses;
    std::array<LabelTerm, 2> labelTerms;
    std::array<GeometryTerm, 2> geometryTerms;
    std::array<Eigen::MatrixXd, 2> rows;            ///< of transitionMatrix
    std::array<std::vector<LibraryClip>, 2> clips;  ///< by take; empty ones where there is none
    Findings findings;                              ///< what was left out
};
std::shared_ptr<const BoutLibrary> boutLibrary(LibrarySource source);

/// The same with the model by which an avatar of that player finds its target (paper A, 5.2): the
/// 36 numbers and c, where it stood half a second after the change. Trains; cancellable.
std::shared_ptr<const BoutLibrary> withAvatar(std::shared_ptr<const BoutLibrary> library,
                                              int player, const Progress& progress = {});

/// By node of a player: whether one of the label's aspects strikes.
std::vector<char> strikingNodes(const BoutLibrary& library, int player);

/// Nodes that a key of the interactive mode asks for, through the action table R: "kick" and
/// "punch" (what aspects strike with), an aspect ("right_kick", "jump"), or one with a qualifier
/// ("right_punch:fwd"). Without a qualifier all that strike count; of an aspect without any, the
/// first. Only nodes that can be shown. Throws Error that says what the words are, or that this
/// fighter never shows it.
std::vector<int> commandedNodes(const BoutLibrary& library, int player, const std::string& words);

}  // namespace kumite
