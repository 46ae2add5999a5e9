#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace kumite {

/// One number per frame that a recording stores for a joint. Positions in file units, rotations
/// in degrees. The order of a joint's rotation channels is the order of the matrix product:
/// `Zrotation Xrotation Yrotation` means R = Rz · Rx · Ry.
enum class Channel : std::uint8_t {
    Xposition,
    Yposition,
    Zposition,
    Xrotation,
    Yrotation,
    Zrotation
};

bool isRotation(Channel channel);
/// 0, 1, 2 for x, y, z.
int axisOf(Channel channel);
/// The spelling of the BVH format, e.g. "Xposition".
std::string_view channelName(Channel channel);

/// A joint of a skeleton, or an End Site: a point without channels that tells where the last
/// bone of a chain ends. End Sites are named after their parent: "lFoot End Site".
struct Joint {
    std::string name;
    int parent = -1;  ///< index of the parent, always smaller than the own; -1 for the root
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< from the parent at rest, file units
    /// Where the channel rotations act: local rotation = F · R(channels) · Fᵀ. Identity in BVH;
    /// the bone's `axis` in ASF.
    Eigen::Matrix3d rotationFrame = Eigen::Matrix3d::Identity();
    std::vector<Channel> channels;
    int firstChannel = 0;  ///< column of the first channel in Motion::channels
    bool isEndSite = false;
};

/// A tree of joints in depth-first order as the file lists them, End Sites included; joints[0] is
/// the root and every parent stands before its children. A valid skeleton has at least one joint
/// and contiguous channel columns; the names need not differ.
///
/// Position channels replace the offset on the axes they name (what MotionBuilder, Blender and
/// the CMU files mean), they are not added to it.
struct Skeleton {
    std::vector<Joint> joints;
    int channelCount = 0;

    int jointCount() const { return static_cast<int>(joints.size()); }
    std::vector<int> childrenOf(int joint) const;
    /// The first joint of that name (not an End Site first, if both exist), or -1.
    int find(std::string_view name) const;
    /// Joint positions at rest (all rotations zero, root at the origin), file units.
    std::vector<Eigen::Vector3d> restPositions() const;

    /// Throws Error with one sentence if the rules above do not hold.
    void validate() const;
};

}  // namespace kumite
