// From channel values to actions: how long a bout takes, and what one edit costs.
#include <cmath>
#include <cstdio>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include "core/motion/survey.h"
#include "core/project/edits.h"
#include "tests/benchmarks/run_keeper.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

/// makeHuman with fingers: 43 joints and 132 channels, as the CMU recordings by cgspeed have.
std::shared_ptr<const Skeleton> skeletonOf43() {
    auto skeleton = std::make_shared<Skeleton>(*test::makeHuman());
    for (int i = 0; skeleton->channelCount < 132; ++i) {
        Joint joint;
        joint.name = "Finger" + std::to_string(i);
        joint.parent = skeleton->find(i % 2 ? "RightWrist" : "LeftWrist");
        joint.offset = Eigen::Vector3d(i % 2 ? -8 : 8, 0, i - 12);
        joint.channels = {Channel::Zrotation, Channel::Xrotation, Channel::Yrotation};
        joint.firstChannel = skeleton->channelCount;
        skeleton->channelCount += 3;
        skeleton->joints.push_back(joint);
    }
    return skeleton;
}

/// A bout in which every joint moves all the time.
Project movingBout(double seconds, double rate) {
    const auto skeleton = skeletonOf43();
    Project project;
    Take take;
    take.name = "long";
    for (const int player : {0, 1}) {
        const auto motion = test::makeMotion(
            skeleton, static_cast<int>(seconds * rate), rate, [&](int frame, int column) {
                const double t = frame / rate;
                if (column == 1) return 92 + 2.0 * std::sin(9 * t + player) + std::sin(23 * t);
                if (column < 3) return 80 * std::sin(0.3 * t + column);
                return 25 * std::sin(column + (1.0 + 0.05 * column) * t + player);
            });
        take.fighters.push_back(test::makeFighter(motion, rate));
    }
    project.takes.push_back(take);
    return project;
}

const Project& sixteenMinutes() {
    static const Project project = movingBout(16 * 60, 60);
    return project;
}

void roles_kinematics_force_minima_of_16_minutes(benchmark::State& state) {
    const Project& project = sixteenMinutes();
    for (auto _ : state) {
        for (const Fighter& fighter : project.takes[0].fighters) {
            benchmark::DoNotOptimize(surveyMotion(*fighter.motion));
        }
        const Analysis analysis = analyse(project);
        state.counters["minima"] = static_cast<double>(analysis.at({0, 0}).force->minima.size() +
                                                       analysis.at({0, 1}).force->minima.size());
    }
}
BENCHMARK(roles_kinematics_force_minima_of_16_minutes)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void one_boundary_edit_to_all_derived_values(benchmark::State& state) {
    Project project = sixteenMinutes();
    Analysis analysis = analyse(project);
    const int frame = analysis.at({0, 0}).segmentation->boundaries[500].frame;
    for (auto _ : state) {
        for (const bool remove : {true, false}) {
            const auto edit = remove ? removeBoundary(project, analysis, {0, 0}, frame)
                                     : restoreBoundary(project, analysis, {0, 0}, frame);
            project = edit->project;
            analysis = analyse(project, analysis);
        }
    }
    state.SetItemsProcessed(2 * state.iterations());
}
BENCHMARK(one_boundary_edit_to_all_derived_values)->Unit(benchmark::kMillisecond)->UseRealTime();

void one_hour_at_120_hz(benchmark::State& state) {
    const Project project = movingBout(3600, 120);
    for (auto _ : state)
        benchmark::DoNotOptimize(analyse(project));
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_GB"] = static_cast<double>(usage.ru_maxrss) * 1024 / 1e9;
}
BENCHMARK(one_hour_at_120_hz)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void addRows(const bench::RunKeeper& runs) {
    const std::string bout = "16 minutes at 60 Hz, two fighters of 43 joints";
    runs.addTime("roles_kinematics_force_minima_of_16_minutes",
                 {"roles, kinematics, force, minima, suspicion", bout});
    // An iteration removes a boundary and restores it.
    runs.addTime("one_boundary_edit_to_all_derived_values",
                 {"one boundary edit to all derived values", bout}, 2);
    const double peak = runs.counter("one_hour_at_120_hz", "peak_GB");
    runs.addTime("one_hour_at_120_hz",
                 {"kinematics, force, minima, suspicion", "one hour at 120 Hz, two fighters",
                  fmt::format(", {:.1f} GB of memory at most", peak)});
}

}  // namespace
}  // namespace kumite

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    kumite::bench::RunKeeper runs;
    benchmark::RunSpecifiedBenchmarks(&runs);
    kumite::addRows(runs);
    return 0;
}
