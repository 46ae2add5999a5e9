#pragma once

#include <string>

#include "core/motion/kinematics.h"

namespace kumite::cli {

inline constexpr char kUnitsHelp[] =
    "unit of the file: m, dm, cm, mm, inch, foot, cmu or a number of metres; default: found";

/// Metres per unit of a name or number. Throws UsageError.
double parseUnits(const std::string& text);
/// "y" or "z". Throws UsageError.
UpAxis parseUp(const std::string& text);

}  // namespace kumite::cli
