#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/finding.h"
#include "core/motion/kinematics.h"
#include "core/motion/motion.h"
#include "core/motion/roles.h"

namespace kumite {

/// A skeleton in the common space (metres, right-handed, y up): what motion is synthesised on.
/// Same joints in the same order as the Skeleton it stands for, so that indices and roles agree.
struct Rig {
    struct Joint {
        std::string name;
        int parent = -1;  ///< smaller than the own index; -1 for joint 0
        /// From the parent, in the parent's axes. Joint 0 has none: a pose says where it is.
        Eigen::Vector3d offset = Eigen::Vector3d::Zero();
        bool isEndSite = false;
    };
    std::vector<Joint> joints;
    RoleMap roles;
    /// The joint whose position carries the body through space: 0, but in files that put the hips'
    /// way below a root that stands still. It and the joints above it have no offset, so that a
    /// pose's root is the place of this joint.
    int traveller = 0;
    /// The direction that the body faces at rest, a unit vector in the axes of the rest pose (see
    /// `restForward` in heading.h).
    Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();

    int jointCount() const { return static_cast<int>(joints.size()); }
    const Joint& joint(int index) const { return joints[static_cast<std::size_t>(index)]; }
};

/// The rig of a motion. Where position channels hold a bone, its offset is their mean over
/// `frames`; `rigLosses` tells how far they stray from it.
Rig rigOf(const Motion& motion, FrameRange frames, const SpaceConvention& space,
          const RoleMap& roles);

/// What a rig cannot hold of a motion: bones whose positions vary (each with the largest distance
/// from the mean) and ways of joints above the traveller. Empty where only the traveller moves.
Findings rigLosses(const Motion& motion, FrameRange frames, const SpaceConvention& space,
                   const RoleMap& roles);

/// A skeleton of these joints in metres, y up: joint 0 with channels XYZ and zxy, the others zxy.
/// For motions that no recording lends its channels to.
std::shared_ptr<const Skeleton> skeletonOf(const Rig& rig);

/// The first End Site that hangs on a joint, or nothing.
std::optional<int> endSiteOf(const Rig& rig, int joint);

/// The joint that tells where a foot meets the ground, as `footPoint` of a skeleton in feet.h.
std::optional<int> footPoint(const Rig& rig, bool left);

/// Hip to ankle along the bones, mean of the legs that are there; 0 without legs. Metres.
double legLength(const Rig& rig);

/// Joint positions with no rotation anywhere, joint 0 at the origin. Metres.
std::vector<Eigen::Vector3d> restPositions(const Rig& rig);

}  // namespace kumite
