#include "core/interaction/basic_structure.h"

#include <algorithm>
#include <cmath>

namespace kumite {

int frameBefore(double seconds, double rate, double offset) {
    // A clock that is a rounding error late must not show the frame itself.
    return static_cast<int>(std::ceil((seconds - offset) * rate - 1e-6)) - 1;
}

int actionBefore(std::span<const Action> actions, int frame) {
    const int shown = frame - 1;
    const auto after = std::upper_bound(actions.begin(), actions.end(), shown,
                                        [](int f, const Action& each) { return f < each.begin; });
    if (after == actions.begin()) return -1;
    const auto found = after - 1;
    return shown <= found->end ? static_cast<int>(found - actions.begin()) : -1;
}

BasicStructure basicStructure(std::span<const LabelledTake> takes) {
    BasicStructure all;
    for (std::size_t t = 0; t < takes.size(); ++t) {
        const LabelledTake& take = takes[t];
        const std::array<int, 2> first = {static_cast<int>(all[0].size()),
                                          static_cast<int>(all[1].size())};
        for (std::size_t p = 0; p < std::min<std::size_t>(2, take.players.size()); ++p) {
            const LabelledStream& stream = take.players[p];
            const int count = static_cast<int>(stream.actions.size());
            for (int i = 0; i < count; ++i) {
                BasicAction action;
                action.take = static_cast<int>(t);
                action.index = i;
                action.frames = stream.actions[static_cast<std::size_t>(i)];
                action.beginSeconds = stream.offset + action.frames.begin / stream.rate;
                action.endSeconds = stream.offset + action.frames.end / stream.rate;
                if (i + 1 < count) action.next = first[p] + i + 1;
                if (take.players.size() > 1) {
                    const LabelledStream& other = take.players[1 - p];
                    const int before = frameBefore(action.beginSeconds, other.rate, other.offset);
                    const int found = actionBefore(other.actions, before + 1);
                    if (found >= 0) action.inProgress = first[1 - p] + found;
                }
                all[p].push_back(action);
            }
        }
    }
    return all;
}

}  // namespace kumite
