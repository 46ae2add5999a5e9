#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/motion/kinematics.h"
#include "core/motion/roles.h"

namespace kumite {

/// The joint that tells where a foot meets the ground: toe, else the ankle's End Site, else the
/// ankle. Nothing without a leg.
std::optional<int> footPoint(const Skeleton& skeleton, const RoleMap& roles, bool left);

/// Rest height of a foot: the 5th percentile of its height over the take (method A2b), linear
/// between ranks. Metres.
double restHeight(const JointPositions& positions, int joint);

/// The floor: the lower of both feet's rest heights (method A2b). Nothing without feet.
std::optional<double> floorHeight(const Skeleton& skeleton, const RoleMap& roles,
                                  const JointPositions& positions);

/// Speed of a joint at each frame, central differences (one-sided at the ends), m/s.
std::vector<float> jointSpeed(const JointPositions& positions, int joint, double rate);

/// Foot skate (expectations, "Numbers to beat"): interval i lies between frames i and i + 1; a
/// foot skates there if it is less than 5 cm above `floor` in both frames and its horizontal
/// speed, and the mean of that speed over 0.25 s around it, are both above 0.5 m/s.
struct FootSkate {
    int intervals = 0;
    int left = 0;  ///< intervals in which that foot skates
    int right = 0;
    int either = 0;
    double ratio() const { return intervals > 0 ? double(either) / intervals : 0.0; }
};

/// Both tracks have one position per frame, metres, y up.
FootSkate measureFootSkate(std::span<const Eigen::Vector3f> leftToe,
                           std::span<const Eigen::Vector3f> rightToe, double rate, double floor);

}  // namespace kumite
