#include <fmt/format.h>

#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/project/edits.h"
#include "core/project/project_file.h"
#include "core/project/report.h"

namespace kumite::cli {
namespace {

/// Accepts numbers above a bound, or from it on.
std::function<std::string(const std::string&)> numberFrom(double bound, bool inclusive) {
    return [bound, inclusive](const std::string& text) {
        const auto value = parseNumber(text);
        if (value && (inclusive ? *value >= bound : *value > bound)) return std::string();
        return fmt::format("expected a number {} {:g}, not {}", inclusive ? "from" : "above", bound,
                           text);
    };
}

void printText(const OpenProject& open, const Streams& streams) {
    if (open.project.takes.empty()) streams.out << "The project has no take yet.\n";
    for (std::size_t t = 0; t < open.project.takes.size(); ++t) {
        const Take& take = open.project.takes[t];
        for (std::size_t p = 0; p < take.fighters.size(); ++p) {
            const FighterAnalysis& fighter = open.analysis.takes[t][p];
            const std::string who = fmt::format("take {}, fighter {}", take.name, p + 1);
            if (!fighter.available()) {
                streams.out << who << ": the recording is missing\n";
                continue;
            }
            const Segmentation& cut = *fighter.segmentation;
            streams.out << fmt::format(
                "{}: {} actions in {:.2f} s; {} boundaries removed, {} corrections, {} without a "
                "minimum; {:.0f} % of the body's mass\n",
                who, cut.actions.size(), fighter.frameCount() / fighter.input.rate,
                cut.removed.size(), fighter.input.corrections.size(), cut.unmatched.size(),
                100 * fighter.body->com.massCoverage);
            for (const Correction& correction : cut.unmatched) {
                streams.out << "  no minimum any more: " << correctionText(correction) << "\n";
            }
        }
    }
}

}  // namespace

void addSegment(CLI::App& app, Action& action) {
    struct Options {
        std::string project;
        std::optional<double> cutoff, prominence;
        bool json = false, all = false, save = false, csv = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "segment", "Minima of the contact force, boundaries and actions of all takes.");
    command->add_option("PROJECT", o->project, "a .kumite file; none: the demo bout");
    command->add_option("--cutoff", o->cutoff, "low-pass cutoff in Hz, for this run")
        ->check(numberFrom(0, false));
    command
        ->add_option("--prominence", o->prominence,
                     "prominence that makes a minimum a boundary, body weights, for this run")
        ->check(numberFrom(0, true));
    command->add_flag("--save", o->save, "keep --cutoff and --prominence in the project");
    CLI::Option* json = command->add_flag("--json", o->json, "one JSON object on standard output");
    command->add_flag("--csv", o->csv, "the actions as a table on standard output")->excludes(json);
    command->add_flag("--all-minima", o->all, "with --json: also minima below the threshold")
        ->needs(json);
    command->footer("Example: kumite segment bout.kumite --prominence 0.08 --json");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            OpenProject open = openProject(o->project, streams);
            if (o->save && open.isDemo) {
                throw UsageError("--save needs a project; the demo bout is made anew each time.");
            }
            SegmentationSettings settings = open.project.segmentation;
            settings.cutoff = o->cutoff.value_or(settings.cutoff);
            settings.prominence = o->prominence.value_or(settings.prominence);
            if (auto edit = setSegmentation(open.project, settings)) {
                open.project = std::move(edit->project);
                open.analysis = analyse(open.project, open.analysis);
                if (o->save) printFindings(saveProject(open.project, open.path), streams);
            }
            printFindings(smoothingFindings(open.project, open.analysis), streams);
            if (o->json) {
                streams.out << segmentationJson(open.project, open.analysis, {{}, o->all});
            } else if (o->csv) {
                streams.out << actionsCsv(open.project, open.analysis, {});
            } else {
                printText(open, streams);
            }
        };
    });
}

}  // namespace kumite::cli
