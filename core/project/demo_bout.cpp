#include "core/project/demo_bout.h"

#include <cstdlib>

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/formats/bvh.h"
#include "core/project/edits.h"
#include "core/project/import.h"
#include "core/project/project_file.h"

namespace kumite {

std::filesystem::path DemoFiles::player(int number) const {
    return folder / fmt::format("player{}.bvh", number);
}

DemoFiles writeDemoBout(const demo::DemoSettings& settings, const std::filesystem::path& folder,
                        const Progress& progress) {
    const demo::DemoBout bout = demo::makeDemoBout(settings, progress.part(0, 0.7));
    const DemoFiles files{folder};
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
        throw Error(
            fmt::format("The folder {} cannot be made: {}.", folder.string(), failed.message()));
    }
    for (int player = 1; player <= 2; ++player) {
        const Motion& motion = bout.motions[static_cast<std::size_t>(player) - 1];
        writeFileAtomically(files.player(player),
                            bvhText(motion, motion.frames(), motion.frameTime));
        progress.update(0.7 + 0.1 * player);
    }
    writeFileAtomically(files.truth(), demo::truthText(bout.truth));
    TakeRequest request;
    request.name = "demo";
    request.rate = settings.rate;
    request.trim = FrameRange{0, -1};
    for (int player = 1; player <= 2; ++player) {
        FighterRequest fighter;
        fighter.path = files.player(player);
        request.fighters.push_back(fighter);
    }
    const ImportedTake imported = importTake(request, progress.part(0.9, 1));
    saveProject(addTake(Project{}, imported.take)->project, files.project());
    return files;
}

std::filesystem::path demoFolder() {
    const auto named = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::filesystem::path(value ? value : "");
    };
    std::filesystem::path data = named("XDG_DATA_HOME");
    if (!data.is_absolute() && named("HOME").is_absolute()) data = named("HOME") / ".local/share";
    if (!data.is_absolute()) data = std::filesystem::temp_directory_path();
    return data / "kumite" / "demo";
}

}  // namespace kumite
