#include "core/project/edits.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/formats/json_text.h"

namespace kumite {
namespace {

/// The project with one fighter changed by `change`, or nothing if that changed nothing.
template <typename Change>
MaybeEdit changeFighter(const Project& project, FighterAddress address, std::string name,
                        const Change& change) {
    Edit edit{project, std::move(name)};
    Fighter& fighter = fighterAt(edit.project, address);
    change(fighter);
    if (fighter == fighterAt(project, address)) return std::nullopt;
    return edit;
}

void requireFinite(double value, const char* what) {
    if (!std::isfinite(value)) throw Error(std::string(what) + " must be a number.");
}

bool isTaken(const Project& project, const std::string& name) {
    return std::any_of(project.takes.begin(), project.takes.end(),
                       [&](const Take& take) { return take.name == name; });
}

std::string who(FighterAddress fighter) {
    return fmt::format(", fighter {}", fighter.player + 1);
}

/// Drafts name motions and actions by their take, "take:1" or "take:1:4@0:10".
void renameIn(nlohmann::ordered_json& json, const std::string& old, const std::string& name) {
    if (json.is_string()) {
        const auto text = json.get<std::string>();
        const std::size_t after = old.size() + 1;
        if (text.size() > after && text.compare(0, after, old + ":") == 0 &&
            std::isdigit(static_cast<unsigned char>(text[after])) != 0)
            json = name + text.substr(old.size());
    } else if (json.is_structured()) {
        for (auto& each : json)
            renameIn(each, old, name);
    }
}

}  // namespace

MaybeEdit setSegmentation(const Project& project, const SegmentationSettings& settings) {
    if (!(settings.cutoff > 0) || !std::isfinite(settings.cutoff)) {
        throw Error("The cutoff must be a positive number of Hz.");
    }
    if (!(settings.prominence >= 0) || !std::isfinite(settings.prominence)) {
        throw Error("The prominence must be a number of body weights, 0 or more.");
    }
    if (settings == project.segmentation) return std::nullopt;
    Edit edit{project, "Change segmentation settings"};
    edit.project.segmentation = settings;
    return edit;
}

MaybeEdit setBodyModel(const Project& project, const BodyModel& model) {
    if (model == project.bodyModel) return std::nullopt;
    Edit edit{project, "Change body model to " + model.name};
    edit.project.bodyModel = model;
    return edit;
}

MaybeEdit restoreVersion(const Project& project, const Project& version, const std::string& when) {
    if (version == project) return std::nullopt;
    return Edit{version, "Restore the version of " + when};
}

MaybeEdit addClips(const Project& project, const std::vector<std::filesystem::path>& clips) {
    Edit edit{project, "Add clips"};
    auto& all = edit.project.clips;
    for (const auto& clip : clips) {
        if (std::find(all.begin(), all.end(), clip) == all.end()) all.push_back(clip);
    }
    if (all == project.clips) return std::nullopt;
    return edit;
}

MaybeEdit removeClips(const Project& project, const std::vector<std::filesystem::path>& clips) {
    Edit edit{project, "Remove clips"};
    std::erase_if(edit.project.clips, [&](const auto& clip) {
        return std::find(clips.begin(), clips.end(), clip) != clips.end();
    });
    if (edit.project.clips == project.clips) return std::nullopt;
    return edit;
}

MaybeEdit setDraft(const Project& project, const std::string& kind, const std::string& json,
                   std::string edit) {
    Edit changed{project, std::move(edit)};
    if (json.empty()) {
        changed.project.drafts.erase(kind);
    } else {
        changed.project.drafts[kind] = parseJson(json, "draft " + kind).dump();
    }
    if (changed.project.drafts == project.drafts) return std::nullopt;
    return changed;
}

MaybeEdit addTake(const Project& project, const Take& take) {
    if (take.name.empty()) throw Error("A take needs a name.");
    if (isTaken(project, take.name)) {
        throw Error("There is a take named \"" + take.name + "\" already.");
    }
    if (take.fighters.empty() || take.fighters.size() > 2) {
        throw Error("A take has one or two fighters.");
    }
    Edit edit{project, "Add take " + take.name};
    edit.project.takes.push_back(take);
    return edit;
}

MaybeEdit removeTake(const Project& project, int take) {
    Edit edit{project, "Remove take " + project.takes.at(static_cast<std::size_t>(take)).name};
    edit.project.takes.erase(edit.project.takes.begin() + take);
    return edit;
}

MaybeEdit renameTake(const Project& project, int take, const std::string& name) {
    const std::string& old = project.takes.at(static_cast<std::size_t>(take)).name;
    if (name == old) return std::nullopt;
    if (name.empty()) throw Error("A take needs a name.");
    if (isTaken(project, name)) throw Error("There is a take named \"" + name + "\" already.");
    Edit edit{project, "Rename take to " + name};
    edit.project.takes[static_cast<std::size_t>(take)].name = name;
    for (const char* kind : {"hit", "keys", "sequence"}) {
        const auto draft = edit.project.drafts.find(kind);
        if (draft == edit.project.drafts.end()) continue;
        auto json = parseJson(draft->second, std::string("draft ") + kind);
        renameIn(json, asStored(old), asStored(name));
        draft->second = json.dump();
    }
    return edit;
}

MaybeEdit moveTake(const Project& project, int take, int to) {
    const auto count = static_cast<int>(project.takes.size());
    const std::string& name = project.takes.at(static_cast<std::size_t>(take)).name;
    if (to < 0 || to >= count) throw Error("There is no such place in the list of takes.");
    if (to == take) return std::nullopt;
    Edit edit{project, fmt::format("Move take {} to place {}", name, to + 1)};
    const auto begin = edit.project.takes.begin();
    if (take < to) {
        std::rotate(begin + take, begin + take + 1, begin + to + 1);
    } else {
        std::rotate(begin + to, begin + take, begin + take + 1);
    }
    return edit;
}

MaybeEdit swapFighters(const Project& project, int take) {
    if (project.takes.at(static_cast<std::size_t>(take)).fighters.size() < 2) {
        throw Error("There is one fighter only: nothing to swap.");
    }
    Edit edit{project, "Swap fighters"};
    auto& fighters = edit.project.takes[static_cast<std::size_t>(take)].fighters;
    if (fighters[0] == fighters[1]) return std::nullopt;
    std::swap(fighters[0], fighters[1]);
    return edit;
}

MaybeEdit setOffset(const Project& project, FighterAddress address, double seconds) {
    requireFinite(seconds, "A time offset");
    return changeFighter(project, address, "Change time offset" + who(address),
                         [&](Fighter& fighter) { fighter.offset = seconds; });
}

MaybeEdit setPlacement(const Project& project, FighterAddress address, const Placement& placement) {
    requireFinite(placement.x + placement.z + placement.yaw, "A placement");
    return changeFighter(project, address, "Place" + who(address),
                         [&](Fighter& fighter) { fighter.placement = placement; });
}

MaybeEdit setFloor(const Project& project, FighterAddress address, std::optional<double> metres) {
    if (metres) requireFinite(*metres, "The floor's height");
    return changeFighter(project, address, "Change floor" + who(address),
                         [&](Fighter& fighter) { fighter.floor = metres; });
}

MaybeEdit setRole(const Project& project, FighterAddress address, Role role,
                  std::optional<int> joint) {
    const Fighter& fighter = fighterAt(project, address);
    const int jointCount = fighter.motion ? fighter.motion->skeleton->jointCount() : 0;
    if (joint && (*joint < 0 || *joint >= jointCount)) {
        throw Error("The skeleton has no such joint.");
    }
    return changeFighter(project, address,
                         "Change role " + std::string(roleName(role)) + who(address),
                         [&](Fighter& changed) {
                             if (joint) {
                                 changed.roles.set(role, *joint);
                             } else {
                                 changed.roles.clear(role);
                             }
                         });
}

MaybeEdit relinkRecording(const Project& project, FighterAddress address,
                          const RecordingRef& recording, std::shared_ptr<const Motion> motion) {
    const Fighter& fighter = fighterAt(project, address);
    if (fighter.motion && fighter.recording == recording) return std::nullopt;
    if (motion->frameCount < fighter.frames.end) {
        throw Error(
            fmt::format("{} holds {} frames, but the take reaches to frame {}: it is not "
                        "the recording that is missing.",
                        recording.path.string(), motion->frameCount, fighter.frames.end));
    }
    const auto nameIn = [](const Motion& where, int joint) {
        const auto& joints = where.skeleton->joints;
        const auto index = static_cast<std::size_t>(joint);
        return index < joints.size() ? joints[index].name : std::string();
    };
    for (const Role role : allRoles()) {
        const auto joint = fighter.roles[role];
        if (!joint) continue;
        const auto known = fighter.roleNames.find(role);
        const std::string was = fighter.motion                     ? nameIn(*fighter.motion, *joint)
                                : known != fighter.roleNames.end() ? known->second
                                                                   : std::string();
        if (nameIn(*motion, *joint) == was) continue;
        throw Error(recording.path.string() +
                    " has another skeleton: it is not the recording that is missing.");
    }
    return changeFighter(project, address, "Relink recording" + who(address),
                         [&](Fighter& changed) {
                             changed.recording = recording;
                             changed.motion = std::move(motion);
                             changed.roleNames.clear();
                         });
}

}  // namespace kumite
