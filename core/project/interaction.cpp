#include "core/project/interaction.h"

#include <algorithm>
#include <atomic>

#include <fmt/format.h>

#include "core/base/parallel.h"

namespace kumite {
namespace {

/// Whether a fighter's poses and its centre of mass are known.
bool hasTrack(const FighterAnalysis& values) {
    return values.available() && values.frameCount() > 0 && !values.body->com.position.empty() &&
           values.input.roles.has(Role::Pelvis);
}

FighterTrack trackOf(const FighterAnalysis& values) {
    const Fighter& fighter = values.input;
    FighterTrack track;
    track.positions = &values.motion->positions;
    track.pelvis = *fighter.roles[Role::Pelvis];
    track.joints = featureJoints(*fighter.motion->skeleton, fighter.roles);
    track.heading = values.body->heading;
    track.com = values.body->com.position;
    track.rate = fighter.rate;
    track.offset = fighter.offset;
    track.x = fighter.placement.x;
    track.z = fighter.placement.z;
    track.yaw = fighter.placement.yaw;
    return track;
}

/// Takes as the graph wants them. A fighter without a body has actions, but no labels that count.
std::vector<LabelledTake> labelledTakes(const Project& project, const Analysis& analysis,
                                        Findings& findings) {
    std::vector<LabelledTake> takes;
    for (const Take& take : project.takes) {
        LabelledTake& labelled = takes.emplace_back();
        labelled.name = take.name;
        for (const Fighter& fighter : take.fighters)
            labelled.players.push_back({fighter.rate, fighter.offset, 0, {}, {}});
    }
    for (const FighterLabels& fighter : effectiveLabels(project, analysis)) {
        const FighterAnalysis& values = analysis.at(fighter.fighter);
        LabelledTake& take = takes[static_cast<std::size_t>(fighter.fighter.take)];
        LabelledStream& stream = take.players[static_cast<std::size_t>(fighter.fighter.player)];
        stream.frameCount = values.frameCount();
        stream.actions = values.segmentation->actions;
        const bool usable = hasTrack(values);
        for (const ActionLabel& label : fighter.labels)
            stream.labels.push_back(usable && label.anyKnown() ? label.label() : Label());
        if (!usable) {
            findings.push_back(warning(
                fmt::format("Take {}, player {}: no pelvis or no centre of mass is known, so its "
                            "actions are left out.",
                            take.name, fighter.fighter.player + 1)));
        }
    }
    return takes;
}

void reportOpenActions(const CoupledGraph& graph, Findings& findings) {
    for (const int player : {0, 1}) {
        const auto& actions = graph.actions[static_cast<std::size_t>(player)];
        const auto open = std::count_if(actions.begin(), actions.end(),
                                        [](const BasicAction& each) { return each.node < 0; });
        if (open == 0 || open == static_cast<std::ptrdiff_t>(actions.size())) continue;
        findings.push_back(warning(
            fmt::format("Player {}: {} of {} actions have no label and are left out, with every "
                        "transition that touches them.",
                        player + 1, open, actions.size())));
    }
}

bool sameGraph(const CoupledGraph& a, const CoupledGraph& b) {
    return a.vocabulary == b.vocabulary && a.takes == b.takes && a.actions == b.actions &&
           a.nodes == b.nodes && a.transitions == b.transitions;
}

/// The moments of every fighter with a track, taken over where motion and body are the same.
std::vector<FighterPoses> fighterPoses(const Analysis& analysis, const Interaction& previous,
                                       const Progress& progress) {
    std::vector<FighterPoses> all;
    for (const auto& take : analysis.takes) {
        for (const FighterAnalysis& values : take) {
            if (!hasTrack(values)) continue;
            FighterPoses now{values.motion, values.body, nullptr};
            const auto old =
                std::find_if(previous.fighterPoses.begin(), previous.fighterPoses.end(),
                             [&](const FighterPoses& each) {
                                 return each.motion == now.motion && each.body == now.body;
                             });
            now.moments = old != previous.fighterPoses.end()
                              ? old->moments
                              : std::make_shared<const PoseMoments>(poseMoments(
                                    trackOf(values), {0, values.frameCount()}, progress));
            all.push_back(std::move(now));
        }
    }
    return all;
}

/// Two pieces of work at the same time as halves of one.
std::array<Progress, 2> sideBySide(const Progress& whole) {
    std::array<Progress, 2> halves{whole, whole};
    if (!whole.report) return halves;
    const auto done = std::make_shared<std::array<std::atomic<double>, 2>>();
    for (std::size_t i = 0; i < 2; ++i) {
        halves[i].report = [report = whole.report, done, i](double fraction) {
            (*done)[i] = fraction;
            report(0.5 * ((*done)[0] + (*done)[1]));
        };
    }
    return halves;
}

std::shared_ptr<const PoseSpace> commonSpace(const std::vector<FighterPoses>& fighters,
                                             const Interaction& previous) {
    const bool known =
        previous.poses &&
        std::equal(fighters.begin(), fighters.end(), previous.fighterPoses.begin(),
                   previous.fighterPoses.end(), [](const FighterPoses& a, const FighterPoses& b) {
                       return a.moments == b.moments;
                   });
    if (known) return previous.poses;
    PoseMoments sum;
    for (const FighterPoses& fighter : fighters)
        sum.add(*fighter.moments);
    return std::make_shared<const PoseSpace>(poseSpace(sum));
}

}  // namespace

BoutTracks boutTracks(const Analysis& analysis) {
    BoutTracks tracks;
    for (const auto& take : analysis.takes) {
        TakeTracks& pair = tracks.takes.emplace_back(TakeTracks{nullptr, nullptr});
        for (std::size_t p = 0; p < std::min<std::size_t>(2, take.size()); ++p) {
            if (!hasTrack(take[p])) continue;
            tracks.all.push_back(std::make_unique<FighterTrack>(trackOf(take[p])));
            pair[p] = tracks.all.back().get();
        }
    }
    return tracks;
}

Interaction deriveInteraction(const Project& project, const Analysis& analysis,
                              const InteractionSettings& settings, const Interaction& previous,
                              const Progress& progress) {
    Interaction now;
    now.settings = settings;
    progress.update(0);
    auto graph = std::make_shared<const CoupledGraph>(
        coupledGraph(project.labelling.vocabulary, labelledTakes(project, analysis, now.findings)));
    now.graph = previous.graph && sameGraph(*previous.graph, *graph) ? previous.graph : graph;
    reportOpenActions(*now.graph, now.findings);
    now.fighterPoses = fighterPoses(analysis, previous, progress.part(0.05, 0.3));
    now.poses = commonSpace(now.fighterPoses, previous);

    const BoutTracks tracks = boutTracks(analysis);
    auto numbers = std::make_shared<const BoutNumbers>(boutNumbers(*now.graph, tracks.takes));
    progress.update(0.4);
    const bool unchanged = now.graph == previous.graph && now.poses == previous.poses &&
                           settings == previous.settings && *numbers == *previous.numbers;
    if (unchanged) {
        now.numbers = previous.numbers;
        now.models = previous.models;
        progress.update(1);
        return now;
    }
    now.numbers = numbers;
    const std::array<Progress, 2> training = sideBySide(progress.part(0.4, 1));
    forBlocks({0, 2}, 1, [&](FrameRange movers) {
        const int mover = movers.begin;
        now.models[static_cast<std::size_t>(mover)] = std::make_shared<const TransitionModel>(
            learnTransitionModel(now.graph, mover, settings.estimator, settings.geometry,
                                 transitionMatrix(*now.graph, *now.numbers, mover, *now.poses,
                                                  settings.components, settings.numbers),
                                 training[static_cast<std::size_t>(mover)]));
    });
    progress.update(1);
    return now;
}

std::optional<std::string> whyNoModel(const Project& project, const Interaction& interaction) {
    if (!interaction.graph->transitions[0].empty() || !interaction.graph->transitions[1].empty()) {
        return std::nullopt;
    }
    const bool pairs = std::any_of(project.takes.begin(), project.takes.end(),
                                   [](const Take& take) { return take.fighters.size() == 2; });
    if (!pairs) return "A model of two fighters needs a take with two of them.";
    if (interaction.graph->nodes[0].empty() && interaction.graph->nodes[1].empty()) {
        return "No action is labelled yet: label some by hand and let the machine do the rest "
               "(kumite label --auto), or import labels (kumite label --import).";
    }
    return "No transition has the labels of all its three actions: label more of both fighters.";
}

Moment momentAt(const Analysis& analysis, const Interaction& interaction, int take, int frame,
                int mover) {
    const CoupledGraph& graph = *interaction.graph;
    Moment moment;
    const auto& fighters = analysis.takes.at(static_cast<std::size_t>(take));
    if (fighters.size() < 2) return moment;
    const auto slot = static_cast<std::size_t>(mover);
    // The actions of B of this take stand together, in order.
    const auto inTake = [&](std::size_t player, int shown) {
        const auto& all = graph.actions[player];
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool holds =
                all[i].take == take && all[i].frames.begin <= shown &&
                (shown < all[i].frames.end || (all[i].next < 0 && shown <= all[i].frames.end));
            if (holds) return static_cast<int>(i);
        }
        return -1;
    };
    const Fighter& own = fighters[slot].input;
    const Fighter& other = fighters[1 - slot].input;
    // At the very first frame nothing was before: what begins there is under way.
    const int shown = std::max(0, frame - 1);
    moment.ownAction = inTake(slot, shown);
    moment.opponentAction = inTake(
        1 - slot, frameBefore(own.offset + (shown + 1) / own.rate, other.rate, other.offset));
    if (moment.ownAction < 0 || moment.opponentAction < 0) return moment;
    moment.own = graph.action(mover, moment.ownAction).node;
    moment.opponent = graph.action(1 - mover, moment.opponentAction).node;
    const BoutTracks tracks = boutTracks(analysis);
    const TakeTracks& pair = tracks.takes[static_cast<std::size_t>(take)];
    if (!pair[0] || !pair[1]) return moment;
    const int inside = std::clamp(frame, 0, pair[slot]->frameCount() - 1);
    const TransitionGround ground = transitionGround(*pair[slot], *pair[1 - slot], inside);
    const auto summary = [&](std::size_t player, int action) -> const ActionSummary& {
        return interaction.numbers->summaries[player][static_cast<std::size_t>(action)];
    };
    const bool led = interaction.settings.numbers == TransitionNumbers::WithTarget;
    if (!led || ground.target) {
        moment.numbers =
            transitionNumbers(ground.frame, summary(slot, moment.ownAction),
                              summary(1 - slot, moment.opponentAction), nullptr, *interaction.poses,
                              interaction.settings.components, led ? &*ground.target : nullptr);
    }
    const auto found = transitionAt(graph, mover, take, frame);
    if (found) {
        const Transition& t = graph.transitionsOf(mover)[static_cast<std::size_t>(*found)];
        if (graph.action(mover, t.next).frames.begin == frame) moment.transition = found;
    }
    return moment;
}

std::vector<NextLabel> nextLabels(const Interaction& interaction, int mover, const Moment& moment) {
    const TransitionModel& model = *interaction.models[static_cast<std::size_t>(mover)];
    return nextLabels(model, moment.own, moment.opponent,
                      moment.numbers.size() > 0 ? &moment.numbers : nullptr);
}

}  // namespace kumite
