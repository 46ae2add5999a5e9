#include "core/project/project_file.h"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/json_text.h"
#include "core/project/label_json.h"
#include "core/project/versions.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

// ---- writing -----------------------------------------------------------------------------------

std::string storedPath(const std::filesystem::path& path, const std::filesystem::path& folder) {
    if (path.empty()) return {};
    const std::filesystem::path relative = path.lexically_relative(folder);
    return relative.empty() ? path.generic_string() : relative.generic_string();
}

Json correctionJson(const Correction& correction) {
    switch (correction.kind) {
        case Correction::Kind::Remove:
            return {{"remove", correction.frame}};
        case Correction::Kind::Move:
            return {{"move", correction.frame}, {"to", correction.to}};
        case Correction::Kind::Keep:
            return {{"keep", correction.frame}};
        case Correction::Kind::Add:
            break;
    }
    Json json = {{"add", correction.frame}};
    if (correction.beside) json["beside"] = true;
    if (correction.removed) json["removed"] = true;
    return json;
}

/// Joints are stored by index (names may repeat) and by name (for the reader, and to notice a
/// skeleton that changed).
Json rolesJson(const Fighter& fighter) {
    Json json = Json::object();
    for (const Role role : allRoles()) {
        const auto joint = fighter.roles[role];
        if (!joint) continue;
        const auto index = static_cast<std::size_t>(*joint);
        const auto known = fighter.roleNames.find(role);
        const std::string name = fighter.motion ? fighter.motion->skeleton->joints[index].name
                                 : known != fighter.roleNames.end() ? known->second
                                                                    : std::string();
        json[std::string(roleName(role))] = {*joint, name};
    }
    return json;
}

Json fighterJson(const Fighter& fighter, const Vocabulary& vocabulary,
                 const std::filesystem::path& folder) {
    Json recording = {{"path", storedPath(fighter.recording.path, folder)}};
    if (!fighter.recording.asf.empty()) {
        recording["asf"] = storedPath(fighter.recording.asf, folder);
    }
    if (!fighter.recording.root.empty()) recording["root"] = fighter.recording.root;
    recording["sha256"] = fighter.recording.sha256;
    Json corrections = Json::array();
    for (const Correction& c : fighter.corrections)
        corrections.push_back(correctionJson(c));
    Json json = {{"recording", std::move(recording)},
                 {"metres_per_unit", fighter.space.metresPerUnit},
                 {"up", fighter.space.up == UpAxis::Y ? "y" : "z"},
                 {"rate_hz", fighter.rate},
                 {"frames", {fighter.frames.begin, fighter.frames.end}},
                 {"offset_s", fighter.offset},
                 {"placement",
                  {{"x_m", fighter.placement.x},
                   {"z_m", fighter.placement.z},
                   {"yaw_rad", fighter.placement.yaw}}}};
    if (fighter.floor) json["floor_m"] = *fighter.floor;
    json["roles"] = rolesJson(fighter);
    json["corrections"] = std::move(corrections);
    if (!fighter.notes.empty()) {
        Json notes = Json::array();
        for (const ActionNote& note : fighter.notes)
            notes.push_back({{"frame", note.frame}, {"text", asStored(note.text)}});
        json["notes"] = std::move(notes);
    }
    if (!fighter.labels->empty()) json["labels"] = labelTrackJson(*fighter.labels, vocabulary);
    return json;
}

Json bodyModelJson(const BodyModel& model) {
    Json segments = Json::array();
    for (const BodySegment& segment : model.segments) {
        Json from = Json::array();
        for (const Role role : segment.from)
            from.push_back(roleName(role));
        Json json = {{"name", segment.name}, {"mass", segment.mass}, {"from", std::move(from)}};
        if (segment.to) {
            json["to"] = roleName(*segment.to);
            json["fraction"] = segment.fraction;
        }
        if (segment.toEndSite) json["to_end_site"] = true;
        if (segment.toOptional) json["to_optional"] = true;
        segments.push_back(std::move(json));
    }
    return {{"name", model.name}, {"segments", std::move(segments)}};
}

// ---- reading -----------------------------------------------------------------------------------

Correction readCorrection(const JsonReader& json) {
    Correction correction;
    if (json.has("remove")) {
        correction.kind = Correction::Kind::Remove;
        correction.frame = json["remove"].integer();
    } else if (json.has("add")) {
        correction.kind = Correction::Kind::Add;
        correction.frame = json["add"].integer();
        correction.beside = json.has("beside") && json["beside"].boolean();
        correction.removed = json.has("removed") && json["removed"].boolean();
    } else if (json.has("move")) {
        correction.kind = Correction::Kind::Move;
        correction.frame = json["move"].integer();
        correction.to = json["to"].integer();
    } else if (json.has("keep")) {
        correction.kind = Correction::Kind::Keep;
        correction.frame = json["keep"].integer();
    } else {
        throw json.error("expected \"remove\", \"add\", \"move\" or \"keep\"");
    }
    return correction;
}

