#include "core/formats/json_text.h"
#include "core/synthesis/bout_tape.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

std::string_view barredName(Barred barred) {
    switch (barred) {
        case Barred::No:
            break;
        case Barred::NoSample:
            return "no sample";
        case Barred::Mode:
            return "mode";
        case Barred::Command:
            return "command";
        case Barred::Stance:
            return "stance";
        case Barred::Ban:
            return "ban";
    }
    return "";
}

/// Where an action of B stands in the recordings. Frames of the take.
Json sampleJson(const CoupledGraph& graph, int player, int action) {
    const BasicAction& basic = graph.action(player, action);
    return {{"take", graph.takes[static_cast<std::size_t>(basic.take)]},
            {"begin", basic.frames.begin},
            {"end", basic.frames.end}};
}

Json labelJson(const CoupledGraph& graph, int player, int node) {
    return node == kAnyNode ? Json(nullptr) : Json(graph.node(player, node).text);
}

Json optionJson(const CoupledGraph& graph, int player, const Option& option) {
    const ChoiceModel::Candidate& candidate = option.candidate;
    Json json = {{"label", graph.node(player, candidate.node).text},
                 {"label_term", rounded(candidate.label)},
                 {"geometry_term", rounded(candidate.geometry)},
                 {"product", rounded(candidate.product)},
                 {"chance", rounded(option.chance)}};
    if (option.barred != Barred::No) json["barred"] = barredName(option.barred);
    if (candidate.transition >= 0) {
        const auto& all = graph.transitionsOf(player);
        json["sample"] =
            sampleJson(graph, player, all[static_cast<std::size_t>(candidate.transition)].next);
    }
    return json;
}

Json choiceJson(const CoupledGraph& graph, const BoutChoice& choice) {
    Json json = {{"frame", choice.frame},
                 {"player", choice.player + 1},
                 {"own", labelJson(graph, choice.player, choice.own)},
                 {"opponent", labelJson(graph, 1 - choice.player, choice.opponent)},
                 {"chosen", labelJson(graph, choice.player, choice.node)},
                 {"sample", sampleJson(graph, choice.player, choice.action)}};
    if (choice.options.options.empty()) json["replayed"] = true;
    if (choice.forced) json["forced"] = true;
    if (choice.commanded) json["commanded"] = true;
    if (choice.steered) json["steered"] = true;
    if (choice.options.stanceGaveWay) json["stance_gave_way"] = true;
    if (choice.options.commandGaveWay) json["command_gave_way"] = true;
    if (choice.options.banGaveWay) json["ban_gave_way"] = true;
    json["number"] = choice.number;
    json["distance_m"] = rounded(choice.distance);
    json["turn_rad"] = rounded(choice.turn);
    json["join_s"] = rounded(choice.joinSeconds);
    if (choice.coupling) {
        json["coupling"] = {{"warp", rounded(choice.coupling->meeting.own)},
                            {"other_warp", rounded(choice.coupling->meeting.other)},
                            {"lag_s", rounded(choice.coupling->lag)},
                            {"missed_s", rounded(choice.coupling->meeting.error)}};
    }
    Json& list = json["candidates"] = Json::array();
    for (const Option& option : choice.options.options)
        list.push_back(optionJson(graph, choice.player, option));
    return json;
}

}  // namespace

std::string boutLog(const BoutTape& tape) {
    const BoutLibrary& library = tape.first().library();
    const CoupledGraph& graph = *library.graph;
    const BoutSettings& settings = tape.first().settings();
    Json json = {{"kumite_bout", 1},
                 {"model", library.hash},
                 {"rate", library.rate},
                 {"frames", tape.end() + 1},
                 {"mode", modeName(settings.mode)},
                 {"seed", settings.seed},
                 {"temperature", settings.temperature},
                 {"score", settings.score == ChoiceScore::Evidence ? "evidence" : "best_sample"},
                 {"coupling", settings.coupling},
                 {"foot_locking", settings.footLocking},
                 {"separation", settings.separation}};
    if (settings.mode == BoutMode::Avatar) {
        json["avatar"] = settings.avatar + 1;
        json["react_first"] = settings.reactFirst;
    }
    if (settings.mode == BoutMode::Passive) {
        json["attacker"] = settings.attacker + 1;
        Json& attack = json["attack"] = Json::array();
        for (const int action : settings.attack)
            attack.push_back(sampleJson(graph, settings.attacker, action));
    }
    Json& start = json["start"] = Json::array();
    for (const int player : {0, 1}) {
        const FighterShown& shown = tape.first().shown(player);
        Json fighter = sampleJson(graph, player, shown.action);
        fighter["label"] = labelJson(graph, player, shown.node);
        fighter["shown"] = -shown.actionBegin;
        start.push_back(std::move(fighter));
    }
    json["commands"] = Json::parse(scriptText(tape.commands(), library.rate))["commands"];
    Json& choices = json["choices"] = Json::array();
    for (const auto& choice : tape.choices())
        choices.push_back(choiceJson(graph, *choice));
    return prettyJson(json);
}

}  // namespace kumite
