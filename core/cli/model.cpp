#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/project/graph_export.h"
#include "core/project/model_report.h"

namespace kumite::cli {
namespace {

struct Options {
    std::string project, report, graph, split = "blocks", estimator = "EQU7";
    int seeds = ValidationSettings().seeds;
    std::uint32_t seed = ValidationSettings().seed;
    int components = ValidationSettings().components;
    bool target = false;
    double shrinkage = GeometrySettings().shrinkage;
    bool json = false;
};

/// Seconds since the last call.
class StopWatch {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - start_).count();
        start_ = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void printAverages(const Streams& streams, std::string_view name, const Averages& averages) {
    streams.out << fmt::format("  {:14}{:12}{:12}{:8}\n", name, fixed(averages.train, 3),
                               fixed(averages.validation, 3), fixed(averages.deviation, 3));
}

void printText(const ModelReport& report, const Streams& streams) {
    for (const int player : {0, 1}) {
        const PlayerSummary& p = report.players[static_cast<std::size_t>(player)];
        streams.out << fmt::format(
            "player {}: {} actions in {:.1f} s, {} labels, {} transitions; {:.0f} % labelled by "
            "hand, {:.1f} % of the minima corrected\n",
            player + 1, p.actions, p.seconds, p.labels, p.transitions, 100 * p.handShare(),
            100 * p.correctedShare());
    }
    const ValidationResult& r = report.validation;
    streams.out << fmt::format(
        "{} components cover {:.1f} % of the poses' variance, {} dimensions\n{} splits by {}: "
        "{:.0f} transitions a player to learn from, {:.0f} to judge by\n",
        report.settings.components, 100 * report.covered, report.settings.dimensions(), r.seeds,
        report.settings.split == SplitBy::Takes ? "takes" : "blocks", r.transitions[0],
        r.transitions[1]);
    streams.out << "label term, mean log P       train  validation      sd\n";
    for (const auto estimator : {LabelEstimator::Equ5, LabelEstimator::Equ6, LabelEstimator::Equ7,
                                 LabelEstimator::Uniform})
        printAverages(streams, estimatorName(estimator),
                      r.labelTerm[static_cast<std::size_t>(estimator)]);
    streams.out << "geometry term, mean log P    train  validation      sd\n";
    for (const auto kind : {CovarianceKind::Full, CovarianceKind::FullRaw, CovarianceKind::Diagonal,
                            CovarianceKind::SemiTied})
        printAverages(streams, covarianceName(kind),
                      r.geometryTerm[static_cast<std::size_t>(kind)]);
    printAverages(streams, "one Gaussian", r.pooled);
    streams.out << "gain over one Gaussian by k  train  validation      sd\n";
    for (const auto& row : r.components)
        printAverages(streams, std::to_string(row.k), row.gain);
    streams.out << "what the paper found\n";
    for (const PaperCheck& check : checkPaper(r))
        streams.out << fmt::format("  {:3} {} ({})\n", check.holds ? "yes" : "no", check.claim,
                                   check.figures);
    for (const auto& [stage, seconds] : report.seconds)
        streams.out << fmt::format("{} {:.2f} s  ", stage, seconds);
    streams.out << "\n";
}

LabelEstimator estimatorNamed(const std::string& name) {
    if (name == "EQU5") return LabelEstimator::Equ5;
    if (name == "EQU6") return LabelEstimator::Equ6;
    return LabelEstimator::Equ7;
}

void runModel(const Options& o, const Streams& streams) {
    for (const std::string& out : {o.report, o.graph}) {
        if (!out.empty()) refuseToOverwrite(out, {o.project});
    }
    StopWatch watch;
    ModelReport report;
    const OpenProject open = openProject(o.project, streams);
    report.seconds.emplace_back("reading", watch.lap());
    const Analysis analysis = analyse(open.project);
    report.seconds.emplace_back("segmentation", watch.lap());
    InteractionSettings settings;
    settings.estimator = estimatorNamed(o.estimator);
    settings.components = o.components;
    if (o.target) settings.numbers = TransitionNumbers::WithTarget;
    settings.geometry.shrinkage = o.shrinkage;
    const Interaction interaction =
        deriveInteraction(open.project, analysis, settings, {}, streams.progress("training"));
    report.seconds.emplace_back("graph_and_training", watch.lap());
    if (const auto why = whyNoModel(open.project, interaction)) throw Error(*why);
    printFindings(interaction.findings, streams);
    if (!o.graph.empty()) writeGraph(interaction, o.graph);
    if (!o.graph.empty() && o.report.empty() && !o.json) return;

    report.name =
        o.project.empty() ? "the demo bout" : std::filesystem::path(o.project).stem().string();
    report.findings = interaction.findings;
    report.covered = interaction.poses->covered(o.components);
    for (const int player : {0, 1})
        report.players[static_cast<std::size_t>(player)] =
            playerSummary(open.project, analysis, interaction, player);
    report.settings.seeds = o.seeds;
    report.settings.seed = o.seed;
    report.settings.split = o.split == "takes" ? SplitBy::Takes : SplitBy::Blocks;
    report.settings.components = o.components;
    report.settings.numbers = settings.numbers;
    report.settings.geometry = settings.geometry;
    watch.lap();
    report.validation =
        validateModel(analysis, interaction, report.settings, streams.progress("validating"));
    report.seconds.emplace_back("validation", watch.lap());
    if (!o.report.empty()) writeModelReport(report, interaction, o.report);
    if (o.json) {
        streams.out << modelJson(report);
    } else {
        printText(report, streams);
    }
}

}  // namespace

void addModel(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "model",
        "The coupled graph and what it teaches: who does what next, judged by cross-validation.");
    command->add_option("PROJECT", o->project, "a .kumite file with labels")->required();
    command->add_option("--report", o->report,
                        "folder for tables, pictures, the graph and report.md");
    command->add_option("--graph", o->graph,
                        "write the graph as .csv, .json or .graphml (alone: nothing else is done)");
    command->add_option("--seeds", o->seeds, "how many splits are drawn")
        ->check(CLI::Range(1, 1000));
    command->add_option("--seed", o->seed, "of the first split");
    command
        ->add_option("--split", o->split, "what is set apart as a whole: blocks of time or takes")
        ->check(CLI::IsMember({"blocks", "takes"}));
    command->add_option("--estimator", o->estimator, "label term of the graph: EQU5, EQU6 or EQU7")
        ->check(CLI::IsMember({"EQU5", "EQU6", "EQU7"}));
    command->add_option("--components", o->components, "principal components of the pose, k")
        ->check(CLI::Range(1, kPoseNumbers));
    command
        ->add_option(
            "--shrinkage", o->shrinkage,
            "τ, samples of what all labels vary that count with a label's own, and κ = τ/10 "
            "samples of their mean; 0: the plain method")
        ->check(CLI::Range(0.0, 1e6));
    command->add_flag(
        "--target", o->target,
        "geometry term of an avatar: two dimensions more, where the mover stands half "
        "a second later");
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(
        "Labels that count are those in the project: by hand, imported or accepted.\n"
        "Examples: kumite model bout.kumite --report report\n"
        "          kumite model bout.kumite --graph bout.graphml");
    command->callback(
        [o, &action] { action = [o](const Streams& streams) { runModel(*o, streams); }; });
}

}  // namespace kumite::cli
