#include "studio/view3d/figure_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace kumite::studio {

namespace {

constexpr int kSides = 14;
constexpr int kCapRings = 3;

/// Radii of the bone that begins at a role's joint, for legs of 0.85 m.
struct Thickness {
    double from;
    double to;
};

Thickness thicknessOf(Role role) {
    switch (role) {
        case Role::Pelvis:
            return {0.100, 0.095};
        case Role::Spine:
            return {0.098, 0.108};
        case Role::Chest:
            return {0.105, 0.070};
        case Role::Neck:
            return {0.046, 0.042};
        case Role::Head:
            return {0.042, 0.042};
        case Role::LeftClavicle:
        case Role::RightClavicle:
            return {0.052, 0.050};
        case Role::LeftShoulder:
        case Role::RightShoulder:
            return {0.050, 0.038};
        case Role::LeftElbow:
        case Role::RightElbow:
            return {0.038, 0.027};
        case Role::LeftWrist:
        case Role::RightWrist:
            return {0.028, 0.020};
        case Role::LeftHip:
        case Role::RightHip:
            return {0.072, 0.054};
        case Role::LeftKnee:
        case Role::RightKnee:
            return {0.053, 0.036};
        case Role::LeftAnkle:
        case Role::RightAnkle:
            return {0.038, 0.030};
        case Role::LeftToe:
        case Role::RightToe:
            return {0.028, 0.020};
    }
    return {0.03, 0.03};
}

bool isHand(Role role) {
    return role == Role::LeftWrist || role == Role::RightWrist;
}

/// Whether the way from the pelvis to a hip joint goes through `joint`.
bool leadsToHip(const Skeleton& skeleton, const RoleMap& roles, int joint) {
    for (const Role hip : {Role::LeftHip, Role::RightHip}) {
        for (int at = roles[hip].value_or(-1); at >= 0;
             at = skeleton.joints[static_cast<std::size_t>(at)].parent) {
            if (at == joint) return true;
        }
    }
    return false;
}

double legLength(const Skeleton& skeleton, const RoleMap& roles, double metresPerUnit) {
    double length = 0;
    const auto hip = roles[Role::LeftHip];
    auto joint = roles[Role::LeftAnkle];
    if (!hip || !joint) return 0;
    for (int j = *joint; j >= 0 && j != *hip;
         j = skeleton.joints[static_cast<std::size_t>(j)].parent) {
        length += skeleton.joints[static_cast<std::size_t>(j)].offset.norm() * metresPerUnit;
    }
    return length;
}

/// The role that says how thick things are at a joint: its own, or that of its nearest ancestor.
std::vector<std::optional<Role>> regions(const Skeleton& skeleton, const RoleMap& roles) {
    std::vector<std::optional<Role>> region(skeleton.joints.size());
    for (std::size_t joint = 0; joint < skeleton.joints.size(); ++joint) {
        const int parent = skeleton.joints[joint].parent;
        if (parent >= 0) region[joint] = region[static_cast<std::size_t>(parent)];
        for (const Role role : allRoles()) {
            if (roles[role] == static_cast<int>(joint)) region[joint] = role;
        }
    }
    return region;
}

/// A point of a ring, and the outward direction there.
struct RingFrame {
    Eigen::Vector3f axis, across, over;

    explicit RingFrame(const Eigen::Vector3f& direction) : axis(direction) {
        across = axis.unitOrthogonal();
        over = axis.cross(across);
    }
    Eigen::Vector3f around(int side) const {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
        return std::cos(angle) * across + std::sin(angle) * over;
    }
};

/// Joins consecutive rings of kSides corners with triangles.
void joinRings(std::vector<int>& triangles, int first, int rings) {
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int side = 0; side < kSides; ++side) {
            const int a = first + ring * kSides + side;
            const int b = first + ring * kSides + (side + 1) % kSides;
            const int c = a + kSides;
            const int d = b + kSides;
            triangles.insert(triangles.end(), {a, b, c, b, d, c});
        }
    }
}

}  // namespace

std::vector<Bone> bonesOf(const Skeleton& skeleton, const RoleMap& roles, double metresPerUnit) {
    const double leg = legLength(skeleton, roles, metresPerUnit);
    const double scale = leg > 0 ? std::clamp(leg / 0.85, 0.3, 2.0) : 1.0;
    const auto region = regions(skeleton, roles);
    std::vector<Bone> bones;
    bool headDone = false;
    for (std::size_t to = 0; to < skeleton.joints.size(); ++to) {
        const int from = skeleton.joints[to].parent;
        if (from < 0) continue;
        const double length = skeleton.joints[to].offset.norm() * metresPerUnit;
        Bone bone{from, static_cast<int>(to), 0, 0, false};
        const auto& role = region[static_cast<std::size_t>(from)];
        if (!role) {
            bone.fromRadius = bone.toRadius = std::clamp(0.13 * length, 0.008, 0.05);
        } else {
            Thickness thick = thicknessOf(*role);
            const bool atRole = roles[*role] == from;
            const bool fingers = isHand(*role) && !atRole;
            const bool manyChildren = skeleton.childrenOf(from).size() > 1;
            if (fingers) thick = {0.009, 0.008};
            if (isHand(*role) && atRole && manyChildren) thick = {0.018, 0.011};
            if (*role == Role::Chest && region[to] && *region[to] == Role::Neck) {
                thick = {0.085, 0.048};
            }
            if (*role == Role::Pelvis && leadsToHip(skeleton, roles, static_cast<int>(to))) {
                thick = {0.080, 0.068};
            }
            if (*role == Role::Head) {
                // The face's other joints (eyes, jaw) lie inside the one ellipsoid.
                if (headDone) continue;
                bone.isHead = headDone = true;
            }
            bone.fromRadius = thick.from * scale;
            bone.toRadius = thick.to * scale;
        }
        // A bone of no length is a joint drawn twice.
        if (length < 1e-4 && !bone.isHead) continue;
        bones.push_back(bone);
    }
    return bones;
}

