#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/demo/demo.h"

namespace kumite {

/// The files of a demo bout in one folder.
struct DemoFiles {
    std::filesystem::path folder;

    std::filesystem::path player(int number) const;  ///< 1 or 2
    std::filesystem::path truth() const { return folder / "truth.json"; }
    std::filesystem::path project() const { return folder / "demo.kumite"; }
};

/// Makes a bout and writes player1.bvh, player2.bvh, truth.json and a project of one take,
/// demo.kumite. The folder is made if it is not there; files of those names are replaced. Throws
/// Error, Cancelled.
DemoFiles writeDemoBout(const demo::DemoSettings& settings, const std::filesystem::path& folder,
                        const Progress& progress = {});

/// Where the demo bout of the window and the command line lies: a folder of this user's data,
/// because projects that are made of it go on naming its recordings.
std::filesystem::path demoFolder();

}  // namespace kumite
