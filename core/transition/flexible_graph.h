#pragma once

#include <memory>
#include <optional>

#include "core/motion/motion_library.h"
#include "core/transition/candidate_paths.h"
#include "core/transition/pose_metric.h"

namespace kumite {

struct FlexibleGraphSettings {
    PoseMetricSettings metric;
    std::optional<double> threshold;  ///< of the clusters; nothing: by `secondsPerCluster`
    double secondsPerCluster = 0.75;  ///< what the mean cluster is to hold
    bool undirected = false;          ///< clips may be played backward
    int pathsPerPair = 5;
    double longestPath = 8;  ///< a path costs less than this many median edges

    bool operator==(const FlexibleGraphSettings&) const = default;
};

/// A library prepared for transitions (paper B, "Preprocess Phase"): a pure function of library and
/// settings, never changed, so that threads may share it. Candidate paths are found when they are
/// asked for, which takes less than a millisecond: nothing has to be stored.
struct FlexibleGraph {
    FlexibleGraphSettings settings;
    std::shared_ptr<const MotionLibrary> library;
    PoseMetric metric;
    PoseClusters clusters;
    TransitionGraph graph;
    PathSettings paths;
    PathSearch search;  ///< to be copied by who searches

    /// A cluster's centre frame.
    const Pose& medoid(int cluster) const;
};

/// The frames of a library as points, for clustering; both must outlive it.
PointSource pointsOf(const MotionLibrary& library, const PoseMetric& metric);

/// The threshold that the settings name, or the one that they lead to.
double clusterThreshold(const MotionLibrary& library, const PoseMetric& metric,
                        const FlexibleGraphSettings& settings, const Progress& progress = {});

/// Clusters, graph and the limit of paths. A library without any difference between frames gets
/// one cluster; without frames none. Throws Error, Cancelled.
std::shared_ptr<const FlexibleGraph> buildFlexibleGraph(
    std::shared_ptr<const MotionLibrary> library, const FlexibleGraphSettings& settings = {},
    const Progress& progress = {});

}  // namespace kumite
