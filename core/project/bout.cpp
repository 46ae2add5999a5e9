#include "core/project/bout.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/parallel.h"
#include "core/motion/blend.h"
#include "core/motion/feet.h"
#include "core/synthesis/moments.h"

namespace kumite {
namespace {

/// Faster recordings are halved until they are no faster: what a screen shows.
constexpr double kFastest = 60.5;  ///< Hz

double boutRate(double rate) {
    while (rate > kFastest)
        rate /= 2;
    return rate;
}

/// A fighter's take at the bout's rate, in its space.
LibraryClip clipFor(const FighterAnalysis& values, const FighterTrack& track,
                    const std::shared_ptr<const Rig>& rig, double rate, const Progress& progress) {
    const Fighter& fighter = values.input;
    LibraryClip result;
    const FrameRange frames = framesOf(fighter);
    result.clip =
        rig ? clipOf(*fighter.motion, frames, fighter.space, rig, fighter.rate, progress)
            : clipOf(*fighter.motion, frames, fighter.space, fighter.roles, fighter.rate, progress);
    if (std::abs(rate - fighter.rate) > 1e-9) result.clip = resampled(result.clip, rate);
    result.clip = moved(std::move(result.clip), GroundTransform{track.yaw, track.x, track.z});
    for (Pose& pose : result.clip.frames)
        pose.root.y() -= values.body->floor;
    result.offset = fighter.offset;
    for (const bool left : {true, false}) {
        if (const auto point = footPoint(*fighter.motion->skeleton, fighter.roles, left))
            result.footRest[left ? 0 : 1] =
                restHeight(*track.positions, *point) - values.body->floor;
    }
    const int last = track.frameCount() - 1;
    for (int i = 0; i < result.clip.frameCount(); ++i) {
        const double at = std::min(i * fighter.rate / rate, static_cast<double>(last));
        const int whole = std::min(static_cast<int>(at), std::max(0, last - 1));
        const int next = std::min(whole + 1, last);
        const double share = at - whole;
        const auto yaw = [&](int frame) {
            return track.heading[static_cast<std::size_t>(frame)] + track.yaw;
        };
        result.stations.push_back(
            {track.root(whole) + share * (track.root(next) - track.root(whole)),
             yaw(whole) + share * (yaw(next) - yaw(whole))});
        result.com.push_back(track.comOnGround(whole) +
                             share * (track.comOnGround(next) - track.comOnGround(whole)));
        const auto nearest = static_cast<std::size_t>(std::lround(at));
        const FootContacts& contacts = values.body->contacts;
        if (nearest < contacts.left.size()) result.contacts.left.push_back(contacts.left[nearest]);
        if (nearest < contacts.right.size())
            result.contacts.right.push_back(contacts.right[nearest]);
    }
    return result;
}

/// The frames of a take that actions hold, as one range.
FrameRange framesHeld(const CoupledGraph& graph, int player, int take,
                      const std::vector<char>& actions) {
    FrameRange held;
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const BasicAction& action = graph.action(player, static_cast<int>(i));
        if (!actions[i] || action.take != take) continue;
        held = held.empty() ? FrameRange{action.frames.begin, action.frames.end}
                            : FrameRange{std::min(held.begin, action.frames.begin),
                                         std::max(held.end, action.frames.end)};
    }
    return held;
}

}  // namespace

bool sameJoints(const Rig& rig, const Skeleton& skeleton) {
    return std::equal(rig.joints.begin(), rig.joints.end(), skeleton.joints.begin(),
                      skeleton.joints.end(), [](const Rig::Joint& a, const Joint& b) {
                          return a.name == b.name && a.parent == b.parent;
                      });
}

