#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/project/project.h"

namespace kumite {

/// Version that this program writes. Older files are migrated on reading, newer ones refused.
inline constexpr int kProjectVersion = 2;

/// Text of a project file: JSON, stable key order, one line per short value; recording paths
/// relative to `folder` where they can be.
std::string projectText(const Project& project, const std::filesystem::path& folder);

/// The project that `text` describes, without motions; `name` is used in messages, relative
/// paths start at `folder`. Throws InputError.
Project parseProject(std::string_view text, const std::string& name,
                     const std::filesystem::path& folder);

/// A project with its recordings loaded. A recording that is missing leaves its fighter without a
/// motion and a warning that says what to do; one that was moved next to the project file or into
/// a folder below it is found by its SHA-256; one that changed is used, with a warning.
struct LoadedProject {
    Project project;
    Findings findings;
};
LoadedProject loadProject(const std::filesystem::path& path, const Progress& progress = {});

/// The same for a project without motions whose file belongs into `folder`. Recordings that `known`
/// has in memory are taken from there.
LoadedProject loadRecordings(Project project, const std::filesystem::path& folder,
                             const Project& known = {}, const Progress& progress = {});

/// A body model from a file of its own: the value of "body_model" in a project file. Throws
/// InputError.
BodyModel readBodyModel(const std::filesystem::path& path);
/// The same from text; `name` is used in messages.
BodyModel parseBodyModel(std::string_view text, const std::string& name);

/// Saves atomically. What the file held before is kept as a version (versions.h); where that
/// fails, the project is saved nevertheless and a warning says so. Throws Error; the file is then
/// as it was.
Findings saveProject(const Project& project, const std::filesystem::path& path);

}  // namespace kumite
