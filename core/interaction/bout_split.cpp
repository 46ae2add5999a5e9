#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "core/base/error.h"
#include "core/interaction/cross_validation.h"

namespace kumite {
namespace {

constexpr int kFewestBlocks = 9;
constexpr double kValidationShare = 1.0 / 3;

/// How long each take lasts, seconds.
std::vector<double> takeLengths(const CoupledGraph& graph) {
    std::vector<double> lengths(graph.takes.size(), 0.0);
    for (const auto& actions : graph.actions) {
        for (const BasicAction& action : actions) {
            double& length = lengths[static_cast<std::size_t>(action.take)];
            length = std::max(length, action.endSeconds);
        }
    }
    return lengths;
}

/// Cuts takes into blocks of equal length; numbers count through all takes.
class Blocks {
public:
    Blocks(const CoupledGraph& graph, const ValidationSettings& settings)
        : lengths_(takeLengths(graph)) {
        double all = 0;
        for (const double length : lengths_)
            all += length;
        const double longest = std::min(settings.blockSeconds, all / kFewestBlocks);
        for (const double length : lengths_) {
            first_.push_back(count_);
            const bool whole = settings.split == SplitBy::Takes || !(longest > 0);
            perTake_.push_back(
                whole ? 1 : std::max(1, static_cast<int>(std::lround(length / longest))));
            count_ += perTake_.back();
        }
    }
    int count() const { return count_; }
    int at(int take, double seconds) const {
        const auto t = static_cast<std::size_t>(take);
        const double share = lengths_[t] > 0 ? seconds / lengths_[t] : 0;
        const int inside = static_cast<int>(share * perTake_[t]);
        return first_[t] + std::clamp(inside, 0, perTake_[t] - 1);
    }

private:
    std::vector<double> lengths_;
    std::vector<int> first_, perTake_;
    int count_ = 0;
};

/// Which blocks judge: a third of those that have transitions, drawn by the seed.
std::vector<bool> drawValidation(const std::vector<bool>& used, std::uint32_t seed) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) order.push_back(i);
    }
    std::mt19937 random(seed);
    // Fisher–Yates by hand: std::shuffle may differ between libraries.
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    const auto held = std::max<std::size_t>(
        1, static_cast<std::size_t>(
               std::lround(static_cast<double>(order.size()) * kValidationShare)));
    std::vector<bool> validation(used.size(), false);
    for (std::size_t i = 0; i < held; ++i)
        validation[order[i]] = true;
    return validation;
}

}  // namespace

BoutSplit splitBout(const CoupledGraph& graph, const ValidationSettings& settings,
                    std::uint32_t seed) {
    const Blocks blocks(graph, settings);
    const auto blockOf = [&](int mover, const Transition& t) {
        const BasicAction& next = graph.action(mover, t.next);
        return static_cast<std::size_t>(blocks.at(next.take, next.beginSeconds));
    };
    std::vector<bool> used(static_cast<std::size_t>(blocks.count()), false);
    for (const int mover : {0, 1}) {
        for (const Transition& t : graph.transitionsOf(mover))
            used[blockOf(mover, t)] = true;
    }
    if (std::count(used.begin(), used.end(), true) < 2) {
        throw Error(settings.split == SplitBy::Takes
                        ? "A split by takes needs two takes or more with labelled transitions."
                        : "There are too few labelled transitions to set some apart.");
    }
    const std::vector<bool> validation = drawValidation(used, seed);

    BoutSplit split;
    for (const std::size_t player : {0, 1})
        split.learnt[player].assign(graph.actions[player].size(), false);
    const auto each = [&](const auto& visit) {
        for (const int mover : {0, 1}) {
            for (const Transition& t : graph.transitionsOf(mover))
                visit(static_cast<std::size_t>(mover), t, validation[blockOf(mover, t)]);
        }
    };
    each([&](std::size_t mover, const Transition& t, bool held) {
        if (held) return;
        split.learnt[mover][static_cast<std::size_t>(t.own)] = true;
        split.learnt[mover][static_cast<std::size_t>(t.next)] = true;
        split.learnt[1 - mover][static_cast<std::size_t>(t.opponent)] = true;
    });
    each([&](std::size_t mover, const Transition& t, bool held) {
        const bool shared = split.learnt[mover][static_cast<std::size_t>(t.own)] ||
                            split.learnt[mover][static_cast<std::size_t>(t.next)] ||
                            split.learnt[1 - mover][static_cast<std::size_t>(t.opponent)];
        split.sides[mover].push_back(!held    ? HoldoutSide::Training
                                     : shared ? HoldoutSide::LeftOut
                                              : HoldoutSide::Validation);
    });
    return split;
}

}  // namespace kumite
