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

Separation::Separation(const std::array<std::shared_ptr<const Rig>, 2>& rigs, double rate,
                       const SeparationSettings& settings)
    : settings_(settings), rate_(rate) {
    for (const std::size_t p : {0, 1}) {
        bodies_[p].rig = rigs[p];
        bodies_[p].moved.fill(Vector3d::Zero());
        for (std::size_t i = 0; i < kLimbs; ++i)
            bodies_[p].limbs[i] = kumite::limbOf(*rigs[p], kEnds[i]);
    }
}

void Separation::foresee(const std::array<const Pose*, 2>& ahead) {
    Vector3d apart = ahead[0]->root - ahead[1]->root;
    apart.y() = 0;
    double depth = 0;
    if (apart.norm() < kFarApart) {
        for (const std::size_t p : {0, 1}) {
            jointFrames(*bodies_[p].rig, *ahead[p], frames_[p]);
            bodyCapsules(bodies_[p].rig->roles, frames_[p].positions, solids_[p]);
        }
        for (const BodyCapsule& a : solids_[0]) {
            if (limbOf(a) >= 0) continue;
            for (const BodyCapsule& b : solids_[1]) {
                if (limbOf(b) < 0) depth = std::max(depth, nearness(a.solid, b.solid).depth);
            }
        }
    }
    const double wanted =
        std::min(std::max(0.0, depth - settings_.allowed) / 2, settings_.farthestPush);
    const Vector3d direction =
        apart.norm() > 1e-6 ? Vector3d(apart.normalized()) : Vector3d::UnitX();
    for (const std::size_t p : {0, 1}) {
        Push& push = pushes_[p];
        const Vector3d target = (p == 0 ? wanted : -wanted) * direction;
        // A critically damped spring: no jump in place or speed, whatever the target does.
        const bool growing = target.squaredNorm() > push.at.squaredNorm();
        const double omega = 2 / (growing ? settings_.pushSeconds : settings_.calmSeconds);
        const double dt = 1 / rate_;
        const Vector3d gap = push.at - target;
        const Vector3d lead = push.speed + omega * gap;
        const double decay = std::exp(-omega * dt);
        push.at = target + (gap + lead * dt) * decay;
        push.speed = (push.speed - omega * lead * dt) * decay;
    }
}

void Separation::part(std::array<Pose*, 2> poses, std::array<JointFrames*, 2> joints,
                      const std::array<std::array<bool, 2>, 2>& standing) {
    const double left = std::exp(-1 / (settings_.limbSeconds * rate_));
    for (Body& body : bodies_) {
        for (Vector3d& moved : body.moved) {
            moved *= left;
            if (moved.norm() < 1e-4) moved.setZero();
        }
    }
    const bool close = (poses[0]->root - poses[1]->root).norm() < kFarApart;
    // What was moved in the last frame is moved on; the second look finds what that leaves.
    for (int look = 0; look < 2; ++look) {
        std::array<std::array<Vector3d, kLimbs>, 2> more;
        for (auto& each : more)
            each.fill(Vector3d::Zero());
        if (close) {
            for (const std::size_t p : {0, 1})
                bodyCapsules(bodies_[p].rig->roles, joints[p]->positions, solids_[p]);
            const auto freeLimb = [&](std::size_t p, const BodyCapsule& solid) {
                const int limb = limbOf(solid);
                if (limb < 0 || !bodies_[p].limbs[static_cast<std::size_t>(limb)]) return -1;
                return limb >= 2 && standing[p][static_cast<std::size_t>(limb - 2)] ? -1 : limb;
            };
            const auto move = [&](std::size_t p, int limb, const BodyCapsule& solid, double along,
                                  const Vector3d& way) {
                const double lever = isFoot(solid) ? 1.0 : std::max(along, kLeastAlong);
                cover(more[p][static_cast<std::size_t>(limb)], way / lever);
            };
            for (const BodyCapsule& a : solids_[0]) {
                const int limbA = freeLimb(0, a);
                for (const BodyCapsule& b : solids_[1]) {
                    const int limbB = freeLimb(1, b);
                    if (limbA < 0 && limbB < 0) continue;
                    const Nearness near = nearness(a.solid, b.solid);
                    const double depth = near.depth - settings_.allowed;
                    if (depth <= 0) continue;
                    const double share = limbA >= 0 && limbB >= 0 ? 0.5 : 1.0;
                    const Vector3d way = share * depth * near.direction;
                    if (limbA >= 0) move(0, limbA, a, near.alongFirst, way);
                    if (limbB >= 0) move(1, limbB, b, near.alongSecond, -way);
                }
            }
        }
        for (const std::size_t p : {0, 1}) {
            bool changed = false;
            for (std::size_t i = 0; i < kLimbs; ++i) {
                Body& body = bodies_[p];
                if (!body.limbs[i]) continue;
                // In the first look what is kept from the last frame; then only what is added.
                Vector3d step = look == 0 ? body.moved[i] : Vector3d::Zero();
                const Vector3d before = step;
                cover(step, more[p][i]);
                if (step.isZero(0)) continue;
                Vector3d whole = body.moved[i] + step - before;
                limit(whole, settings_.farthestLimb);
                step = whole - body.moved[i] + before;
                body.moved[i] = whole;
                const auto end = static_cast<std::size_t>(body.limbs[i]->end);
                reach(*body.rig, *poses[p], *joints[p], *body.limbs[i],
                      joints[p]->positions[end] + step, EndTurn::KeepsLocal);
                changed = true;
            }
            if (changed) jointFrames(*bodies_[p].rig, *poses[p], *joints[p]);
        }
    }
}

}  // namespace kumite
