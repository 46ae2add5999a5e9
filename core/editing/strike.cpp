#include "core/editing/strike.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/motion/feet.h"

namespace kumite {
namespace {

using Eigen::Vector3d;

constexpr std::array<Striker, 4> kStrikers = {Striker::LeftHand, Striker::RightHand,
                                              Striker::LeftFoot, Striker::RightFoot};
constexpr std::array<std::string_view, 4> kNames = {"left_hand", "right_hand", "left_foot",
                                                    "right_foot"};

/// How the striking joint stands to the body, frame by frame.
struct Reach {
    std::vector<double> out;      ///< horizontally from the pelvis, metres
    std::vector<double> height;   ///< of the striking joint, metres
    std::vector<double> stretch;  ///< from the limb's root, metres
    std::vector<double> speed;    ///< against the pelvis, m/s
    bool isKick = false;

    /// How far the limb has left its rest: a hand goes out, a foot (which may stand far behind)
    /// goes up.
    const std::vector<double>& away() const { return isKick ? height : out; }
};

std::optional<Reach> reachOf(const Clip& clip, FrameRange range, Striker striker) {
    const Rig& rig = *clip.rig;
    const auto joint = strikingJoint(rig, striker);
    const auto pelvis = rig.roles[Role::Pelvis];
    const Role rootRole = isKick(striker)
                              ? (isLeft(striker) ? Role::LeftHip : Role::RightHip)
                              : (isLeft(striker) ? Role::LeftShoulder : Role::RightShoulder);
    const auto root = rig.roles[rootRole];
    if (!joint || !pelvis || !root || range.empty()) return std::nullopt;
    Reach reach;
    reach.isKick = isKick(striker);
    JointFrames frames;
    Vector3d before = Vector3d::Zero();
    for (int f = range.begin; f < range.end; ++f) {
        jointFrames(rig, clip.frames[static_cast<std::size_t>(f)], frames);
        const Vector3d at = frames.positions[static_cast<std::size_t>(*joint)];
        const Vector3d away = at - frames.positions[static_cast<std::size_t>(*pelvis)];
        reach.out.push_back(std::hypot(away.x(), away.z()));
        reach.height.push_back(at.y());
        reach.stretch.push_back((at - frames.positions[static_cast<std::size_t>(*root)]).norm());
        reach.speed.push_back(f == range.begin ? 0.0 : (away - before).norm() * clip.rate);
        before = away;
    }
    return reach;
}

}  // namespace

std::string_view strikerName(Striker striker) {
    return kNames[static_cast<std::size_t>(striker)];
}

std::optional<Striker> strikerFromName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return kStrikers[static_cast<std::size_t>(found - kNames.begin())];
}

std::optional<int> strikingJoint(const Rig& rig, Striker striker) {
    if (isKick(striker)) return footPoint(rig, isLeft(striker));
    return rig.roles[isLeft(striker) ? Role::LeftWrist : Role::RightWrist];
}

std::optional<StrikeMoment> strikeIn(const Clip& clip, FrameRange range, Striker striker) {
    range = {std::max(0, range.begin), std::min(clip.frameCount(), range.end)};
    const auto reach = reachOf(clip, range, striker);
    if (!reach || range.size() < 3) return std::nullopt;
    const double farthest = *std::max_element(reach->out.begin(), reach->out.end());
    const auto [lowest, highest] = std::minmax_element(reach->height.begin(), reach->height.end());
    const double raised = 0.5 * (*lowest + *highest);
    int hit = -1;
    const auto count = static_cast<int>(reach->out.size());
    for (int i = 0; i < count; ++i) {
        const auto f = static_cast<std::size_t>(i);
        if (reach->out[f] < 0.8 * farthest) continue;
        if (isKick(striker) && reach->height[f] < raised) continue;
        if (hit < 0 || reach->stretch[f] > reach->stretch[static_cast<std::size_t>(hit)]) hit = i;
    }
    // A foot that is low where it is far out does not kick; the farthest frame is as good as any.
    if (hit < 0)
        hit = static_cast<int>(std::max_element(reach->out.begin(), reach->out.end()) -
                               reach->out.begin());
    // At rest: no farther than a tenth of the way from the nearest of that side.
    const std::vector<double>& away = reach->away();
    const double top = away[static_cast<std::size_t>(hit)];
    const int margin = static_cast<int>(std::lround(0.1 * clip.rate));
    constexpr double kLongest = 1.2;  // seconds on either side
    const int longest = static_cast<int>(std::lround(kLongest * clip.rate));
    const auto edge = [&](int step, int end) {
        double nearest = top;
        for (int i = hit; i != end; i += step)
            nearest = std::min(nearest, away[static_cast<std::size_t>(i)]);
        const double rest = nearest + 0.1 * (top - nearest);
        int i = hit;
        while (i != end && away[static_cast<std::size_t>(i)] > rest)
            i += step;
        return i + step * margin;
    };
    const int begin = std::max({0, hit - longest, edge(-1, -1)});
    const int end = std::min({count - 1, hit + longest, edge(1, count)}) + 1;
    return StrikeMoment{{range.begin + begin, range.begin + end}, range.begin + hit};
}

