#include "core/synthesis/bout_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace kumite {
namespace {

/// An action as it was shown: the player and the frame at which it began.
using Shown = std::pair<int, int>;

const LibraryClip* longestTake(const BoutLibrary& library, std::size_t& take) {
    const LibraryClip* longest = nullptr;
    const auto& clips = *library.fighter(0).clips;
    const auto& others = *library.fighter(1).clips;
    for (std::size_t t = 0; t < clips.size() && t < others.size(); ++t) {
        if (clips[t].empty() || others[t].empty()) continue;
        if (longest && clips[t].clip.frameCount() <= longest->clip.frameCount()) continue;
        longest = &clips[t];
        take = t;
    }
    return longest;
}

/// Joint accelerations where an action begins, as it was recorded.
void addRecordedBeginning(const LibraryFighter& fighter, const BoutAction& action,
                          std::vector<float>& accelerations) {
    const Clip& clip = fighter.clipOf(action).clip;
    // As much as is looked at around a join, and a frame more for the changes of velocity.
    const int around = static_cast<int>(std::lround(kAfterJoin * clip.rate)) + 2;
    const int first = std::max(0, action.begin - 2);
    const int last = std::min(clip.frameCount(), action.begin + around);
    const Clip part{clip.rig, clip.rate, {clip.frames.begin() + first, clip.frames.begin() + last}};
    const std::array join = {action.begin - first};
    const std::vector<float> found = measureJoins(part, join).atJoins.acceleration;
    accelerations.insert(accelerations.end(), found.begin(), found.end());
}

}  // namespace

RecordingQuality recordingQuality(const BoutLibrary& library, const Progress& progress) {
    RecordingQuality result;
    std::size_t take = 0;
    if (!longestTake(library, take)) return result;
    JudgedMotion judged;
    std::array<Clip, 2> clips;
    // Both on one clock: what begins later is judged from then on.
    double begin = 0;
    for (const int player : {0, 1})
        begin = std::max(begin, (*library.fighter(player).clips)[take].offset);
    for (const int player : {0, 1}) {
        const LibraryFighter& fighter = library.fighter(player);
        const LibraryClip& source = (*fighter.clips)[take];
        const int first = source.frameAt(begin);
        Clip& clip = clips[static_cast<std::size_t>(player)];
        clip = {source.clip.rig,
                source.clip.rate,
                {source.clip.frames.begin() + first, source.clip.frames.end()}};
        JudgedFighter& one = judged.fighters.emplace_back();
        one.clip = &clip;
        LabelSequence labels;
        for (const BoutAction& action : fighter.actions) {
            if (action.clip != static_cast<int>(take)) continue;
            if (action.begin > first) one.joins.push_back(action.begin - first);
            if (action.node >= 0) labels.push_back(library.graph->node(player, action.node).text);
            if (action.role == ActionRole::Reaction && action.lag)
                judged.hits.push_back({0, *action.lag, library.typicalLag});
        }
        judged.labels.push_back(std::move(labels));
    }
    result.bar = barOf(judged);
    result.quality = measureQuality(judged, result.bar, progress);
    return result;
}

Quality boutQuality(const BoutTape& tape, const JointMotionBar& bar, const Progress& progress) {
    const BoutLibrary& library = tape.first().library();
    JudgedMotion judged;
    std::array<Clip, 2> clips;
    for (const std::size_t p : {0, 1}) {
        clips[p] = {library.fighters[p].rig, library.rate, {}};
        judged.fighters.push_back({&clips[p], 0, {}});
        judged.labels.emplace_back();
    }
    std::map<Shown, double> moments;
    std::vector<float> recorded;
    std::vector<std::pair<std::shared_ptr<const BoutChoice>, std::array<Shown, 2>>> meetings;
    tape.replay(
        [&](const Bout& bout) {
            for (const int player : {0, 1}) {
                const FighterShown& shown = bout.shown(player);
                clips[static_cast<std::size_t>(player)].frames.push_back(shown.pose);
                moments[{player, shown.actionBegin}] = shown.momentFrame;
            }
            for (const auto& choice : bout.newChoices()) {
                const auto slot = static_cast<std::size_t>(choice->player);
                judged.fighters[slot].joins.push_back(choice->frame);
                const LibraryFighter& fighter = library.fighter(choice->player);
                addRecordedBeginning(fighter, fighter.action(choice->action), recorded);
                if (choice->node >= 0)
                    judged.labels[slot].push_back(
                        library.graph->node(choice->player, choice->node).text);
                if (!choice->coupling) continue;
                const int other = 1 - choice->player;
                meetings.push_back({choice,
                                    {Shown{choice->player, choice->frame},
                                     Shown{other, bout.shown(other).actionBegin}}});
            }
        },
        progress.part(0, 0.5));
    for (const auto& [choice, both] : meetings) {
        const double own = moments[both[0]] / library.rate;
        const double other = moments[both[1]] / library.rate;
        const BoutAction& action = library.fighter(choice->player).action(choice->action);
        if (action.role == ActionRole::Reaction) {
            judged.hits.push_back({other, own, choice->coupling->lag});
        } else {
            judged.hits.push_back({own, other, -choice->coupling->lag});
        }
    }
    Quality quality = measureQuality(judged, bar, progress.part(0.5, 1));
    if (!recorded.empty() && bar.acceleration > 0)
        quality.recordedAccelerationRatio =
            percentile(std::move(recorded), 0.99) / bar.acceleration;
    return quality;
}

}  // namespace kumite
