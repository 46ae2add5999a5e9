#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/demo/com_path.h"
#include "core/demo/process.h"
#include "core/demo/technique.h"

namespace kumite::demo {

/// What the choice of an action was made from.
struct Choice {
    int own = 0;       ///< index in techniques(), the action that ended
    int opponent = 0;  ///< the opponent's in progress
    Range range = Range::Middle;
};

/// One action of the plan, seconds from the bout's begin.
struct PlannedAction {
    double begin = 0;
    double end = 0;
    Technique technique;
    Manner manner = Manner::Guard;  ///< of an action of others
    /// Nothing where the law did not choose: at the bout's begin and end.
    std::optional<Choice> choice;
    KickStyle style = KickStyle::Front;
    Target target = Target::Head;
    double effort = 1;       ///< how far and hard, 0.8 to 1.15
    double flightAtEnd = 0;  ///< seconds without ground about `end`
    std::optional<ForceDip> dip;
    Eigen::Vector2d station;  ///< where the fighter shall stand at `end`: x, z in metres
    int variation = 0;        ///< seed of this action's small differences

    double duration() const { return end - begin; }
};

struct Script {
    Temper temper;
    Eigen::Vector2d start;               ///< station at time 0
    std::vector<PlannedAction> actions;  ///< gapless from 0 to the bout's end

    /// Index of the action in progress at a time (its begin belongs to it).
    int actionAt(double time) const;
    Eigen::Vector2d stationAt(double time) const;
};

/// A bout as a plan: who does what when and where. A stepwise random process in time: at the end
/// of an action the next one is drawn by process.h; an attack shortens what the opponent idles
/// at, so that an answer begins a human reaction time later.
std::array<Script, 2> choreograph(std::uint64_t seed, double seconds);

}  // namespace kumite::demo
