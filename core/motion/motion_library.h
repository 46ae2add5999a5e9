#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/motion/foot_lock.h"
#include "core/motion/pose.h"

namespace kumite {

/// Poses that follow each other and which feet stand in them, both of one length.
struct MotionPart {
    std::span<const Pose> poses;
    std::span<const Standing> standing;

    int size() const { return static_cast<int>(poses.size()); }
    bool empty() const { return poses.empty(); }
    MotionPart part(FrameRange frames) const {
        const auto begin = static_cast<std::size_t>(frames.begin);
        const auto count = static_cast<std::size_t>(frames.size());
        return {poses.subspan(begin, count), standing.subspan(begin, count)};
    }
};

/// A recording, or one fighter of a take, brought to what its library has in common.
struct LibraryMotion {
    std::string name;  ///< a file's stem, or "take:player" (players from 1)
    Clip clip;
    std::vector<Standing> standing;  ///< per frame of the clip
    /// What the file's or take's frames are to the clip's: frame f there is shown at f / sourceRate
    /// seconds.
    double sourceRate = 0;
    int take = -1;  ///< of the project that the library is of, and its player; -1: of a file
    int player = -1;
    bool made = false;  ///< itself made of other motions: nothing is looked up in it
};

/// A stretch of a motion that can be asked for by name.
struct LibraryAction {
    std::string name;   ///< a file's stem (the whole of it), or "take:player:action"
    std::string label;  ///< as spelt ("right_kick:up+move:L-R"); empty where none is known
    int motion = 0;
    FrameRange frames;  ///< of the motion's clip; the frames of both boundaries are in it

    bool operator==(const LibraryAction&) const = default;
};

/// Motions of one rig at one rate, their floors at y = 0, and the actions in them.
struct MotionLibrary {
    std::shared_ptr<const Rig> rig;
    double rate = 0;  ///< Hz
    std::vector<LibraryMotion> motions;
    std::vector<LibraryAction> actions;
    /// The skeleton that the rig stands for and its file's conventions: what results are written
    /// with.
    std::shared_ptr<const Skeleton> skeleton;
    SpaceConvention space;
    FootLockSettings feet;  ///< rest heights of the rig's feet, for results

    MotionPart part(const LibraryAction& action) const {
        const LibraryMotion& motion = motions[static_cast<std::size_t>(action.motion)];
        return MotionPart{motion.clip.frames, motion.standing}.part(action.frames);
    }
};

}  // namespace kumite
