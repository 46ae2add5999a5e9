#include "core/synthesis/separation.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

using Eigen::Vector3d;

constexpr std::array kEnds = {Role::LeftWrist, Role::RightWrist, Role::LeftAnkle, Role::RightAnkle};
/// Bodies whose roots are farther apart than this cannot touch, metres.
constexpr double kFarApart = 2.4;
/// A limb's end has to go farther than the point that is hit, if that is near the elbow or knee.
constexpr double kLeastAlong = 0.4;

/// Which of a body's limbs can take a solid out of the way; -1: none, the whole body must go.
int limbOf(const BodyCapsule& solid) {
    switch (solid.from) {
        case Role::LeftElbow:
            return 0;
        case Role::RightElbow:
            return 1;
        case Role::LeftKnee:
        case Role::LeftAnkle:
            return 2;
        case Role::RightKnee:
        case Role::RightAnkle:
            return 3;
        default:
            return -1;
    }
}

bool isFoot(const BodyCapsule& solid) {
    return solid.from == Role::LeftAnkle || solid.from == Role::RightAnkle;
}

/// `sum` lengthened so that it goes as far along `step` as `step` does.
void cover(Vector3d& sum, const Vector3d& step) {
    const double length = step.norm();
    if (length < 1e-9) return;
    const Vector3d direction = step / length;
    const double missing = length - sum.dot(direction);
    if (missing > 0) sum += missing * direction;
}

void limit(Vector3d& vector, double most) {
    const double length = vector.norm();
    if (length > most) vector *= most / length;
}

}  // namespace

void Separation::Spring::follow(const Vector3d& target, double seconds, double dt) {
    const double omega = 2 / seconds;
    const Vector3d gap = at - target;
    const Vector3d lead = speed + omega * gap;
    const double decay = std::exp(-omega * dt);
    at = target + (gap + lead * dt) * decay;
    speed = (speed - omega * lead * dt) * decay;
}

Separation::Separation(const std::array<std::shared_ptr<const Rig>, 2>& rigs, double rate,
                       const SeparationSettings& settings)
    : settings_(settings), rate_(rate) {
    for (const std::size_t p : {0, 1}) {
        bodies_[p].rig = rigs[p];
        bodies_[p].extra.fill(Vector3d::Zero());
        for (std::size_t i = 0; i < kLimbs; ++i)
            bodies_[p].limbs[i] = kumite::limbOf(*rigs[p], kEnds[i]);
    }
}

/// By how much the ends of limbs have to go so that the solids as they are now overlap by no more
/// than `allowed`.
Separation::Ways Separation::waysOut(double allowed, const Stands& standing) const {
    Ways ways;
    for (auto& each : ways)
        each.fill(Vector3d::Zero());
    const auto freeLimb = [&](std::size_t p, const BodyCapsule& solid) {
        const int limb = limbOf(solid);
        if (limb < 0 || !bodies_[p].limbs[static_cast<std::size_t>(limb)]) return -1;
        return limb >= 2 && standing[p][static_cast<std::size_t>(limb - 2)] ? -1 : limb;
    };
    const auto move = [&](std::size_t p, int limb, const BodyCapsule& solid, double along,
                          const Vector3d& way) {
        const double lever = isFoot(solid) ? 1.0 : std::max(along, kLeastAlong);
        cover(ways[p][static_cast<std::size_t>(limb)], way / lever);
    };
    for (const BodyCapsule& a : solids_[0]) {
        const int limbA = freeLimb(0, a);
        for (const BodyCapsule& b : solids_[1]) {
            const int limbB = freeLimb(1, b);
            if (limbA < 0 && limbB < 0) continue;
            const Nearness near = nearness(a.solid, b.solid);
            const double depth = near.depth - allowed;
            if (depth <= 0) continue;
            const double share = limbA >= 0 && limbB >= 0 ? 0.5 : 1.0;
            const Vector3d way = share * depth * near.direction;
            if (limbA >= 0) move(0, limbA, a, near.alongFirst, way);
            if (limbB >= 0) move(1, limbB, b, near.alongSecond, -way);
        }
    }
    for (auto& body : ways) {
        for (Vector3d& way : body)
            limit(way, settings_.farthestLimb);
    }
    return ways;
}

