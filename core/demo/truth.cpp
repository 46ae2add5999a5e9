#include "core/demo/truth.h"

#include <nlohmann/json.hpp>

namespace kumite::demo {
namespace {

using Json = nlohmann::ordered_json;

Json ranges(const std::vector<FrameRange>& all) {
    Json json = Json::array();
    for (const FrameRange& range : all)
        json.push_back({range.begin, range.end});
    return json;
}

Json actionJson(const TrueAction& action) {
    Json json;
    json["begin"] = action.begin;
    json["end"] = action.end;
    json["peak"] = action.peak;
    for (const auto& [aspect, qualifier] : action.label)
        json["label"][aspect] = qualifier;
    if (!action.manner.empty()) json["manner"] = action.manner;
    if (!action.own.empty()) {
        json["chosen"] = {
            {"own", action.own}, {"opponent", action.opponent}, {"range", action.range}};
    }
    return json;
}

Json hitJson(const TrueHit& hit) {
    return {{"frame", hit.frame},
            {"limb", hit.limb},
            {"target", hit.target},
            {"outcome", hit.outcome},
            {"point", {hit.point.x(), hit.point.y(), hit.point.z()}}};
}

Json playerJson(const TruePlayer& player) {
    Json json;
    json["boundaries"] = player.boundaries;
    json["spurious"] = player.spurious;
    json["actions"] = Json::array();
    for (const TrueAction& action : player.actions)
        json["actions"].push_back(actionJson(action));
    json["contacts"] = {{"left", ranges(player.contacts[0])},
                        {"right", ranges(player.contacts[1])}};
    json["hits"] = Json::array();
    for (const TrueHit& hit : player.hits)
        json["hits"].push_back(hitJson(hit));
    return json;
}

}  // namespace

std::string truthText(const Truth& truth) {
    Json json;
    json["rate"] = truth.rate;
    json["seed"] = truth.seed;
    json["players"] = Json::array();
    for (const TruePlayer& player : truth.players)
        json["players"].push_back(playerJson(player));
    json["process"] = Json::array();
    for (const ProcessRow& row : truth.process) {
        Json next = Json::object();
        for (const auto& [label, probability] : row.next)
            next[label] = probability;
        json["process"].push_back({{"mover", row.mover},
                                   {"own", row.own},
                                   {"opponent", row.opponent},
                                   {"range", row.range},
                                   {"next", std::move(next)}});
    }
    return json.dump(1) + "\n";
}

}  // namespace kumite::demo
