#pragma once

#include <span>
#include <vector>

#include "core/demo/body.h"
#include "core/demo/com_path.h"
#include "core/demo/footwork.h"
#include "core/demo/posture.h"
#include "core/demo/strikes.h"

namespace kumite::demo {

/// Everything that decides a fighter's pose at any time.
struct FighterPlan {
    BodySize size;
    Script script;
    ComPath centreOfMass;
    Feet feet;
    std::vector<Strike> strikes;  ///< in order of their hits
    PosturePlan posture;
    std::uint64_t seed = 0;
};

/// The strikes whose hit lies within 2 s of a time.
std::span<const Strike> strikesNear(const FighterPlan& plan, double time);

struct Figure {
    Pose pose;
    Landmarks marks;
};

/// The pose at a time: trunk and arms by posture and strikes, legs to where the feet are, and the
/// pelvis so that the centre of mass is where it is planned (method D, steps 4 to 6). A pure
/// function of the plan and the time, whatever the frame rate. `opponent`: where the other is, for
/// the direction to face.
Figure figureAt(const FighterPlan& plan, const ComPath& opponent, double time);

/// Direction that the fighter faces: from its own to the other's centre of mass.
double facingAt(const ComPath& own, const ComPath& opponent, double time);

/// Height of the centre of mass in the usual guard, metres.
double guardHeightOf(const BodySize& size);

}  // namespace kumite::demo