std::shared_ptr<const BoutLibrary> boutLibrary(const Project& project, const Analysis& analysis,
                                               const Interaction& interaction,
                                               const Progress& progress) {
    if (const auto why = whyNoModel(project, interaction)) throw Error(*why);
    LibrarySource source;
    source.components = interaction.settings.components;
    source.geometry = interaction.settings.geometry;
    source.graph = interaction.graph;
    source.numbers = interaction.numbers;
    source.poses = interaction.poses;
    Findings findings;
    const BoutTracks tracks = boutTracks(analysis);
    for (const auto& take : analysis.takes) {
        for (const FighterAnalysis& values : take) {
            if (values.available() && source.rate == 0) source.rate = boutRate(values.input.rate);
        }
    }
    std::array<std::shared_ptr<const Rig>, 2> rigs;
    for (std::size_t t = 0; t < analysis.takes.size(); ++t) {
        for (const std::size_t p : {0, 1}) {
            source.clips[p].emplace_back();
            const FighterTrack* track = tracks.takes[t][p];
            if (!track || analysis.takes[t].size() < 2) continue;
            const FighterAnalysis& values = analysis.takes[t][p];
            if (rigs[p] && !sameJoints(*rigs[p], *values.input.motion->skeleton)) {
                findings.push_back(
                    warning(fmt::format("Take {}, player {}: its skeleton has other joints than "
                                        "that of the first take, "
                                        "so it is left out of bouts.",
                                        project.takes[t].name, p + 1)));
                continue;
            }
            const double share =
                static_cast<double>(2 * t + p) / static_cast<double>(2 * analysis.takes.size());
            source.clips[p].back() =
                clipFor(values, *track, rigs[p], source.rate, progress.part(share, share));
            rigs[p] = source.clips[p].back().clip.rig;
        }
    }
    for (const std::size_t mover : {0, 1}) {
        source.labelTerms[mover] = interaction.models[mover]->labels;
        source.geometryTerms[mover] = interaction.models[mover]->geometry;
        source.rows[mover] = interaction.models[mover]->numbers;
    }
    source.findings = std::move(findings);
    auto library = boutLibrary(std::move(source));
    progress.update(1);
    return library;
}

// ---- passive -----------------------------------------------------------------------------------

CapturedAttack attackIn(const Interaction& interaction, int attacker, int take, FrameRange frames) {
    const CoupledGraph& graph = *interaction.graph;
    CapturedAttack attack;
    attack.attacker = attacker;
    bool striking = false;
    const auto& all = graph.actions[static_cast<std::size_t>(attacker)];
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].take != take || !frames.contains(all[i].frames.begin)) continue;
        attack.actions.push_back(static_cast<int>(i));
        striking =
            striking || (all[i].node >= 0 &&
                         strikes(*graph.vocabulary, graph.node(attacker, all[i].node).label));
    }
    if (attack.actions.empty()) {
        throw Error(fmt::format("No action of player {} begins in frames {} to {} of take {}.",
                                attacker + 1, frames.begin, frames.end,
                                graph.takes[static_cast<std::size_t>(take)]));
    }
    if (!striking) {
        throw Error(fmt::format("Player {} does not attack in frames {} to {} of take {}.",
                                attacker + 1, frames.begin, frames.end,
                                graph.takes[static_cast<std::size_t>(take)]));
    }
    return attack;
}

CapturedAttack busiestAttack(const Interaction& interaction, int attacker, double seconds) {
    const CoupledGraph& graph = *interaction.graph;
    const auto& all = graph.actions[static_cast<std::size_t>(attacker)];
    std::vector<char> strike;
    for (const BasicAction& action : all) {
        strike.push_back(action.node >= 0 &&
                         strikes(*graph.vocabulary, graph.node(attacker, action.node).label));
    }
    CapturedAttack best;
    best.attacker = attacker;
    int most = 0;
    // A window that begins with each action in turn; both ends move on only.
    std::size_t end = 0;
    int inside = 0;
    for (std::size_t begin = 0; begin < all.size(); ++begin) {
        if (end < begin) end = begin;
        while (end < all.size() && all[end].take == all[begin].take &&
               (end == begin || all[end].endSeconds <= all[begin].beginSeconds + seconds))
            inside += strike[end++];
        if (inside > most) {
            most = inside;
            best.actions.clear();
            for (std::size_t i = begin; i < end; ++i)
                best.actions.push_back(static_cast<int>(i));
        }
        inside -= strike[begin];
    }
    if (most == 0) throw Error(fmt::format("Player {} never attacks.", attacker + 1));
    return best;
}

