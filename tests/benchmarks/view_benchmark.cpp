// How long a frame of the 3D view takes at 1280x800: the playhead moves on by a frame, the scene is
// built and drawn and brought to the screen.
//     kumite-view-benchmark RECORDING [RECORDING]

#include <QApplication>
#include <QElapsedTimer>

#include <cstdio>
#include <ctime>
#include <vector>

#include "studio/app/opening.h"
#include "studio/app/session.h"
#include "studio/view3d/stage_view.h"
#include "tests/benchmarks/bench_table.h"
#include "tests/benchmarks/studio_benchmark.h"

namespace {

using namespace kumite;
using namespace kumite::studio;

void measure(const char* name, Session& session, StageView& view) {
    constexpr int kWarmUp = 20;
    constexpr int kFrames = 300;
    std::vector<double> milliseconds;
    std::clock_t begin = 0;
    for (int i = 0; i < kWarmUp + kFrames; ++i) {
        if (i == kWarmUp) begin = std::clock();
        QElapsedTimer clock;
        clock.start();
        session.transport().setPlayhead(session.transport().span().begin + i / 60.0);
        view.repaint();
        QApplication::processEvents();
        if (i >= kWarmUp) milliseconds.push_back(1e-6 * double(clock.nsecsElapsed()));
    }
    // The time of all cores together does not depend on what else the machine does.
    const double work = 1000.0 * double(std::clock() - begin) / CLOCKS_PER_SEC / kFrames;
    std::printf("%-28s median %6.2f ms   95 in 100 below %6.2f ms   cores together %6.2f ms\n",
                name, quantile(milliseconds, 0.5), quantile(milliseconds, 0.95), work);
    std::fflush(stdout);
    bench::addRow({std::string("3D view, a frame: ") + name,
                   std::to_string(session.playerCount()) + " fighters, 1280×800",
                   bench::timeText(1e-3 * quantile(milliseconds, 0.5))});
}

}  // namespace

int main(int argc, char** argv) {
    prepareBenchmark();
    QApplication application(argc, argv);
    const QStringList files =
        benchmarkFiles(application, "kumite-view-benchmark", "RECORDING [RECORDING]");
    OpenedProject opened = openRecordings(requestFor(files), {}, {});
    Session session;
    StageView view(session);
    view.resize(1280, 800);
    view.show();
    session.document().open(History(std::move(opened.project)), std::move(opened.analysis), {},
                            false);
    QApplication::processEvents();
    view.frameAll();
    measure("whole take in view", session, view);
    view.frameActiveFighter();
    measure("fighter fills the picture", session, view);
    return 0;
}
