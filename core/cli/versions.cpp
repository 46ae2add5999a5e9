#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/cli/command.h"
#include "core/project/edits.h"
#include "core/project/versions.h"

namespace kumite::cli {
namespace {

std::string momentOf(const KeptVersion& version) {
    return fmt::format("{:%Y-%m-%d %H:%M:%S}",
                       fmt::localtime(std::chrono::system_clock::to_time_t(version.saved)));
}

void list(const std::vector<KeptVersion>& versions, bool asJson, std::ostream& out) {
    if (asJson) {
        auto rows = nlohmann::ordered_json::array();
        for (const KeptVersion& version : versions) {
            rows.push_back({{"file", version.file.string()},
                            {"saved", momentOf(version)},
                            {"takes", version.takes},
                            {"corrections", version.corrections}});
        }
        out << nlohmann::ordered_json{{"versions", rows}}.dump(2) << "\n";
        return;
    }
    if (versions.empty()) out << "No earlier version is kept; every save keeps the one before.\n";
    for (std::size_t i = 0; i < versions.size(); ++i) {
        const KeptVersion& version = versions[i];
        out << fmt::format("{:2}  {}  {}\n", i + 1, momentOf(version),
                           version.problem.empty() ? fmt::format("takes {}, corrections {}",
                                                                 version.takes, version.corrections)
                                                   : version.problem);
    }
}

void restore(const std::string& project, int number, const Streams& streams) {
    const auto versions = keptVersions(project);
    if (number < 1 || number > static_cast<int>(versions.size())) {
        throw Error(fmt::format("{}: there is no version {}; {} are kept.", project, number,
                                versions.size()));
    }
    const KeptVersion& version = versions[static_cast<std::size_t>(number - 1)];
    const LoadedProject loaded = loadVersion(project, version, {}, streams.progress("reading"));
    printFindings(loaded.findings, streams);
    printFindings(saveProject(loaded.project, project), streams);
    streams.out << "Restored the version of " << momentOf(version)
                << "; what was saved before it is kept as a version.\n";
}

}  // namespace

void addVersions(CLI::App& app, Action& action) {
    struct Options {
        std::string project;
        int restore = 0;
        bool json = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "versions", "Lists the last ten states of a project that were saved over; restores one.");
    command->add_option("PROJECT", o->project, "a .kumite file")->required();
    CLI::Option* which =
        command->add_option("--restore", o->restore, "number in the list, 1 is the newest");
    command->add_flag("--json", o->json, "one JSON object on standard output")->excludes(which);
    command->footer("Example: kumite versions bout.kumite --restore 1");
    command->callback([o, which, &action] {
        action = [o, asked = which->count() > 0](const Streams& streams) {
            if (asked) {
                restore(o->project, o->restore, streams);
            } else {
                list(keptVersions(o->project), o->json, streams.out);
            }
        };
    });
}

}  // namespace kumite::cli
