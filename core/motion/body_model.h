#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/roles.h"

namespace kumite {

/// A body segment's share of the mass and where its centre lies.
struct BodySegment {
    std::string name;
    double mass = 0;  ///< share of the body's mass
    /// The centre of mass is at from + fraction · (to − from). Two roles in `from` mean their mean.
    std::vector<Role> from;
    std::optional<Role> to;  ///< nothing: the centre is at `from`
    /// `to` means the end of the bone that the role's joint begins (its End Site), e.g. the top of
    /// the head; without an End Site the whole segment is at that joint.
    bool toEndSite = false;
    bool toOptional = false;  ///< a skeleton without `to` has the whole segment at `from`
    double fraction = 0.5;

    bool operator==(const BodySegment&) const = default;
};

/// Segment masses and centres. Data, so that a user can replace it.
struct BodyModel {
    std::string name;
    std::vector<BodySegment> segments;

    bool operator==(const BodyModel&) const = default;
};

/// Male means of de Leva, J. Biomech. 29(9), 1996, simplified to what every skeleton has
/// (method A1).
const BodyModel& deLevaMale();

}  // namespace kumite
