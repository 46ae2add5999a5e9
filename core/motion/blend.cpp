#include "core/motion/blend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/text.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

std::string exchanged(std::string_view name, std::string_view left, std::string_view right) {
    const auto replaced = [&](std::string_view from, std::string_view to) -> std::string {
        const auto at = name.find(from);
        if (at == std::string_view::npos) return {};
        return std::string(name.substr(0, at)) + std::string(to) +
               std::string(name.substr(at + from.size()));
    };
    std::string other = replaced(left, right);
    return other.empty() ? replaced(right, left) : other;
}

/// The name of a joint of the other side, as the usual spellings have it.
bool areSides(std::string_view a, std::string_view b) {
    for (const auto& [left, right] :
         {std::pair<std::string_view, std::string_view>{"Left", "Right"},
          {"left", "right"},
          {"LEFT", "RIGHT"}}) {
        if (exchanged(a, left, right) == b) return true;
    }
    const auto isSide = [](char x, char y) {
        return (x == 'l' && y == 'r') || (x == 'L' && y == 'R') || (x == 'r' && y == 'l') ||
               (x == 'R' && y == 'L');
    };
    // "lHand" and "rHand", "Hand_L" and "Hand_R".
    if (a.size() != b.size() || a.empty()) return false;
    return (isSide(a.front(), b.front()) && a.substr(1) == b.substr(1)) ||
           (isSide(a.back(), b.back()) && a.substr(0, a.size() - 1) == b.substr(0, b.size() - 1));
}

class Pairing {
public:
    explicit Pairing(const Rig& rig) : rig_(rig), children_(rig.joints.size()) {
        for (int i = 0; i < rig.jointCount(); ++i) {
            if (rig.joint(i).parent >= 0)
                children_[static_cast<std::size_t>(rig.joint(i).parent)].push_back(i);
        }
        partner_.assign(rig.joints.size(), -1);
    }

    std::vector<int> partners() {
        for (const Role role : allRoles()) {
            if (mirrored(role) == role || !rig_.roles.has(role) || !rig_.roles.has(mirrored(role)))
                continue;
            if (*rig_.roles[role] != *rig_.roles[mirrored(role)])
                pair(*rig_.roles[role], *rig_.roles[mirrored(role)]);
        }
        // Parents stand before their children, so that what hangs on partners follows from them.
        for (int i = 0; i < rig_.jointCount(); ++i)
            pairChildren(i);
        for (int i = 0; i < rig_.jointCount(); ++i) {
            if (of(i) < 0) of(i) = i;
        }
        return partner_;
    }

private:
    int& of(int joint) { return partner_[static_cast<std::size_t>(joint)]; }
    void pair(int a, int b) {
        of(a) = b;
        of(b) = a;
    }

    void pairChildren(int joint) {
        const int other = of(joint) < 0 ? joint : of(joint);
        const auto& mine = children_[static_cast<std::size_t>(joint)];
        const auto& theirs = children_[static_cast<std::size_t>(other)];
        for (const int a : mine) {
            for (const int b : theirs) {
                if (a != b && of(a) < 0 && of(b) < 0 &&
                    areSides(rig_.joint(a).name, rig_.joint(b).name))
                    pair(a, b);
            }
        }
        if (other == joint || mine.size() != theirs.size()) return;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            if (of(mine[i]) < 0 && of(theirs[i]) < 0) pair(mine[i], theirs[i]);
        }
    }

    const Rig& rig_;
    std::vector<std::vector<int>> children_;
    std::vector<int> partner_;
};

Vector3d mirroredAlong(const Vector3d& vector, const Vector3d& normal) {
    return vector - 2.0 * vector.dot(normal) * normal;
}

}  // namespace

Vector3d GroundTransform::operator*(const Vector3d& p) const {
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {c * p.x() + s * p.z() + x, p.y(), c * p.z() - s * p.x() + z};
}

GroundTransform GroundTransform::operator*(const GroundTransform& inner) const {
    const Vector3d shift = *this * Vector3d(inner.x, 0, inner.z);
    return {yaw + inner.yaw, shift.x(), shift.z()};
}

GroundTransform GroundTransform::inverse() const {
    const Vector3d shift = GroundTransform{-yaw, 0, 0} * Vector3d(x, 0, z);
    return {-yaw, -shift.x(), -shift.z()};
}

Quaterniond GroundTransform::turn() const {
    return Quaterniond(Eigen::AngleAxisd(yaw, Vector3d::UnitY()));
}

GroundTransform groundAlignment(std::span<const Vector3d> from, std::span<const Vector3d> to,
                                std::span<const double> weights) {
    if (from.size() != to.size() || from.empty() ||
        (!weights.empty() && weights.size() != from.size()))
        throw Error("Points to be aligned must come in pairs.");
    const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
    double sum = 0;
    Vector3d meanFrom = Vector3d::Zero(), meanTo = Vector3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        sum += weight(i);
        meanFrom += weight(i) * from[i];
        meanTo += weight(i) * to[i];
    }
    if (!(sum > 0)) throw Error("Points to be aligned need a weight above zero.");
    meanFrom /= sum;
    meanTo /= sum;
    double sine = 0, cosine = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Vector3d a = from[i] - meanFrom, b = to[i] - meanTo;
        sine += weight(i) * (b.x() * a.z() - b.z() * a.x());
        cosine += weight(i) * (b.x() * a.x() + b.z() * a.z());
    }
    GroundTransform transform;
    if (std::hypot(sine, cosine) > 1e-12 * sum) transform.yaw = std::atan2(sine, cosine);
    const Vector3d shift = meanTo - transform * meanFrom;
    transform.x = shift.x();
    transform.z = shift.z();
    return transform;
}

