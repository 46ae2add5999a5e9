// Measures made bouts against their plan: kumite-demo-figures [SECONDS [SEEDS]]; or, by the same
// figures, any project: kumite-demo-figures PROJECT.kumite …

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/project/demo_bout.h"
#include "core/project/project_file.h"
#include "tests/benchmarks/bench_table.h"
#include "tests/support/bout_figures.h"

namespace {

using namespace kumite;
using Clock = std::chrono::steady_clock;

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

void print(const std::map<std::string, int>& counts, int all) {
    for (const auto& [name, count] : counts) {
        std::cout << fmt::format("      {:5.1f} %  {}\n", 100.0 * count / all, name);
    }
}

void printMotion(const FighterAnalysis& fighter) {
    const test::MotionFigures m = test::measureMotion(fighter);
    std::cout << fmt::format(
        "      {:.2f} actions/s, vertical force {:.4f}, deviation {:.3f} BW, skate {:.3f}, under "
        "floor "
        "{:.1f} mm, knee {:.0f}-{:.0f}, elbow {:.0f}-{:.0f} deg, hand {:.1f} m/s, foot {:.1f} "
        "m/s\n",
        m.actionsPerSecond, m.meanVerticalForce, m.forceDeviation, m.skate,
        1000 * m.deepestUnderFloor, degrees(m.sharpestKnee), degrees(m.straightestKnee),
        degrees(m.sharpestElbow), degrees(m.straightestElbow), m.fastestHand, m.fastestFoot);
}

void printPair(const Take& take, const std::vector<FighterAnalysis>& fighters) {
    const test::PairFigures pair = test::measurePair(take, fighters);
    std::cout << fmt::format(
        "   distance {:.2f} / {:.2f} / {:.2f} m; overlap above 3 cm in {:.2f} % of frames, deepest "
        "{:.1f} cm\n",
        pair.nearest, pair.mean, pair.farthest, 100 * pair.overlapShare, 100 * pair.deepestOverlap);
}

void measureProject(const std::filesystem::path& path) {
    const Project project = loadProject(path).project;
    const Analysis analysis = analyse(project);
    for (std::size_t t = 0; t < project.takes.size(); ++t) {
        std::cout << project.takes[t].name << "\n";
        for (const FighterAnalysis& fighter : analysis.takes[t])
            printMotion(fighter);
        if (analysis.takes[t].size() == 2) printPair(project.takes[t], analysis.takes[t]);
    }
}

/// Least and largest of some numbers.
struct Range {
    double least = INFINITY, most = -INFINITY;
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    std::string text(int decimals) const { return bench::rangeText(least, most, decimals); }
};

/// Of all made bouts, by fighter.
struct MadeFigures {
    Range f1, spuriousShare, actionsPerSecond, overlapShare;
    int spurious = 0, spuriousInTop = 0;
    test::ReviewFigures review;
    double making = 0;  ///< seconds, the slowest
};

void measure(double seconds, std::uint64_t seed, const std::filesystem::path& folder,
             MadeFigures& all) {
    const auto start = Clock::now();
    const DemoFiles files = writeDemoBout({seconds, 60, seed}, folder);
    const double making = std::chrono::duration<double>(Clock::now() - start).count();
    const Project project = loadProject(files.project()).project;
    const Analysis analysis = analyse(project);
    std::ifstream file(files.truth());
    const auto truth = nlohmann::json::parse(file);
    std::cout << fmt::format("seed {}: {} s made and written in {:.2f} s\n", seed, seconds, making);
    all.making = std::max(all.making, making);
    for (std::size_t p = 0; p < 2; ++p) {
        const FighterAnalysis& fighter = analysis.takes[0][p];
        const test::CutFigures cut = test::compareCut(fighter, truth["players"][p], 60);
        std::cout << fmt::format(
            "   fighter {}: F1 {:.4f} ({} planned, {} found, {} matched), spurious {} ({:.1f} %), "
            "in "
            "top 5 %: {}\n",
            p + 1, cut.f1(), cut.planned, cut.found, cut.matched, cut.spurious,
            100.0 * cut.spurious / cut.found, cut.spuriousInTop);
        all.f1.add(cut.f1());
        all.spuriousShare.add(100.0 * cut.spurious / cut.found);
        all.spurious += cut.spurious;
        all.spuriousInTop += cut.spuriousInTop;
        all.actionsPerSecond.add(test::measureMotion(fighter).actionsPerSecond);
        printMotion(fighter);
    }
    const test::ReviewFigures review = test::reviewByTruth(project, truth["players"], 60);
    std::cout << fmt::format("   review: {} decisions remove {} spurious minima, {} are left\n",
                             review.decisions, review.removed, review.spuriousLeft);
    all.review.decisions += review.decisions;
    all.review.removed += review.removed;
    all.review.spuriousLeft += review.spuriousLeft;
    printPair(project.takes[0], analysis.takes[0]);
    all.overlapShare.add(100 * test::measurePair(project.takes[0], analysis.takes[0]).overlapShare);
    const test::LabelFigures labels = test::measureLabels(truth);
    std::cout << fmt::format(
        "   baseline {:.3f}; information {:.3f} bits (by chance {:.3f}), of range {:.3f} bits\n",
        labels.baseline, labels.information, labels.informationByChance, labels.informationOfRange);
    std::map<std::string, int> outcomes;
    for (const auto& player : truth["players"]) {
        for (const auto& hit : player["hits"]) {
            ++outcomes[hit["outcome"].get<std::string>()];
        }
    }
    int hits = 0;
    for (const auto& [name, count] : outcomes)
        hits += count;
    print(outcomes, hits);
    print(labels.techniques, labels.actions);
    print(labels.moves, labels.actions);
    print(labels.reacts, labels.actions);
}

void addRows(const MadeFigures& all, const std::string& size) {
    bench::addRow({"made bouts: boundaries found against planned, F1", size, all.f1.text(3)});
    bench::addRow({"made bouts: spurious among the minima that cut", size,
                   fmt::format("{} %, {} of {} among the top 5 % of suspects",
                               all.spuriousShare.text(1), all.spuriousInTop, all.spurious),
                   "paper's stream: 2 %"});
    bench::addRow({"made bouts: review, one key a decision, until no suspect is left", size,
                   fmt::format("{} decisions remove {} spurious minima, {} are left",
                               all.review.decisions, all.review.removed, all.review.spuriousLeft)});
    bench::addRow({"made bouts: actions a second", size, all.actionsPerSecond.text(2),
                   "paper's stream: 1.5"});
    bench::addRow({"made bouts: frames with limbs more than 3 cm in each other", size,
                   all.overlapShare.text(1) + " %", "recordings: 0.6–3.1 %"});
    bench::addRow({"making and writing a bout, at most", size, bench::timeText(all.making)});
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && !parseNumber(argv[1])) {
        for (int i = 1; i < argc; ++i)
            measureProject(argv[i]);
        return 0;
    }
    const double seconds = argc > 1 ? parseNumber(argv[1]).value_or(300) : 300;
    const int seeds = argc > 2 ? static_cast<int>(parseNumber(argv[2]).value_or(5)) : 5;
    const auto folder = std::filesystem::temp_directory_path() / "kumite-demo-figures";
    MadeFigures all;
    for (int seed = 1; seed <= seeds; ++seed) {
        measure(seconds, static_cast<std::uint64_t>(seed), folder, all);
    }
    addRows(all, fmt::format("{} bouts of {:.0f} minutes", seeds, seconds / 60));
    std::filesystem::remove_all(folder);
    return 0;
}
