#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Geometry>

namespace kumite {

/// Angles of a joint about three axes over time, radians, one per frame.
using AngleTrack = std::vector<Eigen::Vector3d>;

/// Mean and root mean square deviation per axis, over the angles unwrapped in time.
struct AngleStatistics {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
};
AngleStatistics statisticsOf(const AngleTrack& angles);

/// The angles without their jumps of a full turn: neighbours differ by at most π.
AngleTrack unwrapped(AngleTrack angles);

/// S = (R − M_R) / σ_R · σ_Q + M_Q per axis (paper C, eq. 1; method C2): the retrieved motion's
/// local course with the query's mean and deviation. σ_R = 0: S = M_Q. Every frame, the first and
/// last too. The result is unwrapped.
AngleTrack adjusted(const AngleTrack& retrieved, const AngleTrack& query);

/// Order of axes in which two tracks of rotations stay farthest from gimbal lock: the one whose
/// middle angle comes least near to ±90°.
std::array<int, 3> safestOrder(std::span<const Eigen::Quaterniond> a,
                               std::span<const Eigen::Quaterniond> b);

/// Rotations as continuous angles: R = R(order[0]) · R(order[1]) · R(order[2]), angle k about the
/// axis order[k].
AngleTrack anglesOf(std::span<const Eigen::Quaterniond> turns, const std::array<int, 3>& order);
Eigen::Quaterniond turnOf(const Eigen::Vector3d& angles, const std::array<int, 3>& order);

/// What the adjustment of a joint did, for the tables.
struct JointAdjustment {
    std::array<int, 3> order{};
    AngleStatistics query, retrieved, assembled;
};

/// Adjusts a joint's rotations in place so that their angles get the query's statistics.
JointAdjustment adjustJoint(std::vector<Eigen::Quaterniond>& retrieved,
                            std::span<const Eigen::Quaterniond> query);

}  // namespace kumite
