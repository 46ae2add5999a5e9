#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/labelling/label.h"
#include "core/segmentation/segmentation.h"

namespace kumite {

/// What the interaction sees of a fighter of a take: its actions on the take's clock and what they
/// are. Frames of the take.
struct LabelledStream {
    double rate = 0;    ///< Hz
    double offset = 0;  ///< seconds on the take's clock of frame 0
    int frameCount = 0;
    std::vector<Action> actions;
    std::vector<Label> labels;  ///< one per action; empty: nobody has said anything
};

/// A take: players in order, one or two.
struct LabelledTake {
    std::string name;
    std::vector<LabelledStream> players;
};

/// A node of the basic data structure B (paper A, section 3.3): an action of one player, linked to
/// the player's next one and to what the opponent was doing when it began.
struct BasicAction {
    int take = 0;
    int index = 0;            ///< among the actions of its fighter in that take
    Action frames;            ///< of the take
    double beginSeconds = 0;  ///< on the take's clock
    double endSeconds = 0;
    int node = -1;        ///< of the player's graph; -1: not labelled
    int next = -1;        ///< the player's next action of the same take; -1: none
    int inProgress = -1;  ///< the opponent's action in progress when this one begins; -1: none

    bool operator==(const BasicAction&) const = default;
};

/// Both players' actions of all takes, in order of takes and time. `next` and `inProgress` are
/// indices into the own and the other player's list. Takes are never chained across their ends.
/// Nodes are not yet set.
using BasicStructure = std::array<std::vector<BasicAction>, 2>;
BasicStructure basicStructure(std::span<const LabelledTake> takes);

/// The opponent's frame shown just before a moment of the take's clock: the last one strictly
/// earlier (method A6: at the frame b where an action begins it is b − 1). May lie outside of the
/// opponent's frames.
int frameBefore(double seconds, double rate, double offset);

/// Index of the action in progress just before a frame: the one that holds frame − 1, the later one
/// at a boundary; -1 where there is none.
int actionBefore(std::span<const Action> actions, int frame);

}  // namespace kumite
