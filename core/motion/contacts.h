#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/motion/kinematics.h"
#include "core/motion/roles.h"

namespace kumite {

/// When a foot stands on the ground (method A2b). A contact begins below `height` and `speed` and
/// ends above `releaseHeight` or `releaseSpeed`.
struct ContactSettings {
    double height = 0.05;         ///< metres above the foot's rest height
    double speed = 0.5;           ///< m/s, in space
    double releaseHeight = 0.08;  ///< metres above the foot's rest height
    double releaseSpeed = 0.8;    ///< m/s
    double shortest = 0.05;       ///< seconds; what is shorter does not count

    bool operator==(const ContactSettings&) const = default;
};

/// Per frame 1 where the foot is in contact, else 0. A side without a leg is empty.
struct FootContacts {
    std::vector<std::uint8_t> left;
    std::vector<std::uint8_t> right;

    bool operator==(const FootContacts&) const = default;
};

/// Contacts of one foot from its height over its rest height (metres) and its speed (m/s), per
/// frame. The only implementation: rules, foot locking and the lanes of the window use it.
std::vector<std::uint8_t> footContact(std::span<const float> heightOverRest,
                                      std::span<const float> speed, double rate,
                                      const ContactSettings& settings = {});

/// Contacts of both feet (toe, else foot end, see footPoint) against each foot's own rest height.
FootContacts footContacts(const Skeleton& skeleton, const RoleMap& roles,
                          const JointPositions& positions, double rate,
                          const ContactSettings& settings = {});

}  // namespace kumite
