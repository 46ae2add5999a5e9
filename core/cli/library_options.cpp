#include "core/cli/library_options.h"

#include <filesystem>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/project/kept_clip.h"
#include "core/project/project_file.h"

namespace kumite::cli {

void addLibraryOptions(CLI::App& command, LibraryOptions& options) {
    command
        .add_option("LIB", options.sources,
                    "motion files (.bvh, .amc), folders of them, projects (.kumite), in any mix")
        ->required();
    command.add_option("--rate", options.rate, "frames a second that all clips are brought to")
        ->check(CLI::Range(5.0, 240.0))
        ->capture_default_str();
}

std::shared_ptr<const MotionLibrary> openLibrary(const LibraryOptions& options,
                                                 const std::string& out, const Streams& streams) {
    LoadedLibrary loaded = loadLibrary({options.sources.begin(), options.sources.end()},
                                       {options.rate}, streams.progress("reading"));
    if (!out.empty()) refuseToOverwrite(out, loaded.files);
    printFindings(loaded.findings, streams);
    return std::make_shared<const MotionLibrary>(std::move(loaded.library));
}

std::optional<Project> projectWithDraft(const LibraryOptions& options, const std::string& kind) {
    for (const std::string& source : options.sources) {
        const std::filesystem::path path(source);
        if (lowerCase(path.extension().string()) != ".kumite") continue;
        const FileBytes file(source);
        Project project =
            parseProject(file.bytes(), source, std::filesystem::absolute(path).parent_path());
        if (project.drafts.count(kind) > 0) return project;
    }
    return std::nullopt;
}

void addGraphOptions(CLI::App& command, GraphOptions& options) {
    command
        .add_option("--threshold", options.threshold,
                    "pose distance that makes a cluster; else such that one holds 0.75 s")
        ->check(CLI::PositiveNumber);
    command.add_flag("--undirected", options.undirected, "clips may be played backward too");
}

std::shared_ptr<const FlexibleGraph> openGraph(std::shared_ptr<const MotionLibrary> library,
                                               const GraphOptions& options,
                                               const Streams& streams) {
    FlexibleGraphSettings settings;
    settings.threshold = options.threshold;
    settings.undirected = options.undirected;
    return buildFlexibleGraph(std::move(library), settings, streams.progress("clustering"));
}

void writeClip(const MotionLibrary& library, const Clip& clip, const std::string& path) {
    writeFileAtomically(path, clipText(library, clip));
}

}  // namespace kumite::cli
