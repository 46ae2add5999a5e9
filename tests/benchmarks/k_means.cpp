#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/benchmarks/transition_corpus.h"

namespace kumite::bench {

PoseClusters kMeans(const PointSource& source, int k, int iterations) {
    MetricPoints all{source.shape, {}};
    std::vector<FrameAddress> addresses;
    MetricPoints points{source.shape, {}};
    for (std::size_t m = 0; m < source.frameCounts.size(); ++m) {
        points.values.clear();
        source.read(static_cast<int>(m), points);
        for (int i = 0; i < points.count(); ++i) {
            all.add(points.at(i));
            addresses.push_back({static_cast<int>(m), i});
        }
    }
    const int n = all.count();
    const std::size_t width = source.shape.width();
    std::mt19937 random(1);
    std::vector<int> start(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        start[static_cast<std::size_t>(i)] = i;
    std::shuffle(start.begin(), start.end(), random);
    MetricPoints means{source.shape, {}};
    for (int c = 0; c < k; ++c)
        means.add(all.at(start[static_cast<std::size_t>(c)]));
    std::vector<int> ids(static_cast<std::size_t>(n), -1);
    std::vector<std::pair<double, int>> nearest;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        nearest.assign(static_cast<std::size_t>(k), {INFINITY, -1});
        bool changed = false;
        for (int i = 0; i < n; ++i) {
            double least = INFINITY;
            int id = -1;
            for (int c = 0; c < k; ++c) {
                const double d = metricDistance(source.shape, means.at(c), all.at(i));
                if (d < least) {
                    least = d;
                    id = c;
                }
            }
            changed = changed || ids[static_cast<std::size_t>(i)] != id;
            ids[static_cast<std::size_t>(i)] = id;
            auto& best = nearest[static_cast<std::size_t>(id)];
            best = std::min(best, {least, i});
        }
        std::vector<double> sums(means.values.size(), 0.0);
        std::vector<int> counts(static_cast<std::size_t>(k), 0);
        for (int i = 0; i < n; ++i) {
            const auto id = static_cast<std::size_t>(ids[static_cast<std::size_t>(i)]);
            const double* point = all.at(i);
            const double* mean = means.at(static_cast<int>(id));
            double* sum = sums.data() + id * width;
            ++counts[id];
            const auto coordinates = static_cast<std::size_t>(source.shape.coordinates);
            for (std::size_t j = 0; j < coordinates; ++j)
                sum[j] += point[j];
            for (std::size_t j = coordinates; j < width; j += 4) {
                double dot = 0;
                for (std::size_t q = j; q < j + 4; ++q)
                    dot += point[q] * mean[q];
                for (std::size_t q = j; q < j + 4; ++q)
                    sum[q] += dot < 0 ? -point[q] : point[q];
            }
        }
        for (std::size_t c = 0; c < static_cast<std::size_t>(k); ++c) {
            if (counts[c] == 0) continue;
            const auto coordinates = static_cast<std::size_t>(source.shape.coordinates);
            double* mean = means.values.data() + c * width;
            const double* sum = sums.data() + c * width;
            for (std::size_t j = 0; j < coordinates; ++j)
                mean[j] = sum[j] / counts[c];
            for (std::size_t j = coordinates; j < width; j += 4) {
                const double length =
                    std::hypot(std::hypot(sum[j], sum[j + 1]), std::hypot(sum[j + 2], sum[j + 3]));
                for (std::size_t q = j; q < j + 4 && length > 0; ++q)
                    mean[q] = sum[q] / length;
            }
        }
        if (!changed) break;
    }
    PoseClusters clusters;
    clusters.centres = PoseTree(source.shape);
    std::vector<int> newId(static_cast<std::size_t>(k), -1);
    for (int c = 0; c < k; ++c) {
        const int frame = nearest[static_cast<std::size_t>(c)].second;
        if (frame < 0) continue;
        newId[static_cast<std::size_t>(c)] = clusters.count();
        clusters.centres.add(all.at(frame));
        clusters.founders.push_back(addresses[static_cast<std::size_t>(frame)]);
    }
    clusters.ids.resize(source.frameCounts.size());
    for (int i = 0; i < n; ++i) {
        clusters.ids[static_cast<std::size_t>(addresses[static_cast<std::size_t>(i)].motion)]
            .push_back(newId[static_cast<std::size_t>(ids[static_cast<std::size_t>(i)])]);
    }
    return clusters;
}

}  // namespace kumite::bench
