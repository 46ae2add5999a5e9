#pragma once

#include <array>
#include <vector>

#include "core/demo/choreography.h"
#include "core/demo/strikes.h"

namespace kumite::demo {

/// What of a posture is planned by key values over time. Angles in radians: yaw about y (positive
/// toward the left), lean forward, tilt toward the right. Hands in metres from the neck, in the
/// fighter's frame: aside to its own side, up, ahead.
enum class Control {
    PelvisYaw,
    PelvisLean,
    PelvisTilt,
    SpineYaw,  ///< of the chest against the pelvis
    SpineLean,
    SpineTilt,
    HeadYaw,  ///< against the look at the opponent
    HeadLean,
    HeadTilt,
    LeftAside,
    LeftUp,
    LeftAhead,
    RightAside,
    RightUp,
    RightAhead,
    LeftPivot,  ///< of the planted foot about its toe
    RightPivot
};
inline constexpr int kControlCount = 17;

/// All controls at one time.
using Posture = std::array<double, kControlCount>;

inline double& of(Posture& posture, Control control) {
    return posture[static_cast<std::size_t>(control)];
}
inline double of(const Posture& posture, Control control) {
    return posture[static_cast<std::size_t>(control)];
}

/// Posture over time: minimum-jerk from key to key, a little sway, and the knocks of strikes that
/// land.
class PosturePlan {
public:
    /// `received`: the opponent's strikes.
    PosturePlan(const Script& script, const std::vector<Strike>& received, std::uint64_t seed);

    Posture at(double time) const;

private:
    struct Key {
        double time;
        double value;
    };
    struct Knock {
        double time;
        double strength;
        double sideways;
        bool head;
    };

    void add(Control control, double time, double value);
    void addBoundary(const PlannedAction& ending, Random& random);
    void addMiddle(const PlannedAction& action, Random& random);
    void addDefence(const PlannedAction& action, Random& random);
    double valueOf(Control control, double time) const;

    Temper temper_;
    std::uint64_t seed_ = 0;
    Posture guard_{};
    std::array<std::vector<Key>, kControlCount> keys_;
    std::vector<Knock> knocks_;
};

/// From 0 to 1 with no jump in speed or acceleration at either end.
double minimumJerk(double s);

}  // namespace kumite::demo
