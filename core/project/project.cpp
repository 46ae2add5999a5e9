#include "core/project/project.h"

#include <utility>

#include "core/base/error.h"

namespace kumite {

const Fighter& fighterAt(const Project& project, FighterAddress address) {
    return project.takes.at(static_cast<std::size_t>(address.take))
        .fighters.at(static_cast<std::size_t>(address.player));
}

Fighter& fighterAt(Project& project, FighterAddress address) {
    return const_cast<Fighter&>(fighterAt(std::as_const(project), address));
}

int takeNamed(const Project& project, std::string_view name) {
    std::string known;
    for (std::size_t i = 0; i < project.takes.size(); ++i) {
        if (project.takes[i].name == name) return static_cast<int>(i);
        known += (i ? ", " : "") + project.takes[i].name;
    }
    throw Error("There is no take named \"" + std::string(name) + "\"; " +
                (known.empty() ? "the project has none." : "there is: " + known + "."));
}

}  // namespace kumite
