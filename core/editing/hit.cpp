#include "core/editing/hit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/editing/body_parts.h"
#include "core/motion/foot_lock.h"
#include "core/motion/two_bone.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::array<std::string_view, 3> kMethods = {"full", "partial", "best"};

/// The joints of a strike's side.
struct Joints {
    int striking = 0;
    int pelvis = 0;
    std::optional<int> chest, collar, shoulder, hip;
    std::optional<Limb> limb;    ///< what strikes
    std::vector<Limb> standing;  ///< legs that stay where they stand
    std::vector<std::optional<BodyPart>> parts;
    BodyPart part = BodyPart::RightArm;

    explicit Joints(const StrikeSpace& space) {
        const Rig& rig = *space.rig;
        const bool left = isLeft(space.striker), kick = isKick(space.striker);
        const auto role = [&](Role l, Role r) { return rig.roles[left ? l : r]; };
        striking = *strikingJoint(rig, space.striker);
        pelvis = rig.roles[Role::Pelvis].value_or(0);
        chest = rig.roles[Role::Chest];
        collar = role(Role::LeftClavicle, Role::RightClavicle);
        shoulder = role(Role::LeftShoulder, Role::RightShoulder);
        hip = role(Role::LeftHip, Role::RightHip);
        const Role end = kick ? (left ? Role::LeftAnkle : Role::RightAnkle)
                              : (left ? Role::LeftWrist : Role::RightWrist);
        limb = limbOf(rig, end);
        for (const Role foot : {Role::LeftAnkle, Role::RightAnkle}) {
            if (kick && foot == end) continue;
            if (const auto leg = limbOf(rig, foot)) standing.push_back(*leg);
        }
        part = kick ? (left ? BodyPart::LeftLeg : BodyPart::RightLeg)
                    : (left ? BodyPart::LeftArm : BodyPart::RightArm);
        std::vector<int> parents;
        for (const Rig::Joint& joint : rig.joints)
            parents.push_back(joint.parent);
        parts = partsOfJoints(parents, rig.roles);
    }
};

