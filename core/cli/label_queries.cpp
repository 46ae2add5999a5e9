#include "core/cli/label_queries.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/formats/json_text.h"
#include "core/labelling/distances.h"
#include "core/labelling/learning_curve.h"
#include "core/project/label_judgement.h"
#include "core/project/label_search.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

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

void printFound(const OpenProject& open, const std::string& typed, const std::string& only,
                bool json, const Streams& streams) {
    const LabelFilter filter = parseLabelFilter(filterWords(open.project), typed);
    std::vector<FoundAction> found = findActions(open.project, open.analysis, filter);
    if (!only.empty()) {
        const int index = takeNamed(open.project, only);
        std::erase_if(found, [&](const FoundAction& each) { return each.fighter.take != index; });
    }
    Json list = Json::array();
    for (const FoundAction& each : found) {
        const bool known = !each.match.aspects.empty();
        const std::string source(known ? sourceName(each.match.source) : "");
        if (json) {
            list.push_back(
                {{"take", take(open, each.fighter)},
                 {"player", each.fighter.player + 1},
                 {"action", each.action},
                 {"begin_s", rounded(each.begin)},
                 {"end_s", rounded(each.end)},
                 {"label", spelling(open, each.label())},
                 {"source", known ? Json(source) : Json(nullptr)},
                 {"confidence", known ? Json(rounded(each.match.confidence)) : Json(nullptr)}});
            continue;
        }
        streams.out << fmt::format(
            "{:10}  {}  {:4}  {:8} s  {:8} s  {:7}  {:5}  {}\n", take(open, each.fighter),
            each.fighter.player + 1, each.action, fixed(each.begin, 3), fixed(each.end, 3), source,
            known ? fixed(each.match.confidence, 2) : "", spelling(open, each.label()));
    }
    if (json) {
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

void printJudgement(const OpenProject& open, bool curve, bool asJson, const Streams& streams) {
    const Vocabulary& vocabulary = *open.project.labelling.vocabulary;
    const ActionTable table = actionTable(open.project, open.analysis);
    const std::vector<Example> examples = handExamples(open.project, open.analysis, table);
    const ParameterSet parameters = parametersOf(open.project);
    const TrainingSet set(vocabulary, table.features, examples, open.project.labelling.learning);
    const Proposals proposals =
        propose(open.project, open.analysis, table, set.predict(parameters, false));
    const HandJudgement judgement =
        judgeHandLabels(open.project, open.analysis, table, parameters, proposals,
                        streams.progress("judging").part(0, curve ? 0.2 : 1));
    Json json = {{"hand_labelled", examples.size()},
                 {"label_accuracy", rounded(judgement.scores.labelAccuracy)}};
    if (!asJson) {
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
        if (asJson) continue;
        streams.out << fmt::format("  {:12}  accuracy {:5.1f} %  macro-F1 {:5.1f} %\n",
                                   vocabulary[a].id, 100 * score.accuracy, 100 * score.macroF1);
    }
    if (curve) {
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
            if (asJson) continue;
            streams.out << fmt::format("{:5} labels  asked {:5.1f} %  random {:5.1f} %\n",
                                       point.labelled, 100 * point.asked, 100 * point.random);
        }
        const auto gain = orderGain(curves);
        json["gain"] = gain ? Json{{"asked", gain->asked}, {"random", gain->random}} : Json();
        if (gain && !asJson) {
            streams.out << fmt::format("{} labels as asked do what {} in random order do\n",
                                       gain->asked, gain->random);
        }
    }
    if (asJson) streams.out << json.dump(1) << "\n";
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
        if (table.rows[row].fighter == fighter && table.rows[row].action == *action)
            return static_cast<int>(row);
    }
    throw Error(fmt::format("There is no action {} of player {}.", *action, *player));
}

void printSimilar(const OpenProject& open, const LabelQuery& query, bool json,
                  const Streams& streams) {
    const ActionTable table = actionTable(open.project, open.analysis);
    const int row = rowNamed(open, table, query.similar);
    const std::vector<FoundAction> all = findActions(open.project, open.analysis, LabelFilter());
    const ActionDistances distances(table.features, open.project.labelling.learning.mirrored);
    Json list = Json::array();
    for (const auto& each : distances.nearest(row, query.count)) {
        const auto& [fighter, action] = table.rows[static_cast<std::size_t>(each.row)];
        const auto found =
            std::find_if(all.begin(), all.end(),
                         [&, address = fighter, index = action](const FoundAction& other) {
                             return other.fighter == address && other.action == index;
                         });
        const std::string label = spelling(open, found->label());
        list.push_back({{"take", take(open, fighter)},
                        {"player", fighter.player + 1},
                        {"action", action},
                        {"begin_s", rounded(found->begin)},
                        {"distance", rounded(each.distance)},
                        {"mirrored", each.mirrored},
                        {"label", label}});
        if (json) continue;
        streams.out << fmt::format("{:10}  {}  {:4}  {:8} s  distance {:.2f}{}  {}\n",
                                   take(open, fighter), fighter.player + 1, action,
                                   fixed(found->begin, 3), each.distance,
                                   each.mirrored ? " mirrored" : "         ", label);
    }
    if (json) {
        streams.out << Json{{"similar", std::move(list)}}.dump(1, ' ', false,
                                                               Json::error_handler_t::replace)
                    << "\n";
    }
}

}  // namespace

void addLabelQueries(CLI::App& command, LabelQuery& query) {
    command.add_option("--filter", query.filter,
                       "list the actions that this lets through, as one types it");
    auto* similar = command.add_option("--similar", query.similar,
                                       "list the actions most like TAKE:PLAYER:ACTION");
    command.add_option("--count", query.count, "with --similar: how many")
        ->check(CLI::Range(1, 1000))
        ->needs(similar);
    command.add_flag("--judge", query.judge,
                     "hold machines that had not seen a hand label against it, and the rules");
    command.add_flag("--curve", query.curve,
                     "the same, and accuracy over labels given, as asked and in random order");
}

void answerLabelQuery(const OpenProject& open, const LabelQuery& query, const std::string& take,
                      bool json, const Streams& streams) {
    if (!query.filter.empty()) return printFound(open, query.filter, take, json, streams);
    if (!query.similar.empty()) return printSimilar(open, query, json, streams);
    printJudgement(open, query.curve, json, streams);
}

}  // namespace kumite::cli