std::vector<StrikeMoment> findStrikes(const Clip& clip, Striker striker, double least) {
    std::vector<StrikeMoment> moments;
    const auto reach = reachOf(clip, {0, clip.frameCount()}, striker);
    if (!reach) return moments;
    // Turning points: the limb goes out and comes back by `least` at least.
    struct Turn {
        int frame;
        bool out;
    };
    std::vector<Turn> turns;
    const auto at = [&](int f) { return reach->away()[static_cast<std::size_t>(f)]; };
    const int last = clip.frameCount() - 1;
    int low = 0, high = 0;
    bool goingOut = true;
    turns.push_back({0, false});
    for (int f = 0; f <= last; ++f) {
        if (goingOut) {
            if (at(f) > at(high)) high = f;
            if (at(f) < at(low)) low = high = f;
            const bool wentOut = at(high) - at(low) >= least;
            if (wentOut && (f == last || at(high) - at(f) >= least)) {
                turns.push_back({high, true});
                goingOut = false;
                low = f;
            }
        } else {
            if (at(f) < at(low)) low = f;
            if (at(f) - at(low) >= least) {
                turns.push_back({low, false});
                goingOut = true;
                high = f;
            }
        }
    }
    turns.push_back({last, false});
    for (std::size_t i = 1; i + 1 < turns.size(); ++i) {
        if (!turns[i].out) continue;
        const FrameRange range{turns[i - 1].frame, turns[i + 1].frame + 1};
        const auto moment = strikeIn(clip, range, striker);
        if (!moment) continue;
        // A foot that goes straight up jumps or steps.
        constexpr double kOut = 0.4;
        if (isKick(striker) && reach->out[static_cast<std::size_t>(moment->hit)] < kOut) continue;
        constexpr double kSlowest = 1.5;  // m/s: what is slower reaches or rests
        const auto speed = reach->speed.begin();
        if (*std::max_element(speed + moment->frames.begin, speed + moment->hit + 1) < kSlowest)
            continue;
        moments.push_back(*moment);
    }
    return moments;
}

std::optional<Striker> likeliestStriker(const Clip& clip, FrameRange range) {
    std::optional<Striker> best;
    double fastest = 0;
    range = {std::max(0, range.begin), std::min(clip.frameCount(), range.end)};
    for (const Striker striker : kStrikers) {
        const auto reach = reachOf(clip, range, striker);
        if (!reach) continue;
        const double speed = *std::max_element(reach->speed.begin(), reach->speed.end());
        if (speed > fastest) {
            fastest = speed;
            best = striker;
        }
    }
    return best;
}

double fastestOf(const Clip& clip, int joint) {
    JointFrames frames;
    double fastest = 0;
    Vector3d before = Vector3d::Zero();
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        jointFrames(*clip.rig, clip.frames[f], frames);
        const Vector3d at = frames.positions[static_cast<std::size_t>(joint)];
        if (f > 0) fastest = std::max(fastest, (at - before).norm() * clip.rate);
        before = at;
    }
    return fastest;
}

double floorUnder(const Clip& clip) {
    const JointPositions positions = positionsOf(clip);
    std::optional<double> floor;
    for (const bool left : {true, false}) {
        const auto joint = footPoint(*clip.rig, left);
        if (!joint || clip.frames.empty()) continue;
        const double height = restHeight(positions, *joint);
        floor = std::min(floor.value_or(height), height);
    }
    return floor.value_or(0.0);
}

GroundTransform toOrigin(const Rig& rig, const Pose& pose) {
    JointFrames frames;
    jointFrames(rig, pose, frames);
    const auto pelvis = static_cast<std::size_t>(rig.roles[Role::Pelvis].value_or(0));
    const Vector3d at = frames.positions[pelvis];
    const GroundTransform back{0, -at.x(), -at.z()};
    return GroundTransform{-headingOf(rig, pose).value_or(0.0), 0, 0} * back;
}

Strike strikeFrom(const Clip& clip, const StrikeMoment& moment, double floor, std::string name) {
    Strike strike{std::move(name), {clip.rig, clip.rate, {}}, moment.hit - moment.frames.begin};
    const Pose& first = clip.frames[static_cast<std::size_t>(moment.frames.begin)];
    const GroundTransform transform = toOrigin(*clip.rig, first);
    for (int f = moment.frames.begin; f < moment.frames.end; ++f) {
        Pose pose = moved(clip.frames[static_cast<std::size_t>(f)], transform);
        pose.root.y() -= floor;
        strike.clip.frames.push_back(std::move(pose));
    }
    return strike;
}

}  // namespace kumite