/// 0 at both ends of the strike, 1 at the hit, without a jerk between.
double strengthAt(const StrikeSpace& space, int frame) {
    const int span = frame <= space.hit ? space.hit : space.frames - 1 - space.hit;
    if (span == 0) return 1;
    const double s = 1 - std::abs(frame - space.hit) / static_cast<double>(span);
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

/// A pose that is being corrected, with the frames of its joints.
class Correction {
public:
    Correction(const StrikeSpace& space, const Joints& joints, Pose start)
        : joints_(joints), rig_(*space.rig), pose_(std::move(start)) {
        update();
    }
    void update() { jointFrames(rig_, pose_, frames_); }
    const Vector3d& at(int joint) const { return frames_.positions[std::size_t(joint)]; }
    const Quaterniond& turnOf(int joint) const { return frames_.turns[std::size_t(joint)]; }
    const Pose& pose() const { return pose_; }
    Vector3d hitting() const { return at(joints_.striking); }

    void turn(const JointTurn& turn, double strength) {
        if (turn.angle == 0) return;
        turnInSpace(rig_, pose_, frames_, turn.joint,
                    Quaterniond(Eigen::AngleAxisd(strength * turn.angle, turn.axis)));
        update();
    }
    void shift(const Vector3d& way) {
        pose_.root += way;
        update();
    }
    /// Moves the striking joint by `way` with elbow or knee alone.
    void bend(const Vector3d& way) {
        if (!joints_.limb) return;
        const Vector3d end = at(joints_.limb->end) + way;
        reach(rig_, pose_, frames_, *joints_.limb, end, EndTurn::KeepsWorld);
        update();
    }
    /// Puts the standing feet where they were in `frames`, turned as there.
    void stand(const JointFrames& frames) {
        for (const Limb& leg : joints_.standing) {
            const auto foot = static_cast<std::size_t>(leg.end);
            reach(rig_, pose_, frames_, leg, frames.positions[foot], EndTurn::KeepsWorld);
            update();
            setTurnInSpace(rig_, pose_, frames_, leg.end, frames.turns[foot]);
            update();
        }
    }
    const JointFrames& frames() const { return frames_; }

private:
    const Joints& joints_;
    const Rig& rig_;
    Pose pose_;
    JointFrames frames_;
};

/// The pose before corrections: the parts put together from both blends.
Pose assembledPose(const StrikeSpace& space, const Joints& joints, const HitSolution& solution,
                   int frame) {
    Pose pose = blendedPose(space, solution.horizontal.weights, frame);
    if (solution.method == HitMethod::Full) return pose;
    Pose other = blendedPose(space, solution.vertical.weights, frame);
    if (isKick(space.striker)) {
        // The striking leg of M_H on the rest of M_V.
        for (std::size_t j = 0; j < joints.parts.size(); ++j) {
            if (joints.parts[j] == joints.part) other.turns[j] = pose.turns[j];
        }
        return other;
    }
    // Hips, chest and collar of M_H turned about y as those of M_V are.
    Correction body(space, joints, pose);
    const JointFrames standing = body.frames();
    JointFrames wanted;
    jointFrames(*space.rig, other, wanted);
    for (const std::optional<int> joint :
         {std::optional(joints.pelvis), joints.chest, joints.collar}) {
        if (!joint) continue;
        const double yaw = wrapped(yawOf(*space.rig, wanted.turns[std::size_t(*joint)]) -
                                   yawOf(*space.rig, body.turnOf(*joint)));
        body.turn({*joint, Vector3d::UnitY(), yaw}, 1);
        if (*joint == joints.pelvis) body.stand(standing);
    }
    return body.pose();
}

/// Shifts and turns the assembled pose as the solution says, at `strength` of it.
Pose correctedPose(const StrikeSpace& space, const Joints& joints, const HitSolution& solution,
                   int frame, double strength) {
    Correction body(space, joints, assembledPose(space, joints, solution, frame));
    if (solution.method == HitMethod::Full) return body.pose();
    const JointFrames standing = body.frames();
    if (solution.shift != Vector3d::Zero()) {
        body.shift(strength * solution.shift);
        body.stand(standing);
    }
    for (const JointTurn& turn : solution.turns)
        body.turn(turn, strength);
    if (solution.bend != Vector3d::Zero()) body.bend(strength * solution.bend);
    return body.pose();
}

/// Corrections that bring the striking joint as near to the target as they may; in the order of the
/// paper's: punch chest, collar (and shoulder); kick hip about y, then about the level axis.
void solveCorrections(const StrikeSpace& space, const Joints& joints, const HitSettings& settings,
                      HitSolution& solution) {
    constexpr int kRounds = 5;
    constexpr double kMet = 5e-4;
    for (int round = 0; round < kRounds; ++round) {
        solution.turns.clear();
        solution.bend.setZero();
        Correction body(space, joints, correctedPose(space, joints, solution, space.hit, 1.0));
        const auto aim = [&](const std::optional<int>& joint, double limit,
                             const std::optional<Vector3d>& axis = {}) {
            if (!joint) return;
            solution.turns.push_back(
                aimingTurn(*joint, body.at(*joint), body.hitting(), solution.target, limit, axis));
            body.turn(solution.turns.back(), 1);
        };
        if (isKick(space.striker)) {
            aim(joints.hip, settings.hip, Vector3d::UnitY());
            if (joints.hip) {
                Vector3d ahead = solution.target - body.at(*joints.hip);
                ahead.y() = 0;
                if (ahead.norm() > 1e-6)
                    aim(joints.hip, settings.hip, Vector3d::UnitY().cross(ahead.normalized()));
            }
        } else {
            aim(joints.chest, settings.chest, Vector3d::UnitY());
            aim(joints.collar, settings.collar);
            aim(joints.shoulder, settings.shoulder);
        }
        solution.bend = solution.target - body.hitting();
        body.bend(solution.bend);
        solution.reached = body.hitting();
        const Vector3d missing = solution.target - solution.reached;
        solution.error = missing.norm();
        if (solution.error < kMet) return;
        // The pelvis gives way by what is missing, within its limits.
        Vector3d shift = solution.shift + missing;
        const double level = std::hypot(shift.x(), shift.z());
        if (level > settings.shift) {
            shift.x() *= settings.shift / level;
            shift.z() *= settings.shift / level;
        }
        shift.y() = std::clamp(shift.y(), -settings.sink, settings.sink);
        if ((shift - solution.shift).norm() < kMet || round + 1 == kRounds) return;
        solution.shift = shift;
    }
}

HitSolution fullSolution(const BlendFit& fit, const Vector3d& target, const HitSettings& settings) {
    HitSolution solution;
    solution.target = target;
    solution.horizontal = solution.vertical = fit;
    solution.reached = fit.point;
    solution.error = fit.error;
    solution.insideNaturalRegion = fit.error <= settings.close;
    return solution;
}

HitSolution partialSolution(const StrikeSpace& space, const Joints& joints, const Vector3d& target,
                            const HitSettings& settings) {
    HitSolution solution;
    solution.method = HitMethod::Partial;
    solution.target = target;
    // P_H: at the target's height above all, then near to it sideways.
    constexpr double kFirst = 10;
    solution.horizontal = fitBlend(space, target, Vector3d(1, kFirst, 1).asDiagonal());
    // P_V: in its direction above all, then near to it in height; how far out counts little.
    const double azimuth = std::atan2(target.x(), target.z());
    Eigen::Matrix3d measure;
    measure.row(0) = kFirst * Vector3d(std::cos(azimuth), 0, -std::sin(azimuth)).transpose();
    measure.row(1) = Vector3d::UnitY().transpose();
    measure.row(2) = 0.3 * Vector3d(std::sin(azimuth), 0, std::cos(azimuth)).transpose();
    solution.vertical = fitBlend(space, target, measure);
    solveCorrections(space, joints, settings, solution);
    return solution;
}

/// A clip out of poses at uneven moments: the hit comes at a whole frame.
struct Rendering {
    Clip clip;
    int hit = 0;
};

Rendering warped(const StrikeSpace& space, const std::vector<Pose>& poses,
                 const std::vector<double>& times, double slower) {
    Rendering result{{space.rig, space.rate, {}}, 0};
    const double atHit = times[static_cast<std::size_t>(space.hit)];
    const auto framesFor = [&](double seconds) {
        if (seconds <= 0) return 0;
        return std::max(1, static_cast<int>(std::lround(seconds * slower * space.rate)));
    };
    const int before = framesFor(atHit), after = framesFor(times.back() - atHit);
    std::size_t k = 0;
    const auto add = [&](double time) {
        while (k + 2 < times.size() && times[k + 1] <= time)
            ++k;
        const std::size_t next = std::min(k + 1, times.size() - 1);
        const double span = times[next] - times[k];
        const double weight = span > 0 ? std::clamp((time - times[k]) / span, 0.0, 1.0) : 0.0;
        result.clip.frames.push_back(blend(poses[k], poses[next], weight));
    };
    for (int n = 0; n < before; ++n)
        add(atHit * n / before);
    result.hit = before;
    result.clip.frames.push_back(poses[static_cast<std::size_t>(space.hit)]);
    k = static_cast<std::size_t>(space.hit);
    for (int n = 1; n <= after; ++n)
        add(atHit + (times.back() - atHit) * n / after);
    return result;
}

HitMotion motionOfSolution(const StrikeSpace& space, const Joints& joints,
                           const HitSolution& solution) {
    std::vector<Pose> poses;
    for (int f = 0; f < space.frames; ++f)
        poses.push_back(correctedPose(space, joints, solution, f, strengthAt(space, f)));
    std::vector<double> times = blendedTimes(space, solution.horizontal.weights);
    if (isKick(space.striker)) {
        const std::vector<double> other = blendedTimes(space, solution.vertical.weights);
        for (std::size_t i = 0; i < times.size(); ++i)
            times[i] = (times[i] + other[i]) / 2;
    }
    Rendering rendering = warped(space, poses, times, 1.0);
    constexpr double kFaster = 1.1, kSlowest = 1.5;
    const double speed = fastestOf(rendering.clip, joints.striking);
    if (speed > kFaster * space.fastest && space.fastest > 0) {
        rendering =
            warped(space, poses, times, std::min(kSlowest, speed / (kFaster * space.fastest)));
    }
    HitMotion motion;
    motion.hit = rendering.hit;
    Clip clean = withLockedFeet(rendering.clip);
    const GroundTransform home = toOrigin(*space.rig, clean.frames.front());
    motion.clip = moved(std::move(clean), home);
    JointFrames frames;
    jointFrames(*space.rig, motion.clip.frames[static_cast<std::size_t>(motion.hit)], frames);
    motion.reached = frames.positions[static_cast<std::size_t>(joints.striking)];
    motion.solution = solution;
    return motion;
}

HitSolution solved(const StrikeSpace& space, const Joints& joints, const Vector3d& target,
                   HitMethod method, const HitSettings& settings) {
    HitSolution full = fullSolution(fitBlend(space, target), target, settings);
    if (method == HitMethod::Full || (method == HitMethod::Best && full.insideNaturalRegion))
        return full;
    HitSolution partial = partialSolution(space, joints, target, settings);
    partial.insideNaturalRegion = full.insideNaturalRegion;
    if (method == HitMethod::Best && full.error <= partial.error) return full;
    return partial;
}

HitMotion rendered(const StrikeSpace& space, const Joints& joints, HitSolution solution,
                   const HitSettings& settings) {
    const Vector3d target = solution.target;
    const bool inside = solution.insideNaturalRegion;
    HitMotion best;
    Vector3d aimed = target;
    // Cleaning up feet moves the body a little: what was missed is aimed at beside the target.
    for (int round = 0; round < std::max(1, settings.rounds); ++round) {
        HitMotion motion = motionOfSolution(space, joints, solution);
        motion.error = (motion.reached - target).norm();
        const Vector3d missed = target - motion.reached;
        if (round == 0 || motion.error < best.error) best = std::move(motion);
        constexpr double kMet = 1e-3;
        if (best.error < kMet || solution.error > settings.tolerance) break;
        aimed += missed;
        if (solution.method == HitMethod::Full) {
            solution = fullSolution(fitBlend(space, aimed), aimed, settings);
        } else {
            solution.target = aimed;
            solveCorrections(space, joints, settings, solution);
        }
    }
    best.solution.target = target;
    best.solution.insideNaturalRegion = inside;
    best.hits = best.error <= settings.tolerance;
    return best;
}

}  // namespace

