#pragma once

#include <optional>
#include <string>

#include "core/base/finding.h"
#include "core/motion/kinematics.h"
#include "core/motion/role_mapping.h"

namespace kumite {

/// What a look at a recording finds out about it. Every value can be overridden by the user; the
/// findings say what was seen and on what ground.
struct Survey {
    RoleMapping roles;
    SpaceConvention space;
    std::string unitName;       ///< "cm", "m", "inch", "cmu", …
    double legLength = 0;       ///< hip to ankle along the bones, metres; 0 without legs
    double rate = 0;            ///< Hz, from the header unless overridden
    int leadingRestFrames = 0;  ///< frames of a T-pose or other rest pose before the motion
    Findings findings;
};

/// Overrides of a survey: what the user said instead of what would be found.
struct SurveyOverrides {
    std::optional<double> metresPerUnit;
    std::optional<UpAxis> up;
    std::optional<double> rate;
};

/// Looks at a whole motion. Never fails on a valid one.
Survey surveyMotion(const Motion& motion, const SurveyOverrides& overrides = {});

/// Metres per unit for a name that the command line knows (m, dm, cm, mm, inch, foot, cmu) or a
/// positive number of metres; nothing for anything else.
std::optional<double> metresPerUnitFromName(std::string_view name);
/// The name of a unit, or "0.0127 m" where it has none.
std::string unitNameOf(double metresPerUnit);

}  // namespace kumite
