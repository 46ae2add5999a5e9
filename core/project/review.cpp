#include "core/project/review.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/motion/feet.h"

namespace kumite {
namespace {

/// From this height on a foot that moves is no step any more.
constexpr double kKickHeight = 0.25;  // metres

struct Foot {
    bool left = false;
    double speed = 0;
    double height = 0;
};

/// The faster foot at a frame, and the height of the other.
struct Feet {
    Foot faster;
    double otherHeight = 0;
};

std::optional<Feet> feetAt(const FighterAnalysis& fighter, int frame) {
    const JointPositions& positions = fighter.motion->positions;
    std::vector<Foot> feet;
    for (const bool left : {true, false}) {
        const auto joint = footPoint(*fighter.input.motion->skeleton, fighter.input.roles, left);
        if (!joint) continue;
        feet.push_back({left, jointSpeed(positions, *joint, frame, fighter.input.rate),
                        positions.at(frame, *joint).y() - fighter.body->floor});
    }
    if (feet.empty()) return std::nullopt;
    if (feet.size() == 1) return Feet{feet[0], 0.0};
    if (feet[1].speed > feet[0].speed) std::swap(feet[0], feet[1]);
    return Feet{feet[0], feet[1].height};
}

double secondsToNearest(const FighterAnalysis& fighter, int minimum) {
    const auto& minima = fighter.force->minima;
    const Suspicion& suspicion = *fighter.suspicion;  // 0: cuts nothing
    const int frame = minima[static_cast<std::size_t>(minimum)].frame;
    double nearest = frame;
    nearest = std::min<double>(nearest, fighter.frameCount() - 1 - frame);
    const auto cuts = [&](std::size_t i) { return suspicion[i] > 0; };
    for (auto i = static_cast<std::size_t>(minimum); i-- > 0;) {
        if (!cuts(i)) continue;
        nearest = std::min<double>(nearest, frame - minima[i].frame);
        break;
    }
    for (auto i = static_cast<std::size_t>(minimum) + 1; i < minima.size(); ++i) {
        if (!cuts(i)) continue;
        nearest = std::min<double>(nearest, minima[i].frame - frame);
        break;
    }
    return nearest / fighter.input.rate;
}

}  // namespace

SuspectReason suspectReason(const FighterAnalysis& fighter, int minimum) {
    using Kind = SuspectReason::Kind;
    const auto index = static_cast<std::size_t>(minimum);
    const ForceMinimum& what = fighter.force->minima[index];
    SuspectReason reason;
    reason.prominence = what.prominence;
    reason.force = what.force;
    reason.nearest = secondsToNearest(fighter, minimum);
    const auto feet = feetAt(fighter, what.frame);
    if (feet) {
        reason.left = feet->faster.left;
        reason.footSpeed = feet->faster.speed;
        reason.footHeight = feet->faster.height;
    }
    const SuspicionEvidence& evidence = (*fighter.evidence)[index];
    const std::array<std::pair<double, Kind>, 4> all = {{{evidence.footMoving, Kind::MovingFoot},
                                                         {evidence.shallow, Kind::Shallow},
                                                         {evidence.crowded, Kind::Crowded},
                                                         {evidence.high, Kind::High}}};
    const auto strongest = std::max_element(
        all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    constexpr double kWorthSaying = 0.1;  // log-odds
    if (strongest->first < kWorthSaying) return reason;
    reason.kind = strongest->second;
    // A foot in the air explains a dip better than that the dip is shallow.
    const bool kicks = feet && feet->faster.height > kKickHeight &&
                       feet->otherHeight < kKickHeight && evidence.footMoving > -0.4;
    if (kicks && (reason.kind == Kind::MovingFoot || reason.kind == Kind::Shallow)) {
        reason.kind = Kind::SlowKick;
    }
    return reason;
}

std::string_view reasonName(SuspectReason::Kind kind) {
    switch (kind) {
        case SuspectReason::Kind::Unremarkable:
            return "unremarkable";
        case SuspectReason::Kind::SlowKick:
            return "slow_kick";
        case SuspectReason::Kind::MovingFoot:
            return "moving_foot";
        case SuspectReason::Kind::Shallow:
            return "shallow";
        case SuspectReason::Kind::Crowded:
            return "crowded";
        case SuspectReason::Kind::High:
            return "high";
    }
    return {};
}

double ReviewStatistics::shareCorrected() const {
    const int all = minima + added;
    return all > 0 ? std::min(1.0, static_cast<double>(removed + moved + added) / all) : 0.0;
}

ReviewStatistics& ReviewStatistics::operator+=(const ReviewStatistics& other) {
    seconds += other.seconds;
    minima += other.minima;
    removed += other.removed;
    moved += other.moved;
    added += other.added;
    accepted += other.accepted;
    toReview += other.toReview;
    return *this;
}

ReviewStatistics reviewStatistics(const FighterAnalysis& fighter, double threshold) {
    ReviewStatistics result;
    if (!fighter.available()) return result;
    result.seconds = fighter.frameCount() / fighter.input.rate;
    if (fighter.force) {
        const auto& minima = fighter.force->minima;
        result.minima = static_cast<int>(std::count_if(
            minima.begin(), minima.end(),
            [&](const ForceMinimum& minimum) { return minimum.prominence >= threshold; }));
    }
    const auto& removed = fighter.segmentation->removed;
    // What a hand added and took away again is no correction.
    result.removed = static_cast<int>(std::count_if(
        removed.begin(), removed.end(),
        [](const RemovedBoundary& boundary) { return boundary.minimum.has_value(); }));
    for (const Boundary& boundary : fighter.segmentation->boundaries) {
        switch (boundary.source) {
            case BoundarySource::End:
                break;
            case BoundarySource::Detected:
                if ((*fighter.suspicion)[static_cast<std::size_t>(*boundary.minimum)] >= kSuspect) {
                    ++result.toReview;
                }
                break;
            case BoundarySource::Accepted:
                ++result.accepted;
                break;
            case BoundarySource::Moved:
                ++result.moved;
                break;
            case BoundarySource::Added:
                ++result.added;
                break;
        }
    }
    return result;
}

}  // namespace kumite
