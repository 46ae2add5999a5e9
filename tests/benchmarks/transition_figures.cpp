// Measures pose clusters, candidate paths and transitions:
//     kumite-transition-figures [corpus|kmeans|table1|growth|quality …] [--largest FRAMES]
// Without a word all of it. Corpora of the paper's size (73 clips, 3648 frames at 30 Hz) are cut
// from a made bout and, where KUMITE_DATA or ../shared/data is there, from recordings. Seconds are
// the processor's (getrusage) of one thread unless it says otherwise, so that a busy machine
// changes them little.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>

#include <sys/resource.h>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/project/library_strikes.h"
#include "core/quality/quality.h"
#include "core/transition/playback.h"
#include "core/transition/sequence.h"
#include "tests/benchmarks/bench_table.h"
#include "tests/benchmarks/transition_corpus.h"

namespace {

using namespace kumite;
using namespace kumite::bench;

/// The library's points held in memory, so that times are those of clustering alone.
PointSource heldPoints(const MotionLibrary& library, const PoseMetric& metric) {
    auto held = std::make_shared<std::vector<MetricPoints>>();
    PointSource source = pointsOf(library, metric);
    for (std::size_t m = 0; m < library.motions.size(); ++m) {
        held->push_back({metric.shape(), {}});
        source.read(static_cast<int>(m), held->back());
    }
    source.read = [held](int motion, MetricPoints& points) {
        points = (*held)[static_cast<std::size_t>(motion)];
    };
    return source;
}

/// Both passes by looking at every centre for every frame, as the paper has it.
int clustersByScan(const PointSource& source, double threshold) {
    PoseTree centres(source.shape);
    MetricPoints points{source.shape, {}};
    std::vector<std::vector<bool>> open(source.frameCounts.size());
    for (const bool first : {true, false}) {
        for (std::size_t m = 0; m < source.frameCounts.size(); ++m) {
            points.values.clear();
            source.read(static_cast<int>(m), points);
            for (int i = 0; i < points.count(); ++i) {
                if (!first && !open[m][static_cast<std::size_t>(i)]) continue;
                double least = INFINITY;
                for (int c = 0; c < centres.count(); ++c)
                    least = std::min(
                        least, metricDistance(source.shape, centres.points().at(c), points.at(i)));
                if (!first) continue;
                if (least > 2 * threshold) centres.add(points.at(i));
                open[m].push_back(least >= threshold && least <= 2 * threshold);
            }
        }
    }
    return centres.count();
}

/// A row of the table beside the paper's time of the same, if the corpus stands in it.
void addTimeRow(const Corpus& corpus, const std::string& what, const std::string& size,
                double seconds, double paper) {
    if (!corpus.inTable) return;
    addRow(
        {what, size, timeText(seconds), "paper: " + timeText(paper), timesText(paper / seconds)});
}

std::string sizeOf(const Corpus& corpus) {
    return fmt::format("{} corpus, {} clips, {} frames", corpus.name,
                       corpus.library->motions.size(), kFrames);
}

double pathSeconds(const FlexibleGraph& graph, PathSummary& summary) {
    PathSearch search = graph.search;
    const int n = graph.graph.nodeCount;
    return timed([&] {
        summary = {};
        for (int target = 0; target < n; ++target) {
            for (int source = 0; source < n; ++source) {
                if (source == target) continue;
                const auto paths = search.paths(source, target);
                ++summary.pairs;
                summary.pairsWithPath += !paths.empty();
                summary.paths += paths.size();
                for (const CandidatePath& path : paths)
                    summary.visitedNodes += path.nodes.size();
            }
        }
    });
}

void measureCorpus(const Corpus& corpus) {
    FlexibleGraphSettings settings;
    std::cout << fmt::format("{} corpus: {} clips, {} frames at 30 Hz\n", corpus.name,
                             corpus.library->motions.size(), kFrames);
    for (const bool undirected : {false, true}) {
        settings.undirected = undirected;
        const auto graph = buildFlexibleGraph(corpus.library, settings);
        const PointSource held = heldPoints(*corpus.library, graph->metric);
        const double r = graph->clusters.threshold;
        const double points = timed([&] {
            MetricPoints all{graph->metric.shape(), {}};
            for (const LibraryMotion& motion : corpus.library->motions)
                graph->metric.points(motion.clip.frames, kRate, all);
        });
        const double choosing = timed([&] { thresholdFor(held, 0.75 * kRate); });
        const double clustering = timed([&] { clusterPoses(held, r); });
        const double scan = timed([&] { clustersByScan(held, r); });
        const double graphing = timed([&] { buildTransitionGraph(graph->clusters, undirected); });
        PathSummary limited;
        const double paths = pathSeconds(*graph, limited);
        FlexibleGraph unlimited = *graph;
        unlimited.search = PathSearch(graph->graph, {5, INFINITY});
        PathSummary all;
        const double allPaths = pathSeconds(unlimited, all);
        std::vector<double> edgeFrames;
        for (const GraphEdge& edge : graph->graph.edges)
            edgeFrames.push_back(edge.shortest());
        std::sort(edgeFrames.begin(), edgeFrames.end());
        std::cout << fmt::format(
            "  {}: threshold {:.3f}, {} clusters, {} clips, {} edges (median shortest clip {:.0f} "
            "frames, limit {:.0f})\n"
            "    points {:.4f} s, choosing the threshold {:.3f} s, clustering {:.4f} s (scan "
            "{:.4f} "
            "s), graph {:.5f} s\n"
            "    candidate paths under the limit {:.3f} s: {} paths, {:.1f} % of pairs; without a "
            "limit {:.3f} s: {} paths, {:.1f} % of pairs, {:.1f} MB if they were stored\n",
            undirected ? "undirected" : "directed", r, graph->clusters.count(),
            graph->graph.runs.size(), graph->graph.edges.size(),
            edgeFrames.empty() ? 0 : edgeFrames[edgeFrames.size() / 2], graph->paths.limit, points,
            choosing, clustering, scan, graphing, paths, limited.paths, 100 * limited.share(),
            allPaths, all.paths, 100 * all.share(),
            1e-6 * static_cast<double>(4 * all.visitedNodes + 12 * all.paths));
        if (!undirected) continue;  // the paper's graph is
        const std::string size = fmt::format("{}, {} clusters, {} edges", sizeOf(corpus),
                                             graph->clusters.count(), graph->graph.edges.size());
        addTimeRow(corpus, "clustering poses", size, clustering, 0.76);
        addTimeRow(corpus, "up to five cheapest paths of all pairs", size, allPaths, 463);
    }
}

/// What some transitions are like together.
struct QualityFigures {
    int count = 0;
    int failed = 0;
    double frames = 0;
    double skate = 0;
    double penetration = 0;
    double joinDistance = 0;
    int joins = 0;
    JointMotion atJoins;
    double seconds = 0;
    double synthesised = 0;
};

std::vector<float> joined(std::vector<float> a, const std::vector<float>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

void addTransition(QualityFigures& figures, std::shared_ptr<const FlexibleGraph> graph,
                   const LibraryAction& from, const LibraryAction& to,
                   const TransitionRequest& request, bool cleanFeet) {
    Sequence sequence;
    sequence.cleanFeet = cleanFeet;
    for (const LibraryAction& action : {from, to}) {
        SequenceBlock& block = sequence.blocks.emplace_back();
        block.name = action.name;
        block.action = action;
        block.transition = request;
    }
    const double start = processorSeconds();
    SequenceMotion motion;
    try {
        motion = makeSequence(graph, sequence);
    } catch (const Error&) {
        ++figures.failed;
        return;
    }
    figures.seconds += processorSeconds() - start;
    ++figures.count;
    const FrameRange between = motion.pieces[1].frames;
    figures.frames += between.size();
    // Judged from half a second before the transition to half a second behind it.
    const int first = std::max(0, between.begin - 15);
    const int last = std::min(motion.clip.frameCount(), between.end + 15);
    Clip clip = motion.clip;
    clip.frames.assign(motion.clip.frames.begin() + first, motion.clip.frames.begin() + last);
    figures.synthesised += motion.clip.frameCount();
    std::vector<int> joins;
    for (const int join : motion.joins()) {
        if (join > first && join < last - 1) joins.push_back(join - first);
    }
    for (const DistanceGrid& grid : motion.pieces[1].transition->grids) {
        figures.joinDistance += grid.at(grid.row, grid.column);
        ++figures.joins;
    }
    const MeasuredBody body = measuredBody(clip, 0);
    figures.skate += footSkateOf(body).value_or(0);
    figures.penetration += floorPenetration(body).value_or(Penetration{}).share;
    const JoinMotion measured = measureJoins(clip, joins);
    figures.atJoins.velocity =
        joined(std::move(figures.atJoins.velocity), measured.atJoins.velocity);
    figures.atJoins.acceleration =
        joined(std::move(figures.atJoins.acceleration), measured.atJoins.acceleration);
}

/// Joints' acceleration at joins over that inside the clips, 99th percentiles.
double roughness(const QualityFigures& f, const JointMotionBar& bar) {
    return percentile(f.atJoins.acceleration, 0.99) / bar.acceleration;
}

void print(const std::string& name, const QualityFigures& f, const JointMotionBar& bar) {
    if (f.count == 0) {
        std::cout << fmt::format("    {:<28} none ({} have no path)\n", name, f.failed);
        return;
    }
    std::cout << fmt::format(
        "    {:<28} {:4} made, {:5.1f} frames between; skate {:.3f}, in the floor {:.3f}; at "
        "joins, "
        "p99 over the recording's: speed {:.2f}, acceleration {:.2f}{}; {:.1f} µs a frame\n",
        name, f.count, f.frames / f.count, f.skate / f.count, f.penetration / f.count,
        percentile(f.atJoins.velocity, 0.99) / bar.velocity, roughness(f, bar),
        f.joins ? fmt::format("; distance {:.2f}", f.joinDistance / f.joins) : std::string(),
        1e6 * f.seconds / f.synthesised);
}

/// Along a path, and on a curve where there is none, beside the clips.
void addQualityRows(const Corpus& corpus, const std::map<std::string, QualityFigures>& figures,
                    const JointMotionBar& bar, double skate) {
    for (const auto& [group, what] :
         {std::pair("path: graph", "transitions along a path"),
          std::pair("no path: bezier", "transitions on a curve, where there is no path")}) {
        const auto found = figures.find(group);
        if (!corpus.inTable || found == figures.end() || found->second.count == 0) continue;
        const QualityFigures& f = found->second;
        addRow(
            {what, fmt::format("{} pairs, {} corpus", f.count, corpus.name),
             fmt::format("feet skate {:.2f}, joins {:.2f}", f.skate / f.count, roughness(f, bar)),
             fmt::format("the clips: feet skate {:.2f}", skate)});
    }
}

void measureQualityOf(const Corpus& corpus, bool withKMeans) {
    const MotionLibrary& library = *corpus.library;
    JudgedMotion recorded;
    for (const LibraryMotion& motion : library.motions)
        recorded.fighters.push_back({&motion.clip, 0, {}});
    const JointMotionBar bar = barOf(recorded);
    double skate = 0;
    for (const LibraryMotion& motion : library.motions)
        skate += footSkateOf(measuredBody(motion.clip, 0)).value_or(0);
    skate /= static_cast<double>(library.motions.size());
    std::cout << fmt::format("{} corpus: 500 random pairs; the recording itself: skate {:.3f}\n",
                             corpus.name, skate);
    const auto graph = buildFlexibleGraph(corpus.library);
    FlexibleGraphSettings both;
    both.undirected = true;
    const auto undirected = buildFlexibleGraph(corpus.library, both);
    std::shared_ptr<const FlexibleGraph> byMeans;
    if (withKMeans) {
        FlexibleGraph other = *graph;
        const PointSource held = heldPoints(library, graph->metric);
        double seconds = 0;
        seconds = timed([&] { other.clusters = kMeans(held, graph->clusters.count(), 100); }, 0);
        other.graph = buildTransitionGraph(other.clusters, false);
        other.paths.limit = pathLimit(other.graph, other.settings.longestPath);
        other.search = PathSearch(other.graph, other.paths);
        PathSummary summary;
        pathSeconds(other, summary);
        std::cout << fmt::format(
            "    k-means, k = {}, up to 100 iterations: {:.2f} s; {} clips, {} edges, {:.1f} % of "
            "pairs have a path\n",
            graph->clusters.count(), seconds, other.graph.runs.size(), other.graph.edges.size(),
            100 * summary.share());
        addTimeRow(corpus, fmt::format("k-means, k = {}", graph->clusters.count()), sizeOf(corpus),
                   seconds, 8212);
        byMeans = std::make_shared<const FlexibleGraph>(std::move(other));
    }
    std::mt19937 random(7);
    std::map<std::string, QualityFigures> figures;
    for (int i = 0; i < 500; ++i) {
        const auto pick = [&] {
            return library.actions[random() % static_cast<unsigned>(library.actions.size())];
        };
        const LibraryAction from = pick(), to = pick();
        const TransitionReport located =
            locate(*graph, library.part(from).poses, library.part(to).poses);
        const std::string group = located.candidates.empty() ? "no path: " : "path: ";
        const auto seed = static_cast<std::uint64_t>(i);
        const auto add = [&](const std::string& name, TransitionMethod method,
                             const std::shared_ptr<const FlexibleGraph>& over, bool feet) {
            addTransition(figures[group + name], over, from, to, {method, seed, {}}, feet);
        };
        for (const TransitionMethod method :
             {TransitionMethod::Graph, TransitionMethod::Bezier, TransitionMethod::Linear})
            add(std::string(methodName(method)), method, graph, true);
        add("graph, backward too", TransitionMethod::Graph, undirected, true);
        add("graph, raw feet", TransitionMethod::Graph, graph, false);
        add("bezier, raw feet", TransitionMethod::Bezier, graph, false);
        if (byMeans) add("graph by k-means", TransitionMethod::Graph, byMeans, true);
    }
    for (const auto& [name, f] : figures)
        print(name, f, bar);
    addQualityRows(corpus, figures, bar, skate);
}

/// What the paper's Table 1 says of a case.
struct PaperCase {
    int frames = 0;
    double seconds = 0;
};

/// The cases of the paper's Table 1.
void measureTable1(const Corpus& corpus) {
    const auto graph = buildFlexibleGraph(corpus.library);
    const MotionLibrary& library = *corpus.library;
    const auto action = [&](std::size_t i) { return library.part(library.actions[i]); };
    const auto line = [&](const std::string& name, int frames, double seconds,
                          const std::optional<PaperCase>& paper = {}) {
        std::cout << fmt::format(
            "    {:<24} {:4} frames in {:.5f} s, {:5.2f} µs a frame (paper: {})\n", name, frames,
            seconds, 1e6 * seconds / frames,
            paper ? fmt::format("{} in {:.3f}", paper->frames, paper->seconds) : "-");
        if (paper)
            addTimeRow(corpus, name + ", a frame", fmt::format("{} frames", frames),
                       seconds / frames, paper->seconds / paper->frames);
    };
    std::cout << corpus.name << " corpus, Table 1\n";
    Sequence six;
    for (std::size_t i = 0; i < 6; ++i) {
        SequenceBlock& block = six.blocks.emplace_back();
        block.action = library.actions[i * 11];
        block.trim = FrameRange{0, 25};
    }
    int frames = 0;
    double seconds = timed([&] { frames = makeSequence(graph, six).clip.frameCount(); });
    line("consecutive attacks", frames, seconds, PaperCase{150, 0.157});
    six.cleanFeet = false;
    seconds = timed([&] { frames = makeSequence(graph, six).clip.frameCount(); });
    line("… raw feet", frames, seconds);
    for (const LibraryAction& strike : library.actions) {
        // The first action in which a strike is found that reaches this far.
        const Eigen::Vector3d target(0.0, 1.2, 0.6);
        std::optional<StrikeBlock> made;
        try {
            made = strikeAt(library, strike, target);
        } catch (const Error&) {
            continue;
        }
        if (!made->hit.hits) continue;
        Sequence parametric = six;
        parametric.cleanFeet = true;
        parametric.blocks.back() = {};
        seconds = timed([&] {
            parametric.blocks.back().made =
                std::make_shared<const LibraryMotion>(strikeAt(library, strike, target).motion);
            frames = makeSequence(graph, parametric).clip.frameCount();
        });
        line("parametric, one example", frames, seconds, PaperCase{233, 0.561});
        break;
    }
    // The curve alone, to the first pose of the action.
    seconds = timed([&] {
        MotionStrip strip(graph, {});
        strip.begin(action(3));
        strip.lead(action(40).part({0, 1}), {TransitionMethod::Bezier, 1, {}});
        frames = strip.frameCount() - action(3).size();
    });
    line("Bézier interpolation", frames, seconds, PaperCase{20, 0.029});
    seconds = timed([&] {
        PlaybackBuffer buffer(graph);
        buffer.play(action(10));
        for (int i = 0; i < 25; ++i)
            buffer.next();
        buffer.play(action(50));
        frames = 25;
        while (buffer.planned() > 0) {
            buffer.next();
            ++frames;
        }
    });
    line("dodge", frames, seconds, PaperCase{121, 0.155});
    PathSearch search = graph->search;
    std::mt19937 random(3);
    const auto n = static_cast<unsigned>(graph->graph.nodeCount);
    const double query = timed(
        [&] { search.paths(static_cast<int>(random() % n), static_cast<int>(random() % n)); });
    std::cout << fmt::format("    candidate paths of one pair, found when asked for: {:.1f} µs\n",
                             1e6 * query);
}

double exponent(double smaller, double larger, double ratio) {
    return smaller > 0 && larger > 0 ? std::log(larger / smaller) / std::log(ratio) : 0;
}

/// One row of the table of growth.
struct Growth {
    double frames, clusters, clustering, scan, graph, path;
};

void measureGrowth(double largest) {
    std::cout << "growth, made bouts, one threshold for all sizes\n";
    std::vector<double> sizes;
    for (const double size : {3648.0, 10000.0, 30000.0, 100000.0, 300000.0, 1000000.0}) {
        if (size <= largest) sizes.push_back(size);
    }
    std::unique_ptr<PoseMetric> metric;
    auto held = std::make_shared<std::vector<MetricPoints>>();
    std::shared_ptr<const Rig> rig;
    std::size_t have = 0;
    std::uint64_t seed = 1;
    double threshold = 0;
    std::vector<Growth> rows;
    for (const double size : sizes) {
        while (static_cast<double>(have) < size) {
            MotionLibrary bout;
            bout.rig = rig;
            bout.rate = kRate;
            addBout(bout, rig ? 300 : 61, seed++);
            rig = bout.rig;
            if (!metric) metric = std::make_unique<PoseMetric>(*rig);
            for (const LibraryMotion& motion : bout.motions) {
                held->push_back({metric->shape(), {}});
                metric->points(motion.clip.frames, kRate, held->back());
                have += motion.clip.frames.size();
            }
        }
        PointSource source;
        source.shape = metric->shape();
        std::size_t taken = 0;
        for (const MetricPoints& points : *held) {
            const auto room = static_cast<std::size_t>(size) - taken;
            const int count =
                static_cast<int>(std::min(room, static_cast<std::size_t>(points.count())));
            if (count > 0) source.frameCounts.push_back(count);
            taken += static_cast<std::size_t>(count);
        }
        source.read = [held, counts = source.frameCounts](int motion, MetricPoints& points) {
            const MetricPoints& all = (*held)[static_cast<std::size_t>(motion)];
            points.values.assign(all.at(0), all.at(counts[static_cast<std::size_t>(motion)]));
        };
        if (threshold == 0) threshold = thresholdFor(source, 0.75 * kRate);
        PoseClusters clusters;
        const double clustering = timed([&] { clusters = clusterPoses(source, threshold); }, 0.05);
        const double scan =
            size <= 100000 ? timed([&] { clustersByScan(source, threshold); }, 0) : 0;
        TransitionGraph graph;
        const double graphing = timed([&] { graph = buildTransitionGraph(clusters, false); }, 0.05);
        const PathSettings settings{5, pathLimit(graph, FlexibleGraphSettings{}.longestPath)};
        PathSearch search(graph, settings);
        std::mt19937 random(5);
        const auto n = static_cast<unsigned>(graph.nodeCount);
        const double path = timed(
            [&] { search.paths(static_cast<int>(random() % n), static_cast<int>(random() % n)); },
            1.0);
        std::size_t clips = 0;
        for (const GraphEdge& edge : graph.edges)
            clips += edge.clips.size();
        const double memory =
            static_cast<double>(clusters.centres.points().values.size() * sizeof(double) +
                                taken * sizeof(int) + graph.runs.size() * sizeof(ClusterRun) +
                                graph.edges.size() * sizeof(GraphEdge) + clips * sizeof(EdgeClip));
        const Growth row{size, static_cast<double>(clusters.count()), clustering, scan, graphing,
                         path};
        std::cout << fmt::format(
            "  {:8.0f} frames: {:6} clusters, {:7} clips, {:7} edges; clustering {:8.3f} s{}, "
            "graph "
            "{:.3f} s; paths of one pair {:.3f} ms; clusters and graph {:.1f} MB (points, if held: "
            "{:.0f} MB)\n",
            size, clusters.count(), graph.runs.size(), graph.edges.size(), clustering,
            scan > 0 ? fmt::format(" (scan {:.2f} s)", scan) : std::string(), graphing, 1e3 * path,
            1e-6 * memory,
            1e-6 * static_cast<double>(taken * metric->shape().width() * sizeof(double)));
        if (!rows.empty()) {
            const Growth& before = rows.back();
            const double ratio = row.frames / before.frames;
            std::cout << fmt::format(
                "           exponents in frames: clusters {:.2f}, clustering {:.2f}, scan {:.2f}, "
                "paths of one pair {:.2f}\n",
                exponent(before.clusters, row.clusters, ratio),
                exponent(before.clustering, row.clustering, ratio),
                exponent(before.scan, row.scan, ratio), exponent(before.path, row.path, ratio));
        }
        rows.push_back(row);
    }
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        if (row->scan == 0) continue;
        addRow({"clustering poses", fmt::format("made bouts, {:.0f} frames", row->frames),
                timeText(row->clustering), "looking at every centre: " + timeText(row->scan),
                timesText(row->scan / row->clustering)});
        break;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::cout << fmt::format("  peak memory of the program, all points held: {:.0f} MB\n",
                             static_cast<double>(usage.ru_maxrss) / 1024);
}

}  // namespace

int main(int argc, char** argv) {
    std::cout << std::unitbuf;  // rows are seen as they come
    std::set<std::string> parts;
    double largest = 1000000;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--largest" && i + 1 < argc) {
            largest = parseNumber(argv[++i]).value_or(largest);
        } else {
            parts.insert(word);
        }
    }
    const auto wanted = [&](const char* part) { return parts.empty() || parts.count(part) > 0; };
    try {
        const std::vector<Corpus> list = corpora();
        for (const Corpus& corpus : list) {
            if (wanted("corpus")) measureCorpus(corpus);
            if (wanted("table1")) measureTable1(corpus);
            if (wanted("quality")) measureQualityOf(corpus, wanted("kmeans"));
        }
        if (wanted("growth")) measureGrowth(largest);
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
