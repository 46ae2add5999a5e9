#pragma once

#include <memory>

#include "core/motion/motion_library.h"

namespace kumite::test {

/// A library of made motions of makeHuman's rig at 30 Hz. "kick", "punch", "block" and "turn" (60
/// frames each) go from one stance to a posture of their own and back, a little differently each
/// time and walking on as they go; "lonely" sways about a posture far from all others.
std::shared_ptr<const MotionLibrary> madeLibrary();

/// A library of one motion that goes from one stance to another and stays: "one", 60 frames.
std::shared_ptr<const MotionLibrary> oneWayLibrary();

/// The action of that name.
const LibraryAction& actionOf(const MotionLibrary& library, const std::string& name);
MotionPart partOf(const MotionLibrary& library, const std::string& name);

}  // namespace kumite::test
