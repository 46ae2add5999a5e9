#include "core/motion/foot_lock.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/motion/feet.h"
#include "core/motion/inertialise.h"

namespace kumite {
namespace {

using Eigen::Vector3d;

/// With this share of speed times duration `decayed` slows down without turning back: its speed is
/// then v0 (1 − s)³ (1 + 3 s).
constexpr double kOnward = 0.4;

/// 1 at 0, 0 at 1 and beyond, level at both.
double fading(double s) {
    if (s >= 1) return 0;
    return 1.0 - s * s * (3.0 - 2.0 * s);
}

Vector3d levelled(const Vector3d& vector) {
    return {vector.x(), 0, vector.z()};
}

}  // namespace

FootLock::FootLock(std::shared_ptr<const Rig> rig, double rate, const FootLockSettings& settings)
    : rig_(std::move(rig)), rate_(rate), settings_(settings) {
    if (!(rate > 0)) throw Error("A rate must be a positive number of frames a second.");
    useful_ = 1 + static_cast<int>(std::floor(settings.lookAhead * rate + 1e-9));
    for (const bool isLeft : {true, false}) {
        Foot& foot = feet_[isLeft ? 0 : 1];
        foot.leg = limbOf(*rig_, isLeft ? Role::LeftAnkle : Role::RightAnkle);
        foot.point = footPoint(*rig_, isLeft).value_or(-1);
        if (foot.point < 0) foot.leg.reset();
        for (int joint = foot.point; joint >= 0; joint = rig_->joint(joint).parent)
            foot.chain.insert(foot.chain.begin(), joint);
    }
}

FootLock::Leg FootLock::legOf(const Foot& foot, const Pose& pose) const {
    Leg leg{pose.root, pose.root, pose.root, pose.root};
    Vector3d position = pose.root;
    Eigen::Quaterniond turn = pose.turns[0];
    for (const int joint : foot.chain) {
        if (joint != 0) {
            position += turn * rig_->joint(joint).offset;
            turn = turn * pose.turns[static_cast<std::size_t>(joint)];
        }
        if (joint == foot.leg->root) leg.hip = position;
        if (joint == foot.leg->middle) leg.knee = position;
        if (joint == foot.leg->end) leg.ankle = position;
    }
    leg.point = position;
    return leg;
}

/// The correction of a foot that is held and has come to rest.
Vector3d FootLock::heldCorrection(const Foot& foot, std::size_t side, const Vector3d& raw) const {
    Vector3d correction = levelled(foot.anchor - raw);
    correction.y() = std::max(-foot.sink, settings_.floor[side] - raw.y());
    return correction;
}

/// A foot begins or ends to stand: what it is corrected by now and how fast that changes is eased
/// into what follows.
void FootLock::change(Foot& foot, std::size_t side, const Vector3d& raw,
                      std::span<const Pose> ahead, std::span<const Standing> standing) {
    foot.locked = standing[0][side];
    foot.since = 0;
    foot.offset = foot.shown;
    foot.velocity.setZero();
    if (started_) foot.velocity = (foot.shown - foot.shownBefore) * rate_;
    if (!foot.locked) return;

    // Held where its speed carries it until it has come to rest, without a way back.
    foot.anchor = raw + foot.shown;
    if (started_) foot.velocity += levelled(raw - foot.rawBefore) * rate_;
    const Vector3d onward = kOnward * settings_.ease * levelled(foot.velocity);
    foot.anchor += onward;
    double lowest = raw.y();
    for (std::size_t i = 1; i < ahead.size() && standing[i][side]; ++i)
        lowest = std::min(lowest, legOf(foot, ahead[i]).point.y());
    foot.sink =
        std::clamp(lowest - settings_.floor[side] - settings_.onToes, 0.0, settings_.highestSink);
    foot.offset = Vector3d(0, foot.shown.y() + foot.sink, 0) - onward;
}

Vector3d FootLock::correctionOf(Foot& foot, std::size_t side, std::span<const Pose> ahead,
                                std::span<const Standing> standing) {
    const Vector3d raw = legOf(foot, ahead[0]).point;
    foot.since += 1.0 / rate_;
    if (!started_ || standing[0][side] != foot.locked) change(foot, side, raw, ahead, standing);

    Vector3d correction = decayed(foot.offset, foot.velocity, foot.since, settings_.ease);
    if (foot.locked) correction += levelled(foot.anchor - raw) - Vector3d(0, foot.sink, 0);
    const Vector3d level = levelled(correction);
    if (level.norm() > settings_.farthest) {
        const Vector3d back = level * (settings_.farthest / level.norm() - 1.0);
        if (foot.locked) foot.anchor += back;
        correction += back;
    }
    correction.y() = std::max(correction.y(), settings_.floor[side] - raw.y());
    foot.rawBefore = raw;
    return correction;
}

void FootLock::settle(bool left) {
    Foot& foot = feet_[left ? 0 : 1];
    foot.rawBefore += foot.shown;
    foot.offset.setZero();
    foot.velocity.setZero();
    foot.sink = 0;
    foot.shown.setZero();
    foot.shownBefore.setZero();
}

double FootLock::dropFor(std::span<const Pose> ahead, std::span<const Standing> standing) {
    double drop = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        const Foot& foot = feet_[side];
        if (!foot.leg) continue;
        for (std::size_t i = 0; i < ahead.size(); ++i) {
            // Of later frames the place of a foot is known that goes on standing.
            if (i > 0 && !(foot.locked && standing[i][side])) break;
            const Leg leg = legOf(foot, ahead[i]);
            const Vector3d correction = i == 0 ? foot.shown : heldCorrection(foot, side, leg.point);
            const double length = (leg.knee - leg.hip).norm() + (leg.ankle - leg.knee).norm();
            const double most =
                std::max(settings_.stretch.most * length, (leg.ankle - leg.hip).norm());
            const Vector3d way = leg.hip - (leg.ankle + correction);
            if (way.norm() <= most) continue;
            const double across = std::hypot(way.x(), way.z());
            const double height = across < most ? std::sqrt(most * most - across * across) : 0.0;
            const double needed = std::clamp(way.y() - height, 0.0, settings_.hipsDrop);
            drop = std::max(drop, needed * fading(static_cast<double>(i) / useful_));
        }
    }
    // Goes back up slowly: what is not needed halves in half the ease.
    return std::max(drop, drop_ * std::exp2(-2.0 / (settings_.ease * rate_)));
}

