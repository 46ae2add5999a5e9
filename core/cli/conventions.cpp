#include "core/cli/conventions.h"

#include "core/cli/command.h"
#include "core/motion/survey.h"

namespace kumite::cli {

double parseUnits(const std::string& text) {
    const auto metres = metresPerUnitFromName(text);
    if (!metres) {
        throw UsageError("\"" + text +
                         "\" is no unit, expected m, dm, cm, mm, inch, foot, cmu or a number of "
                         "metres.");
    }
    return *metres;
}

UpAxis parseUp(const std::string& text) {
    if (text == "y" || text == "Y") return UpAxis::Y;
    if (text == "z" || text == "Z") return UpAxis::Z;
    throw UsageError("\"" + text + "\" is no up axis, expected y or z.");
}

}  // namespace kumite::cli
