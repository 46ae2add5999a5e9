#pragma once

#include <vector>

#include "core/motion/roles.h"
#include "core/motion/skeleton.h"

namespace kumite::studio {

/// A part of a drawn body: a rounded cone from one joint to another, or the head's ellipsoid
/// around both. Radii in metres.
struct Bone {
    int from = 0;
    int to = 0;
    double fromRadius = 0;
    double toRadius = 0;
    bool isHead = false;
    bool isLeft = false;  ///< of the left arm or leg
};

/// A bone from every joint to each of its children, End Sites included; as thick as its role in
/// the body says, or by its length where the skeleton has no roles. `metresPerUnit` scales the
/// skeleton's offsets.
std::vector<Bone> bonesOf(const Skeleton& skeleton, const RoleMap& roles, double metresPerUnit);

}  // namespace kumite::studio
