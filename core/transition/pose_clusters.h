#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/transition/pose_tree.h"

namespace kumite {

/// The frames of some motions as points, read motion by motion, so that a large library never lies
/// in memory as a whole. `read` appends the points of a motion to an empty `points`; it gives the
/// same ones each time.
struct PointSource {
    MetricShape shape;
    std::vector<int> frameCounts;  ///< per motion
    std::function<void(int motion, MetricPoints& points)> read;

    std::size_t frameCount() const;
};

/// A frame of a library: motion and frame in it, both from 0.
struct FrameAddress {
    int motion = 0;
    int frame = 0;

    bool operator==(const FrameAddress&) const = default;
};

/// Every frame's cluster (paper B, "Frame-Based Two-Pass Clustering").
struct PoseClusters {
    double threshold = 0;
    PoseTree centres;                    ///< the centre points; their ids are the clusters
    std::vector<FrameAddress> founders;  ///< the frame that founded each cluster: its centre
    std::vector<std::vector<int>> ids;   ///< by motion and frame; −1: undefined

    int count() const { return centres.count(); }
};

/// The first pass: in the order of frames, one nearer than `threshold` to a centre joins it, one
/// farther than twice the threshold from all becomes a centre, any other stays undefined. So no two
/// centres are nearer than twice the threshold. Throws Error if the threshold is not positive;
/// Cancelled.
PoseClusters firstPass(const PointSource& source, double threshold, const Progress& progress = {});

/// The second pass: undefined frames join the nearest centre (of equals the lower number), which is
/// at most twice the threshold away.
void secondPass(const PointSource& source, PoseClusters& clusters, const Progress& progress = {});

/// Both passes.
PoseClusters clusterPoses(const PointSource& source, double threshold,
                          const Progress& progress = {});

/// The threshold at which the mean cluster holds about `framesPerCluster` frames (method B: 0.75 s
/// of them). Sought on at most 20 000 frames, stretches spread over the library, so
/// that a larger library is cut no finer than what it repeats. 0 if there are fewer than two
/// different frames.
double thresholdFor(const PointSource& source, double framesPerCluster,
                    const Progress& progress = {});

}  // namespace kumite
