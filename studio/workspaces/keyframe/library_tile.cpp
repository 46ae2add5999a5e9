#include "studio/workspaces/keyframe/library_tile.h"

#include <algorithm>

namespace kumite::studio {

ActionTile tileOf(const MotionLibrary& library, const Clip& clip, FrameRange frames) {
    frames.begin = std::clamp(frames.begin, 0, std::max(0, clip.frameCount() - 1));
    frames.end = std::clamp(frames.end, frames.begin, clip.frameCount());
    const Clip slice{clip.rig,
                     clip.rate,
                     {clip.frames.begin() + frames.begin, clip.frames.begin() + frames.end}};
    FighterAnalysis figure;
    // Of the motion a view asks for its skeleton and length; where joints are stands beside it.
    auto motion = std::make_shared<Motion>();
    motion->skeleton = library.skeleton;
    motion->frameCount = slice.frameCount();
    figure.input.motion = std::move(motion);
    figure.input.frames = {0, slice.frameCount()};
    figure.input.rate = clip.rate;
    figure.input.roles = library.rig->roles;
    figure.input.space = library.space;
    figure.motion = std::make_shared<const FighterMotion>(FighterMotion{positionsOf(slice)});
    auto body = std::make_shared<FighterBody>();
    for (const Pose& pose : slice.frames)
        body->heading.push_back(headingOf(*clip.rig, pose).value_or(0));
    figure.body = std::move(body);
    ActionTile tile;
    tile.fighters[0] = std::move(figure);
    tile.end = slice.seconds();
    return tile;
}

}  // namespace kumite::studio