std::array<std::vector<char>, 2> leftOutWith(const CoupledGraph& graph,
                                             const CapturedAttack& attack) {
    std::array<std::vector<char>, 2> out;
    const auto attacker = static_cast<std::size_t>(attack.attacker);
    for (const std::size_t p : {0, 1})
        out[p].assign(graph.actions[p].size(), 0);
    for (const int index : attack.actions) {
        const BasicAction& action = graph.action(attack.attacker, index);
        out[attacker][static_cast<std::size_t>(index)] = 1;
        const auto& others = graph.actions[1 - attacker];
        for (std::size_t i = 0; i < others.size(); ++i) {
            if (others[i].take == action.take && others[i].beginSeconds < action.endSeconds &&
                others[i].endSeconds > action.beginSeconds)
                out[1 - attacker][i] = 1;
        }
    }
    return out;
}

Interaction interactionWithout(const Analysis& analysis, const Interaction& interaction,
                               const CapturedAttack& attack, const Progress& progress) {
    const auto out = leftOutWith(*interaction.graph, attack);
    const int take = interaction.graph->action(attack.attacker, attack.actions.front()).take;
    Interaction rest = interaction;
    auto graph = std::make_shared<CoupledGraph>(*interaction.graph);
    auto numbers = std::make_shared<BoutNumbers>(*interaction.numbers);
    for (const std::size_t mover : {0, 1}) {
        graph->transitions[mover].clear();
        numbers->grounds[mover].clear();
        const auto& all = interaction.graph->transitions[mover];
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool touched = out[mover][static_cast<std::size_t>(all[i].own)] ||
                                 out[mover][static_cast<std::size_t>(all[i].next)] ||
                                 out[1 - mover][static_cast<std::size_t>(all[i].opponent)];
            if (touched) continue;
            graph->transitions[mover].push_back(all[i]);
            numbers->grounds[mover].push_back(interaction.numbers->grounds[mover][i]);
        }
    }
    const BoutTracks tracks = boutTracks(analysis);
    PoseMoments sum;
    for (std::size_t t = 0; t < tracks.takes.size(); ++t) {
        for (const std::size_t p : {0, 1}) {
            const FighterTrack* track = tracks.takes[t][p];
            if (!track) continue;
            const FrameRange held =
                framesHeld(*graph, static_cast<int>(p), static_cast<int>(t), out[p]);
            if (static_cast<int>(t) == take && !held.empty()) {
                sum.add(poseMoments(*track, {0, held.begin}));
                sum.add(poseMoments(*track, {held.end, track->frameCount()}));
                continue;
            }
            const auto& motion = analysis.takes[t][p].motion;
            for (const FighterPoses& known : interaction.fighterPoses) {
                if (known.motion == motion) sum.add(*known.moments);
            }
        }
    }
    rest.fighterPoses.clear();
    rest.poses = std::make_shared<const PoseSpace>(poseSpace(sum));
    rest.graph = graph;
    rest.numbers = numbers;
    progress.update(0.2);
    forBlocks({0, 2}, 1, [&](FrameRange movers) {
        const int mover = movers.begin;
        rest.models[static_cast<std::size_t>(mover)] =
            std::make_shared<const TransitionModel>(learnTransitionModel(
                graph, mover, rest.settings.estimator, rest.settings.geometry,
                transitionMatrix(*graph, *numbers, mover, *rest.poses, rest.settings.components),
                mover == 0 ? progress.part(0.2, 1) : Progress{{}, progress.stop}));
    });
    progress.update(1);
    return rest;
}

}  // namespace kumite
