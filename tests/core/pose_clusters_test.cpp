#include "core/transition/pose_clusters.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/transition/candidate_paths.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

/// Motions held in memory as a source.
PointSource sourceOf(std::vector<MetricPoints> motions) {
    PointSource source;
    if (!motions.empty()) source.shape = motions.front().shape;
    for (const MetricPoints& motion : motions)
        source.frameCounts.push_back(motion.count());
    source.read = [motions](int motion, MetricPoints& points) {
        points = motions[static_cast<std::size_t>(motion)];
    };
    return source;
}

/// Random walks of poses: three rotations and two coordinates.
std::vector<MetricPoints> walks(int motions, int frames, unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&] { return random() / 2147483648.0 - 1; };
    std::vector<MetricPoints> all;
    for (int m = 0; m < motions; ++m) {
        MetricPoints points{{2, {1, 0.5, 1}}, {}};
        std::vector<Eigen::Quaterniond> turns(3, Eigen::Quaterniond::Identity());
        double x = uniform(), y = uniform();
        for (int f = 0; f < frames; ++f) {
            x += 0.1 * uniform() - 0.05 * x;
            y += 0.1 * uniform() - 0.05 * y;
            std::vector<double> point = {x, y};
            for (Eigen::Quaterniond& turn : turns) {
                const Eigen::Vector3d axis(uniform(), uniform(), uniform());
                turn = turn * Eigen::AngleAxisd(0.2 * uniform(), axis.normalized());
                const double sign = random() % 2 ? 1 : -1;  // both mean the same rotation
                for (const double c : {turn.w(), turn.x(), turn.y(), turn.z()})
                    point.push_back(sign * c);
            }
            points.add(point.data());
        }
        all.push_back(std::move(points));
    }
    return all;
}

TEST(MetricDistance, AnglesOfRotations) {
    const MetricShape shape{1, {2.0}};
    for (const double angle : {0.0, 1e-9, 0.3, 2.0, std::numbers::pi}) {
        const double half = angle / 2;
        const double a[] = {1.0, 1, 0, 0, 0};
        const double b[] = {1.0, std::cos(half), 0, std::sin(half), 0};
        const double c[] = {4.0, -std::cos(half), 0, -std::sin(half), 0};
        EXPECT_NEAR(metricDistance(shape, a, b), 2 * angle, 1e-12 + 1e-9 * angle);
        EXPECT_NEAR(metricDistance(shape, a, c), std::hypot(3, 2 * angle), 1e-9);
    }
}

TEST(MetricDistance, IsAMetricAndTheBoundChangesNothing) {
    const MetricPoints points = walks(1, 60, 3)[0];
    for (int i = 0; i < points.count(); ++i) {
        for (int j = 0; j < points.count(); ++j) {
            const double d = metricDistance(points.shape, points.at(i), points.at(j));
            EXPECT_EQ(d, metricDistance(points.shape, points.at(j), points.at(i)));
            EXPECT_EQ(metricDistanceWithin(points.shape, points.at(i), points.at(j), d), d);
            EXPECT_EQ(metricDistanceWithin(points.shape, points.at(i), points.at(j), 2 * d), d);
            if (i != j) {
                EXPECT_TRUE(std::isinf(metricDistanceWithin(points.shape, points.at(i),
                                                            points.at(j), d * (1 - 1e-9))));
            }
            for (int k = 0; k < points.count(); k += 7) {
                EXPECT_LE(d, metricDistance(points.shape, points.at(i), points.at(k)) +
                                 metricDistance(points.shape, points.at(k), points.at(j)) + 1e-12);
            }
        }
    }
}

TEST(PoseTree, FindsWhatAScanFinds) {
    const MetricPoints points = walks(1, 900, 5)[0];
    const MetricPoints queries = walks(3, 150, 6)[1];
    PoseTree tree(points.shape);
    EXPECT_EQ(tree.nearest(queries.at(0)).id, -1);
    for (int i = 0; i < points.count(); ++i) {
        tree.add(points.at(i));
        if (i % 100 == 3) tree.add(points.at(i));  // equal points: the lower number wins
        const double* query = queries.at(i % queries.count());
        const NearestPoint scanned = tree.nearestByScan(query);
        const NearestPoint found = tree.nearest(query);
        ASSERT_EQ(found.id, scanned.id);
        ASSERT_EQ(found.distance, scanned.distance);
        ASSERT_EQ(tree.nearest(query, scanned.distance, i / 2).id, scanned.id);
        ASSERT_EQ(tree.nearest(query, scanned.distance * (1 - 1e-9)).id, -1);
    }
}

