#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/motion/roles.h"

namespace kumite {

/// The parts that a body is put together from (method C2). The pelvis with what stands above it in
/// the tree carries all of them and belongs to none.
enum class BodyPart { LeftArm, RightArm, LeftLeg, RightLeg, Trunk };

inline constexpr int kBodyPartCount = 5;

/// Spelling in files and on the command line: "left_arm"; "trunk" is trunk and head.
std::string_view partName(BodyPart part);
std::optional<BodyPart> partFromName(std::string_view name);
const std::array<BodyPart, kBodyPartCount>& allParts();
BodyPart mirrored(BodyPart part);

/// The part of every joint of a skeleton that is given by its parents (-1: a root; parents stand
/// before children); nothing for the pelvis and what is above it. An arm begins at the first joint
/// that carries nothing but that arm (as a rule the clavicle), a leg likewise.
std::vector<std::optional<BodyPart>> partsOfJoints(std::span<const int> parents,
                                                   const RoleMap& roles);

/// The joint where a part begins, its junction with the rest of the body (paper C, 4.2.2): the
/// first joint of that part in the tree; nothing where the skeleton has no such part.
std::optional<int> junctionOf(std::span<const std::optional<BodyPart>> parts, BodyPart part);

}  // namespace kumite
