#pragma once

#include "core/motion/pose.h"
#include "core/project/analysis.h"

namespace kumite {

/// A fighter's take as poses in the bout's space: placed, its floor at y = 0, at its rate. Frame 0
/// of the clip is frame 0 of the take. `losses`, if given, says what a rig cannot hold (rig.h).
/// Throws Error if the recording is missing.
Clip placedClip(const FighterAnalysis& fighter, Findings* losses = nullptr);

}  // namespace kumite
