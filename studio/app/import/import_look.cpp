#include "studio/app/import/import_look.h"

#include <algorithm>
#include <cmath>

namespace kumite::studio {

namespace {

constexpr int kPoses = 160;      // looked at for floor and extent
constexpr int kDistances = 800;  // points of the curve: about one a pixel

JointPositions frameOf(const Fighter& fighter, double seconds) {
    const int frame = framesOf(fighter).begin + frameAtTime(fighter, seconds);
    return forwardKinematics(*fighter.motion, {frame, frame + 1}, fighter.space);
}

double momentOf(TimeSpan span, int index, int count) {
    return span.begin + (span.end - span.begin) * index / std::max(1, count - 1);
}

/// Height of the lowest joint over sampled frames: what the preview stands on. The analysis finds
/// the floor from both feet (method A2b), which takes the whole recording.
double lowestPoint(const Fighter& fighter, TimeSpan span) {
    std::vector<float> lowest;
    for (int i = 0; i < kPoses; ++i) {
        const JointPositions pose = frameOf(fighter, momentOf(span, i, kPoses));
        float low = pose.at(0, 0).y();
        for (int joint = 1; joint < pose.jointCount; ++joint)
            low = std::min(low, pose.at(0, joint).y());
        lowest.push_back(low);
    }
    std::nth_element(lowest.begin(), lowest.begin() + kPoses / 10, lowest.end());
    return lowest[kPoses / 10];
}

Eigen::Vector3d pelvisAt(const ImportLook& look, int player, double seconds) {
    const Fighter& fighter = look.imported.take.fighters[static_cast<std::size_t>(player)];
    const int joint = fighter.roles[Role::Pelvis].value_or(0);
    return placed(fighter, look.floors[static_cast<std::size_t>(player)],
                  frameOf(fighter, seconds).at(0, joint).cast<double>());
}

}  // namespace

double ImportLook::distanceAt(double seconds) const {
    if (distances.empty()) return 0;
    const double share = (seconds - span.begin) / std::max(1e-9, span.end - span.begin);
    const auto last = static_cast<double>(distances.size() - 1);
    return distances[static_cast<std::size_t>(std::clamp(std::round(share * last), 0.0, last))];
}

std::vector<Eigen::Vector3d> poseAt(const ImportLook& look, int player, double seconds) {
    const Fighter& fighter = look.imported.take.fighters[static_cast<std::size_t>(player)];
    const JointPositions pose = frameOf(fighter, seconds);
    std::vector<Eigen::Vector3d> joints;
    for (int joint = 0; joint < pose.jointCount; ++joint) {
        joints.push_back(placed(fighter, look.floors[static_cast<std::size_t>(player)],
                                pose.at(0, joint).cast<double>()));
    }
    return joints;
}

ImportLook lookAt(const TakeRequest& request, const Recordings& recordings,
                  const Progress& progress) {
    ImportLook look;
    look.imported = makeTake(request, recordings);
    look.span = timeSpan(look.imported.take);
    const auto& fighters = look.imported.take.fighters;
    const int players = static_cast<int>(fighters.size());
    look.low.setConstant(1e9);
    look.high.setConstant(-1e9);
    for (const Fighter& fighter : fighters) {
        progress.update(0.1);
        look.floors.push_back(fighter.floor ? *fighter.floor : lowestPoint(fighter, look.span));
    }
    for (int i = 0; i < kPoses; ++i) {
        progress.update(0.2 + 0.4 * i / kPoses);
        for (int player = 0; player < players; ++player) {
            for (const auto& joint : poseAt(look, player, momentOf(look.span, i, kPoses))) {
                look.low = look.low.cwiseMin(joint);
                look.high = look.high.cwiseMax(joint);
            }
        }
    }
    for (int i = 0; players == 2 && i < kDistances; ++i) {
        progress.update(0.6 + 0.4 * i / kDistances);
        const double seconds = momentOf(look.span, i, kDistances);
        const Eigen::Vector3d between = pelvisAt(look, 1, seconds) - pelvisAt(look, 0, seconds);
        look.distances.push_back(std::hypot(between.x(), between.z()));
    }
    return look;
}

}  // namespace kumite::studio
