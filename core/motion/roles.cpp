#include "core/motion/roles.h"

#include <algorithm>

namespace kumite {
namespace {

constexpr std::array<std::string_view, kRoleCount> kNames = {
    "pelvis",        "spine",         "chest",      "neck",           "head",
    "left_clavicle", "left_shoulder", "left_elbow", "left_wrist",     "left_hip",
    "left_knee",     "left_ankle",    "left_toe",   "right_clavicle", "right_shoulder",
    "right_elbow",   "right_wrist",   "right_hip",  "right_knee",     "right_ankle",
    "right_toe"};

constexpr int kLimbRoles = 8;  // of one side

}  // namespace

std::string_view roleName(Role role) {
    return kNames[static_cast<std::size_t>(role)];
}

std::optional<Role> roleFromName(std::string_view name) {
    const auto at = std::find(kNames.begin(), kNames.end(), name);
    if (at == kNames.end()) return std::nullopt;
    return static_cast<Role>(at - kNames.begin());
}

const std::array<Role, kRoleCount>& allRoles() {
    static const std::array<Role, kRoleCount> roles = [] {
        std::array<Role, kRoleCount> all{};
        for (int i = 0; i < kRoleCount; ++i)
            all[static_cast<std::size_t>(i)] = static_cast<Role>(i);
        return all;
    }();
    return roles;
}

Role mirrored(Role role) {
    if (role >= Role::RightClavicle) return static_cast<Role>(static_cast<int>(role) - kLimbRoles);
    if (role >= Role::LeftClavicle) return static_cast<Role>(static_cast<int>(role) + kLimbRoles);
    return role;
}

int RoleMap::count() const {
    return kRoleCount - static_cast<int>(missing().size());
}

std::vector<Role> RoleMap::missing() const {
    std::vector<Role> roles;
    std::copy_if(allRoles().begin(), allRoles().end(), std::back_inserter(roles),
                 [this](Role role) { return !has(role); });
    return roles;
}

}  // namespace kumite
