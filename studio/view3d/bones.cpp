#include "studio/view3d/bones.h"

#include <algorithm>
#include <optional>

namespace kumite::studio {

namespace {

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

bool isLeftLimb(Role role) {
    for (const Role each : {Role::LeftShoulder, Role::LeftElbow, Role::LeftWrist, Role::LeftHip,
                            Role::LeftKnee, Role::LeftAnkle, Role::LeftToe}) {
        if (role == each) return true;
    }
    return false;
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
        Bone bone{from, static_cast<int>(to)};
        const auto& role = region[static_cast<std::size_t>(from)];
        bone.isLeft = role && isLeftLimb(*role);
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

}  // namespace kumite::studio
