#include "core/quality/body_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/motion/feet.h"
#include "core/motion/overlap.h"

namespace kumite {
namespace {

int commonFrames(const MeasuredBody& first, const MeasuredBody& second) {
    return std::min(first.positions.frameCount, second.positions.frameCount);
}

/// From one root to the other on the floor.
Eigen::Vector3d wayBetween(const MeasuredBody& from, const MeasuredBody& to, int frame) {
    const auto i = static_cast<std::size_t>(frame);
    Eigen::Vector3d way = to.clip->frames[i].root - from.clip->frames[i].root;
    way.y() = 0;
    return way;
}

/// All solids of a body within this of its root, so that bodies apart need no closer look.
double extent(const std::vector<Capsule>& capsules, const Eigen::Vector3d& root) {
    double extent = 0;
    for (const Capsule& capsule : capsules) {
        extent = std::max(extent, capsule.radius + std::max((capsule.a - root).norm(),
                                                            (capsule.b - root).norm()));
    }
    return extent;
}

}  // namespace

MeasuredBody measuredBody(const Clip& clip, double floor) {
    return {&clip, positionsOf(clip), floor};
}

std::optional<double> footSkateOf(const MeasuredBody& body) {
    const auto left = footPoint(*body.clip->rig, true);
    const auto right = footPoint(*body.clip->rig, false);
    if (!left || !right || body.positions.frameCount < 2) return std::nullopt;
    std::vector<Eigen::Vector3f> leftTrack, rightTrack;
    for (int frame = 0; frame < body.positions.frameCount; ++frame) {
        leftTrack.push_back(body.positions.at(frame, *left));
        rightTrack.push_back(body.positions.at(frame, *right));
    }
    return measureFootSkate(leftTrack, rightTrack, body.clip->rate, body.floor).ratio();
}

std::optional<Penetration> floorPenetration(const MeasuredBody& body) {
    std::vector<int> points;
    for (const bool left : {true, false}) {
        if (const auto point = footPoint(*body.clip->rig, left)) points.push_back(*point);
    }
    if (points.empty() || body.positions.frameCount == 0) return std::nullopt;
    Penetration result;
    int frames = 0;
    for (int frame = 0; frame < body.positions.frameCount; ++frame) {
        double deepest = 0;
        for (const int point : points)
            deepest = std::max(deepest, body.floor - body.positions.data(frame, point)[1]);
        frames += deepest > kPenetrationDepth;
        result.worst = std::max(result.worst, deepest);
    }
    result.share = static_cast<double>(frames) / body.positions.frameCount;
    return result;
}

Penetration interpenetration(const MeasuredBody& first, const MeasuredBody& second) {
    Penetration result;
    const int frames = commonFrames(first, second);
    int deep = 0;
    for (int frame = 0; frame < frames; ++frame) {
        const auto i = static_cast<std::size_t>(frame);
        const auto a = bodyCapsules(first.clip->rig->roles, first.positions, frame);
        const auto b = bodyCapsules(second.clip->rig->roles, second.positions, frame);
        const Eigen::Vector3d &here = first.clip->frames[i].root,
                              &there = second.clip->frames[i].root;
        if ((there - here).norm() > extent(a, here) + extent(b, there)) continue;
        const double depth = overlap(a, b);
        deep += depth > kInterpenetrationDepth;
        result.worst = std::max(result.worst, depth);
    }
    if (frames > 0) result.share = static_cast<double>(deep) / frames;
    return result;
}

double facingError(const MeasuredBody& body, const MeasuredBody& other) {
    double sum = 0;
    int known = 0;
    for (int frame = 0; frame < commonFrames(body, other); ++frame) {
        const auto heading =
            headingOf(*body.clip->rig, body.clip->frames[static_cast<std::size_t>(frame)]);
        const Eigen::Vector3d way = wayBetween(body, other, frame);
        if (!heading || way.norm() < 1e-6) continue;
        sum +=
            std::abs(std::remainder(*heading - std::atan2(way.x(), way.z()), 2 * std::numbers::pi));
        ++known;
    }
    return known > 0 ? sum / known : 0;
}

FighterDistance fighterDistance(const MeasuredBody& first, const MeasuredBody& second) {
    const int frames = commonFrames(first, second);
    if (frames == 0) return {};
    FighterDistance result{std::numeric_limits<double>::infinity(), 0, 0};
    for (int frame = 0; frame < frames; ++frame) {
        const double distance = wayBetween(first, second, frame).norm();
        result.nearest = std::min(result.nearest, distance);
        result.farthest = std::max(result.farthest, distance);
        result.mean += distance / frames;
    }
    return result;
}

std::optional<double> hitTimingError(std::span<const HitMoments> hits) {
    if (hits.empty()) return std::nullopt;
    double sum = 0;
    for (const HitMoments& hit : hits)
        sum += std::abs(hit.reaction - hit.strike - hit.lag);
    return sum / static_cast<double>(hits.size());
}

}  // namespace kumite
