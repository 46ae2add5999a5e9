#include "core/project/placed_clip.h"

#include "core/base/error.h"
#include "core/motion/blend.h"

namespace kumite {

Clip placedClip(const FighterAnalysis& fighter, Findings* losses) {
    const Fighter& input = fighter.input;
    if (!fighter.available()) {
        throw Error(input.recording.path.string() +
                    ": the recording is missing; the take cannot be shown without it.");
    }
    const FrameRange frames = framesOf(input);
    if (losses) *losses = rigLosses(*input.motion, frames, input.space, input.roles);
    Clip clip = moved(clipOf(*input.motion, frames, input.space, input.roles, input.rate),
                      {input.placement.yaw, input.placement.x, input.placement.z});
    for (Pose& pose : clip.frames)
        pose.root.y() -= fighter.body->floor;
    return clip;
}

}  // namespace kumite