TEST(PoseTree, ManyEqualPointsAreNoChain) {
    const MetricPoints points = walks(1, 1, 5)[0];
    PoseTree tree(points.shape);
    for (int i = 0; i < 20000; ++i)
        tree.add(points.at(0));
    EXPECT_EQ(tree.nearest(points.at(0)).id, 0);
}

class KnownClusters : public testing::TestWithParam<const char*> {};

TEST_P(KnownClusters, ClustersGraphAndPaths) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer(GetParam());
    const auto& input = known["input"];
    const auto& expected = known["expected"];
    const auto& list = input["points"];
    std::vector<int> firstFrames;
    std::vector<MetricPoints> motions;
    for (const auto& range : input["motions"]) {
        firstFrames.push_back(range[0]);
        MetricPoints& points = motions.emplace_back();
        points.shape.coordinates = static_cast<int>(list[0].size());
        for (int i = range[0]; i < range[1]; ++i)
            points.add(list[static_cast<std::size_t>(i)].get<std::vector<double>>().data());
    }
    const PointSource source = sourceOf(motions);
    const auto flat = [](const PoseClusters& clusters) {
        std::vector<int> ids;
        for (const auto& part : clusters.ids)
            ids.insert(ids.end(), part.begin(), part.end());
        return ids;
    };
    PoseClusters clusters = firstPass(source, input["threshold"]);
    EXPECT_EQ(flat(clusters), expected["ids_after_first_pass"].get<std::vector<int>>());
    secondPass(source, clusters);
    EXPECT_EQ(flat(clusters), expected["ids"].get<std::vector<int>>());
    ASSERT_EQ(clusters.founders.size(), expected["centre_frames"].size());
    for (std::size_t i = 0; i < clusters.founders.size(); ++i) {
        const FrameAddress at = clusters.founders[i];
        EXPECT_EQ(firstFrames[static_cast<std::size_t>(at.motion)] + at.frame,
                  expected["centre_frames"][i]);
    }

    const TransitionGraph graph = buildTransitionGraph(clusters, input["undirected"]);
    ASSERT_EQ(graph.runs.size(), expected["clips"].size());
    for (std::size_t i = 0; i < graph.runs.size(); ++i) {
        const ClusterRun& run = graph.runs[i];
        const auto& clip = expected["clips"][i];
        const int first = firstFrames[static_cast<std::size_t>(run.motion)];
        EXPECT_EQ(run.motion, clip["motion"]);
        EXPECT_EQ(first + run.frames.begin, clip["begin"]);
        EXPECT_EQ(first + run.frames.end, clip["end"]);
        EXPECT_EQ(run.cluster, clip["cluster"]);
    }
    ASSERT_EQ(graph.edges.size(), expected["edges"].size());
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const GraphEdge& edge = graph.edges[i];
        const auto& wanted = expected["edges"][i];
        EXPECT_EQ(edge.source, wanted["source"]);
        EXPECT_EQ(edge.target, wanted["target"]);
        EXPECT_EQ(edge.shortest(), wanted["shortest"]);
        EXPECT_NEAR(edge.cost, wanted["cost"], 1e-9 * (1 + edge.cost));
        std::vector<std::vector<int>> clips;
        for (const EdgeClip& clip : edge.clips) {
            const int first = firstFrames[static_cast<std::size_t>(clip.motion)];
            clips.push_back({first + clip.frames.begin, first + clip.frames.end});
        }
        std::sort(clips.begin(), clips.end());
        EXPECT_EQ(clips, wanted["clips"].get<std::vector<std::vector<int>>>());
    }

    std::map<std::pair<int, int>, std::vector<CandidatePath>> all;
    const PathSettings settings{5, input["path_cost_limit"]};
    std::mutex guard;
    const PathSummary summary = findAllPaths(
        graph, settings, [&](int from, int to, const std::vector<CandidatePath>& paths) {
            const std::lock_guard lock(guard);
            if (!paths.empty()) all[{from, to}] = paths;
        });
    EXPECT_EQ(summary.pairsWithPath, expected["paths"].size());
    for (const auto& pair : expected["paths"]) {
        const auto& paths = all[{pair["source"], pair["target"]}];
        ASSERT_EQ(paths.size(), pair["paths"].size());
        for (std::size_t i = 0; i < paths.size(); ++i) {
            EXPECT_NEAR(paths[i].cost, pair["paths"][i]["cost"], 1e-9 * (1 + paths[i].cost));
            EXPECT_EQ(paths[i].nodes, pair["paths"][i]["nodes"].get<std::vector<int>>());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Files, KnownClusters,
                         testing::Values("clusters_line_fig2", "clusters_plane",
                                         "clusters_plane_undirected"));

TEST(PoseClusters, AFrameAtTheThresholdOrAtTwiceIsUndefined) {
    MetricPoints line{{1, {}}, {0, 1, 2, 2.5}};
    const PoseClusters clusters = firstPass(sourceOf({line}), 1);
    EXPECT_EQ(clusters.ids[0], (std::vector<int>{0, -1, -1, 1}));
}

TEST(PoseClusters, EveryFrameLiesWithinThePromisedRadius) {
    const std::vector<MetricPoints> motions = walks(6, 300, 9);
    for (const double threshold : {0.2, 0.6, 1.5}) {
        const PoseClusters clusters = clusterPoses(sourceOf(motions), threshold);
        const MetricPoints& centres = clusters.centres.points();
        for (int i = 0; i < clusters.count(); ++i) {
            for (int j = 0; j < i; ++j) {
                EXPECT_GT(metricDistance(centres.shape, centres.at(i), centres.at(j)),
                          2 * threshold);
            }
        }
        for (std::size_t m = 0; m < motions.size(); ++m) {
            for (int f = 0; f < motions[m].count(); ++f) {
                const double* point = motions[m].at(f);
                const int id = clusters.ids[m][static_cast<std::size_t>(f)];
                ASSERT_GE(id, 0);
                const double d = metricDistance(centres.shape, centres.at(id), point);
                EXPECT_LE(d, 2 * threshold);
                // Within one threshold it is the nearest too, whichever pass it joined in.
                if (d >= threshold) continue;
                EXPECT_EQ(id, clusters.centres.nearestByScan(point).id);
            }
        }
    }
}

TEST(PoseClusters, ThresholdGivesTheWishedSize) {
    const PointSource source = sourceOf(walks(8, 400, 2));
    for (const double frames : {10.0, 22.5, 100.0}) {
        const double threshold = thresholdFor(source, frames);
        EXPECT_NEAR(3200.0 / clusterPoses(source, threshold).count(), frames, 0.15 * frames);
    }
}

TEST(PoseClusters, EmptyAndConstantLibraries) {
    const PointSource empty = sourceOf({});
    EXPECT_EQ(thresholdFor(empty, 20), 0);
    EXPECT_EQ(clusterPoses(empty, 1).count(), 0);
    EXPECT_EQ(buildTransitionGraph(clusterPoses(empty, 1), true).edges.size(), 0u);
    const PointSource constant = sourceOf({MetricPoints{{1, {}}, {3, 3, 3}}});
    EXPECT_EQ(thresholdFor(constant, 2), 0);
    const PoseClusters one = clusterPoses(constant, 1);
    EXPECT_EQ(one.count(), 1);
    const TransitionGraph graph = buildTransitionGraph(one, true);
    EXPECT_EQ(graph.runs.size(), 1u);
    EXPECT_EQ(findAllPaths(graph, {}, {}).pairs, 0u);
    EXPECT_THROW(clusterPoses(constant, 0), Error);
    EXPECT_THROW(clusterPoses(constant, std::nan("")), Error);
}

}  // namespace
}  // namespace kumite
