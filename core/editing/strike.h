#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/frame_range.h"
#include "core/motion/blend.h"
#include "core/motion/pose.h"

namespace kumite {

/// What strikes.
enum class Striker { LeftHand, RightHand, LeftFoot, RightFoot };

/// "left_hand".
std::string_view strikerName(Striker striker);
std::optional<Striker> strikerFromName(std::string_view name);
inline bool isKick(Striker striker) {
    return striker == Striker::LeftFoot || striker == Striker::RightFoot;
}
inline bool isLeft(Striker striker) {
    return striker == Striker::LeftHand || striker == Striker::LeftFoot;
}
/// The joint whose place is meant to hit: the wrist; the toe (the foot's End Site, else the ankle).
std::optional<int> strikingJoint(const Rig& rig, Striker striker);

/// Where a strike is in a clip.
struct StrikeMoment {
    FrameRange frames;
    int hit = 0;  ///< the frame at full stretch
};

/// The strike in `range`: full stretch is the frame at which the striking joint is farthest from
/// its shoulder or hip, among those in which it is at least 80 % as far out from the pelvis,
/// horizontally, as it ever is, and a foot at least half as high. `frames` is `range` without what
/// is still before and after: from a tenth of a second before the limb leaves its rest (a hand goes
/// out, a foot up) to a tenth after it is back, at most 1.2 s on either side of the hit. Nothing if
/// the range has fewer than three frames or the rig no such limb.
std::optional<StrikeMoment> strikeIn(const Clip& clip, FrameRange range, Striker striker);

/// The strikes of an unlabelled recording: every time that a hand goes out from the pelvis by
/// `least` metres or more, horizontally, and comes back; that a foot goes up as much and is 40 cm
/// from the pelvis, horizontally, at full stretch; at 1.5 m/s against the pelvis or faster.
std::vector<StrikeMoment> findStrikes(const Clip& clip, Striker striker, double least = 0.25);

/// The limb that strikes in a clip: the one whose striking joint gets fastest against the pelvis.
std::optional<Striker> likeliestStriker(const Clip& clip, FrameRange range);

/// One example of a strike in its own frame: at its first frame the pelvis stands over the origin,
/// the heading is +z, the floor is y = 0 (x left, y up: method C1).
struct Strike {
    std::string name;
    Clip clip;
    int hit = 0;  ///< frame of the clip at full stretch
};

/// Cuts a strike out of a clip and brings it into its own frame. `floor` in metres.
Strike strikeFrom(const Clip& clip, const StrikeMoment& moment, double floor, std::string name);

/// The greatest speed of a joint from frame to frame, m/s; 0 in a single frame.
double fastestOf(const Clip& clip, int joint);

/// The floor under a clip: the lower of both feet's rest heights (method A2b), metres; 0 without
/// feet.
double floorUnder(const Clip& clip);

/// The clip with its pelvis over the origin and its heading +z at `frame`.
GroundTransform toOrigin(const Rig& rig, const Pose& pose);

}  // namespace kumite
