#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/motion/motion.h"

namespace kumite {

/// Which axis of the file points up. Y: as it is. Z: (x, y, z) becomes (x, z, -y).
enum class UpAxis { Y, Z };

/// How a file's numbers become metres in the common space (right-handed, y up).
struct SpaceConvention {
    double metresPerUnit = 0.01;
    UpAxis up = UpAxis::Y;

    bool operator==(const SpaceConvention&) const = default;

    /// A point or vector of the file, in metres, y up.
    Eigen::Vector3d toWorld(const Eigen::Vector3d& filePoint) const;
};

/// World positions of every joint and End Site over a range of frames: metres, y up, one block of
/// frames × joints × 3 floats (a float resolves 0.5 µm at 5 m; half the memory of a double).
struct JointPositions {
    int frameCount = 0;
    int jointCount = 0;
    std::vector<float> xyz;

    Eigen::Vector3f at(int frame, int joint) const {
        const float* p = data(frame, joint);
        return {p[0], p[1], p[2]};
    }
    const float* data(int frame, int joint) const {
        return xyz.data() +
               3 * (static_cast<std::size_t>(frame) * static_cast<std::size_t>(jointCount) +
                    static_cast<std::size_t>(joint));
    }
};

/// Forward kinematics of `frames` (of the file) on all cores. Frame 0 of the result is
/// frames.begin. Cancellable; the result does not depend on the number of cores.
JointPositions forwardKinematics(const Motion& motion, FrameRange frames,
                                 const SpaceConvention& space, const Progress& progress = {});

/// Speed of a joint at a frame, central differences (one-sided at the ends), m/s; 0 in a single
/// frame.
float jointSpeed(const JointPositions& positions, int joint, int frame, double rate);

/// The joint's own rotation at one frame, in the file's axes: F · R(channels) · Fᵀ.
Eigen::Matrix3d localRotation(const Joint& joint, std::span<const double> frameChannels);

}  // namespace kumite
