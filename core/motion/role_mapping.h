#pragma once

#include <string>

#include "core/base/finding.h"
#include "core/motion/roles.h"
#include "core/motion/skeleton.h"

namespace kumite {

/// Which joint has which role, how that was found, and what is doubtful about it.
struct RoleMapping {
    RoleMap roles;
    /// Naming family whose table fitted best ("Poser", "HumanIK", "Biovision" …), "topology" where
    /// names said nothing, "none" where the skeleton is not a body.
    std::string family;
    Findings findings;
};

/// Finds the roles by the family of names that explains most of the skeleton, then by the tree's
/// shape for what names left open (method A1). Never fails: a skeleton without a body gets an
/// empty map and a finding that says so.
RoleMapping mapRoles(const Skeleton& skeleton);

}  // namespace kumite
