#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/editing/point_index.h"
#include "core/editing/strike.h"

namespace kumite {

/// How much of which example a blend takes; weights are positive and sum up to 1.
struct ExampleWeight {
    int example = 0;
    double weight = 0;
};
using BlendWeights = std::vector<ExampleWeight>;

struct Box {
    Eigen::Vector3d low = Eigen::Vector3d::Zero();
    Eigen::Vector3d high = Eigen::Vector3d::Zero();

    bool contains(const Eigen::Vector3d& p) const {
        return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
    }
    double volume() const { return (high - low).prod(); }  ///< m³
};

struct StrikeSpaceSettings {
    int neighbours = 3;  ///< examples that an example is blended with, by nearness of their hits
    int steps = 6;       ///< a blend's weights are multiples of 1/steps
    int slopeLimit = 2;  ///< of the time alignment; raised where lengths differ more
};

/// The parameter space of a strike (paper C, 3.1): examples aligned in time and starting heading,
/// and densely sampled blends of them, each with the point that it hits in the striker's frame at
/// the start (pelvis on the floor the origin, x left, y up, z heading; metres).
struct StrikeSpace {
    struct Example {
        std::string name;
        std::vector<Pose> poses;      ///< one per frame of the common timeline
        std::vector<double> seconds;  ///< when the example itself shows that pose
        Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< where it hits
        double alignmentCost = 0;  ///< of its time alignment with the reference, m²
    };
    Striker striker = Striker::RightHand;
    std::shared_ptr<const Rig> rig;
    double rate = 0;  ///< Hz
    std::vector<Example> examples;
    int reference = 0;   ///< the example whose frames are the common timeline
    int frames = 0;      ///< of the common timeline
    int hit = 0;         ///< its frame at full stretch
    double fastest = 0;  ///< greatest speed of the striking joint in the examples, m/s
    /// Examples that are blended with each other.
    std::vector<std::vector<int>> neighbourhoods;
    struct Sample {
        BlendWeights weights;
        int neighbourhood = 0;
    };
    std::vector<Sample> samples;
    PointIndex points;  ///< of the samples
    Box natural;        ///< around the points
};

/// Aligns the examples (of one rig) and samples their blends. Deterministic. Cancellable. Throws
/// Error if there is no example, if rigs differ or lack the limb.
StrikeSpace strikeSpace(const std::vector<Strike>& examples, Striker striker,
                        const StrikeSpaceSettings& settings = {}, const Progress& progress = {});

/// The blend's pose at a frame of the common timeline: rotations by slerp, one example after the
/// other. Its first pose stands in the striker's frame.
Pose blendedPose(const StrikeSpace& space, const BlendWeights& weights, int frame);
/// When the blend shows the common timeline's frames, seconds from the first.
std::vector<double> blendedTimes(const StrikeSpace& space, const BlendWeights& weights);
/// Where the blend hits.
Eigen::Vector3d hitPoint(const StrikeSpace& space, const BlendWeights& weights);

/// A blend for a target.
struct BlendFit {
    BlendWeights weights;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< where it hits
    double error = 0;                                 ///< its distance from the target, metres
};

/// The blend of neighbouring examples that comes nearest to the target: from the best samples of
/// the three best neighbourhoods on, the weights are refined until the point is met or cannot be.
/// `measure` scales distances: what counts is |measure · (point − target)|.
BlendFit fitBlend(const StrikeSpace& space, const Eigen::Vector3d& target,
                  const Eigen::Matrix3d& measure = Eigen::Matrix3d::Identity());

}  // namespace kumite
