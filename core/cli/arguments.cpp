#include <fmt/format.h>

#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/project/demo_bout.h"
#include "core/project/project_file.h"

namespace kumite::cli {

Progress Streams::progress(const std::string& what) const {
    if (!errIsTerminal) return {};
    Progress progress;
    progress.report = [this, what, shown = -1](double fraction) mutable {
        const int percent = static_cast<int>(100 * fraction);
        if (percent == shown) return;
        shown = percent;
        err << (percent < 100 ? fmt::format("\r{} {} %", what, percent)
                              : "\r" + std::string(what.size() + 6, ' ') + "\r")
            << std::flush;
    };
    return progress;
}

void printFindings(const Findings& findings, const Streams& streams) {
    for (const Finding& finding : findings) {
        streams.err << (finding.severity == Severity::Note ? "note: " : "warning: ") << finding.text
                    << "\n";
    }
}

OpenProject openProject(const std::string& path, const Streams& streams) {
    OpenProject open;
    open.path = path;
    open.isDemo = path.empty();
    if (open.isDemo) {
        printFindings({note("No project was named: this is the demo bout.")}, streams);
        const auto progress = streams.progress("making the demo bout");
        open.path = writeDemoBout({}, demoFolder(), progress).project().string();
    }
    LoadedProject loaded = loadProject(open.path, streams.progress("reading"));
    printFindings(loaded.findings, streams);
    open.project = std::move(loaded.project);
    open.analysis = analyse(open.project, {}, streams.progress("computing"));
    return open;
}

FighterAddress fighterNamed(const Project& project, const std::string& take, int player) {
    FighterAddress address;
    if (take.empty()) {
        if (project.takes.size() != 1)
            throw UsageError("Say which take is meant with --take NAME.");
    } else {
        address.take = takeNamed(project, take);
    }
    const Take& chosen = project.takes[static_cast<std::size_t>(address.take)];
    if (player < 1 || player > static_cast<int>(chosen.fighters.size())) {
        throw Error(fmt::format("Take \"{}\" has {} fighter{}: there is no player {}.", chosen.name,
                                chosen.fighters.size(), chosen.fighters.size() == 1 ? "" : "s",
                                player));
    }
    address.player = player - 1;
    return address;
}

FrameRange parseRange(const std::string& text) {
    const auto parts = split(text, ':');
    const auto bound = [&](std::string_view part, int missing) -> int {
        if (part.empty()) return missing;
        const auto value = parseInteger(part);
        if (!value || *value < 0) {
            throw UsageError("\"" + text + "\" is no range of frames, expected A:B.");
        }
        return *value;
    };
    if (parts.size() != 2) {
        throw UsageError("\"" + text + "\" is no range of frames, expected A:B.");
    }
    const FrameRange range{bound(parts[0], 0), bound(parts[1], -1)};
    if (range.end >= 0 && range.empty()) {
        throw UsageError("The range \"" + text + "\" holds no frame.");
    }
    return range;
}

}  // namespace kumite::cli
