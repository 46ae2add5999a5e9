#include "core/project/key_draft.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/editing/key_file.h"
#include "core/formats/json_text.h"
#include "core/project/library.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

const std::string kKind = "keys";

std::string_view kindName(PartChoice::Kind kind) {
    if (kind == PartChoice::Kind::WithBody) return "body";
    return kind == PartChoice::Kind::Own ? "own" : "automatic";
}

PartChoice::Kind readKind(const JsonReader& json) {
    const std::string name = json.text();
    if (name == "body") return PartChoice::Kind::WithBody;
    if (name == "own") return PartChoice::Kind::Own;
    if (name != "automatic") throw json.error("expected \"automatic\", \"body\" or \"own\"");
    return PartChoice::Kind::Automatic;
}

}  // namespace

std::string keyDraftText(const KeyDraft& draft) {
    Json json = {{"track", Json::parse(keysText(draft.track))}};
    if (!draft.body.empty()) json["body"] = asStored(draft.body);
    for (const BodyPart part : allParts()) {
        const auto kind = draft.parts[static_cast<std::size_t>(part)];
        if (kind != PartChoice::Kind::Automatic)
            json["parts"][std::string(partName(part))] = kindName(kind);
        const std::string& place = draft.places[static_cast<std::size_t>(part)];
        if (!place.empty()) json["places"][std::string(partName(part))] = asStored(place);
    }
    if (!draft.assembly.adjusted) json["adjusted"] = false;
    if (draft.assembly.meetKeys != 0) json["meet"] = draft.assembly.meetKeys;
    return json.dump();
}

KeyDraft parseKeyDraft(std::string_view text, const std::string& file,
                       std::shared_ptr<const Rig> rig) {
    const Json json = parseJson(text, file);
    const JsonReader reader(json, file, "");
    if (!reader.has("track")) throw reader.error("\"track\" is missing");
    KeyDraft draft;
    draft.track = parseKeys(
        json["track"].dump(), file, std::move(rig), [](const std::string& clip, int) -> Pose {
            throw Error("the key pose of clip \"" + clip + "\" is not in the project");
        });
    if (reader.has("body")) draft.body = reader["body"].text();
    const auto eachPart = [&](const char* key, const auto& read) {
        if (!reader.has(key)) return;
        for (const std::string& name : reader[key].keys()) {
            const auto part = partFromName(name);
            if (!part) throw reader[key].error("\"" + name + "\" is no part of the body");
            read(static_cast<std::size_t>(*part), reader[key][name]);
        }
    };
    eachPart("parts",
             [&](std::size_t part, const JsonReader& json) { draft.parts[part] = readKind(json); });
    eachPart("places",
             [&](std::size_t part, const JsonReader& json) { draft.places[part] = json.text(); });
    draft.assembly.adjusted = !reader.has("adjusted") || reader["adjusted"].boolean();
    if (reader.has("meet")) {
        draft.assembly.meetKeys = reader["meet"].number();
        if (draft.assembly.meetKeys < 0 || draft.assembly.meetKeys > 1)
            throw reader["meet"].error("expected 0 to 1");
    }
    return draft;
}

KeyDraft keyDraftOf(const Project& project, std::shared_ptr<const Rig> rig, double rate) {
    const auto found = project.drafts.find(kKind);
    if (found != project.drafts.end())
        return parseKeyDraft(found->second, "draft " + kKind, std::move(rig));
    KeyDraft draft;
    draft.track.rig = std::move(rig);
    draft.track.rate = rate;
    return draft;
}

MaybeEdit setKeyDraft(const Project& project, const KeyDraft& draft, std::string edit) {
    return setDraft(project, kKind, draft.track.keys.empty() ? std::string() : keyDraftText(draft),
                    std::move(edit));
}

AssemblyChoices choicesOf(const MotionLibrary& library, const KeyDraft& draft) {
    AssemblyChoices choices;
    const auto rangeOf = [&](const std::string& place) {
        const LibraryAction action = actionNamed(library, place);
        return ClipRange{action.motion, action.frames};
    };
    if (!draft.body.empty()) choices.body = rangeOf(draft.body);
    for (std::size_t part = 0; part < draft.parts.size(); ++part) {
        choices.parts[part].kind = draft.parts[part];
        if (draft.parts[part] == PartChoice::Kind::Own && !draft.places[part].empty())
            choices.parts[part].within = rangeOf(draft.places[part]);
    }
    return choices;
}

}  // namespace kumite
