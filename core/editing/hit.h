#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/editing/joint_turns.h"
#include "core/editing/strike_space.h"

namespace kumite {

/// How a strike is brought to a target: by a blend of whole examples; by blends of parts that are
/// corrected (paper C, 3.2); whichever comes nearer, the whole blend where both are good.
enum class HitMethod { Full, Partial, Best };
std::string_view methodName(HitMethod method);
std::optional<HitMethod> methodFromName(std::string_view name);

/// How far partial blending may correct.
struct HitSettings {
    double chest = 0.6;       ///< radians that the chest turns about y for direction
    double collar = 0.25;     ///< radians of the clavicle
    double shoulder = 0.7;    ///< radians of the shoulder
    double hip = 0.7;         ///< radians of the hip, for direction and for height
    double shift = 0.12;      ///< metres that the pelvis gives way, horizontally
    double sink = 0.06;       ///< metres that it gives way up or down
    double close = 0.01;      ///< metres; a blend that hits so well needs no correction
    double tolerance = 0.03;  ///< metres; a target so near counts as reached
    int rounds = 3;           ///< renderings whose measured error is fed back
};

/// How a target is met, as decided at the moment of the hit.
struct HitSolution {
    HitMethod method = HitMethod::Full;  ///< Full or Partial
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    /// Full: the blend. Partial: P_H, at the target's height and nearest to it sideways.
    BlendFit horizontal;
    /// Partial: P_V, in the target's direction and nearest to it in height. Full: the same blend.
    BlendFit vertical;
    bool insideNaturalRegion = false;  ///< a blend of whole examples meets the target
    // Corrections at the hit, in the order in which they are made; metres.
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< of the pelvis
    std::vector<JointTurn> turns;
    Eigen::Vector3d bend = Eigen::Vector3d::Zero();     ///< way that elbow or knee give, at the hit
    Eigen::Vector3d reached = Eigen::Vector3d::Zero();  ///< where it hits then
    double error = 0;                                   ///< metres
};

/// Decides how a target (in the striker's frame) is met. A few milliseconds; deterministic.
HitSolution solveHit(const StrikeSpace& space, const Eigen::Vector3d& target,
                     HitMethod method = HitMethod::Best, const HitSettings& settings = {});

/// The solution's pose at a frame of the common timeline; corrections come and go smoothly and are
/// whole at the hit.
Pose solvedPose(const StrikeSpace& space, const HitSolution& solution, int frame);

/// A motion that hits, in the striker's frame.
struct HitMotion {
    Clip clip;
    int hit = 0;  ///< frame of the clip
    HitSolution solution;
    Eigen::Vector3d reached = Eigen::Vector3d::Zero();  ///< by the clip as it is, metres
    double error = 0;                                   ///< metres from the target
    bool hits = false;                                  ///< within the tolerance
};

/// Solves, renders (warped in time so that the hit is a frame and the limb no faster than a tenth
/// above the fastest example; feet cleaned up) and measures the clip that comes out. A target that
/// nothing reaches gets the nearest reachable point; `hits` is false then.
HitMotion hitTarget(const StrikeSpace& space, const Eigen::Vector3d& target,
                    HitMethod method = HitMethod::Best, const HitSettings& settings = {});

}  // namespace kumite
