#include "core/transition/pose_clusters.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace kumite {
namespace {

constexpr std::size_t kSampledFrames = 20000;
constexpr int kStretch = 200;  ///< frames of a sample that follow each other
constexpr int kSteps = 12;
constexpr double kCloseEnough = 0.02;  ///< of the wished number of clusters

/// Calls `use(motion, points)` for every motion.
template <typename Use>
void forMotions(const PointSource& source, const Progress& progress, const Use& use) {
    MetricPoints points{source.shape, {}};
    const double all = static_cast<double>(std::max<std::size_t>(1, source.frameCount()));
    double done = 0;
    for (std::size_t m = 0; m < source.frameCounts.size(); ++m) {
        progress.update(done / all);
        points.values.clear();
        source.read(static_cast<int>(m), points);
        use(static_cast<int>(m), points);
        done += source.frameCounts[m];
    }
}

/// Stretches of the library as a source of its own, held in memory.
PointSource sampleOf(const PointSource& source, std::shared_ptr<std::vector<MetricPoints>> held,
                     const Progress& progress) {
    const double share = std::min(
        1.0, static_cast<double>(kSampledFrames) / static_cast<double>(source.frameCount()));
    PointSource sample{source.shape, {}, {}};
    double owed = 0;
    forMotions(source, progress, [&](int, const MetricPoints& points) {
        for (int begin = 0; begin < points.count(); begin += kStretch) {
            const int end = std::min(points.count(), begin + kStretch);
            owed += share * (end - begin);
            if (owed < 0.5 * (end - begin)) continue;
            owed -= end - begin;
            MetricPoints& stretch = held->emplace_back(MetricPoints{source.shape, {}});
            stretch.values.assign(points.at(begin), points.at(end));
            sample.frameCounts.push_back(end - begin);
        }
    });
    sample.read = [held](int motion, MetricPoints& points) {
        points.values = (*held)[static_cast<std::size_t>(motion)].values;
    };
    return sample;
}

}  // namespace

std::size_t PointSource::frameCount() const {
    return std::accumulate(
        frameCounts.begin(), frameCounts.end(), std::size_t{0},
        [](std::size_t sum, int count) { return sum + static_cast<std::size_t>(count); });
}

PoseClusters firstPass(const PointSource& source, double threshold, const Progress& progress) {
    if (!(threshold > 0) || !std::isfinite(threshold))
        throw Error("The threshold of pose clusters must be a positive number.");
    PoseClusters clusters;
    clusters.threshold = threshold;
    clusters.centres = PoseTree(source.shape);
    clusters.ids.resize(source.frameCounts.size());
    int last = -1;
    forMotions(source, progress, [&](int motion, const MetricPoints& points) {
        std::vector<int>& ids = clusters.ids[static_cast<std::size_t>(motion)];
        ids.assign(static_cast<std::size_t>(points.count()), -1);
        for (int frame = 0; frame < points.count(); ++frame) {
            int& id = ids[static_cast<std::size_t>(frame)];
            const double* point = points.at(frame);
            // Centres are more than two thresholds apart: a frame within one of a centre has no
            // other as near.
            if (last >= 0 && metricDistanceWithin(source.shape, clusters.centres.points().at(last),
                                                  point, threshold) < threshold) {
                id = last;
                continue;
            }
            const NearestPoint nearest = clusters.centres.nearest(point, 2 * threshold, last);
            if (nearest.id < 0) {
                id = clusters.count();
                clusters.centres.add(point);
                clusters.founders.push_back({motion, frame});
            } else if (nearest.distance < threshold) {
                id = nearest.id;
            }
            last = id >= 0 ? id : nearest.id;
        }
    });
    return clusters;
}

void secondPass(const PointSource& source, PoseClusters& clusters, const Progress& progress) {
    forMotions(source, progress, [&](int motion, const MetricPoints& points) {
        std::vector<int>& ids = clusters.ids[static_cast<std::size_t>(motion)];
        int last = -1;
        for (int frame = 0; frame < points.count(); ++frame) {
            int& id = ids[static_cast<std::size_t>(frame)];
            if (id < 0) {
                constexpr double all = std::numeric_limits<double>::infinity();
                id = clusters.centres.nearest(points.at(frame), all, last).id;
            }
            last = id;
        }
    });
}

PoseClusters clusterPoses(const PointSource& source, double threshold, const Progress& progress) {
    PoseClusters clusters = firstPass(source, threshold, progress.part(0, 0.5));
    secondPass(source, clusters, progress.part(0.5, 1));
    return clusters;
}

double thresholdFor(const PointSource& source, double framesPerCluster, const Progress& progress) {
    if (source.frameCount() == 0) return 0;
    const auto held = std::make_shared<std::vector<MetricPoints>>();
    const PointSource sample = sampleOf(source, held, progress.part(0, 0.3));
    double farthest = 0;
    for (const MetricPoints& points : *held) {
        for (int i = 0; i < points.count(); ++i) {
            farthest =
                std::max(farthest, metricDistance(source.shape, held->front().at(0), points.at(i)));
        }
    }
    if (farthest == 0) return 0;
    const double wished =
        std::max(1.0, static_cast<double>(sample.frameCount()) / framesPerCluster);
    // At `high` there is one cluster; the number falls as the threshold grows, about like a power
    // of it, which tells where to look next. From above, because few clusters are quickly counted.
    double low = farthest / 1024, high = farthest;
    double threshold = farthest / 4, power = 3;
    double before = high, countBefore = 1;
    for (int i = 0; i < kSteps; ++i) {
        const Progress step = progress.part(0.3 + 0.7 * i / kSteps, 1);
        const int count = firstPass(sample, threshold, step).count();
        if (std::abs(count - wished) <= kCloseEnough * wished) return threshold;
        (count > wished ? low : high) = threshold;
        const double slope = std::log(count / countBefore) / std::log(before / threshold);
        if (slope > 1 && slope < 8) power = slope;
        before = threshold;
        countBefore = count;
        threshold *= std::pow(count / wished, 1 / power);
        if (!(threshold > low && threshold < high)) threshold = std::sqrt(low * high);
    }
    return threshold;
}

}  // namespace kumite
