#pragma once

#include "core/editing/body_parts.h"
#include "core/editing/critical_joint.h"
#include "core/motion/pose.h"

namespace kumite {

/// What a part of a take is replaced by.
struct PartEdit {
    FrameRange frames;  ///< of the take
    BodyPart part = BodyPart::LeftArm;
    double sourceBegin = 0;  ///< frame of the source that the range's first frame shows
    double sourceEnd = 0;    ///< and its last frame; another length than the range's is warped
    double ease = 0.15;      ///< seconds at both ends in which the parts change over
    bool adjusted = false;   ///< junction joints keep the take's mean and deviation (paper C)
};

/// The take with one part's rotations taken from another clip of the same rig over a range of
/// frames; everything else, and every frame outside of the range, stays bit for bit. Throws Error
/// if the range does not lie in the take or the source's frames not in the source.
Clip withPart(const Clip& take, const Clip& source, const PartEdit& edit);

}  // namespace kumite
