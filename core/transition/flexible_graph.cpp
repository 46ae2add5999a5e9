#include "core/transition/flexible_graph.h"

namespace kumite {

const Pose& FlexibleGraph::medoid(int cluster) const {
    const FrameAddress at = clusters.founders[static_cast<std::size_t>(cluster)];
    return library->motions[static_cast<std::size_t>(at.motion)]
        .clip.frames[static_cast<std::size_t>(at.frame)];
}

PointSource pointsOf(const MotionLibrary& library, const PoseMetric& metric) {
    PointSource source;
    source.shape = metric.shape();
    for (const LibraryMotion& motion : library.motions)
        source.frameCounts.push_back(motion.clip.frameCount());
    source.read = [&library, &metric](int motion, MetricPoints& points) {
        const Clip& clip = library.motions[static_cast<std::size_t>(motion)].clip;
        metric.points(clip.frames, clip.rate, points);
    };
    return source;
}

double clusterThreshold(const MotionLibrary& library, const PoseMetric& metric,
                        const FlexibleGraphSettings& settings, const Progress& progress) {
    if (settings.threshold) return *settings.threshold;
    const double found = thresholdFor(pointsOf(library, metric),
                                      settings.secondsPerCluster * library.rate, progress);
    return found > 0 ? found : 1;  // where nothing differs any threshold gives one cluster
}

std::shared_ptr<const FlexibleGraph> buildFlexibleGraph(
    std::shared_ptr<const MotionLibrary> library, const FlexibleGraphSettings& settings,
    const Progress& progress) {
    const PoseMetric metric(*library->rig, settings.metric);
    const PointSource source = pointsOf(*library, metric);
    const double threshold = clusterThreshold(*library, metric, settings, progress.part(0, 0.5));
    PoseClusters clusters = clusterPoses(source, threshold, progress.part(0.5, 0.9));
    TransitionGraph graph = buildTransitionGraph(clusters, settings.undirected);
    const PathSettings paths{settings.pathsPerPair, pathLimit(graph, settings.longestPath)};
    PathSearch search(graph, paths);
    progress.update(1);
    return std::make_shared<const FlexibleGraph>(
        FlexibleGraph{settings, std::move(library), metric, std::move(clusters), std::move(graph),
                      paths, std::move(search)});
}

}  // namespace kumite
