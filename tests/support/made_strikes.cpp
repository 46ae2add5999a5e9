#include "tests/support/made_strikes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/motion/role_mapping.h"
#include "core/motion/two_bone.h"
#include "tests/support/builders.h"

namespace kumite::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kRate = 60;

Quaterniond about(const Vector3d& axis, double angle) {
    return Quaterniond(AngleAxisd(angle, axis));
}

/// Where everything is at one moment, in the striker's frame.
struct Plan {
    Vector3d pelvis{0, 0.86, 0};
    double hipsYaw = 0;   ///< radians
    double chestYaw = 0;  ///< against the hips
    double lean = 0.12;   ///< of the chest, forward
    double tilt = 0;      ///< of the hips, backward
    std::array<Vector3d, 2> wrists{Vector3d(0.13, 1.28, 0.34), Vector3d(-0.13, 1.26, 0.27)};
    std::array<Vector3d, 2> ankles{Vector3d(0.11, 0.08, 0.22), Vector3d(-0.12, 0.08, -0.18)};
    std::array<double, 2> footYaw{0.1, -0.5};
    std::array<double, 2> toesUp{0, 0};
    std::array<double, 2> footFree{0, 0};  ///< 1: the foot goes with its shank, not with the floor
};

/// Left, right.
constexpr std::array<Role, 2> kShoulders = {Role::LeftShoulder, Role::RightShoulder};
constexpr std::array<Role, 2> kElbows = {Role::LeftElbow, Role::RightElbow};
constexpr std::array<Role, 2> kWrists = {Role::LeftWrist, Role::RightWrist};
constexpr std::array<Role, 2> kAnkles = {Role::LeftAnkle, Role::RightAnkle};

Pose poseOf(const Rig& rig, const Plan& plan) {
    Pose pose;
    pose.root = plan.pelvis;
    pose.turns.assign(rig.joints.size(), Quaterniond::Identity());
    const auto turn = [&](Role role) -> Quaterniond& {
        return pose.turns[std::size_t(*rig.roles[role])];
    };
    turn(Role::Pelvis) =
        about(Vector3d::UnitY(), plan.hipsYaw) * about(Vector3d::UnitX(), -plan.tilt);
    turn(Role::Chest) =
        about(Vector3d::UnitY(), plan.chestYaw) * about(Vector3d::UnitX(), plan.lean);
    JointFrames frames;
    for (const std::size_t side : {0, 1}) {
        const double sign = side == 0 ? 1 : -1;
        turn(kShoulders[side]) = about(Vector3d::UnitZ(), -sign * 70 * kRadians);
        turn(kElbows[side]) = about(Vector3d::UnitY(), -sign * 100 * kRadians);
        jointFrames(rig, pose, frames);
        reach(rig, pose, frames, *limbOf(rig, kWrists[side]), plan.wrists[side],
              EndTurn::KeepsLocal);
        jointFrames(rig, pose, frames);
        reach(rig, pose, frames, *limbOf(rig, kAnkles[side]), plan.ankles[side]);
        jointFrames(rig, pose, frames);
        const auto shank = std::size_t(rig.joint(*rig.roles[kAnkles[side]]).parent);
        const Quaterniond flexed = about(Vector3d::UnitX(), -plan.toesUp[side]);
        const Quaterniond onFloor =
            frames.turns[shank].conjugate() * about(Vector3d::UnitY(), plan.footYaw[side]) * flexed;
        turn(kAnkles[side]) = onFloor.slerp(plan.footFree[side], flexed);
    }
    return pose;
}

Vector3d placeOf(const Rig& rig, const Pose& pose, int joint) {
    JointFrames frames;
    jointFrames(rig, pose, frames);
    return frames.positions[std::size_t(joint)];
}

