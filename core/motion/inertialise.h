#pragma once

#include "core/motion/pose.h"

namespace kumite {

/// A difference of two poses, or its change per second: metres, and per joint a rotation vector
/// (radians) v in the parent's axes, so that turn = exp(v) · other turn.
struct PoseOffset {
    Eigen::Vector3d root = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> turns;
};

/// What `shown` is ahead of `other`, the short way round.
PoseOffset offsetBetween(const Pose& shown, const Pose& other);

/// How a join is made.
struct JoinSettings {
    double duration = 0.2;  ///< seconds until the following motion is on its own
    /// How far differing speeds may carry a joint beyond both motions: radians and metres. A fist
    /// that stops dead would else swing on.
    double overshootTurn = 0.25;
    double overshootRoot = 0.05;

    bool operator==(const JoinSettings&) const = default;
};

/// A join that is smooth from the first frame on (inertialised: Bollo, GDC 2018): the following
/// motion is shown with the offset that the shown one had at the join, which decays to nothing.
/// With T = duration and s = t / T
///     x(t) = x0 (1 − 10 s³ + 15 s⁴ − 6 s⁵) + v0 T (s − 6 s³ + 8 s⁴ − 3 s⁵)
/// per component: position and speed are continuous at t = 0; position, speed and acceleration of
/// the offset are 0 at T.
class Inertialisation {
public:
    Inertialisation() = default;
    /// At the moment of the join the pose is `shown` in the motion that ends and `next` in the
    /// one that follows; `before` is shown `dt` seconds earlier, `after` follows `dt` later.
    Inertialisation(const Pose& before, const Pose& shown, const Pose& next, const Pose& after,
                    double dt, const JoinSettings& settings = {});

    /// Adds what is left of the offset `seconds` after the join.
    void apply(Pose& pose, double seconds) const;
    bool over(double seconds) const { return seconds >= duration_; }
    /// The offset itself, `seconds` after the join.
    PoseOffset at(double seconds) const;

private:
    PoseOffset offset_;
    PoseOffset velocity_;
    double duration_ = 0;
};

/// `second` after `first`, which have one rig and rate: the last frame of `first` and the first of
/// `second` are one moment, shown once, as in `first`. `second` is taken where it stands (see
/// `moved`). Throws Error if the rates or joint counts differ or one is empty.
Clip joined(const Clip& first, const Clip& second, const JoinSettings& settings = {});

}  // namespace kumite
