#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/project/project_file.h"

namespace kumite {

/// How many states of a project file are kept besides the file itself.
inline constexpr int kKeptVersions = 10;

/// A state of a project file that was saved over.
struct KeptVersion {
    std::filesystem::path file;
    std::chrono::system_clock::time_point saved;  ///< when it was saved
    int takes = 0;
    int corrections = 0;  ///< of all fighters of all takes
    std::string problem;  ///< why it cannot be read; empty: it can
};

/// Where the versions of a project file are: `.kumite-versions/NAME` beside it, so that they go
/// with the folder and everybody who works there finds the same.
std::filesystem::path versionsFolder(const std::filesystem::path& project);

/// Keeps what the file at `project` holds, before `next` is written there; the oldest version
/// beyond ten goes. Does nothing where there is no file, or it holds `next` already. Throws Error.
void keepVersion(const std::filesystem::path& project, std::string_view next);

/// The versions of a project file, the newest first.
std::vector<KeptVersion> keptVersions(const std::filesystem::path& project);

/// A version with its recordings, as the project in its folder. Recordings that `known` holds are
/// taken from there. Throws InputError.
LoadedProject loadVersion(const std::filesystem::path& project, const KeptVersion& version,
                          const Project& known = {}, const Progress& progress = {});

}  // namespace kumite