double minimumJerk(double s) {
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

Vector3d direction(double azimuth, double elevation) {
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

/// A strike's aim: azimuth to the left and elevation, radians.
struct Aim {
    double azimuth, elevation;
};

std::vector<Aim> aimsOf(StrikeKind kind) {
    std::vector<std::pair<double, double>> degrees;
    switch (kind) {
        case StrikeKind::StraightPunch:
            degrees = {{0, 0}, {28, 2}, {-26, -2}, {2, 24}, {-2, -22}, {20, 17}, {-18, 14}};
            break;
        case StrikeKind::Hook:
            for (const double azimuth : {-14.0, 8.0, 32.0}) {
                for (const double elevation : {-20.0, 2.0, 22.0})
                    degrees.emplace_back(azimuth, elevation);
            }
            break;
        case StrikeKind::StraightKick:
            degrees = {{0, -12}, {0, 12},   {0, 36},   {24, -8},
                       {24, 20}, {-22, -8}, {-22, 20}, {12, 30}};
            break;
        case StrikeKind::SideKick:
            degrees = {{0, -14}, {0, 8},    {0, 28},   {22, -8},
                       {22, 18}, {-20, -8}, {-20, 18}, {10, 0}};
            break;
    }
    std::vector<Aim> aims;
    for (const auto& [azimuth, elevation] : degrees)
        aims.push_back({azimuth * kRadians, elevation * kRadians});
    return aims;
}

/// The plan at `s` (0 at rest, 1 at the hit) of a punch that ends in `wrist`; a hook swings out.
Plan punchPlan(const Aim& aim, double s, const Vector3d& wrist, double swing, double style) {
    Plan plan;
    plan.pelvis += s * Vector3d(0.04 * std::sin(aim.azimuth), -0.03 - 0.02 * style, 0.11);
    plan.hipsYaw = s * (0.45 * aim.azimuth + 0.30 + 0.05 * style);
    plan.chestYaw = s * (0.35 * aim.azimuth + 0.35 - 0.04 * style);
    plan.lean += s * (0.10 - 0.2 * aim.elevation);
    plan.footYaw[1] += 0.5 * s;
    const Vector3d guard = plan.wrists[1];
    plan.wrists[1] = guard + s * (wrist - guard) +
                     swing * std::sin(std::numbers::pi * s) * Vector3d(-1, 0.1, 0.2);
    plan.wrists[0] += s * Vector3d(-0.03, 0.02, -0.1 - 0.02 * style);
    return plan;
}

Plan kickPlan(StrikeKind kind, const Aim& aim, double s, const Vector3d& ankle, double style) {
    Plan plan;
    const bool side = kind == StrikeKind::SideKick;
    plan.pelvis += s * Vector3d(0.06, 0.02, 0.16 + 0.02 * style);
    plan.hipsYaw = s * (0.5 * aim.azimuth + (side ? 1.15 : 0.35) + 0.06 * style);
    plan.chestYaw = s * (side ? -0.35 : -0.2);
    plan.tilt = s * (side ? 0.05 : 0.25 + 0.2 * aim.elevation);
    plan.lean -= s * 0.15;
    plan.footYaw = {0.1 + s * (side ? 0.9 : 0.5),
                    -0.5 + s * (0.5 + aim.azimuth + (side ? 0.9 : 0))};
    plan.toesUp[1] = s * (side ? 0.2 : -0.5);
    plan.footFree[1] = s;
    const Vector3d start = plan.ankles[1], chamber = Vector3d(-0.10, 0.75, 0.22);
    plan.ankles[1] = (1 - s) * (1 - s) * start + 2 * s * (1 - s) * chamber + s * s * ankle;
    plan.wrists[0] += s * Vector3d(0.02, 0, -0.02);
    plan.wrists[1] += s * Vector3d(-0.08, -0.15, -0.05);
    for (Vector3d& wrist : plan.wrists)
        wrist = about(Vector3d::UnitY(), 0.6 * plan.hipsYaw) * wrist + s * Vector3d(0, 0, 0.1);
    return plan;
}

}  // namespace

const char* kindName(StrikeKind kind) {
    constexpr std::array<const char*, 4> kNames = {"straight punch", "hook", "straight kick",
                                                   "side kick"};
    return kNames[std::size_t(kind)];
}

Striker strikerOf(StrikeKind kind) {
    return kind == StrikeKind::StraightPunch || kind == StrikeKind::Hook ? Striker::RightHand
                                                                         : Striker::RightFoot;
}

std::shared_ptr<const Rig> madeRig() {
    static const auto rig = [] {
        const auto human = makeHuman();
        const auto still = makeMotion(human, 1, kRate, [](int, int) { return 0.0; });
        return std::make_shared<const Rig>(
            rigOf(*still, {0, 1}, {0.01, UpAxis::Y}, mapRoles(*human).roles));
    }();
    return rig;
}

std::vector<MadeStrike> madeStrikes(StrikeKind kind, unsigned seed) {
    std::mt19937 random(seed);
    const auto draw = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
    };
    const auto rig = madeRig();
    const bool kick = isKick(strikerOf(kind));
    const double extent = kind == StrikeKind::Hook ? 0.78 : 0.97;  // of the limb's length
    std::vector<MadeStrike> strikes;
    for (const Aim& aim : aimsOf(kind)) {
        const double style = draw(-1, 1), swing = kind == StrikeKind::Hook ? draw(0.20, 0.26) : 0;
        const auto planAt = [&](double s, const Vector3d& end) {
            return kick ? kickPlan(kind, aim, s, end, style) : punchPlan(aim, s, end, swing, style);
        };
        // The end of the stretched limb: out from shoulder or hip as they are at the hit.
        const Pose atHit = poseOf(*rig, planAt(1, Vector3d(-0.1, 1.0, 0.5)));
        const Role root = kick ? Role::RightHip : Role::RightShoulder;
        const double length = kick ? 0.84 : 0.53;
        const Vector3d end = placeOf(*rig, atHit, *rig->roles[root]) +
                             extent * length * direction(aim.azimuth, aim.elevation);
        MadeStrike strike;
        strike.name = std::string(kindName(kind)) + " " + std::to_string(strikes.size() + 1);
        strike.clip = {rig, kRate, {}};
        const int out = static_cast<int>(draw(17, 27)), back = static_cast<int>(draw(22, 32));
        strike.hit = out;
        for (int f = 0; f <= out + back; ++f) {
            const double s =
                f <= out ? minimumJerk(double(f) / out) : minimumJerk(1 - double(f - out) / back);
            strike.clip.frames.push_back(poseOf(*rig, planAt(s, end)));
        }
        strike.point = placeOf(*rig, strike.clip.frames[std::size_t(out)],
                               *strikingJoint(*rig, strikerOf(kind)));
        strike.clip = moved(std::move(strike.clip), {draw(-3, 3), draw(-2, 2), draw(-2, 2)});
        strikes.push_back(std::move(strike));
    }
    return strikes;
}

