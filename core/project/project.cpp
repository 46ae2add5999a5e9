#include "core/project/project.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"

namespace kumite {

FrameRange framesOf(const Fighter& fighter) {
    if (!fighter.motion) return fighter.frames;
    return {fighter.frames.begin, std::min(fighter.frames.end, fighter.motion->frameCount)};
}

const Fighter& fighterAt(const Project& project, FighterAddress address) {
    return project.takes.at(static_cast<std::size_t>(address.take))
        .fighters.at(static_cast<std::size_t>(address.player));
}

Fighter& fighterAt(Project& project, FighterAddress address) {
    return const_cast<Fighter&>(fighterAt(std::as_const(project), address));
}

std::vector<std::filesystem::path> recordingFiles(const Project& project) {
    std::vector<std::filesystem::path> files;
    for (const Take& take : project.takes) {
        for (const Fighter& fighter : take.fighters) {
            files.push_back(fighter.recording.path);
            if (!fighter.recording.asf.empty()) files.push_back(fighter.recording.asf);
        }
    }
    return files;
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
