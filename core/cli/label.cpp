#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/cli/agreement.h"
#include "core/cli/command.h"
#include "core/formats/json_text.h"
#include "core/project/labelling.h"
#include "core/project/project_file.h"
#include "core/project/simulation.h"
#include "core/project/vocabulary_change.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string project, take, import, simulate, strategy = "active", vocabulary;
    double budget = 0.10;
    std::uint32_t seed = 1;
    int batch = QuerySettings().batch;
    bool automatic = false, merge = false, noMirror = false, limbFirst = false, json = false;
};

/// The take that is meant: by name, else the only one.
std::optional<int> chosenTake(const Project& project, const std::string& name) {
    if (!name.empty()) return takeNamed(project, name);
    return project.takes.size() == 1 ? std::optional<int>(0) : std::nullopt;
}

void useVocabulary(OpenProject& open, const Options& o, const Streams& streams) {
    if (o.vocabulary.empty()) return;
    const FileBytes file(o.vocabulary);
    Findings findings;
    const Vocabulary vocabulary = parseVocabulary(file.bytes(), o.vocabulary, &findings);
    for (const VocabularyLoss& loss : lostBy(open.project, vocabulary)) {
        findings.push_back(warning(vocabulary.name + " has no word for " + lossText(loss) + "."));
    }
    printFindings(findings, streams);
    if (auto edit = setVocabulary(open.project, vocabulary))
        open.project = std::move(edit->project);
}

void useLearning(OpenProject& open, const Options& o) {
    LearningSettings learning = open.project.labelling.learning;
    if (o.noMirror) learning.mirrored = false;
    if (o.limbFirst) learning.limbFirst = true;
    if (auto edit = setLearning(open.project, learning)) open.project = std::move(edit->project);
}

void runImport(OpenProject& open, const Options& o, const Streams& streams) {
    refuseToOverwrite(o.project, {o.import});
    Findings findings;
    const auto labels = readLabels(o.import, *open.project.labelling.vocabulary, &findings);
    const MatchedLabels matched =
        matchLabels(open.project, open.analysis, labels, chosenTake(open.project, o.take));
    findings.insert(findings.end(), matched.unmatched.begin(), matched.unmatched.end());
    printFindings(findings, streams);
    std::optional<Agreement> agreement;
    if (o.merge) {
        agreement = compareLabels(open.project, open.analysis,
                                  ownLabels(open.project, open.analysis), matched.fighters);
    }
    const auto bring = o.merge ? mergeLabels : importLabels;
    if (auto edit = bring(open.project, open.analysis, matched.fighters)) {
        open.project = std::move(edit->project);
    }
    if (o.json) {
        Json unmatched = Json::array();
        for (const Finding& finding : findings)
            unmatched.push_back(finding.text);
        Json json = {{"read", labels.size()},
                     {"matched", matched.matched},
                     {"unmatched", std::move(unmatched)}};
        if (agreement) json["agreement"] = agreementJson(open, *agreement);
        streams.out << json.dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
        return;
    }
    streams.out << fmt::format("{} of {} labels found their action\n", matched.matched,
                               labels.size());
    if (agreement) printAgreement(open, *agreement, streams);
}

void runAuto(OpenProject& open, const Options& o, const Streams& streams) {
    const AutoLabels result =
        labelAutomatically(open.project, open.analysis, streams.progress("learning"));
    if (result.examples == 0) {
        streams.err << "warning: nothing is labelled by hand yet: only the rules can speak.\n";
    }
    int actions = 0, byHand = 0;
    for (const FighterLabels& fighter : result.proposals.fighters) {
        actions += static_cast<int>(fighter.labels.size());
        for (const ActionLabel& label : fighter.labels)
            byHand += label.anyByHand();
    }
    if (auto edit = acceptLabels(open.project, open.analysis, result.proposals.fighters)) {
        open.project = std::move(edit->project);
    }
    if (auto edit = setModel(open.project, result.model)) open.project = std::move(edit->project);
    if (!o.json) {
        streams.out << fmt::format(
            "{} actions, {} labelled by hand; {:.0f} % of the examples would be found right\n",
            actions, byHand, 100 * result.expectedAccuracy);
        return;
    }
    streams.out << Json{{"actions", actions},
                        {"labelled_by_hand", byHand},
                        {"examples", result.examples},
                        {"expected_accuracy", rounded(result.expectedAccuracy)},
                        {"training_sha256", result.model.trainingHash}}
                       .dump(1)
                << "\n";
}

Json simulationJson(const Vocabulary& vocabulary, const Simulation& result) {
    Json aspects = Json::object();
    for (int a = 0; a < vocabulary.size(); ++a) {
        const AspectScore& score = result.scores.aspects[static_cast<std::size_t>(a)];
        aspects[vocabulary[a].id] = {{"accuracy", rounded(score.accuracy)},
                                     {"macro_f1", rounded(score.macroF1)},
                                     {"confusion", score.confusion}};
    }
    Json curve = Json::array();
    for (const CurvePoint& point : result.curve) {
        curve.push_back({{"labelled", point.labelled},
                         {"label_accuracy", rounded(point.labelAccuracy)},
                         {"limb_accuracy", rounded(point.limbAccuracy)},
                         {"expected_accuracy", rounded(point.expectedAccuracy)}});
    }
    return {
        {"actions", result.actions},
        {"boundaries_removed", result.removed},
        {"boundaries_added", result.added},
        {"labelled", result.labelled},
        {"labelled_share",
         rounded(result.actions > 0 ? static_cast<double>(result.labelled) / result.actions : 0.0)},
        {"judged", result.scores.actions},
        {"limb_accuracy", rounded(result.scores.limbAccuracy)},
        {"label_accuracy", rounded(result.scores.labelAccuracy)},
        {"baseline_accuracy", rounded(result.scores.baselineAccuracy)},
        {"aspects", std::move(aspects)},
        {"curve", std::move(curve)},
        {"stop_hint", result.stopHint ? Json(*result.stopHint) : Json(nullptr)}};
}

