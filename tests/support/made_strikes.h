#pragma once

#include <string>
#include <vector>

#include "core/editing/strike.h"

namespace kumite::test {

/// Sets of strikes like the paper's: 7 straight punches, 9 hooks, 8 straight kicks, 8 side kicks.
enum class StrikeKind { StraightPunch, Hook, StraightKick, SideKick };
inline constexpr StrikeKind kStrikeKinds[] = {StrikeKind::StraightPunch, StrikeKind::Hook,
                                              StrikeKind::StraightKick, StrikeKind::SideKick};
const char* kindName(StrikeKind kind);
Striker strikerOf(StrikeKind kind);

/// A made strike: somebody somewhere on the floor, facing anywhere, strikes a point and comes back.
struct MadeStrike {
    std::string name;
    Clip clip;
    int hit = 0;            ///< the frame at which the limb is at the point, at rest for a moment
    Eigen::Vector3d point;  ///< in the striker's frame at the start (method C1), metres
};

/// The figure of these strikes (test::makeHuman).
std::shared_ptr<const Rig> madeRig();

/// A whole set. The seed draws places, headings, speeds and small differences of style.
std::vector<MadeStrike> madeStrikes(StrikeKind kind, unsigned seed = 1);

/// The set as examples in their own frames.
std::vector<Strike> asExamples(const std::vector<MadeStrike>& made);

/// A steady walk of `seconds` seconds at `speed` m/s along +z, arms swinging against the legs.
Clip madeWalk(double seconds, double speed = 1.2, double rate = 60);

}  // namespace kumite::test
