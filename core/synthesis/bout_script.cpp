#include <algorithm>
#include <cmath>

#include "core/formats/json_text.h"
#include "core/synthesis/bout_settings.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;
using Kind = BoutCommand::Kind;

BoutCommand readCommand(const JsonReader& json, double rate) {
    BoutCommand command;
    const double seconds = json["at"].number();
    if (seconds < 0 || seconds > 1e6) throw json["at"].error("expected seconds, 0 or more");
    command.frame = static_cast<int>(std::lround(seconds * rate));
    std::vector<std::string> allowed = {"at"};
    const auto is = [&](const char* word) {
        if (!json.has(word)) return false;
        allowed.push_back(word);
        return true;
    };
    const auto player = [&] {
        allowed.push_back("player");
        const int number = json["player"].integer();
        if (number != 1 && number != 2) throw json["player"].error("expected 1 or 2");
        command.player = number - 1;
    };
    if (is("act")) {
        command.kind = Kind::Act;
        command.words = json["act"].text();
    } else if (is("release")) {
        command.kind = Kind::Release;
    } else if (is("target")) {
        const JsonReader place = json["target"];
        command.kind = place.size() == 0 ? Kind::NoTarget : Kind::Target;
        if (place.size() != 0 && place.size() != 2)
            throw place.error("expected [x, z] in metres, or [] for none");
        if (place.size() == 2) command.target = {place.at(0).number(), place.at(1).number()};
    } else if (is("choose")) {
        command.kind = Kind::Choose;
        command.words = json["choose"].text();
        player();
    } else if (is("weigh")) {
        command.kind = Kind::Weigh;
        command.words = json["weigh"].text();
        allowed.push_back("factor");
        command.number = json["factor"].number();
        player();
    } else if (is("seed")) {
        command.kind = Kind::Seed;
        const double seed = json["seed"].number();
        if (seed < 0 || seed > 9007199254740992.0 || seed != std::floor(seed))
            throw json["seed"].error("expected a whole number, 0 or more");
        command.seed = static_cast<std::uint64_t>(seed);
    } else if (is("temperature")) {
        command.kind = Kind::Temperature;
        command.number = json["temperature"].number();
    } else {
        throw json.error("expected one of act, release, target, choose, weigh, seed, temperature");
    }
    for (const std::string& key : json.keys()) {
        if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
            throw json.error("\"" + key + "\" does not belong here");
    }
    return command;
}

Json commandJson(const BoutCommand& command, double rate) {
    Json json = {{"at", command.frame / rate}};
    switch (command.kind) {
        case Kind::Act:
            json["act"] = command.words;
            break;
        case Kind::Release:
            json["release"] = true;
            break;
        case Kind::Target:
            json["target"] = {command.target.x(), command.target.y()};
            break;
        case Kind::NoTarget:
            json["target"] = Json::array();
            break;
        case Kind::Choose:
            json["player"] = command.player + 1;
            json["choose"] = command.words;
            break;
        case Kind::Weigh:
            json["player"] = command.player + 1;
            json["weigh"] = command.words;
            json["factor"] = command.number;
            break;
        case Kind::Seed:
            json["seed"] = command.seed;
            break;
        case Kind::Temperature:
            json["temperature"] = command.number;
            break;
    }
    return json;
}

}  // namespace

std::string_view modeName(BoutMode mode) {
    switch (mode) {
        case BoutMode::Automatic:
            return "auto";
        case BoutMode::Avatar:
            return "avatar";
        case BoutMode::Passive:
            break;
    }
    return "passive";
}

std::optional<BoutMode> modeFromName(std::string_view name) {
    for (const BoutMode mode : {BoutMode::Automatic, BoutMode::Avatar, BoutMode::Passive}) {
        if (modeName(mode) == name) return mode;
    }
    return std::nullopt;
}

std::vector<BoutCommand> parseScript(std::string_view text, const std::string& file, double rate) {
    const Json document = parseJson(text, file);
    const JsonReader json(document, file, "");
    if (json["kumite_script"].integer() != 1) {
        throw json["kumite_script"].error("expected 1; a newer kumite wrote this script");
    }
    const JsonReader list = json["commands"];
    std::vector<BoutCommand> commands;
    for (std::size_t i = 0; i < list.size(); ++i)
        commands.push_back(readCommand(list.at(i), rate));
    std::stable_sort(commands.begin(), commands.end(),
                     [](const BoutCommand& a, const BoutCommand& b) { return a.frame < b.frame; });
    return commands;
}

std::string scriptText(const std::vector<BoutCommand>& commands, double rate) {
    Json json = {{"kumite_script", 1}};
    Json& list = json["commands"] = Json::array();
    for (const BoutCommand& command : commands)
        list.push_back(commandJson(command, rate));
    return prettyJson(json);
}

}  // namespace kumite