void printSimulation(const Vocabulary& vocabulary, const Simulation& result, double seconds,
                     const Streams& streams) {
    streams.out << "labelled  label accuracy  limb accuracy  expected\n";
    for (const CurvePoint& point : result.curve) {
        streams.out << fmt::format("{:8}  {:12.1f} %  {:11.1f} %  {:6.1f} %\n", point.labelled,
                                   100 * point.labelAccuracy, 100 * point.limbAccuracy,
                                   100 * point.expectedAccuracy);
    }
    streams.out << fmt::format(
        "{} of {} actions labelled ({} boundaries removed, {} added); the other {}: label {:.1f} "
        "%, limb {:.1f} %, all others {:.1f} %\n",
        result.labelled, result.actions, result.removed, result.added, result.scores.actions,
        100 * result.scores.labelAccuracy, 100 * result.scores.limbAccuracy,
        100 * result.scores.baselineAccuracy);
    for (int a = 0; a < vocabulary.size(); ++a) {
        const AspectScore& score = result.scores.aspects[static_cast<std::size_t>(a)];
        streams.out << fmt::format("  {:12}  accuracy {:5.1f} %  macro-F1 {:5.1f} %\n",
                                   vocabulary[a].id, 100 * score.accuracy, 100 * score.macroF1);
    }
    streams.out << fmt::format("{:.1f} s\n", seconds);
}

void runSimulation(const OpenProject& open, const Options& o, const Streams& streams) {
    const auto start = std::chrono::steady_clock::now();
    const auto take = chosenTake(open.project, o.take);
    if (!take) throw UsageError("Say which take the truth is about with --take NAME.");
    const Vocabulary& vocabulary = *open.project.labelling.vocabulary;
    const Truth truth{readLabels(o.simulate, vocabulary)};
    SimulationSettings settings;
    settings.active = o.strategy == "active";
    settings.budget = o.budget;
    settings.seed = o.seed;
    settings.query.batch = o.batch;
    settings.query.mirrored = open.project.labelling.learning.mirrored;
    const Simulation result =
        simulateSession(open.project, *take, truth, settings, streams.progress("labelling"));
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!o.json) {
        printSimulation(vocabulary, result, seconds, streams);
        return;
    }
    Json json = {{"strategy", o.strategy}, {"budget", o.budget}, {"seed", o.seed}};
    json.update(simulationJson(vocabulary, result));
    json["seconds"] = rounded(seconds);
    streams.out << json.dump(1) << "\n";
}

std::string share(const std::string& text) {
    const auto value = parseNumber(text);
    return value && *value > 0 && *value <= 1
               ? std::string()
               : "expected a share above 0 and at most 1, not " + text;
}

}  // namespace

void addLabel(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "label", "Labels actions: from a file, by the machine, or as a simulated session.");
    command->add_option("PROJECT", o->project, "a .kumite file")->required();
    auto* import = command->add_option(
        "--import", o->import, "labels to take over: .csv, .json, .eaf (ELAN) or a truth.json");
    auto* automatic = command->add_flag(
        "--auto", o->automatic, "learn from what a hand labelled and label the rest; hands stay");
    auto* simulate = command->add_option(
        "--simulate", o->simulate, "play a user who answers from this truth; changes nothing");
    import->excludes(automatic)->excludes(simulate);
    automatic->excludes(simulate);
    command
        ->add_flag("--merge", o->merge,
                   "with --import: another person's labels: fill in what is not labelled by hand "
                   "yet, keep the rest, and tell how far both agree")
        ->needs(import);
    command->add_option("--strategy", o->strategy, "with --simulate: active or random")
        ->check(CLI::IsMember({"active", "random"}))
        ->needs(simulate);
    command->add_option("--budget", o->budget, "with --simulate: share labelled by hand")
        ->check(share)
        ->needs(simulate);
    command->add_option("--batch", o->batch, "with --simulate: questions per round")
        ->check(CLI::Range(1, 1000))
        ->needs(simulate);
    command->add_option("--seed", o->seed, "with --simulate: of the random order")->needs(simulate);
    command->add_option("--take", o->take, "the take that labels without one belong to");
    command->add_option("--vocabulary", o->vocabulary, "another vocabulary, kept in the project");
    command->add_flag("--no-mirror", o->noMirror, "do not learn from mirror images");
    command->add_flag("--limb-first", o->limbFirst,
                      "find the striking limb first, then what it does");
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(
        "labels.csv: take,player,begin_s,end_s,label[,source,confidence]; a label is spelt\n"
        "right_punch:fwd+move:L-R, what it leaves out is \"others\".\n"
        "Examples: kumite label bout.kumite --import labels.csv\n"
        "          kumite label bout.kumite --auto\n"
        "          kumite label demo.kumite --simulate truth.json --strategy active --budget 0.1");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            if (o->import.empty() && o->simulate.empty() && !o->automatic &&
                o->vocabulary.empty()) {
                throw UsageError("Say what to do: --import FILE, --auto or --simulate TRUTH.");
            }
            OpenProject open = openProject(o->project, streams);
            const Project before = open.project;
            useVocabulary(open, *o, streams);
            useLearning(open, *o);
            if (!o->simulate.empty()) return runSimulation(open, *o, streams);
            if (!o->import.empty()) runImport(open, *o, streams);
            if (o->automatic) runAuto(open, *o, streams);
            if (open.project != before) saveProject(open.project, o->project);
        };
    });
}

}  // namespace kumite::cli