Role readRole(const JsonReader& json) {
    const auto role = roleFromName(json.text());
    if (!role) throw json.error("\"" + json.text() + "\" is no joint role");
    return *role;
}

void readRoles(const JsonReader& json, Fighter& fighter) {
    for (const std::string& key : json.keys()) {
        const auto role = roleFromName(key);
        if (!role) throw json.error("\"" + key + "\" is no joint role");
        const JsonReader entry = json[key];
        const int joint = entry.at(0).integer();
        if (joint < 0) throw entry.error("a joint's index cannot be negative");
        fighter.roles.set(*role, joint);
        fighter.roleNames[*role] = entry.at(1).text();
    }
}

std::filesystem::path resolved(const std::string& stored, const std::filesystem::path& folder) {
    return stored.empty() ? std::filesystem::path() : (folder / stored).lexically_normal();
}

Fighter readFighter(const JsonReader& json, const Vocabulary& vocabulary,
                    const std::filesystem::path& folder) {
    Fighter fighter;
    const JsonReader recording = json["recording"];
    fighter.recording.path = resolved(recording["path"].text(), folder);
    if (recording.has("asf")) fighter.recording.asf = resolved(recording["asf"].text(), folder);
    if (recording.has("root")) fighter.recording.root = recording["root"].text();
    fighter.recording.sha256 = recording["sha256"].text();
    fighter.space.metresPerUnit = json["metres_per_unit"].positive();
    const std::string up = json["up"].text();
    if (up != "y" && up != "z") throw json["up"].error("expected \"y\" or \"z\"");
    fighter.space.up = up == "y" ? UpAxis::Y : UpAxis::Z;
    fighter.rate = json["rate_hz"].positive();
    fighter.frames = {json["frames"].at(0).integer(), json["frames"].at(1).integer()};
    if (fighter.frames.begin < 0 || fighter.frames.empty()) {
        throw json["frames"].error("expected [begin, end] with 0 <= begin < end");
    }
    fighter.offset = json["offset_s"].number();
    const JsonReader placement = json["placement"];
    fighter.placement = {placement["x_m"].number(), placement["z_m"].number(),
                         placement["yaw_rad"].number()};
    if (json.has("floor_m")) fighter.floor = json["floor_m"].number();
    readRoles(json["roles"], fighter);
    const JsonReader corrections = json["corrections"];
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        fighter.corrections.push_back(readCorrection(corrections.at(i)));
    }
    if (json.has("notes")) {
        const JsonReader notes = json["notes"];
        for (std::size_t i = 0; i < notes.size(); ++i) {
            const JsonReader note = notes.at(i);
            fighter.notes.push_back({note["frame"].integer(), note["text"].text()});
        }
    }
    if (json.has("labels")) fighter.labels = readLabelTrack(json["labels"], vocabulary);
    return fighter;
}

BodyModel bodyModelFrom(const JsonReader& json) {
    BodyModel model;
    model.name = json["name"].text();
    const JsonReader segments = json["segments"];
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const JsonReader entry = segments.at(i);
        BodySegment segment;
        segment.name = entry["name"].text();
        segment.mass = entry["mass"].positive();
        for (std::size_t j = 0; j < entry["from"].size(); ++j) {
            segment.from.push_back(readRole(entry["from"].at(j)));
        }
        if (segment.from.empty()) throw entry.error("a segment needs a role in \"from\"");
        if (entry.has("to")) {
            segment.to = readRole(entry["to"]);
            segment.fraction = entry["fraction"].number();
        } else {
            segment.fraction = 0;
        }
        segment.toEndSite = entry.has("to_end_site") && entry["to_end_site"].boolean();
        segment.toOptional = entry.has("to_optional") && entry["to_optional"].boolean();
        model.segments.push_back(std::move(segment));
    }
    return model;
}

/// Brings the JSON of an older version up to date: step i makes version i + 2 of version i + 1.
/// A change of the format adds its step here and a file of the old version to the tests.
using MigrationStep = void (*)(Json&);
constexpr std::array<MigrationStep, kProjectVersion - 1> kMigrations{
    // 2: corrections may be "keep", fighters may have "notes"; what was there means the same.
    [](Json&) {},
};

void migrate(Json& json, int version) {
    for (auto step = static_cast<std::size_t>(version - 1); step < kMigrations.size(); ++step) {
        kMigrations[step](json);
    }
}

SegmentationSettings readSettings(const JsonReader& json) {
    SegmentationSettings settings;
    settings.cutoff = json["cutoff_hz"].positive();
    settings.prominence = json["prominence_bw"].number();
    if (settings.prominence < 0) throw json["prominence_bw"].error("expected 0 or more");
    const std::string curve = json["curve"].text();
    if (curve != "norm" && curve != "vertical") {
        throw json["curve"].error("expected \"norm\" or \"vertical\"");
    }
    settings.curve = curve == "norm" ? ForceCurve::Norm : ForceCurve::Vertical;
    return settings;
}

}  // namespace

