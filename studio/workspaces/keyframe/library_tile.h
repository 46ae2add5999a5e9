#pragma once

#include "core/motion/motion_library.h"
#include "studio/view3d/action_tiles.h"

namespace kumite::studio {

/// Frames of a clip of the library's rig as a small view shows them; title and detail are left to
/// the caller.
ActionTile tileOf(const MotionLibrary& library, const Clip& clip, FrameRange frames);

}  // namespace kumite::studio