Pose FootLock::show(std::span<const Pose> ahead, std::span<const Standing> standing) {
    const std::size_t known =
        std::min<std::size_t>({ahead.size(), standing.size(), static_cast<std::size_t>(useful_)});
    if (known == 0) throw Error("Foot locking needs a frame to show.");
    ahead = ahead.first(known);
    standing = standing.first(known);

    for (std::size_t side = 0; side < 2; ++side) {
        Foot& foot = feet_[side];
        if (!foot.leg) continue;
        const Vector3d correction = correctionOf(foot, side, ahead, standing);
        foot.shownBefore = foot.shown;
        foot.shown = correction;
    }
    drop_ = dropFor(ahead, standing);
    if (drop_ < 1e-6) drop_ = 0;
    started_ = true;

    Pose pose = ahead[0];
    pose.root.y() -= drop_;
    jointFrames(*rig_, pose, frames_);
    for (Foot& foot : feet_) {
        if (!foot.leg || (drop_ == 0 && foot.shown.isZero(1e-9))) continue;
        const Vector3d target = frames_.positions[static_cast<std::size_t>(foot.leg->end)] +
                                Vector3d(0, drop_, 0) + foot.shown;
        const Vector3d missed =
            reach(*rig_, pose, frames_, *foot.leg, target, EndTurn::KeepsWorld, settings_.stretch);
        // Out of reach: the foot is dragged, and stays where that leads.
        foot.shown += missed;
        if (foot.locked) foot.anchor += levelled(missed);
    }
    return pose;
}

std::vector<Standing> standingOf(const Clip& clip, const ContactSettings& settings) {
    const FootContacts contacts = footContacts(*skeletonOf(*clip.rig), clip.rig->roles,
                                               positionsOf(clip), clip.rate, settings);
    std::vector<Standing> standing(clip.frames.size(), Standing{false, false});
    for (std::size_t i = 0; i < standing.size(); ++i) {
        if (!contacts.left.empty()) standing[i][0] = contacts.left[i] != 0;
        if (!contacts.right.empty()) standing[i][1] = contacts.right[i] != 0;
    }
    return standing;
}

Clip withLockedFeet(const Clip& clip, std::span<const Standing> standing,
                    const FootLockSettings& settings) {
    if (standing.size() != clip.frames.size())
        throw Error("Foot locking needs to know of every frame which feet stand.");
    FootLock lock(clip.rig, clip.rate, settings);
    Clip result{clip.rig, clip.rate, {}};
    result.frames.reserve(clip.frames.size());
    const std::span<const Pose> poses(clip.frames);
    for (std::size_t i = 0; i < clip.frames.size(); ++i)
        result.frames.push_back(lock.show(poses.subspan(i), standing.subspan(i)));
    return result;
}

Clip withLockedFeet(const Clip& clip) {
    const JointPositions positions = positionsOf(clip);
    FootLockSettings settings;
    for (const bool isLeft : {true, false}) {
        if (const auto point = footPoint(*clip.rig, isLeft))
            settings.floor[isLeft ? 0 : 1] = restHeight(positions, *point);
    }
    return withLockedFeet(clip, standingOf(clip), settings);
}

}  // namespace kumite
