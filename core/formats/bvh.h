#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/formats/recording.h"

namespace kumite {

/// Reads BVH text as exporters really write it: any channel order and count, position channels
/// on any joint, End Sites named or not or absent, comments (#, //) and blank lines, any line
/// ends, keywords in any case, names with spaces, dots and colons, numbers split over lines, a
/// wrong frame count, a cut last row, several skeletons. `name` is used in messages only.
///
/// Throws InputError `name:line:column: what, expected what`.
Recording readBvh(std::string_view text, const std::string& name, const Progress& progress = {});

/// BVH text of `frames` of a motion with the given frame time (seconds). Joints whose rotations
/// act in a frame of their own (ASF) are written as Z, Y, X rotations; everything else as it was
/// read: hierarchy, channel order and values bit for bit.
std::string bvhText(const Motion& motion, FrameRange frames, double frameTime);

}  // namespace kumite
