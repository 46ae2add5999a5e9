#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/finding.h"
#include "core/motion/motion_library.h"
#include "core/project/analysis.h"

namespace kumite {

struct LibrarySettings {
    double rate = 30;  ///< Hz, of the library's clips

    bool operator==(const LibrarySettings&) const = default;
};

/// A library, and what was lost on the way into it (each text names its motion).
struct LoadedLibrary {
    MotionLibrary library;
    Findings findings;
    std::vector<std::filesystem::path> files;  ///< all that were read
};

/// Reads a library from any mix of motion files, folders of them and projects. A file is a motion
/// and an action of its stem's name ("kick", a second one of that name "kick#2"); a folder counts
/// with all below it, in the order of names; every fighter of a project's takes is a motion
/// "take:player" whose actions are "take:player:action". The first motion lends its rig; others are
/// brought onto it by their roles, and the floor of each lies at y = 0. What has no body is left
/// out with a warning, and so is an unreadable file in a folder. Throws Error if a file that was
/// named cannot be read, or if nothing remains; Cancelled.
LoadedLibrary loadLibrary(const std::vector<std::filesystem::path>& sources,
                          const LibrarySettings& settings = {}, const Progress& progress = {});

/// The library of an open project: its takes and its clips (of a project among them the takes).
/// Fighters without a recording are left out, and so is with a warning what cannot be read.
LoadedLibrary libraryOf(const Project& project, const Analysis& analysis,
                        const LibrarySettings& settings = {}, const Progress& progress = {});

/// What a name means: an action, a whole motion ("take:player"), or a stretch of either by frames
/// of its file or take, "kick@120:260" (half-open, either end may be left out). The result bears
/// the name. Throws Error that says what there is.
LibraryAction actionNamed(const MotionLibrary& library, std::string_view name);

}  // namespace kumite
