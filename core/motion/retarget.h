#pragma once

#include <optional>

#include "core/base/finding.h"
#include "core/motion/pose.h"

namespace kumite {

/// How poses of one rig become poses of another.
///
/// Rotations in space are handed over from joint to joint by role (joints without a role by name,
/// where both rigs have it), measured from a common rest pose: the target with its limbs brought
/// parallel to the source's resting limbs. The trunk needs no such turn but that of the whole
/// body; arms and legs are aligned bone by bone, and so are feet unless both rigs rest on them. A
/// target joint that nothing is handed to stays as it is in that pose, relative to its parent. The
/// middle of the hips goes where the source's goes, scaled by the legs' lengths.
class Retargeting {
public:
    Retargeting(std::shared_ptr<const Rig> source, std::shared_ptr<const Rig> target);

    /// Ways are scaled about `origin` (metres, a place on the floor): what stands there stays.
    Pose apply(const Pose& pose, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) const;

    /// Leg length of the target over the source's; 1 where a rig has no legs.
    double scale() const { return scale_; }
    /// What the target cannot show of the source and the reverse: roles that only one of them has,
    /// proportions that differ.
    const Findings& losses() const { return losses_; }

private:
    struct Link {
        int source = -1;  ///< joint whose turn in space is handed over; −1: none
        Eigen::Quaterniond rest = Eigen::Quaterniond::Identity();
    };

    std::shared_ptr<const Rig> source_;
    std::shared_ptr<const Rig> target_;
    std::vector<Link> links_;                  ///< per target joint
    std::vector<Eigen::Quaterniond> resting_;  ///< local turns of the target's common rest pose
    double scale_ = 1;
    Findings losses_;
};

/// A clip on another rig. Ways are scaled about the floor below the first frame's root; the whole
/// is lifted or lowered so that its feet have the floor that the source's feet have (feet.h), where
/// both rigs have feet. `losses`, if given, says what was lost.
Clip retargeted(const Clip& clip, std::shared_ptr<const Rig> target, Findings* losses = nullptr);

}  // namespace kumite