std::string projectText(const Project& project, const std::filesystem::path& folder) {
    const SegmentationSettings& settings = project.segmentation;
    Json takes = Json::array();
    for (const Take& take : project.takes) {
        Json fighters = Json::array();
        for (const Fighter& fighter : take.fighters) {
            fighters.push_back(fighterJson(fighter, *project.labelling.vocabulary, folder));
        }
        takes.push_back({{"name", take.name}, {"fighters", std::move(fighters)}});
    }
    Json json = {{"kumite", kProjectVersion},
                 {"segmentation",
                  {{"cutoff_hz", settings.cutoff},
                   {"prominence_bw", settings.prominence},
                   {"curve", settings.curve == ForceCurve::Norm ? "norm" : "vertical"}}},
                 {"body_model", bodyModelJson(project.bodyModel)}};
    if (project.labelling != LabelSettings()) {
        json["labelling"] = labelSettingsJson(project.labelling);
    }
    if (!project.clips.empty()) {
        Json clips = Json::array();
        for (const auto& clip : project.clips)
            clips.push_back(storedPath(clip, folder));
        json["clips"] = std::move(clips);
    }
    for (const auto& [kind, text] : project.drafts)
        json["drafts"][kind] = Json::parse(text);
    json["takes"] = std::move(takes);
    return prettyJson(json);
}

Project parseProject(std::string_view text, const std::string& name,
                     const std::filesystem::path& folder) {
    if (trimmed(text.substr(0, 200)).starts_with("HIERARCHY")) {
        throw InputError(name, 0, 0, "is a recording; make a project of it with kumite new.");
    }
    Json json = parseJson(text, name);
    const JsonReader reader(json, name, "");
    if (!reader.isObject() || !reader.has("kumite")) {
        throw InputError(name, 0, 0, "is not a Kumite project: it has no \"kumite\" version.");
    }
    const int version = reader["kumite"].integer();
    if (version > kProjectVersion) {
        throw InputError(name, 0, 0,
                         fmt::format("was written by a newer Kumite (file version {}, this one "
                                     "reads up to {}); open it with that one.",
                                     version, kProjectVersion));
    }
    if (version < 1) throw reader["kumite"].error("expected a version of 1 or more");
    migrate(json, version);
    Project project;
    project.segmentation = readSettings(reader["segmentation"]);
    project.bodyModel = bodyModelFrom(reader["body_model"]);
    if (reader.has("labelling")) project.labelling = readLabelSettings(reader["labelling"]);
    if (reader.has("clips")) {
        const JsonReader clips = reader["clips"];
        for (std::size_t i = 0; i < clips.size(); ++i)
            project.clips.push_back(resolved(clips.at(i).text(), folder));
    }
    if (reader.has("drafts")) {
        for (const std::string& kind : reader["drafts"].keys())
            project.drafts[kind] = json["drafts"][kind].dump();
    }
    const JsonReader takes = reader["takes"];
    for (std::size_t i = 0; i < takes.size(); ++i) {
        Take take;
        take.name = takes.at(i)["name"].text();
        for (const Take& other : project.takes) {
            if (other.name == take.name)
                throw takes.at(i)["name"].error("is the name of two takes");
        }
        const JsonReader fighters = takes.at(i)["fighters"];
        if (fighters.size() < 1 || fighters.size() > 2) {
            throw fighters.error("a take has one or two fighters");
        }
        for (std::size_t j = 0; j < fighters.size(); ++j) {
            take.fighters.push_back(
                readFighter(fighters.at(j), *project.labelling.vocabulary, folder));
        }
        project.takes.push_back(std::move(take));
    }
    return project;
}

BodyModel readBodyModel(const std::filesystem::path& path) {
    const FileBytes file(path);
    return parseBodyModel(file.bytes(), path.string());
}

BodyModel parseBodyModel(std::string_view text, const std::string& name) {
    const Json json = parseJson(text, name);
    return bodyModelFrom({json, name, ""});
}

Findings saveProject(const Project& project, const std::filesystem::path& path) {
    // Where links lead: relative paths must mean the same from every way in.
    std::error_code refused;
    const auto folder = std::filesystem::weakly_canonical(path, refused).parent_path();
    if (refused) throw Error(path.string() + ": cannot write: " + refused.message() + ".");
    const std::string text = projectText(project, folder);
    Findings findings;
    try {
        keepVersion(path, text);
    } catch (const std::exception& error) {
        findings.push_back(
            warning(std::string("What was saved before could not be kept. ") + error.what()));
    }
    writeFileAtomically(path, text);
    return findings;
}

}  // namespace kumite
