#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/roles.h"

namespace kumite {

/// What one exporter, or a group that names alike, calls the joints of a body. Names are written
/// as `plainJointNames` makes them; those of limbs without their side.
struct NameFamily {
    struct Entry {
        Role role;                            ///< of the middle, or the left one of a pair
        std::vector<std::string_view> names;  ///< the first that exists wins
    };
    std::string_view name;
    std::vector<Entry> entries;
};

/// Tables of all families that method A1 lists.
const std::vector<NameFamily>& nameFamilies();

/// Joint names without what differs between exporters of one family: name spaces ("mixamorig:"),
/// a prefix that most joints share ("Bip01 ", "Character1_"), case, and everything but letters
/// and digits.
std::vector<std::string> plainJointNames(const std::vector<std::string_view>& names);

/// Whether `plain` is `base` with a side: "leftfoot", "footleft", "lfoot", "footl".
bool isSided(std::string_view plain, std::string_view base, bool left);

}  // namespace kumite
