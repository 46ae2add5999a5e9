#pragma once

#include <memory>
#include <vector>

#include "core/demo/body.h"
#include "core/motion/motion.h"

namespace kumite::demo {

/// How a pose is written down: a skeleton as an exporter makes it, with names, hierarchy, rest
/// pose, channel order and unit of its own, on a body of its own size.
struct Suit {
    /// What turns a joint.
    struct Source {
        enum class Kind { Pelvis, Spine, Neck, Head, Limb, Fixed } kind = Kind::Fixed;
        int spine = 0;  ///< 1 … n
        Side side = Side::Left;
        Part part = Part::Clavicle;
        /// Rotation of the joint in the rest pose, against the T-pose.
        Eigen::Matrix3d rest = Eigen::Matrix3d::Identity();
    };

    BodySize size;
    double unitsPerMetre = 100;
    std::shared_ptr<const Skeleton> skeleton;
    std::vector<Source> sources;  ///< one per joint of the skeleton, End Sites too
};

/// Centimetres, HumanIK's names, three spine joints, T-pose, root XYZ then Z X Y angles.
Suit makeHumanIkSuit();
/// Inches, Poser's names, a longer chain to the legs, fingers, arms hanging at rest, Y X Z angles;
/// a smaller body.
Suit makePoserSuit();

/// Local rotations of all joints and the root's position in the file's unit.
struct SuitFrame {
    Eigen::Vector3d root;
    std::vector<Eigen::Matrix3d> local;
};

void dress(const Suit& suit, const Pose& pose, SuitFrame& frame);

}  // namespace kumite::demo
