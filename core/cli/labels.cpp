// kumite labels: writes labels, finds actions by them, and says how well they are known.
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/labelling/distances.h"
#include "core/labelling/learning_curve.h"
#include "core/project/label_files.h"
#include "core/project/label_judgement.h"
#include "core/project/label_search.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string project, take, out, filter, similar;
    int count = 6;
    bool judge = false, curve = false, json = false;
};

double rounded(double value) {
    return std::round(1e6 * value) / 1e6;
}

std::string take(const OpenProject& open, FighterAddress fighter) {
    return open.project.takes[static_cast<std::size_t>(fighter.take)].name;
}

std::string spelling(const OpenProject& open, const Label& label) {
    return labelText(*open.project.labelling.vocabulary, label, true);
}

ParameterSet parametersOf(const Project& project) {
    return project.labelling.model ? project.labelling.model->parameters
                                   : defaultParameters(*project.labelling.vocabulary);
}

void printFound(const OpenProject& open, const Options& o, const Streams& streams) {
    const LabelFilter filter = parseLabelFilter(filterWords(open.project), o.filter);
    std::vector<FoundAction> found = findActions(open.project, open.analysis, filter);
    if (!o.take.empty()) {
        const int only = takeNamed(open.project, o.take);
        std::erase_if(found, [&](const FoundAction& each) { return each.fighter.take != only; });
    }
    Json list = Json::array();
    for (const FoundAction& each : found) {
        const bool known = !each.match.aspects.empty();
        const std::string source(known ? sourceName(each.match.source) : "");
        if (o.json) {
            list.push_back(
                {{"take", take(open, each.fighter)},
                 {"player", each.fighter.player + 1},
                 {"action", each.action + 1},
                 {"begin_s", rounded(each.begin)},
                 {"end_s", rounded(each.end)},
                 {"label", spelling(open, each.label())},
                 {"source", known ? Json(source) : Json(nullptr)},
                 {"confidence", known ? Json(rounded(each.match.confidence)) : Json(nullptr)}});
            continue;
        }
        streams.out << fmt::format(
            "{:10}  {}  {:4}  {:8} s  {:8} s  {:7}  {:5}  {}\n", take(open, each.fighter),
            each.fighter.player + 1, each.action + 1, fixed(each.begin, 3), fixed(each.end, 3),
            source, known ? fixed(each.match.confidence, 2) : "", spelling(open, each.label()));
    }
    if (o.json) {
        streams.out << Json{{"filter", filter.text()},
                            {"count", found.size()},
                            {"actions", std::move(list)}}
                           .dump(1, ' ', false, Json::error_handler_t::replace)
                    << "\n";
    } else {
        streams.out << fmt::format("{} {}\n", found.size(),
                                   found.size() == 1 ? "action" : "actions");
    }
}

void printJudgement(const OpenProject& open, const Options& o, const Streams& streams) {
    const Vocabulary& vocabulary = *open.project.labelling.vocabulary;
    const ActionTable table = actionTable(open.project, open.analysis);
    const std::vector<Example> examples = handExamples(open.project, open.analysis, table);
    const ParameterSet parameters = parametersOf(open.project);
    const TrainingSet set(vocabulary, table.features, examples, open.project.labelling.learning);
    const Proposals proposals =
        propose(open.project, open.analysis, table, set.predict(parameters, false));
    const HandJudgement judgement =
        judgeHandLabels(open.project, open.analysis, table, parameters, proposals,
                        streams.progress("judging").part(0, o.curve ? 0.2 : 1));
    Json json = {{"hand_labelled", examples.size()},
                 {"label_accuracy", rounded(judgement.scores.labelAccuracy)}};
    if (!o.json) {
        streams.out << fmt::format("{} actions labelled by hand; whole label {:.1f} %\n",
                                   examples.size(), 100 * judgement.scores.labelAccuracy);
    }
    for (int a = 0; a < vocabulary.size(); ++a) {
        const AspectScore& score = judgement.scores.aspects[static_cast<std::size_t>(a)];
        Json names = Json::array();
        for (const Qualifier& qualifier : vocabulary[a].qualifiers)
            names.push_back(qualifier.id);
        json["aspects"][vocabulary[a].id] = {{"accuracy", rounded(score.accuracy)},
                                             {"macro_f1", rounded(score.macroF1)},
                                             {"qualifiers", std::move(names)},
                                             {"confusion", score.confusion}};
        if (o.json) continue;
        streams.out << fmt::format("  {:12}  accuracy {:5.1f} %  macro-F1 {:5.1f} %\n",
                                   vocabulary[a].id, 100 * score.accuracy, 100 * score.macroF1);
    }
    if (o.curve) {
        const OrderCurves curves =
            orderCurves(vocabulary, table.features, examples, open.project.labelling.learning,
                        parameters, streams.progress("judging").part(0.2, 1));
        if (curves.points.empty()) {
            streams.err << fmt::format("note: a learning curve needs {} hand labels.\n",
                                       kFewestForCurves);
        }
        json["curve"] = Json::array();
        for (const OrderPoint& point : curves.points) {
            json["curve"].push_back({{"labelled", point.labelled},
                                     {"asked", rounded(point.asked)},
                                     {"random", rounded(point.random)}});
            if (o.json) continue;
            streams.out << fmt::format("{:5} labels  asked {:5.1f} %  random {:5.1f} %\n",
                                       point.labelled, 100 * point.asked, 100 * point.random);
        }
        const auto gain = orderGain(curves);
        json["gain"] = gain ? Json{{"asked", gain->asked}, {"random", gain->random}} : Json();
        if (gain && !o.json) {
            streams.out << fmt::format("{} labels as asked do what {} in random order do\n",
                                       gain->asked, gain->random);
        }
    }
    if (o.json) streams.out << json.dump(1) << "\n";
}

