#pragma once

#include <optional>
#include <string_view>

#include "core/project/analysis.h"

namespace kumite {

/// Why a minimum is suspected, as data; window and command line put it into words.
struct SuspectReason {
    enum class Kind {
        Unremarkable,  ///< nothing speaks against it
        SlowKick,      ///< one foot is up and moving while the other stands
        MovingFoot,    ///< a foot moves near the floor, or both are up
        Shallow,
        Crowded,
        High
    };

    Kind kind = Kind::Unremarkable;
    double prominence = 0;  ///< body weights
    double force = 0;       ///< body weights
    double nearest = 0;     ///< seconds to the nearest other minimum that cuts
    bool left = false;      ///< which foot; SlowKick and MovingFoot
    double footSpeed = 0;   ///< of that foot, m/s
    double footHeight = 0;  ///< of that foot above the floor, metres
};

/// The strongest evidence against a minimum (its index). `fighter` must have a force.
SuspectReason suspectReason(const FighterAnalysis& fighter, int minimum);

/// "slow_kick", "shallow", …: spelling in reports.
std::string_view reasonName(SuspectReason::Kind kind);

/// How far the correction of a fighter, or of several together, has come.
struct ReviewStatistics {
    double seconds = 0;
    int minima = 0;   ///< that cut by themselves
    int removed = 0;  ///< by hand
    int moved = 0;
    int added = 0;
    int accepted = 0;  ///< looked at and found right
    int toReview = 0;  ///< suspects (kSuspect) that no hand has judged

    double minimaPerSecond() const { return seconds > 0 ? minima / seconds : 0.0; }
    /// Removed, moved and added against all boundaries that were found or added; 0…1.
    double shareCorrected() const;
    ReviewStatistics& operator+=(const ReviewStatistics& other);
};

/// All zero where the recording is missing.
ReviewStatistics reviewStatistics(const FighterAnalysis& fighter, double threshold);

}  // namespace kumite
