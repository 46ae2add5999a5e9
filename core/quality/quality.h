#pragma once

#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/progress.h"
#include "core/quality/body_quality.h"
#include "core/quality/joint_motion.h"
#include "core/quality/label_statistics.h"

namespace kumite {

/// One fighter of what is judged. The clip stands in the bout's space.
struct JudgedFighter {
    const Clip* clip = nullptr;
    double floor = 0;        ///< metres
    std::vector<int> joins;  ///< frames where one action ends and the next begins
};

/// What is judged: one fighter or two at one rate on one clock, a synthesised motion or a
/// recording. What is not known is left empty and its measures say nothing.
struct JudgedMotion {
    std::vector<JudgedFighter> fighters;
    std::vector<HitMoments> hits;
    std::vector<LabelSequence> labels;
};

/// How good a motion is (issue of bouts, item 7; the words are defined in body_quality.h,
/// joint_motion.h and label_statistics.h). Measures of one body are the mean of both fighters,
/// worst values the worse of them.
struct Quality {
    std::optional<double> footSkate;  ///< share of frame intervals
    std::optional<Penetration> floor;
    std::optional<Penetration> interpenetration;
    std::optional<double> joinAccelerationRatio;  ///< 99th percentiles, joins over the bar
    std::optional<double> joinVelocityRatio;
    /// Of a synthesised motion: the first one, had its actions begun as they did when they were
    /// recorded. What goes beyond that is due to joins, the rest to what was chosen.
    std::optional<double> recordedAccelerationRatio;
    std::optional<double> facingError;  ///< radians
    std::optional<FighterDistance> distance;
    std::optional<double> hitTiming;    ///< seconds
    std::optional<NgramCount> variety;  ///< of three labels in a row
};

/// Judges a motion. Joins are held against `bar`; without one, against what lies between the
/// motion's own joins. Cancellable.
Quality measureQuality(const JudgedMotion& motion, std::optional<JointMotionBar> bar = {},
                       const Progress& progress = {});

/// The bar that a recording sets: joint motion inside its actions, both fighters together.
JointMotionBar barOf(const JudgedMotion& recording);

/// As the command line writes it: `foot_skate`, `penetration`, `interpenetration` (shares),
/// `penetration_cm`, `interpenetration_cm` (worst), `join_acceleration_p99_ratio`,
/// `join_velocity_p99_ratio`, `join_acceleration_p99_ratio_as_recorded`, `facing_error_deg`,
/// `distance_m` {`nearest`, `mean`, `farthest`}, `hit_timing_ms`, `variety` (share of distinct runs
/// of three labels). Null where not known.
nlohmann::ordered_json qualityJson(const Quality& quality);

}  // namespace kumite
