#include "core/project/made_takes.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/formats/json_text.h"

namespace kumite {
namespace {

const std::string kKind = "made";

}  // namespace

std::set<std::string> madeRecordings(const Project& project) {
    const auto found = project.drafts.find(kKind);
    if (found == project.drafts.end()) return {};
    const auto json = parseJson(found->second, "draft " + kKind);
    std::set<std::string> made;
    if (!json.is_array()) return made;
    for (const auto& each : json) {
        if (each.is_string()) made.insert(each.get<std::string>());
    }
    return made;
}

bool isMade(const std::set<std::string>& made, const Take& take) {
    return std::any_of(take.fighters.begin(), take.fighters.end(), [&](const Fighter& fighter) {
        return made.count(fighter.recording.sha256) > 0;
    });
}

MaybeEdit addMadeTake(const Project& project, const Take& take) {
    MaybeEdit edit = addTake(project, take);
    auto made = madeRecordings(project);
    for (const Fighter& fighter : take.fighters) {
        if (!fighter.recording.sha256.empty()) made.insert(fighter.recording.sha256);
    }
    if (edit && !made.empty()) edit->project.drafts[kKind] = nlohmann::ordered_json(made).dump();
    return edit;
}

}  // namespace kumite