std::string_view methodName(HitMethod method) {
    return kMethods[static_cast<std::size_t>(method)];
}

std::optional<HitMethod> methodFromName(std::string_view name) {
    const auto found = std::find(kMethods.begin(), kMethods.end(), name);
    if (found == kMethods.end()) return std::nullopt;
    return static_cast<HitMethod>(found - kMethods.begin());
}

HitSolution solveHit(const StrikeSpace& space, const Vector3d& target, HitMethod method,
                     const HitSettings& settings) {
    return solved(space, Joints(space), target, method, settings);
}

Pose solvedPose(const StrikeSpace& space, const HitSolution& solution, int frame) {
    return correctedPose(space, Joints(space), solution, frame, strengthAt(space, frame));
}

HitMotion hitTarget(const StrikeSpace& space, const Vector3d& target, HitMethod method,
                    const HitSettings& settings) {
    const Joints joints(space);
    const HitSolution solution = solved(space, joints, target, method, settings);
    HitMotion motion = rendered(space, joints, solution, settings);
    if (method == HitMethod::Best && solution.method == HitMethod::Full &&
        motion.error > settings.close) {
        // At the region's border the clean-up may take a whole blend off its target.
        HitSolution parts = partialSolution(space, joints, target, settings);
        parts.insideNaturalRegion = solution.insideNaturalRegion;
        HitMotion other = rendered(space, joints, parts, settings);
        if (other.error < motion.error) return other;
    }
    return motion;
}

}  // namespace kumite
