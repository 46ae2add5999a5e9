#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/frame_range.h"

namespace kumite::demo {

/// One action as it was planned. Frames of the take; `begin` and `end` are boundary frames.
struct TrueAction {
    int begin = 0;
    int end = 0;
    int peak = 0;  ///< the frame inside with the highest planned force
    /// Aspect and qualifier of all seven aspects (method A3).
    std::vector<std::pair<std::string, std::string>> label;
    std::string manner;  ///< how an action of others is spent
    /// What the choice was made from, as `Process` names it; empty where the law did not choose.
    std::string own;
    std::string opponent;
    std::string range;
};

struct TrueHit {
    int frame = 0;
    std::string limb;       ///< "left_hand", "right_foot" …
    std::string target;     ///< "head", "trunk", "leg"
    std::string outcome;    ///< "lands", "blocked", "dodged", "short"
    Eigen::Vector3d point;  ///< where the limb shall be, metres
};

struct TruePlayer {
    std::vector<int> boundaries;  ///< first 0, last = frames − 1
    std::vector<int> spurious;    ///< minima of the force that cut no action
    std::vector<TrueAction> actions;
    std::array<std::vector<FrameRange>, 2> contacts;  ///< left and right foot on the ground
    std::vector<TrueHit> hits;
};

/// A row of the law: probabilities of the next technique.
struct ProcessRow {
    int mover = 1;
    std::string own;       ///< technique that ended
    std::string opponent;  ///< opponent's technique in progress
    std::string range;     ///< "near", "middle", "far"
    std::vector<std::pair<std::string, double>> next;
};

/// What is known of a made bout, from its plan and never from looking at the motion.
struct Truth {
    double rate = 60;
    std::uint64_t seed = 1;
    std::array<TruePlayer, 2> players;
    std::vector<ProcessRow> process;  ///< the rows that this bout drew from
};

/// truth.json; its schema stands in core/README.md.
std::string truthText(const Truth& truth);

}  // namespace kumite::demo
