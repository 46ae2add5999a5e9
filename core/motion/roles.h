#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace kumite {

/// What a joint is in a human body, whatever its file calls it (method A1). All analysis runs on
/// roles. A limb's role names the joint where the segment begins: LeftElbow is the joint that
/// turns the left forearm.
enum class Role {
    Pelvis,
    Spine,
    Chest,
    Neck,
    Head,
    LeftClavicle,
    LeftShoulder,
    LeftElbow,
    LeftWrist,
    LeftHip,
    LeftKnee,
    LeftAnkle,
    LeftToe,
    RightClavicle,
    RightShoulder,
    RightElbow,
    RightWrist,
    RightHip,
    RightKnee,
    RightAnkle,
    RightToe
};

inline constexpr int kRoleCount = 21;

/// Spelling in files and on the command line: "left_shoulder".
std::string_view roleName(Role role);
std::optional<Role> roleFromName(std::string_view name);
const std::array<Role, kRoleCount>& allRoles();
/// LeftKnee for RightKnee and the reverse; roles of the middle stay.
Role mirrored(Role role);

/// For every role the index of the joint (or End Site) that has it, or nothing. Two roles may
/// name one joint where a skeleton has fewer joints than a body.
class RoleMap {
public:
    std::optional<int> operator[](Role role) const {
        const int joint = joints_[static_cast<std::size_t>(role)];
        return joint < 0 ? std::nullopt : std::optional<int>(joint);
    }
    bool has(Role role) const { return joints_[static_cast<std::size_t>(role)] >= 0; }
    void set(Role role, int joint) { joints_[static_cast<std::size_t>(role)] = joint; }
    void clear(Role role) { joints_[static_cast<std::size_t>(role)] = -1; }
    int count() const;
    std::vector<Role> missing() const;

    bool operator==(const RoleMap&) const = default;

private:
    std::array<int, kRoleCount> joints_ = [] {
        std::array<int, kRoleCount> none{};
        none.fill(-1);
        return none;
    }();
};

}  // namespace kumite
