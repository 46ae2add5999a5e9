#include "core/interaction/bout_numbers.h"

#include <cassert>
#include <limits>

namespace kumite {

BoutNumbers boutNumbers(const CoupledGraph& graph, const std::vector<TakeTracks>& tracks) {
    BoutNumbers numbers;
    for (const std::size_t player : {0, 1}) {
        for (const BasicAction& action : graph.actions[player]) {
            const FighterTrack* track = tracks[static_cast<std::size_t>(action.take)][player];
            numbers.summaries[player].push_back(track ? summarise(*track, action.frames)
                                                      : ActionSummary());
        }
    }
    for (const std::size_t mover : {0, 1}) {
        for (const Transition& transition : graph.transitions[mover]) {
            const BasicAction& next =
                graph.actions[mover][static_cast<std::size_t>(transition.next)];
            const TakeTracks& take = tracks[static_cast<std::size_t>(next.take)];
            assert(take[0] && take[1]);
            numbers.grounds[mover].push_back(
                transitionGround(*take[mover], *take[1 - mover], next.frames.begin));
        }
    }
    return numbers;
}

Eigen::MatrixXd transitionMatrix(const CoupledGraph& graph, const BoutNumbers& numbers, int mover,
                                 const PoseSpace& space, int k, TransitionNumbers kind) {
    const auto slot = static_cast<std::size_t>(mover);
    const std::vector<Transition>& transitions = graph.transitions[slot];
    const bool targets = kind == TransitionNumbers::WithTarget;
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(transitions.size()),
                         6 * (3 + k) + (targets ? 2 : 0));
    for (std::size_t i = 0; i < transitions.size(); ++i) {
        const Transition& t = transitions[i];
        const TransitionGround& ground = numbers.grounds[slot][i];
        auto row = rows.row(static_cast<Eigen::Index>(i));
        if (targets && !ground.target) {
            row.setConstant(std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        const auto& own = numbers.summaries[slot];
        row = transitionNumbers(ground.frame, own[static_cast<std::size_t>(t.own)],
                                numbers.summaries[1 - slot][static_cast<std::size_t>(t.opponent)],
                                &own[static_cast<std::size_t>(t.next)], space, k,
                                targets ? &*ground.target : nullptr)
                  .transpose();
    }
    return rows;
}

}  // namespace kumite
