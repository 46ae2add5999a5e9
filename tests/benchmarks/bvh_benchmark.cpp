// How fast BVH text becomes channel values: Kumite, Assimp, and one bare std::from_chars pass over
// the same numbers, on one core. Reads the real recordings (KUMITE_DATA, else shared/data beside
// the working folder) or, without them, a made file. Prints the ratios of the best of seven runs at
// the end; --benchmark_enable_random_interleaving=true spreads a busy machine over all of them.

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <assimp/scene.h>
#include <assimp/version.h>
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include "core/formats/bvh.h"
#include "tests/benchmarks/run_keeper.h"

namespace {

namespace bench = kumite::bench;

struct Sample {
    std::string name;
    std::string text;
};

std::string readText(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// 3 MB: 43 joints in a chain, 129 + 3 channels, six decimals.
std::string madeText() {
    constexpr int kJoints = 43;
    constexpr int kFrames = 2400;
    std::string text =
        "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition "
        "Zposition Zrotation Yrotation Xrotation\n";
    for (int j = 1; j < kJoints; ++j) {
        text += fmt::format(
            "JOINT Joint{}\n{{\nOFFSET 0 {}.5 0\nCHANNELS 3 Zrotation Xrotation "
            "Yrotation\n",
            j, j);
    }
    for (int j = 0; j < kJoints; ++j)
        text += "}\n";
    text += fmt::format("MOTION\nFrames: {}\nFrame Time: 0.00833333\n", kFrames);
    for (int frame = 0; frame < kFrames; ++frame) {
        for (int c = 0; c < 3 * kJoints + 3; ++c) {
            text += fmt::format("{:.6f} ", 90 * std::sin(0.01 * frame + c));
        }
        text += '\n';
    }
    return text;
}

const std::vector<Sample>& samples() {
    static const std::vector<Sample> all = [] {
        std::vector<Sample> found;
        const char* set = std::getenv("KUMITE_DATA");
        const std::filesystem::path folder = set ? set : "../shared/data";
        for (const std::string name : {"cmu_karate/martial_03.bvh", "cmu_salsa/60_01.bvh",
                                       "awkward/Boxing_Toes.bvh", "cmu_karate/martial_04.bvh"}) {
            if (!std::filesystem::exists(folder / name)) continue;
            found.push_back({std::filesystem::path(name).stem().string(), readText(folder / name)});
        }
        if (found.empty()) found.push_back({"made", madeText()});
        return found;
    }();
    return all;
}

void countBytes(benchmark::State& state, const Sample& sample) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(sample.text.size()));
}

void readWithKumite(benchmark::State& state, const Sample& sample) {
    for (auto step : state) {
        const kumite::Recording recording = kumite::readBvh(sample.text, sample.name);
        benchmark::DoNotOptimize(recording.motions.front()->channels.data());
    }
    countBytes(state, sample);
}

void readWithAssimp(benchmark::State& state, const Sample& sample) {
    for (auto step : state) {
        Assimp::Importer importer;
        const aiScene* scene =
            importer.ReadFileFromMemory(sample.text.data(), sample.text.size(), 0, "bvh");
        if (!scene) state.SkipWithError(importer.GetErrorString());
        benchmark::DoNotOptimize(scene);
    }
    countBytes(state, sample);
}

void readBareNumbers(benchmark::State& state, const Sample& sample) {
    const std::size_t header = sample.text.find("Frame Time:");
    const std::size_t begin = sample.text.find('\n', header);
    for (auto step : state) {
        const char* at = sample.text.data() + begin;
        const char* const end = sample.text.data() + sample.text.size();
        double sum = 0;
        for (;;) {
            while (at != end && (*at == ' ' || (*at >= '\t' && *at <= '\r')))
                ++at;
            if (at == end) break;
            double value = 0;
            at = std::from_chars(at, end, value).ptr;
            sum += value;
        }
        benchmark::DoNotOptimize(sum);
    }
    countBytes(state, sample);
}

void printRatios(const bench::RunKeeper& runs) {
    constexpr double kMegabyte = 1e6;
    fmt::print("\n{:<14}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "file", "Kumite", "Assimp", "bare",
               "x Assimp", "x bare");
    for (const Sample& sample : samples()) {
        const auto speedOf = [&](const char* reader) {
            return runs.counter(fmt::format("{}/{}", reader, sample.name), "bytes_per_second") /
                   kMegabyte;
        };
        const double kumite = speedOf("BM_Kumite");
        const double assimp = speedOf("BM_Assimp");
        const double bare = speedOf("BM_BareFromChars");
        fmt::print("{:<14}{:>7.0f} MB/s{:>7.0f} MB/s{:>7.0f} MB/s{:>12.1f}{:>12.2f}\n", sample.name,
                   kumite, assimp, bare, kumite / assimp, kumite / bare);
        if (std::isnan(kumite + assimp + bare)) continue;
        bench::addRow(
            {"reading BVH, " + sample.name,
             fmt::format("{:.1f} MB", static_cast<double>(sample.text.size()) / kMegabyte),
             fmt::format("{:.0f} MB/s", kumite),
             fmt::format("Assimp {}.{}: {:.0f} MB/s; bare `std::from_chars`: {:.0f} MB/s",
                         aiGetVersionMajor(), aiGetVersionMinor(), assimp, bare),
             fmt::format("{}; {:.2f}×", bench::timesText(kumite / assimp), kumite / bare)});
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    for (const Sample& sample : samples()) {
        const auto add = [&](const std::string& name, auto* function) {
            benchmark::RegisterBenchmark((name + "/" + sample.name).c_str(), function, sample)
                ->Unit(benchmark::kMillisecond)
                ->MinTime(0.1)
                ->Repetitions(7);
        };
        add("BM_Kumite", readWithKumite);
        add("BM_Assimp", readWithAssimp);
        add("BM_BareFromChars", readBareNumbers);
    }
    bench::RunKeeper runs;
    benchmark::RunSpecifiedBenchmarks(&runs);
    printRatios(runs);
}