std::vector<Strike> asExamples(const std::vector<MadeStrike>& made) {
    std::vector<Strike> examples;
    for (const MadeStrike& strike : made) {
        examples.push_back(
            strikeFrom(strike.clip, {{0, strike.clip.frameCount()}, strike.hit}, 0.0, strike.name));
    }
    return examples;
}

Clip madeWalk(double seconds, double speed, double rate) {
    const auto rig = madeRig();
    Clip clip{rig, rate, {}};
    constexpr double kCycle = 1.1;  // seconds of two steps
    const double stride = speed * kCycle;
    const int frames = static_cast<int>(seconds * rate);
    for (int f = 0; f < frames; ++f) {
        const double t = f / rate;
        Plan plan;
        plan.pelvis = {0, 0.875 + 0.012 * std::cos(4 * std::numbers::pi * t / kCycle), speed * t};
        plan.lean = 0.04;
        for (const std::size_t side : {0, 1}) {
            const double sign = side == 0 ? 1 : -1;
            const double phase = t / kCycle + 0.5 * double(side);
            const double step = std::floor(phase), part = phase - step;
            // 60 % of the cycle on the ground, then a swing.
            const double swing = part < 0.6 ? 0 : minimumJerk((part - 0.6) / 0.4);
            const double along = stride * (step - 0.5 * double(side) + swing + 0.3);
            const double lift =
                part < 0.6 ? 0 : 0.13 * std::sin(std::numbers::pi * (part - 0.6) / 0.4);
            plan.ankles[side] = {sign * 0.09, 0.08 + lift, along};
            plan.footYaw[side] = sign * 0.08;
            const double arm = std::sin(2 * std::numbers::pi * (phase + 0.45));
            plan.wrists[side] = {sign * 0.24, 0.86 + 0.06 * std::abs(arm),
                                 speed * t + 0.05 + 0.2 * arm};
        }
        plan.hipsYaw = 0.06 * std::sin(2 * std::numbers::pi * t / kCycle);
        plan.chestYaw = -2.2 * plan.hipsYaw;
        clip.frames.push_back(poseOf(*rig, plan));
    }
    return clip;
}

}  // namespace kumite::test
