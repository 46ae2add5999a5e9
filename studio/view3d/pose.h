#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/project/analysis.h"
#include "studio/view3d/camera_controller.h"
#include "studio/view3d/overlays.h"

namespace kumite::studio {

/// The path of a hand or foot around a moment: path[now] is where it is then.
struct Trail {
    std::vector<Eigen::Vector3f> path;
    int now = 0;
};

/// A foot on the floor: where its heel and toes are.
struct FootOnFloor {
    Eigen::Vector3f heel;
    Eigen::Vector3f toe;
};

/// What is drawn of a fighter at one moment, in the bout's space: metres, y up, floor at 0.
struct FigurePose {
    std::vector<Eigen::Vector3f> joints;
    std::optional<Eigen::Vector3f> centreOfMass;
    std::optional<Eigen::Vector3f> force;  ///< contact force, body weights
    std::vector<FootOnFloor> footContacts;
    std::vector<Trail> trails;
};

/// A fighter as it stands at a frame, with what the overlays ask for.
FigurePose poseAt(const FighterAnalysis& fighter, int frame, const Overlays& overlays);
/// The positions of its joints alone.
std::vector<Eigen::Vector3f> jointsAt(const FighterAnalysis& fighter, int frame);

/// One joint of it, metres in the bout's space.
Eigen::Vector3d jointAt(const FighterAnalysis& fighter, int frame, int joint);

/// Centre of mass, or the root joint of a skeleton that is no body.
Eigen::Vector3d centreAt(const FighterAnalysis& fighter, int frame);

/// Paths of both hands and both feet from `before` frames back to `after` frames on, as far as
/// the take goes; as many of the four as the skeleton has.
std::vector<Trail> trailsAt(const FighterAnalysis& fighter, int frame, int before, int after);

/// Adds where the fighter goes during the take, with room for its body.
void addPath(Box& box, const FighterAnalysis& fighter);

/// Fighters of a take; null where one is missing.
using Fighters = std::array<const FighterAnalysis*, 2>;

/// The point that a following camera looks at: the middle between the fighters, weighed over half
/// a second to either side, so that it moves smoothly and depends on nothing but the moment.
std::optional<Eigen::Vector3d> followedPoint(const Fighters& fighters, double seconds);

/// Where a camera stands and what it looks at, metres.
struct Viewpoint {
    Eigen::Vector3d position;
    Eigen::Vector3d target;
};

/// Behind and above the right shoulder of a fighter, toward its opponent; alone, the way that it
/// faces. Nothing where there is no such fighter.
std::optional<Viewpoint> overShoulder(const Fighters& fighters, int player, double seconds);

}  // namespace kumite::studio
