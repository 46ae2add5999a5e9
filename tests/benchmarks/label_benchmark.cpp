// What a labelling round costs on a made bout of 16 minutes: features, one round of learning.
// kumite-label-benchmark --matrix FOLDER writes the rows and labels of a round instead, for
// svc_benchmark.py, which times scikit-learn's SVC on them; --peer FOLDER measures and has what
// that found beside it. Times are the processor's, of all threads.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "core/labelling/distances.h"
#include "core/project/demo_bout.h"
#include "core/project/labelling.h"
#include "core/project/project_file.h"
#include "core/project/simulation.h"
#include "tests/benchmarks/run_keeper.h"

namespace kumite {
namespace {

struct Bout {
    CorrectedProject corrected;
    ActionTable table;
    std::vector<Example> examples;  ///< all actions with their true label

    Bout() {
        const auto folder = std::filesystem::temp_directory_path() / "kumite-label-benchmark";
        const DemoFiles files = writeDemoBout({960, 60, 11}, folder);
        const Truth truth{readLabels(files.truth(), kickboxing())};
        corrected = correctFromTruth(loadProject(files.project()).project, 0, truth);
        std::filesystem::remove_all(folder);
        const auto matched = matchLabels(corrected.project, corrected.analysis, truth.labels);
        corrected.project =
            importLabels(corrected.project, corrected.analysis, matched.fighters)->project;
        table = actionTable(corrected.project, corrected.analysis);
        examples = handExamples(corrected.project, corrected.analysis, table);
    }
    /// So many examples from all over the bout.
    std::vector<Example> part(std::size_t count) const {
        std::vector<Example> some;
        for (std::size_t i = 0; i < count; ++i)
            some.push_back(examples[i * examples.size() / count]);
        return some;
    }
};

const Bout& bout() {
    static const Bout made;
    return made;
}

void features_of_all_actions(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(actionTable(bout().corrected.project, bout().corrected.analysis));
    state.counters["actions"] = static_cast<double>(bout().table.rows.size());
}
BENCHMARK(features_of_all_actions)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// Learns every aspect, mirror images included, and predicts every action of the bout.
void one_round(benchmark::State& state) {
    const auto examples = bout().part(static_cast<std::size_t>(state.range(0)));
    const ParameterSet parameters = defaultParameters(kickboxing());
    for (auto _ : state) {
        const TrainingSet set(kickboxing(), bout().table.features, examples, {});
        benchmark::DoNotOptimize(set.predict(parameters, false));
    }
    state.counters["actions"] = static_cast<double>(bout().table.rows.size());
}
BENCHMARK(one_round)
    ->Arg(150)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3)
    ->MeasureProcessCPUTime();

void write(const std::filesystem::path& file, const FeatureMatrix& rows) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(rows.data()),
               static_cast<std::streamsize>(sizeof(float)) * rows.size());
}

void writeMatrix(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    write(folder / "actions.f32", bout().table.features);
    for (const std::size_t count : {150u, 1000u}) {
        const auto examples = bout().part(count);
        FeatureMatrix rows(2 * static_cast<Eigen::Index>(count), kFeatureCount);
        std::ofstream labels(folder / fmt::format("labels-{}.txt", count));
        for (std::size_t i = 0; i < count; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            rows.row(row) = bout().table.features.row(examples[i].row);
            mirrorFeatures(
                {rows.row(row).data(), kFeatureCount},
                {rows.row(row + static_cast<Eigen::Index>(count)).data(), kFeatureCount});
        }
        for (const bool mirrored : {false, true}) {
            for (const Example& example : examples) {
                const Label label =
                    mirrored ? mirroredLabel(kickboxing(), example.label) : example.label;
                for (int a = 0; a < kickboxing().size(); ++a) {
                    if (kickboxing()[a].classifier == Classifier::Msvm)
                        labels << label[static_cast<std::size_t>(a)] << ' ';
                }
                labels << '\n';
            }
        }
        write(folder / fmt::format("examples-{}.f32", count), rows);
    }
    const MsvmParameters usual;
    std::ofstream(folder / "parameters.txt") << usual.c << ' ' << usual.gamma << '\n';
}

/// `peer`: the folder in which svc_benchmark.py left what it measured; may hold nothing or be none.
void addRows(const bench::RunKeeper& runs, const std::filesystem::path& peer) {
    const auto actions = runs.counter("features_of_all_actions", "actions");
    runs.addTime("features_of_all_actions",
                 {"features of actions, processor", fmt::format("{:.0f} actions", actions)});
    std::ifstream in;
    if (!peer.empty()) in.open(peer / "svc.txt");
    std::string version;
    in >> version;
    std::map<int, double> theirs;
    int examples = 0;
    for (double seconds = 0; in >> examples >> seconds;)
        theirs[examples] = seconds;
    for (const int count : {150, 1000}) {
        const std::string name = fmt::format("one_round/{}", count);
        bench::BenchRow row{"a round of learning labels, processor",
                            fmt::format("{} examples and their mirror images, {:.0f} actions",
                                        count, runs.counter(name, "actions"))};
        if (theirs.count(count) > 0) {
            row.peer =
                fmt::format("scikit-learn {} SVC: {}", version, bench::timeText(theirs[count]));
            row.ratio = bench::timesText(theirs[count] / runs.seconds(name));
        }
        runs.addTime(name, row);
    }
}

}  // namespace
}  // namespace kumite

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == "--matrix") {
        kumite::writeMatrix(argv[2]);
        return 0;
    }
    const bool withPeer = argc >= 3 && std::string_view(argv[1]) == "--peer";
    const std::string peer = withPeer ? argv[2] : "";
    benchmark::Initialize(&argc, argv);
    kumite::bench::RunKeeper runs;
    benchmark::RunSpecifiedBenchmarks(&runs);
    kumite::addRows(runs, peer);
    return 0;
}
