#include "core/project/hit_draft.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/formats/json_text.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

const std::string kKind = "hit";
constexpr double kFarthest = 1000;  // metres

double metresOf(const JsonReader& json) {
    const double metres = json.number();
    if (!(std::abs(metres) <= kFarthest)) throw json.error("expected -1000 to 1000");
    return metres;
}

}  // namespace

std::string hitDraftText(const HitDraft& draft) {
    Json json = Json::object();
    if (!draft.strike.empty()) json["strike"] = asStored(draft.strike);
    if (draft.target) json["target"] = {draft.target->x(), draft.target->y(), draft.target->z()};
    if (draft.aim) {
        json["aim"] = roleName(*draft.aim);
        json["distance"] = draft.distance;
    }
    return json.dump();
}

HitDraft parseHitDraft(std::string_view text, const std::string& file) {
    const Json json = parseJson(text, file);
    const JsonReader reader(json, file, "");
    HitDraft draft;
    if (reader.has("strike")) draft.strike = reader["strike"].text();
    if (reader.has("target")) {
        const JsonReader target = reader["target"];
        draft.target =
            Eigen::Vector3d(metresOf(target.at(0)), metresOf(target.at(1)), metresOf(target.at(2)));
    }
    if (reader.has("aim")) {
        draft.aim = roleFromName(reader["aim"].text());
        if (!draft.aim) throw reader["aim"].error("expected a role, as \"head\"");
    }
    if (reader.has("distance")) draft.distance = metresOf(reader["distance"]);
    return draft;
}

HitDraft hitDraftOf(const Project& project) {
    const auto found = project.drafts.find(kKind);
    return found == project.drafts.end() ? HitDraft{}
                                         : parseHitDraft(found->second, "draft " + kKind);
}

MaybeEdit setHitDraft(const Project& project, const HitDraft& draft, std::string edit) {
    return setDraft(project, kKind, draft.isEmpty() ? std::string() : hitDraftText(draft),
                    std::move(edit));
}

}  // namespace kumite
