#include "core/editing/body_parts.h"

#include <algorithm>
#include <utility>

namespace kumite {
namespace {

constexpr std::array<BodyPart, kBodyPartCount> kParts = {
    BodyPart::LeftArm, BodyPart::RightArm, BodyPart::LeftLeg, BodyPart::RightLeg, BodyPart::Trunk};

constexpr std::array<std::string_view, kBodyPartCount> kNames = {"left_arm", "right_arm",
                                                                 "left_leg", "right_leg", "trunk"};

/// The limb's roles from the trunk outward.
std::vector<Role> limbRoles(BodyPart part) {
    switch (part) {
        case BodyPart::LeftArm:
            return {Role::LeftClavicle, Role::LeftShoulder, Role::LeftElbow, Role::LeftWrist};
        case BodyPart::RightArm:
            return {Role::RightClavicle, Role::RightShoulder, Role::RightElbow, Role::RightWrist};
        case BodyPart::LeftLeg:
            return {Role::LeftHip, Role::LeftKnee, Role::LeftAnkle, Role::LeftToe};
        case BodyPart::RightLeg:
            return {Role::RightHip, Role::RightKnee, Role::RightAnkle, Role::RightToe};
        case BodyPart::Trunk:
            break;
    }
    return {Role::Spine, Role::Chest, Role::Neck, Role::Head};
}

}  // namespace

std::string_view partName(BodyPart part) {
    return kNames[static_cast<std::size_t>(part)];
}

std::optional<BodyPart> partFromName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return kParts[static_cast<std::size_t>(found - kNames.begin())];
}

const std::array<BodyPart, kBodyPartCount>& allParts() {
    return kParts;
}

BodyPart mirrored(BodyPart part) {
    switch (part) {
        case BodyPart::LeftArm:
            return BodyPart::RightArm;
        case BodyPart::RightArm:
            return BodyPart::LeftArm;
        case BodyPart::LeftLeg:
            return BodyPart::RightLeg;
        case BodyPart::RightLeg:
            return BodyPart::LeftLeg;
        case BodyPart::Trunk:
            break;
    }
    return part;
}

std::vector<std::optional<BodyPart>> partsOfJoints(std::span<const int> parents,
                                                   const RoleMap& roles) {
    // What a joint carries: a bit per limb, for each joint that has one of its roles below it.
    std::vector<unsigned> carries(parents.size(), 0);
    for (const BodyPart part : kParts) {
        for (const Role role : limbRoles(part)) {
            if (roles[role]) carries[static_cast<std::size_t>(*roles[role])] |= 1u << int(part);
        }
    }
    const auto pelvis = static_cast<std::size_t>(roles[Role::Pelvis].value_or(0));
    carries[pelvis] = ~0u;
    for (std::size_t j = parents.size(); j-- > 0;) {
        if (parents[j] >= 0) carries[static_cast<std::size_t>(parents[j])] |= carries[j];
    }
    std::vector<std::optional<BodyPart>> parts(parents.size());
    for (std::size_t j = 0; j < parents.size(); ++j) {
        if (carries[j] == ~0u) continue;
        const auto above =
            parents[j] < 0 ? std::nullopt : parts[static_cast<std::size_t>(parents[j])];
        if (above && *above != BodyPart::Trunk) {
            parts[j] = above;
            continue;
        }
        parts[j] = BodyPart::Trunk;
        for (const BodyPart part : kParts) {
            if (part != BodyPart::Trunk && carries[j] == 1u << int(part)) parts[j] = part;
        }
    }
    return parts;
}

std::optional<int> junctionOf(std::span<const std::optional<BodyPart>> parts, BodyPart part) {
    const auto found = std::find(parts.begin(), parts.end(), std::optional(part));
    if (found == parts.end()) return std::nullopt;
    return static_cast<int>(found - parts.begin());
}

}  // namespace kumite
