#include "core/project/library_strikes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/project/library.h"

namespace kumite {
namespace {

/// "right_kick:up" taken apart; the qualifier is empty where none is named.
struct AspectName {
    std::string aspect, qualifier;
};

AspectName aspectName(std::string_view text) {
    const auto parts = split(text, ':');
    return {std::string(parts.front()), parts.size() > 1 ? std::string(parts[1]) : std::string()};
}

/// The qualifier that a spelt label gives an aspect; empty where it says nothing of it.
std::string qualifierIn(const std::string& label, const std::string& aspect) {
    for (const std::string_view word : split(label, '+')) {
        const AspectName name = aspectName(word);
        if (name.aspect == aspect) return name.qualifier;
    }
    return {};
}

/// The player of "take:player:action"; 0 for a file.
int playerOf(const std::string& name) {
    const auto parts = split(name, ':');
    return parts.size() < 3 ? 0 : parseInteger(parts[parts.size() - 2]).value_or(0);
}

bool isAttack(const Aspect* aspect, const std::string& qualifier) {
    if (!aspect) return true;
    const auto index = aspect->find(qualifier);
    return !index || aspect->qualifiers[static_cast<std::size_t>(*index)].attack;
}

std::optional<Striker> strikerOf(const Aspect& aspect) {
    if (!aspect.limb) return std::nullopt;
    switch (*aspect.limb) {
        case Role::LeftWrist:
            return Striker::LeftHand;
        case Role::RightWrist:
            return Striker::RightHand;
        case Role::LeftAnkle:
        case Role::LeftToe:
            return Striker::LeftFoot;
        case Role::RightAnkle:
        case Role::RightToe:
            return Striker::RightFoot;
        default:
            return std::nullopt;
    }
}

/// Actions whose label has an aspect.
std::vector<LibraryAction> labelledActions(const MotionLibrary& library,
                                           const StrikeRequest& request, const Aspect* aspect) {
    const AspectName name = aspectName(request.strike);
    std::vector<LibraryAction> found;
    for (std::size_t i = 0; i < library.actions.size(); ++i) {
        LibraryAction action = library.actions[i];
        const std::string qualifier = qualifierIn(action.label, name.aspect);
        if (qualifier.empty() || qualifier == "?") continue;
        const bool wanted =
            name.qualifier.empty() ? isAttack(aspect, qualifier) : qualifier == name.qualifier;
        if (library.motions[static_cast<std::size_t>(action.motion)].made) continue;
        if (!wanted || (request.player && playerOf(action.name) != *request.player)) continue;
        if (i + 1 < library.actions.size()) {
            const LibraryAction& next = library.actions[i + 1];
            const std::string back = qualifierIn(next.label, name.aspect);
            if (next.motion == action.motion && !back.empty() && aspect && !isAttack(aspect, back))
                action.frames.end = next.frames.end;
        }
        found.push_back(std::move(action));
    }
    return found;
}

Clip sliceOf(const MotionLibrary& library, const LibraryAction& action) {
    const auto poses = library.part(action).poses;
    return {library.rig, library.rate, {poses.begin(), poses.end()}};
}

std::vector<LibraryAction> namedActions(const MotionLibrary& library,
                                        const StrikeRequest& request) {
    std::vector<LibraryAction> found;
    for (const std::string_view name : split(request.strike, ',')) {
        LibraryAction action = actionNamed(library, trimmed(name));
        if (request.player && playerOf(action.name) != 0 &&
            playerOf(action.name) != *request.player)
            continue;
        found.push_back(std::move(action));
    }
    return found;
}

Striker limbOfMost(const MotionLibrary& library, const std::vector<LibraryAction>& actions) {
    std::map<Striker, int> votes;
    for (const LibraryAction& action : actions) {
        const auto& clip = library.motions[static_cast<std::size_t>(action.motion)].clip;
        if (const auto limb = likeliestStriker(clip, action.frames)) ++votes[*limb];
    }
    const auto most =
        std::max_element(votes.begin(), votes.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == votes.end())
        throw Error("None of these clips shows a hand or a foot that strikes.");
    return most->first;
}

}  // namespace

StrikeExamples strikesOf(const MotionLibrary& library, const StrikeRequest& request) {
    const Vocabulary& vocabulary = kickboxing();
    const AspectName name = aspectName(request.strike);
    const auto index = vocabulary.find(name.aspect);
    const Aspect* aspect = index ? &vocabulary[*index] : nullptr;
    const bool isLabel =
        aspect || std::any_of(library.actions.begin(), library.actions.end(), [&](const auto& a) {
            return !qualifierIn(a.label, name.aspect).empty();
        });
    const std::vector<LibraryAction> actions =
        isLabel ? labelledActions(library, request, aspect) : namedActions(library, request);
    if (actions.empty()) {
        throw Error(isLabel ? fmt::format("No action of the library is labelled \"{}\"{}.",
                                          request.strike, request.player ? " of that player" : "")
                            : "None of these clips is of that player.");
    }
    StrikeExamples examples;
    examples.striker = request.striker                ? *request.striker
                       : aspect && strikerOf(*aspect) ? *strikerOf(*aspect)
                                                      : limbOfMost(library, actions);
    for (const LibraryAction& action : actions) {
        const Clip clip = sliceOf(library, action);
        std::vector<StrikeMoment> moments;
        if (!isLabel) moments = findStrikes(clip, examples.striker);
        if (moments.size() < 2) {
            moments.clear();
            if (const auto one = strikeIn(clip, {0, clip.frameCount()}, examples.striker))
                moments.push_back(*one);
        }
        for (std::size_t m = 0; m < moments.size(); ++m) {
            std::string title =
                moments.size() > 1 ? fmt::format("{} ({})", action.name, m + 1) : action.name;
            examples.strikes.push_back(strikeFrom(clip, moments[m], 0.0, std::move(title)));
        }
    }
    if (examples.strikes.empty()) {
        throw Error(fmt::format("No strike of the {} was found in \"{}\".",
                                strikerName(examples.striker), request.strike));
    }
    return examples;
}

std::vector<std::string> strikesIn(const MotionLibrary& library, const Vocabulary& vocabulary) {
    std::vector<std::string> found;
    for (const Aspect& aspect : vocabulary.aspects) {
        if (aspect.strike.empty()) continue;
        if (!labelledActions(library, {aspect.id, {}, {}}, &aspect).empty())
            found.push_back(aspect.id);
    }
    return found;
}

StrikeExamples strikesLike(const MotionLibrary& library, const LibraryAction& action) {
    const Vocabulary& vocabulary = kickboxing();
    for (const std::string_view word : split(action.label, '+')) {
        const AspectName name = aspectName(word);
        const auto index = vocabulary.find(name.aspect);
        if (!index || !strikerOf(vocabulary[*index]) ||
            !isAttack(&vocabulary[*index], name.qualifier))
            continue;
        return strikesOf(library, {std::string(word), {}, {}});
    }
    return strikesOf(library, {action.name, {}, {}});
}

StrikeBlock strikeAt(const MotionLibrary& library, const LibraryAction& action,
                     const Eigen::Vector3d& target) {
    StrikeBlock block;
    block.hit = hitTarget(strikeSpace(strikesLike(library, action)), target);
    block.motion.name = action.name;
    block.motion.clip = block.hit.clip;
    block.motion.standing = standingOf(block.hit.clip);
    block.motion.sourceRate = block.hit.clip.rate;
    return block;
}

std::optional<Eigen::Vector3d> targetFrom(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) return std::nullopt;
    Eigen::Vector3d target;
    for (std::size_t i = 0; i < 3; ++i) {
        constexpr double kFarthest = 1000;
        const auto value = parseNumber(trimmed(parts[i]));
        if (!value || std::abs(*value) > kFarthest) return std::nullopt;
        target[static_cast<Eigen::Index>(i)] = *value;
    }
    return target;
}

StrikeSpace strikeSpace(const StrikeExamples& examples, const StrikeSpaceSettings& settings,
                        const Progress& progress) {
    return strikeSpace(examples.strikes, examples.striker, settings, progress);
}

}  // namespace kumite
