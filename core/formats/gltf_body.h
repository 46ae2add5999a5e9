#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/motion/rig.h"

namespace kumite {

/// A body's surface at rest (all turns the identity, joint 0 at the origin), each vertex bound to
/// one joint.
struct BodyMesh {
    std::vector<Eigen::Vector3f> positions;  ///< metres
    std::vector<Eigen::Vector3f> normals;
    std::vector<std::uint16_t> joints;
    std::vector<std::uint32_t> triangles;  ///< three indices each, counter-clockwise from outside
};

/// Capsules for the parts of a body that the roles name (overlap.h), thin ones for all other bones.
BodyMesh bodyMesh(const Rig& rig);

}  // namespace kumite
