// How long the timeline takes to paint one hour at 120 Hz of two fighters: everything anew, as
// while scrolling, and the playhead alone, as while playing.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <QApplication>
#include <QImage>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "studio/app/session.h"
#include "studio/timeline/lanes.h"
#include "studio/timeline/timeline_view.h"
#include "tests/benchmarks/run_keeper.h"
#include "tests/support/builders.h"

namespace kumite::studio {
namespace {

constexpr double kRate = 120;
constexpr int kFrames = 3600 * 120;

/// A body that bobs irregularly some twice a second, with four joints that swing.
FighterAnalysis longFighter(unsigned seed) {
    std::mt19937 random(seed);
    FighterAnalysis fighter;
    fighter.input = test::makeFighter(
        test::makeMotion(test::makeSkeleton({{"hips", -1, {0, 0, 0}, "XYZzxy"},
                                             {"left hand", 0, {10, 0, 0}, "zxy"},
                                             {"right hand", 0, {-10, 0, 0}, "zxy"},
                                             {"left toe", 0, {5, -90, 0}, "zxy"},
                                             {"right toe", 0, {-5, -90, 0}, "zxy"}}),
                         1, kRate, [](int, int) { return 0.0; }),
        kRate);
    // As long as its curves; no channel is looked at again.
    auto recording = std::make_shared<Motion>(*fighter.input.motion);
    recording->frameCount = kFrames;
    fighter.input.motion = recording;
    fighter.input.frames = {0, kFrames};
    fighter.input.roles = {};
    fighter.input.roles.set(Role::LeftWrist, 1);
    fighter.input.roles.set(Role::RightWrist, 2);
    fighter.input.roles.set(Role::LeftToe, 3);
    fighter.input.roles.set(Role::RightToe, 4);
    auto motion = std::make_shared<FighterMotion>();
    motion->positions = {kFrames, 5, std::vector<float>(std::size_t{kFrames} * 5 * 3)};
    auto body = std::make_shared<FighterBody>();
    double phase = 0;
    double beat = 2;
    for (int frame = 0; frame < kFrames; ++frame) {
        if (frame % 60 == 0) beat = std::uniform_real_distribution<>(1.2, 3.2)(random);
        phase += 2 * std::numbers::pi * beat / kRate;
        const double height =
            0.95 + 0.03 * std::sin(phase) + std::normal_distribution<>(0, 2e-5)(random);
        body->com.position.push_back({0, height, 0});
        float* xyz = motion->positions.xyz.data() + std::size_t(frame) * 15;
        for (int i = 0; i < 15; ++i)
            xyz[i] = static_cast<float>(0.2 * std::sin(phase * (0.3 + 0.1 * i) + i));
    }
    auto force = std::make_shared<FighterForce>();
    force->force = contactForce(body->com.position, kRate, 6, ForceCurve::Norm);
    force->minima = findMinima(force->force.curve);
    auto cut = std::make_shared<Segmentation>(
        segment(force->force.curve, force->minima, 0.05, {}, kCorrectionReach * kRate));
    const SuspicionInput input{force->force.curve, force->minima, cut.get(), {}, kRate, 0.05};
    auto ranking = rankSuspicion(std::span(&input, 1)).front();
    fighter.motion = motion;
    fighter.body = body;
    fighter.force = force;
    fighter.segmentation = cut;
    fighter.suspicion = std::make_shared<Suspicion>(std::move(ranking.suspicion));
    fighter.evidence =
        std::make_shared<std::vector<SuspicionEvidence>>(std::move(ranking.evidence));
    return fighter;
}

Session& longBout() {
    static Session session;
    if (session.document().isOpen()) return session;
    Analysis analysis;
    analysis.settings = SegmentationSettings{};
    analysis.takes.push_back({longFighter(1), longFighter(2)});
    Project project;
    project.takes.push_back({"hour", {analysis.takes[0][0].input, analysis.takes[0][1].input}});
    session.document().open(History(project), analysis, {}, false);
    return session;
}

/// Seven lanes as full as those of a bout that is half labelled.
class MadeLanes : public LaneSource {
public:
    explicit MadeLanes(const Session& session) {
        std::mt19937 random(5);
        for (int player = 0; player < 2; ++player) {
            const auto& actions = session.fighter(player)->segmentation->actions;
            for (std::size_t i = 0; i < actions.size() * kLanes; ++i) {
                LaneCell cell;
                cell.value = static_cast<std::int8_t>(random() % 4);
                cell.look = static_cast<LaneLook>(random() % 6);
                cell.uncertain = cell.look == LaneLook::Proposed && random() % 3 == 0;
                cells_[player].push_back(cell);
            }
        }
    }
    int laneCount() const override { return kLanes; }
    QString laneName(int lane) const override { return QStringLiteral("Lane %1").arg(lane); }
    int chosenLane() const override { return 1; }
    QString valueText(int, int value) const override { return QStringLiteral("v%1").arg(value); }
    QColor valueColour(int lane, int value) const override {
        return QColor::fromHsv(lane * 45, 180, 90 + 40 * value);
    }
    std::span<const LaneCell> cells(int player) const override { return cells_[player]; }
    std::vector<ActionRef> chosen() const override { return {}; }
    QString describe(const ActionRef&, int) const override { return {}; }
    bool pressed(const ActionRef&, int, Qt::KeyboardModifiers) override { return false; }
    void dragged(const ActionRef&) override {}
    void released() override {}

private:
    static constexpr int kLanes = 7;
    std::vector<LaneCell> cells_[2];
};

/// Arguments: visible seconds; 1 for all rows of curves, 2 for lanes, too; width in pixels.
void paintAnew(benchmark::State& state) {
    Session& session = longBout();
    TimelineView view(session);
    const auto width = static_cast<int>(state.range(2));
    MadeLanes lanes(session);
    view.resize(width, state.range(1) == 2 ? 520 : state.range(1) == 1 ? 420 : 250);
    if (state.range(1)) view.setOptions({true, true, true, true, RulerUnits::Both});
    if (state.range(1) == 2) view.setLanes(&lanes);
    while (view.isPreparing())
        QApplication::processEvents();
    QImage image(view.size(), QImage::Format_ARGB32_Premultiplied);
    const auto seconds = static_cast<double>(state.range(0));
    double begin = 0;
    for (auto _ : state) {
        // Somewhere else each time, so that nothing painted before is of use.
        begin = std::fmod(begin + 0.37 * seconds, std::max(1e-3, 3599 - seconds));
        session.setVisible({begin, begin + seconds});
        view.render(&image);
        benchmark::DoNotOptimize(image.constBits());
    }
}

void movePlayhead(benchmark::State& state) {
    Session& session = longBout();
    TimelineView view(session);
    view.resize(1920, 250);
    session.showAll();
    QImage image(view.size(), QImage::Format_ARGB32_Premultiplied);
    view.render(&image);
    double seconds = 0;
    for (auto _ : state) {
        session.transport().setPlayhead(seconds += 0.01);
        view.render(&image);
        benchmark::DoNotOptimize(image.constBits());
    }
}

const std::vector<std::int64_t> kVisible = {1, 4, 15, 60, 240, 900, 3600};  // seconds

BENCHMARK(paintAnew)
    ->ArgsProduct({kVisible, {0, 1, 2}, {1280, 1920}})
    ->ArgNames({"seconds", "all", "width"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(movePlayhead)->Unit(benchmark::kMillisecond);

void addRows(const bench::RunKeeper& runs) {
    const std::string size = "one hour at 120 Hz, two fighters, 1920 px wide";
    constexpr const char* kShown[] = {"", ", with force as it is and all speeds",
                                      ", with labels, too"};
    for (const int all : {0, 1, 2}) {
        double worst = 0;
        for (const auto seconds : kVisible) {
            const double time =
                runs.seconds(fmt::format("paintAnew/seconds:{}/all:{}/width:1920", seconds, all));
            if (time > worst) worst = time;
        }
        if (worst > 0)
            bench::addRow({std::string("timeline painted anew, at the slowest zoom") + kShown[all],
                           size, bench::timeText(worst)});
    }
    runs.addTime("movePlayhead", {"timeline, the playhead alone", size});
}

}  // namespace
}  // namespace kumite::studio

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    kumite::bench::RunKeeper runs;
    benchmark::RunSpecifiedBenchmarks(&runs);
    kumite::studio::addRows(runs);
    return 0;
}
