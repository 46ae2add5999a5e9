#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/motion/pose.h"

namespace kumite {

/// How the way from one key to the next is gone.
enum class Easing {
    Linear,
    Smooth,  ///< leaves and arrives at rest (minimum jerk)
    In,      ///< leaves at rest
    Out,     ///< arrives at rest
    Hold     ///< stays until the next key
};
std::string_view easingName(Easing easing);
std::optional<Easing> easingFromName(std::string_view name);
/// Share of the way at a share of the time, both in [0, 1].
double eased(Easing easing, double time);

/// A pose that somebody made, and when it is to be seen.
struct KeyPose {
    int frame = 0;
    Pose pose;
    Easing easing = Easing::Smooth;  ///< of the way to the next key
};

/// Key poses of one rig on a timeline of `rate` Hz, in order of their frames, one per frame. A
/// value: edits give a new track, undo keeps the old one.
struct KeyTrack {
    std::shared_ptr<const Rig> rig;
    double rate = 60;
    std::vector<KeyPose> keys;

    /// Index of the key at that frame.
    std::optional<int> find(int frame) const;
};

// Edits. Throw Error if there is no key at the frame that is named.

/// With a key; it takes the place of one that is at its frame already.
KeyTrack withKey(KeyTrack track, KeyPose key);
KeyTrack withoutKey(KeyTrack track, int frame);
/// A key at another frame; one that was there gives way.
KeyTrack withMovedKey(KeyTrack track, int from, int to);
/// A key at another frame and all later ones as much earlier or later. Throws Error if it would not
/// stay behind the key before it.
KeyTrack withShiftedKeys(KeyTrack track, int from, int to);
/// The same pose once more.
KeyTrack withCopiedKey(KeyTrack track, int from, int to);
KeyTrack withEasing(KeyTrack track, int frame, Easing easing);
/// All keys from `first` on, `factor` times as far from it as they are; keys stay at least one
/// frame apart. Throws Error unless the factor is above 0.
KeyTrack retimed(KeyTrack track, int first, double factor);

/// Throws Error if the rig is missing, poses do not fit it, or keys are not in order.
void validate(const KeyTrack& track);

/// The track's pose at a moment, in frames: eased slerp between the keys around it; the first and
/// last key's pose outside. The track must have a key.
Pose poseAt(const KeyTrack& track, double frame);
/// From the first key's frame to the last key's, frame by frame: the query motion (method C2).
Clip clipOf(const KeyTrack& track);

}  // namespace kumite
