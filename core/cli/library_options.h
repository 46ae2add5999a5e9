#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cli/command.h"
#include "core/project/library.h"
#include "core/transition/flexible_graph.h"

namespace kumite::cli {

/// What a LIB is, for commands that work on a library of motions.
struct LibraryOptions {
    std::vector<std::string> sources;
    double rate = 30;
};
void addLibraryOptions(CLI::App& command, LibraryOptions& options);

/// Reads the library; findings are printed. A result may not be written to `out` if that is one of
/// the files that were read: throws Error.
std::shared_ptr<const MotionLibrary> openLibrary(const LibraryOptions& options,
                                                 const std::string& out, const Streams& streams);

/// The first of the sources that is a project and holds a draft of that kind ("keys").
std::optional<Project> projectWithDraft(const LibraryOptions& options, const std::string& kind);

/// How the pose clusters and the graph over them are made.
struct GraphOptions {
    std::optional<double> threshold;
    bool undirected = false;
};
void addGraphOptions(CLI::App& command, GraphOptions& options);

std::shared_ptr<const FlexibleGraph> openGraph(std::shared_ptr<const MotionLibrary> library,
                                               const GraphOptions& options, const Streams& streams);

/// Writes a clip on the library's rig with the channels of the skeleton that lent it.
void writeClip(const MotionLibrary& library, const Clip& clip, const std::string& path);

}  // namespace kumite::cli
