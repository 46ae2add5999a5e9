#pragma once

#include "core/motion/roles.h"
#include "core/motion/skeleton.h"

namespace kumite {

/// The nearest joint that has both `a` and `b` below or at it.
int commonAncestor(const Skeleton& skeleton, int a, int b);

/// Joints on the way from `ancestor` (left out) down to `joint` (included); empty if it is not one.
std::vector<int> pathDown(const Skeleton& skeleton, int ancestor, int joint);

/// The first End Site that hangs directly on `joint`, or nothing.
std::optional<int> endSiteOf(const Skeleton& skeleton, int joint);

/// Roles read off the tree's shape alone: two pairs of mirrored chains, the legs at the pair
/// nearer to the root; in each chain the two long bones. Left and right follow from where the
/// feet point at rest. An empty map where the tree does not look like a body.
RoleMap rolesByTopology(const Skeleton& skeleton);

}  // namespace kumite