void Mesh::clear() {
    points.clear();
    normals.clear();
    triangles.clear();
}

void Mesh::addCapsule(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float fromRadius,
                      float toRadius) {
    const Eigen::Vector3f along = to - from;
    const float length = along.norm();
    const Eigen::Vector3f axis =
        length > 1e-6F ? Eigen::Vector3f(along / length) : Eigen::Vector3f::UnitY();
    const RingFrame frame(axis);
    // Where the cone touches both spheres, so that the surface has no crease.
    const float slope =
        length > 1e-6F ? std::clamp((fromRadius - toRadius) / length, -0.95F, 0.95F) : 0.0F;
    const float touch = std::asin(slope);
    const float half = std::numbers::pi_v<float> / 2;
    const int first = static_cast<int>(points.size());
    const auto ring = [&](const Eigen::Vector3f& centre, float radius, float angle) {
        for (int side = 0; side < kSides; ++side) {
            const Eigen::Vector3f normal =
                std::cos(angle) * frame.around(side) + std::sin(angle) * axis;
            points.push_back(centre + radius * normal);
            normals.push_back(normal);
        }
    };
    for (int i = 0; i <= kCapRings; ++i) {
        ring(from, fromRadius, -half + (touch + half) * static_cast<float>(i) / kCapRings);
    }
    for (int i = 0; i <= kCapRings; ++i) {
        ring(to, toRadius, touch + (half - touch) * static_cast<float>(i) / kCapRings);
    }
    joinRings(triangles, first, 2 * (kCapRings + 1));
}

void Mesh::addEllipsoid(const Eigen::Vector3f& centre, const Eigen::Vector3f& axis, float length,
                        float width) {
    constexpr int kRings = 11;
    const RingFrame frame(axis);
    const int first = static_cast<int>(points.size());
    for (int i = 0; i < kRings; ++i) {
        const float angle =
            std::numbers::pi_v<float> * (static_cast<float>(i) / (kRings - 1) - 0.5F);
        for (int side = 0; side < kSides; ++side) {
            const Eigen::Vector3f around = frame.around(side);
            points.push_back(centre + width * std::cos(angle) * around +
                             length * std::sin(angle) * axis);
            normals.push_back(
                (std::cos(angle) / width * around + std::sin(angle) / length * axis).normalized());
        }
    }
    joinRings(triangles, first, kRings);
}

void Mesh::addArrow(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius) {
    const Eigen::Vector3f along = to - from;
    const float length = along.norm();
    const Eigen::Vector3f axis =
        length > 1e-6F ? Eigen::Vector3f(along / length) : Eigen::Vector3f::UnitY();
    const float tip = std::min(length, 6 * radius);
    addCapsule(from, to - tip * axis, radius, radius);
    const RingFrame frame(axis);
    const int first = static_cast<int>(points.size());
    const std::array<float, 3> radii = {0.0F, 2.6F * radius, 0.0F};
    const std::array<float, 3> back = {tip, tip, 0.0F};
    for (std::size_t i = 0; i < radii.size(); ++i) {
        for (int side = 0; side < kSides; ++side) {
            const Eigen::Vector3f around = frame.around(side);
            points.push_back(to - back[i] * axis + radii[i] * around);
            normals.push_back(i == 0 ? Eigen::Vector3f(-axis)
                                     : Eigen::Vector3f((around + 0.4F * axis).normalized()));
        }
    }
    joinRings(triangles, first, 3);
}

void buildBody(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints,
               Mesh& mesh) {
    mesh.clear();
    for (const Bone& bone : bones) {
        const Eigen::Vector3f& from = joints[static_cast<std::size_t>(bone.from)];
        const Eigen::Vector3f& to = joints[static_cast<std::size_t>(bone.to)];
        const auto fromRadius = static_cast<float>(bone.fromRadius);
        if (!bone.isHead) {
            mesh.addCapsule(from, to, fromRadius, static_cast<float>(bone.toRadius));
            continue;
        }
        const Eigen::Vector3f along = to - from;
        const float length = along.norm();
        const Eigen::Vector3f axis =
            length > 1e-4F ? Eigen::Vector3f(along / length) : Eigen::Vector3f::UnitY();
        const float halfHeight = std::clamp(0.62F * length, 2.6F * fromRadius, 3.4F * fromRadius);
        mesh.addEllipsoid(from + 0.85F * halfHeight * axis, axis, halfHeight, 0.76F * halfHeight);
    }
}

}  // namespace kumite::studio
