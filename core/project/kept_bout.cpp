#include "core/project/kept_bout.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/formats/bvh.h"
#include "core/project/bout.h"
#include "core/project/import.h"
#include "core/project/labels.h"
#include "core/project/new_files.h"
#include "core/segmentation/boundary_comparison.h"

namespace kumite {
namespace {

constexpr double kTolerance = 0.066;  ///< seconds

/// Corrections that leave exactly these boundaries of what detection finds.
std::vector<Correction> correctionsFor(const std::vector<int>& wanted,
                                       const std::vector<int>& detected, double reach) {
    std::vector<Correction> list;
    const BoundaryComparison compared = compareBoundaries(wanted, detected, reach);
    const auto without = [](const std::vector<int>& all, const std::vector<int>& some) {
        std::vector<int> rest;
        std::set_difference(all.begin(), all.end(), some.begin(), some.end(),
                            std::back_inserter(rest));
        return rest;
    };
    // Pairs may not cross: both lists are in order and the nearest pairs stand for each other.
    const std::vector<int> pairsA = without(wanted, compared.onlyA);
    const std::vector<int> pairsB = without(detected, compared.onlyB);
    for (std::size_t i = 0; i < pairsA.size(); ++i) {
        Correction correction;
        correction.kind = pairsA[i] == pairsB[i] ? Correction::Kind::Keep : Correction::Kind::Move;
        correction.frame = pairsB[i];
        correction.to = correction.kind == Correction::Kind::Move ? pairsA[i] : 0;
        list.push_back(correction);
    }
    for (const int frame : compared.onlyB) {
        Correction correction;
        correction.kind = Correction::Kind::Remove;
        correction.frame = frame;
        list.push_back(correction);
    }
    for (const int frame : compared.onlyA) {
        Correction correction;
        correction.kind = Correction::Kind::Add;
        correction.frame = frame;
        correction.beside = true;
        list.push_back(correction);
    }
    return list;
}

/// Inner boundaries of a fighter as detected and corrected.
std::vector<int> innerBoundaries(const FighterAnalysis& fighter) {
    std::vector<int> frames;
    const auto& boundaries = fighter.segmentation->boundaries;
    for (std::size_t i = 1; i + 1 < boundaries.size(); ++i)
        frames.push_back(boundaries[i].frame);
    return frames;
}

}  // namespace

const Fighter& fighterLike(const Project& project, const Rig& rig, int player) {
    for (const Take& take : project.takes) {
        if (take.fighters.size() != 2) continue;
        const Fighter& fighter = take.fighters[static_cast<std::size_t>(player)];
        if (fighter.motion && sameJoints(rig, *fighter.motion->skeleton)) return fighter;
    }
    throw Error(
        fmt::format("No take of two has a recording of player {} with the skeleton of the "
                    "bout: it was removed since the bout was begun.",
                    player + 1));
}

std::array<Motion, 2> boutMotions(const Project& project, const BoutTape& tape,
                                  const Progress& progress) {
    const std::array<Clip, 2> clips = boutClips(tape, progress.part(0, 0.6));
    std::array<Motion, 2> motions;
    for (const std::size_t p : {0, 1}) {
        const Fighter& like = fighterLike(project, *clips[p].rig, static_cast<int>(p));
        const double from = p == 0 ? 0.6 : 0.8;
        motions[p] =
            motionOf(clips[p], like.motion->skeleton, like.space, progress.part(from, from + 0.2));
    }
    return motions;
}

KeptBout keepBout(const Project& project, const Analysis& analysis, const BoutTape& tape,
                  const std::string& name, const std::filesystem::path& folder,
                  const Progress& progress) {
    KeptBout kept;
    TakeRequest request;
    request.name = name;
    request.rate = tape.first().library().rate;
    request.trim = FrameRange{0, -1};
    // Says early if the name cannot be used.
    Take named;
    named.name = name;
    named.fighters.resize(1);
    addTake(project, named);
    for (const char* ending : {"-1.bvh", "-2.bvh", ".json"})
        kept.files.push_back(folder / (name + ending));
    NewFiles written(kept.files);
    const BoutLibrary& library = tape.first().library();
    const std::array<std::reference_wrapper<const Fighter>, 2> likes = {
        fighterLike(project, *library.fighter(0).rig, 0),
        fighterLike(project, *library.fighter(1).rig, 1)};
    const std::array<Motion, 2> motions = boutMotions(project, tape, progress.part(0, 0.4));
    for (const std::size_t p : {0, 1}) {
        const Fighter& like = likes[p];
        writeFileAtomically(kept.files[p],
                            bvhText(motions[p], motions[p].frames(), motions[p].frameTime));
        FighterRequest fighter;
        fighter.path = kept.files[p];
        fighter.metresPerUnit = like.space.metresPerUnit;
        fighter.up = like.space.up;
        fighter.floor = 0;
        request.fighters.push_back(fighter);
    }
    writeFileAtomically(kept.files[2], boutLog(tape));
    Take take = importTake(request, progress.part(0.4, 0.6)).take;
    for (const std::size_t p : {0, 1}) {
        take.fighters[p].roles = likes[p].get().roles;
    }
    kept.edit = *addTake(project, take);
    kept.edit.name = "Keep bout as take " + name;
    const int index = static_cast<int>(project.takes.size());
    Analysis now = analyse(kept.edit.project, analysis, progress.part(0.6, 0.8));

    const double rate = *request.rate;
    for (const int player : {0, 1}) {
        std::vector<int> wanted;
        for (const ShownAction& action : actionsShown(tape, player)) {
            if (action.begin > 0) wanted.push_back(action.begin);
        }
        const std::vector<int> detected = innerBoundaries(now.at({index, player}));
        const BoundaryComparison compared =
            compareBoundaries(wanted, detected, std::floor(kTolerance * rate + 0.5));
        const auto all = static_cast<double>(wanted.size() + detected.size());
        kept.foundAgain[static_cast<std::size_t>(player)] = all > 0 ? 2 * compared.both / all : 1;
        fighterAt(kept.edit.project, {index, player}).corrections =
            correctionsFor(wanted, detected, kCorrectionReach * rate);
    }
    now = analyse(kept.edit.project, now, progress.part(0.8, 0.9));
    std::vector<ActionAnswer> answers;
    for (const int player : {0, 1}) {
        const auto shown = actionsShown(tape, player);
        const auto& cut = now.at({index, player}).segmentation->actions;
        for (const ShownAction& action : shown) {
            const auto found = std::find_if(cut.begin(), cut.end(), [&](const Action& each) {
                return each.begin == action.begin && each.end == action.end;
            });
            if (found == cut.end() || action.node == kAnyNode) continue;
            const int recorded = library.fighter(player).action(action.action).frames;
            if (2 * (action.end - action.begin) < recorded) continue;
            answers.push_back({{index, player},
                               static_cast<int>(found - cut.begin()),
                               library.graph->node(player, action.node).label});
        }
    }
    if (const auto labelled = setLabels(kept.edit.project, now, answers))
        kept.edit.project = labelled->project;
    progress.update(1);
    written.stay();
    return kept;
}

}  // namespace kumite