/// Row of the table that "take:player:action" names.
int rowNamed(const OpenProject& open, const ActionTable& table, const std::string& text) {
    const auto parts = split(text, ':');
    const auto player = parts.size() >= 3 ? parseInteger(parts[parts.size() - 2]) : std::nullopt;
    const auto action = parts.size() >= 3 ? parseInteger(parts.back()) : std::nullopt;
    if (!player || !action) throw UsageError("--similar takes TAKE:PLAYER:ACTION, not " + text);
    const std::size_t length = text.size() - parts.back().size() - parts[parts.size() - 2].size();
    const FighterAddress fighter = fighterNamed(open.project, text.substr(0, length - 2), *player);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.rows[row].fighter == fighter && table.rows[row].action == *action - 1)
            return static_cast<int>(row);
    }
    throw Error(fmt::format("There is no action {} of player {}.", *action, *player));
}

void printSimilar(const OpenProject& open, const Options& o, const Streams& streams) {
    const ActionTable table = actionTable(open.project, open.analysis);
    const int row = rowNamed(open, table, o.similar);
    const std::vector<FoundAction> all = findActions(open.project, open.analysis, LabelFilter());
    const ActionDistances distances(table.features, open.project.labelling.learning.mirrored);
    Json list = Json::array();
    for (const auto& each : distances.nearest(row, o.count)) {
        const auto& [fighter, action] = table.rows[static_cast<std::size_t>(each.row)];
        const auto found =
            std::find_if(all.begin(), all.end(),
                         [&, address = fighter, index = action](const FoundAction& other) {
                             return other.fighter == address && other.action == index;
                         });
        const std::string label = spelling(open, found->label());
        list.push_back({{"take", take(open, fighter)},
                        {"player", fighter.player + 1},
                        {"action", action + 1},
                        {"begin_s", rounded(found->begin)},
                        {"distance", rounded(each.distance)},
                        {"mirrored", each.mirrored},
                        {"label", label}});
        if (o.json) continue;
        streams.out << fmt::format("{:10}  {}  {:4}  {:8} s  distance {:.2f}{}  {}\n",
                                   take(open, fighter), fighter.player + 1, action + 1,
                                   fixed(found->begin, 3), each.distance,
                                   each.mirrored ? " mirrored" : "         ", label);
    }
    if (o.json) {
        streams.out << Json{{"similar", std::move(list)}}.dump(1, ' ', false,
                                                               Json::error_handler_t::replace)
                    << "\n";
    }
}

void run(const Options& o, const Streams& streams) {
    if (o.out.empty() && o.filter.empty() && o.similar.empty() && !o.judge && !o.curve) {
        throw UsageError(
            "Say what to do: --out FILE, --filter TEXT, --similar ACTION, --judge or "
            "--curve.");
    }
    const OpenProject open = openProject(o.project, streams);
    if (!o.out.empty()) {
        refuseToOverwrite(o.out, {o.project});
        std::optional<int> only;
        if (!o.take.empty()) only = takeNamed(open.project, o.take);
        writeLabels(open.project, open.analysis, only, o.out);
    }
    if (!o.filter.empty()) printFound(open, o, streams);
    if (!o.similar.empty()) printSimilar(open, o, streams);
    if (o.judge || o.curve) printJudgement(open, o, streams);
}

}  // namespace

void addLabels(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "labels", "Writes labels, finds actions by them, says how well they are known.");
    command->add_option("PROJECT", o->project, "a .kumite file")->required();
    command->add_option("--out", o->out, "file to write: .csv, .json or .eaf (ELAN, one take)");
    command->add_option("--take", o->take, "only this take");
    auto* filter = command->add_option("--filter", o->filter,
                                       "list the actions that this lets through, as one types it");
    auto* similar = command->add_option("--similar", o->similar,
                                        "list the actions most like TAKE:PLAYER:ACTION");
    command->add_option("--count", o->count, "with --similar: how many")
        ->check(CLI::Range(1, 1000))
        ->needs(similar);
    auto* judge =
        command->add_flag("--judge", o->judge,
                          "hold machines that had not seen a hand label against it, and the rules");
    auto* curve = command->add_flag(
        "--curve", o->curve, "also accuracy over labels given, as asked and in random order");
    filter->excludes(similar)->excludes(judge)->excludes(curve);
    similar->excludes(judge)->excludes(curve);
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(
        "A filter: \"right kick up, machine, below 0.6\", \"player 2, jump, uncertain\",\n"
        "\"kick or punch, not by hand, after 1:20\", \"unlabelled\". All parts must hold; source\n"
        "and confidence are those of the aspects that are named, else the least of all.\n"
        "Actions count from 1.\n"
        "Examples: kumite labels bout.kumite --out labels.csv\n"
        "          kumite labels bout.kumite --filter \"kick, by machine, below 0.6\"\n"
        "          kumite labels bout.kumite --similar sparring:1:12");
    command->callback([o, &action] { action = [o](const Streams& streams) { run(*o, streams); }; });
}

}  // namespace kumite::cli
