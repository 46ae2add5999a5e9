#pragma once

#include <string>

#include "core/motion/kinematics.h"
#include "core/motion/skeleton.h"

namespace kumite {

/// `frame,joint,x,y,z`: world positions in metres, y up, six decimals. Frames are numbered from
/// `firstFrame`; End Sites are left out unless asked for. Names with commas or quotes are quoted
/// as CSV does.
std::string jointPositionsCsv(const Skeleton& skeleton, const JointPositions& positions,
                              int firstFrame, bool withEndSites);

/// A field as CSV wants it: quoted where it must be.
std::string csvField(std::string_view text);

}  // namespace kumite
