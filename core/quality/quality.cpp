#include "core/quality/quality.h"

#include <algorithm>
#include <numbers>

namespace kumite {
namespace {

void append(JointMotion& all, const JointMotion& part) {
    all.velocity.insert(all.velocity.end(), part.velocity.begin(), part.velocity.end());
    all.acceleration.insert(all.acceleration.end(), part.acceleration.begin(),
                            part.acceleration.end());
}

JoinMotion joinsOf(const JudgedMotion& motion) {
    JoinMotion all;
    for (const JudgedFighter& fighter : motion.fighters) {
        const JoinMotion own = measureJoins(*fighter.clip, fighter.joins);
        append(all.atJoins, own.atJoins);
        append(all.inside, own.inside);
    }
    return all;
}

std::optional<double> ratio(double value, double bar) {
    return bar > 0 ? std::optional(value / bar) : std::nullopt;
}

std::optional<double> meanOf(const std::vector<double>& values) {
    if (values.empty()) return std::nullopt;
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

nlohmann::ordered_json orNull(const std::optional<double>& value, double factor = 1) {
    if (!value) return nullptr;
    return *value * factor;
}

}  // namespace

Quality measureQuality(const JudgedMotion& motion, std::optional<JointMotionBar> bar,
                       const Progress& progress) {
    Quality quality;
    std::vector<MeasuredBody> bodies;
    for (const JudgedFighter& fighter : motion.fighters) {
        bodies.push_back(measuredBody(*fighter.clip, fighter.floor));
        progress.update(0.2 * static_cast<double>(bodies.size()));
    }

    std::vector<double> skates, shares;
    for (const MeasuredBody& body : bodies) {
        if (const auto skate = footSkateOf(body)) skates.push_back(*skate);
        if (const auto penetration = floorPenetration(body)) {
            shares.push_back(penetration->share);
            if (!quality.floor) quality.floor = Penetration{};
            quality.floor->worst = std::max(quality.floor->worst, penetration->worst);
        }
    }
    quality.footSkate = meanOf(skates);
    if (quality.floor) quality.floor->share = *meanOf(shares);
    progress.update(0.5);

    const JoinMotion joins = joinsOf(motion);
    if (!joins.atJoins.acceleration.empty()) {
        const JointMotionBar reached = barOf(joins.atJoins);
        const JointMotionBar held = bar.value_or(barOf(joins.inside));
        quality.joinAccelerationRatio = ratio(reached.acceleration, held.acceleration);
        quality.joinVelocityRatio = ratio(reached.velocity, held.velocity);
    }
    progress.update(0.7);

    if (bodies.size() == 2) {
        quality.interpenetration = interpenetration(bodies[0], bodies[1]);
        quality.facingError =
            0.5 * (facingError(bodies[0], bodies[1]) + facingError(bodies[1], bodies[0]));
        quality.distance = fighterDistance(bodies[0], bodies[1]);
    }
    quality.hitTiming = hitTimingError(motion.hits);
    if (const NgramCount runs = countNgrams(motion.labels, 3); runs.total > 0)
        quality.variety = runs;
    progress.update(1);
    return quality;
}

JointMotionBar barOf(const JudgedMotion& recording) {
    return barOf(joinsOf(recording).inside);
}

nlohmann::ordered_json qualityJson(const Quality& quality) {
    const auto share = [](const std::optional<Penetration>& p) {
        return p ? std::optional(p->share) : std::nullopt;
    };
    const auto worst = [](const std::optional<Penetration>& p) {
        return p ? std::optional(p->worst) : std::nullopt;
    };
    nlohmann::ordered_json json;
    json["foot_skate"] = orNull(quality.footSkate);
    json["penetration"] = orNull(share(quality.floor));
    json["penetration_cm"] = orNull(worst(quality.floor), 100);
    json["interpenetration"] = orNull(share(quality.interpenetration));
    json["interpenetration_cm"] = orNull(worst(quality.interpenetration), 100);
    json["join_acceleration_p99_ratio"] = orNull(quality.joinAccelerationRatio);
    json["join_velocity_p99_ratio"] = orNull(quality.joinVelocityRatio);
    json["join_acceleration_p99_ratio_as_recorded"] = orNull(quality.recordedAccelerationRatio);
    json["facing_error_deg"] = orNull(quality.facingError, 180 / std::numbers::pi);
    json["distance_m"] = nullptr;
    if (const auto& distance = quality.distance) {
        json["distance_m"] = {{"nearest", distance->nearest},
                              {"mean", distance->mean},
                              {"farthest", distance->farthest}};
    }
    json["hit_timing_ms"] = orNull(quality.hitTiming, 1000);
    json["variety"] =
        orNull(quality.variety ? std::optional(quality.variety->share()) : std::nullopt);
    return json;
}

}  // namespace kumite
