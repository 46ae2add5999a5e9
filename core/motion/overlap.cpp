#include "core/motion/overlap.h"

#include <algorithm>
#include <limits>

namespace kumite {
namespace {

using Eigen::Vector3d;

constexpr BodySolid kSolids[] = {
    {Role::Pelvis, Role::Chest, 0.12},
    {Role::Chest, Role::Neck, 0.11},
    {Role::Neck, Role::Head, 0.07},
    {Role::LeftShoulder, Role::LeftElbow, 0.045},
    {Role::LeftElbow, Role::LeftWrist, 0.04},
    {Role::LeftHip, Role::LeftKnee, 0.065},
    {Role::LeftKnee, Role::LeftAnkle, 0.05},
    {Role::LeftAnkle, Role::LeftToe, 0.035},
    {Role::RightShoulder, Role::RightElbow, 0.045},
    {Role::RightElbow, Role::RightWrist, 0.04},
    {Role::RightHip, Role::RightKnee, 0.065},
    {Role::RightKnee, Role::RightAnkle, 0.05},
    {Role::RightAnkle, Role::RightToe, 0.035},
};

}  // namespace

std::span<const BodySolid> bodySolids() {
    return kSolids;
}

void bodyCapsules(const RoleMap& roles, std::span<const Vector3d> positions,
                  std::vector<BodyCapsule>& out) {
    out.clear();
    const auto at = [&](Role role) { return positions[static_cast<std::size_t>(*roles[role])]; };
    for (const BodySolid& solid : kSolids) {
        if (!roles.has(solid.from) || !roles.has(solid.to)) continue;
        out.push_back({{at(solid.from), at(solid.to), solid.radius}, solid.from, solid.to});
    }
    // The skull goes on beyond the head joint, as far again as the neck is long.
    if (roles.has(Role::Neck) && roles.has(Role::Head)) {
        const Vector3d head = at(Role::Head);
        out.push_back(
            {{head, head + (head - at(Role::Neck)), kSkullRadius}, Role::Head, Role::Head});
    }
}

std::vector<Capsule> bodyCapsules(const RoleMap& roles, const JointPositions& positions,
                                  int frame) {
    std::vector<Vector3d> joints;
    for (int joint = 0; joint < positions.jointCount; ++joint)
        joints.push_back(positions.at(frame, joint).cast<double>());
    std::vector<BodyCapsule> solids;
    bodyCapsules(roles, joints, solids);
    std::vector<Capsule> capsules;
    for (const BodyCapsule& each : solids)
        capsules.push_back(each.solid);
    return capsules;
}

/// Closest points of two line segments by clamping each parameter in turn.
Nearness nearness(const Capsule& p, const Capsule& q) {
    const Vector3d u = p.b - p.a;
    const Vector3d v = q.b - q.a;
    const Vector3d w = p.a - q.a;
    const double uu = u.squaredNorm();
    const double vv = v.squaredNorm();
    const double uv = u.dot(v);
    const double uw = u.dot(w);
    const double vw = v.dot(w);
    const double determinant = uu * vv - uv * uv;
    double s = 0;
    if (determinant > 1e-12) s = std::clamp((uv * vw - vv * uw) / determinant, 0.0, 1.0);
    double t = vv > 1e-12 ? (uv * s + vw) / vv : 0.0;
    if (t < 0 || t > 1 || vv <= 1e-12) {
        t = std::clamp(t, 0.0, 1.0);
        s = uu > 1e-12 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0.0;
    }
    const Vector3d way = w + s * u - t * v;
    const double distance = way.norm();
    Nearness near;
    near.depth = p.radius + q.radius - distance;
    if (distance > 1e-9) near.direction = way / distance;
    near.alongFirst = s;
    near.alongSecond = t;
    return near;
}

double overlap(const std::vector<Capsule>& first, const std::vector<Capsule>& second) {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Capsule& p : first) {
        for (const Capsule& q : second) {
            deepest = std::max(deepest, nearness(p, q).depth);
        }
    }
    return deepest;
}

}  // namespace kumite
