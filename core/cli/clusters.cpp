#include <chrono>
#include <ctime>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/cli/library_options.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// Beyond this many clusters paths are only found for the pairs that are asked for.
constexpr int kMostForAllPairs = 2000;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Figures {
    std::size_t frames = 0;
    std::optional<PathSummary> paths;
    double thresholdSeconds = 0;
    double clusteringSeconds = 0;
    double pathSeconds = 0;
};

Json toJson(const FlexibleGraph& graph, const Figures& figures) {
    Json json = {{"motions", graph.library->motions.size()},
                 {"actions", graph.library->actions.size()},
                 {"rate", graph.library->rate},
                 {"frames", figures.frames},
                 {"threshold", graph.clusters.threshold},
                 {"undirected", graph.graph.undirected},
                 {"clusters", graph.clusters.count()},
                 {"clips", graph.graph.runs.size()},
                 {"edges", graph.graph.edges.size()},
                 {"path_limit", graph.paths.limit},
                 {"pairs_with_path", nullptr},
                 {"paths", nullptr},
                 {"seconds",
                  {{"threshold", figures.thresholdSeconds},
                   {"clustering", figures.clusteringSeconds},
                   {"paths", nullptr}}}};
    if (figures.paths) {
        json["pairs_with_path"] = figures.paths->share();
        json["paths"] = figures.paths->paths;
        json["seconds"]["paths"] = figures.pathSeconds;
    }
    return json;
}

void printText(const FlexibleGraph& graph, const Figures& figures, const Streams& streams) {
    streams.out << fmt::format(
        "{} motions, {} frames at {:g} Hz; threshold {:.3f}: {} clusters, {} clips, {} {}edges "
        "({:.3f} s)\n",
        graph.library->motions.size(), figures.frames, graph.library->rate,
        graph.clusters.threshold, graph.clusters.count(), graph.graph.runs.size(),
        graph.graph.edges.size(), graph.graph.undirected ? "undirected " : "",
        figures.clusteringSeconds);
    if (figures.paths) {
        streams.out << fmt::format(
            "{} paths that cost less than {:.0f}: {:.1f} % of {} pairs have one ({:.3f} s)\n",
            figures.paths->paths, graph.paths.limit, 100 * figures.paths->share(),
            figures.paths->pairs, figures.pathSeconds);
    } else {
        streams.out << fmt::format(
            "more than {} clusters: paths are found for the pairs that are asked for\n",
            kMostForAllPairs);
    }
}

}  // namespace

void addClusters(CLI::App& app, Action& action) {
    struct Options {
        LibraryOptions library;
        GraphOptions graph;
        bool json = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "clusters", "Pose clusters of a library of motions and the transition graph over them.");
    addLibraryOptions(*command, o->library);
    addGraphOptions(*command, o->graph);
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer("Example: kumite clusters karate/ bout.kumite --json");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            const auto library = openLibrary(o->library, "", streams);
            Figures figures;
            for (const LibraryMotion& motion : library->motions)
                figures.frames += motion.clip.frames.size();
            const auto thresholdStart = Clock::now();
            FlexibleGraphSettings settings;
            settings.threshold = o->graph.threshold;
            GraphOptions options = o->graph;
            options.threshold = clusterThreshold(*library, PoseMetric(*library->rig), settings,
                                                 streams.progress("choosing the threshold"));
            figures.thresholdSeconds = secondsSince(thresholdStart);
            const auto start = Clock::now();
            const auto graph = openGraph(library, options, streams);
            figures.clusteringSeconds = secondsSince(start);
            if (graph->graph.nodeCount <= kMostForAllPairs) {
                const auto pathStart = Clock::now();
                figures.paths =
                    findAllPaths(graph->graph, graph->paths, {}, streams.progress("finding paths"));
                figures.pathSeconds = secondsSince(pathStart);
            }
            if (o->json) {
                streams.out << toJson(*graph, figures).dump(1) << "\n";
            } else {
                printText(*graph, figures, streams);
            }
        };
    });
}

}  // namespace kumite::cli