GroundTransform groundAlignment(const Rig& rig, const Pose& from, const Pose& to) {
    const auto before = headingOf(rig, from);
    const auto after = headingOf(rig, to);
    GroundTransform transform;
    if (before && after) transform.yaw = std::remainder(*after - *before, 2 * std::numbers::pi);
    const Vector3d shift = to.root - transform * from.root;
    transform.x = shift.x();
    transform.z = shift.z();
    return transform;
}

Pose blend(const Pose& a, const Pose& b, double weight) {
    Pose pose;
    pose.root = (1.0 - weight) * a.root + weight * b.root;
    pose.turns.reserve(a.turns.size());
    for (std::size_t i = 0; i < a.turns.size(); ++i)
        pose.turns.push_back(a.turns[i].slerp(weight, b.turns[i]));
    return pose;
}

Pose moved(const Pose& pose, const GroundTransform& transform) {
    Pose result = pose;
    result.root = transform * pose.root;
    result.turns[0] = transform.turn() * pose.turns[0];
    return result;
}

Clip moved(Clip clip, const GroundTransform& transform) {
    const Quaterniond turn = transform.turn();
    for (Pose& pose : clip.frames) {
        pose.root = transform * pose.root;
        pose.turns[0] = turn * pose.turns[0];
    }
    return clip;
}

Pose poseAt(const Clip& clip, double seconds) {
    const double last = clip.frameCount() - 1;
    const double frame = std::clamp(seconds * clip.rate, 0.0, last);
    // A time that means a frame shows that frame, whatever the rounding.
    const double nearest = std::round(frame);
    if (std::abs(frame - nearest) < 1e-9 * std::max(1.0, frame))
        return clip.frames[static_cast<std::size_t>(nearest)];
    const auto before = static_cast<std::size_t>(frame);
    return blend(clip.frames[before], clip.frames[before + 1], frame - static_cast<double>(before));
}

Clip resampled(const Clip& clip, double rate) {
    if (!(rate > 0)) throw Error("A rate must be a positive number of frames a second.");
    if (rate == clip.rate || clip.frames.empty()) {
        Clip same = clip;
        same.rate = rate;
        return same;
    }
    Clip result{clip.rig, rate, {}};
    const auto frames = static_cast<std::size_t>(std::floor(clip.seconds() * rate + 1e-6)) + 1;
    result.frames.reserve(frames);
    for (std::size_t i = 0; i < frames; ++i)
        result.frames.push_back(poseAt(clip, static_cast<double>(i) / rate));
    return result;
}

Mirror mirrorOf(const Rig& rig) {
    Mirror mirror;
    mirror.partner = Pairing(rig).partners();
    const std::vector<Vector3d> rest = restPositions(rig);
    for (const auto& [left, right] : {std::pair{Role::LeftHip, Role::RightHip},
                                      std::pair{Role::LeftShoulder, Role::RightShoulder}}) {
        if (!rig.roles.has(left) || !rig.roles.has(right)) continue;
        const Vector3d across = rest[static_cast<std::size_t>(*rig.roles[left])] -
                                rest[static_cast<std::size_t>(*rig.roles[right])];
        if (across.norm() < 1e-6) continue;
        // Measured hips lie a little askew; the axes of the file are what both sides share.
        int axis = 0;
        across.cwiseAbs().maxCoeff(&axis);
        mirror.sideways =
            across[axis] > 0.95 * across.norm() || -across[axis] > 0.95 * across.norm()
                ? Vector3d(Vector3d::Unit(axis))
                : Vector3d(across.normalized());
        break;
    }
    for (std::size_t i = 0; i < rig.joints.size(); ++i) {
        const auto other = static_cast<std::size_t>(mirror.partner[i]);
        const Vector3d image = mirroredAlong(rig.joints[other].offset, mirror.sideways);
        mirror.asymmetry = std::max(mirror.asymmetry, (rig.joints[i].offset - image).norm());
    }
    return mirror;
}

Pose mirrored(const Mirror& mirror, const Pose& pose) {
    const Vector3d& side = mirror.sideways;
    Pose result = pose;
    result.root.x() = -pose.root.x();
    for (std::size_t i = 0; i < pose.turns.size(); ++i) {
        const Quaterniond& from = pose.turns[static_cast<std::size_t>(mirror.partner[i])];
        // S R S for the mirroring S along `side`: the axis is mirrored and the turn reversed.
        const Vector3d axis = -mirroredAlong(from.vec(), side);
        result.turns[i] = Quaterniond(from.w(), axis.x(), axis.y(), axis.z());
    }
    // Joint 0 turns to the space, whose mirror is x = 0: M R S = (M S) (S R S).
    const Eigen::Matrix3d across = Eigen::Matrix3d(Vector3d(-1, 1, 1).asDiagonal()) *
                                   (Eigen::Matrix3d::Identity() - 2.0 * side * side.transpose());
    result.turns[0] = (Quaterniond(across) * result.turns[0]).normalized();
    return result;
}

Pose mirrored(const Rig& rig, const Pose& pose) {
    return mirrored(mirrorOf(rig), pose);
}

}  // namespace kumite