void Separation::foresee(const std::array<const Pose*, 2>& ahead,
                         const std::array<const Pose*, 2>& soon, const Stands& standing) {
    const double dt = 1 / rate_;
    const auto look = [&](const std::array<const Pose*, 2>& poses) {
        if ((poses[0]->root - poses[1]->root).norm() > kFarApart) return false;
        for (const std::size_t p : {0, 1}) {
            jointFrames(*bodies_[p].rig, *poses[p], frames_[p]);
            for (Vector3d& position : frames_[p].positions)
                position += pushes_[p].at;
            bodyCapsules(bodies_[p].rig->roles, frames_[p].positions, solids_[p]);
        }
        return true;
    };
    Ways ways;
    for (auto& each : ways)
        each.fill(Vector3d::Zero());
    if (look(soon)) ways = waysOut(settings_.allowed, standing);
    for (const std::size_t p : {0, 1}) {
        for (std::size_t i = 0; i < kLimbs; ++i)
            bodies_[p].moved[i].follow(ways[p][i], settings_.limbSeconds, dt);
    }

    Vector3d apart = ahead[0]->root - ahead[1]->root;
    apart.y() = 0;
    double depth = 0;
    if (look(ahead)) {
        for (const BodyCapsule& a : solids_[0]) {
            if (limbOf(a) >= 0) continue;
            for (const BodyCapsule& b : solids_[1]) {
                if (limbOf(b) < 0) depth = std::max(depth, nearness(a.solid, b.solid).depth);
            }
        }
        // They were looked at where the present push has them.
        const Vector3d direction = apart.stableNormalized();
        depth += (pushes_[0].at - pushes_[1].at).dot(direction);
    }
    const double wanted =
        std::min(std::max(0.0, depth - settings_.allowed) / 2, settings_.farthestPush);
    const Vector3d direction =
        apart.norm() > 1e-6 ? Vector3d(apart.normalized()) : Vector3d::UnitX();
    for (const std::size_t p : {0, 1}) {
        const Vector3d target = (p == 0 ? wanted : -wanted) * direction;
        const bool growing = target.squaredNorm() > pushes_[p].at.squaredNorm();
        pushes_[p].follow(target, growing ? settings_.pushSeconds : settings_.calmSeconds, dt);
    }
}

/// Moves the ends of a body's limbs.
void Separation::move(std::size_t p, Pose& pose, JointFrames& joints,
                      const std::array<Vector3d, kLimbs>& ways) const {
    const Body& body = bodies_[p];
    bool changed = false;
    for (std::size_t i = 0; i < kLimbs; ++i) {
        if (!body.limbs[i] || ways[i].norm() < 1e-4) continue;
        const auto end = static_cast<std::size_t>(body.limbs[i]->end);
        reach(*body.rig, pose, joints, *body.limbs[i], joints.positions[end] + ways[i],
              EndTurn::KeepsLocal);
        changed = true;
    }
    if (!changed) return;
    jointFrames(*body.rig, pose, joints);
    for (const std::size_t side : {0, 1}) {
        const std::size_t leg = side + 2;
        const auto point = footPoint(*body.rig, side == 0);
        if (!point || !body.limbs[leg] || ways[leg].norm() < 1e-4) continue;
        const double sunk =
            settings_.floor[p][side] - joints.positions[static_cast<std::size_t>(*point)].y();
        if (sunk <= 0) continue;
        const auto end = static_cast<std::size_t>(body.limbs[leg]->end);
        reach(*body.rig, pose, joints, *body.limbs[leg],
              joints.positions[end] + Vector3d(0, sunk, 0));
        jointFrames(*body.rig, pose, joints);
    }
}

void Separation::part(std::array<Pose*, 2> poses, std::array<JointFrames*, 2> joints,
                      const Stands& standing) {
    const double left = std::exp(-1 / (settings_.limbSeconds * rate_));
    for (const std::size_t p : {0, 1}) {
        Body& body = bodies_[p];
        std::array<Vector3d, kLimbs> ways;
        for (std::size_t i = 0; i < kLimbs; ++i) {
            // A foot that stands by now is not moved.
            if (i >= 2 && standing[p][i - 2]) body.moved[i] = Spring();
            body.extra[i] *= left;
            ways[i] = body.moved[i].at + body.extra[i];
        }
        move(p, *poses[p], *joints[p], ways);
    }
    if ((poses[0]->root - poses[1]->root).norm() > kFarApart) return;
    for (const std::size_t p : {0, 1})
        bodyCapsules(bodies_[p].rig->roles, joints[p]->positions, solids_[p]);
    Ways ways = waysOut(settings_.allowed + settings_.leftOver, standing);
    for (const std::size_t p : {0, 1}) {
        for (std::size_t i = 0; i < kLimbs; ++i) {
            limit(ways[p][i], settings_.fastestLimb / rate_);
            bodies_[p].extra[i] += ways[p][i];
        }
        move(p, *poses[p], *joints[p], ways[p]);
    }
}

}  // namespace kumite
