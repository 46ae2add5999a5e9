// How long the window of a project does not answer while it is worked with: from a key press that
// edits a boundary until every view has painted it, pictures a second while it plays, and the
// longest gap of the event loop during the acts of a session.
//     kumite-edit-benchmark PROJECT.kumite [edits|playing|session]

#include <QApplication>
#include <QElapsedTimer>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/loop_watch.h"
#include "studio/app/main_window.h"
#include "studio/app/picture.h"
#include "studio/app/recovery.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "tests/benchmarks/bench_table.h"
#include "tests/benchmarks/studio_benchmark.h"

namespace {

using namespace kumite;
using namespace kumite::studio;

/// Counts how often a widget is painted.
class Painted : public QObject {
public:
    explicit Painted(QWidget& widget) { widget.installEventFilter(this); }
    int times = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) ++times;
        return false;
    }
};

std::vector<int> detectedFrames(Session& session) {
    std::vector<int> frames;
    for (const BoundaryMark& mark : session.marks(0)) {
        if (mark.isLive() && mark.isEditable()) frames.push_back(mark.frame);
    }
    return frames;
}

/// What the window shows, for the table.
std::string sizeOf(const Session& session) {
    const auto span = session.transport().span();
    return fixed((span.end - span.begin) / 60, 0) + " minutes of bout, 1280×800";
}

/// Removes boundaries of fighter 1 all over the take, one by one, and times each.
void measureEdits(const char* name, MainWindow& window) {
    constexpr std::size_t kEdits = 40;
    Session& session = window.session();
    const std::vector<int> frames = detectedFrames(session);
    std::vector<double> milliseconds;
    Painted timeline(window.timeline());
    for (std::size_t i = 0; i < kEdits && i < frames.size(); ++i) {
        session.goTo({0, frames[i * frames.size() / kEdits]});
        letWork(100);
        timeline.times = 0;
        QElapsedTimer clock;
        clock.start();
        QTest::keyClick(&window.timeline(), Qt::Key_Delete);
        // Widgets of a window are painted in one go.
        while (timeline.times == 0)
            QApplication::processEvents();
        milliseconds.push_back(1e-6 * double(clock.nsecsElapsed()));
    }
    const std::size_t done = session.document().history().position();
    session.document().goToStep(0);
    letWork(200);
    std::printf("%-24s %zu edits   median %6.2f ms   worst %6.2f ms\n", name, done,
                quantile(milliseconds, 0.5), quantile(milliseconds, 1));
    std::fflush(stdout);
    bench::addRow({std::string("a key press to all views, ") + name, sizeOf(session),
                   bench::timeText(1e-3 * quantile(milliseconds, 0.5)) + ", at worst " +
                       bench::timeText(1e-3 * quantile(milliseconds, 1))});
}

/// Plays in each workspace, the Graph's views one by one: pictures of the 3D view a second.
void measurePlaying(MainWindow& window) {
    struct View {
        const char* workspace;
        const char* command;  ///< that leads to it; may be nothing
    };
    QWidget* canvas = nullptr;
    for (QWidget* child : window.stage().findChildren<QWidget*>()) {
        if (child->inherits("kumite::studio::VtkWidget")) canvas = child;
    }
    if (canvas == nullptr) return;
    Painted painted(*canvas);
    LoopWatch watch;
    std::vector<double> rates;
    for (const View& view :
         {View{"segment", nullptr}, View{"label", nullptr}, View{"graph", nullptr},
          View{"graph", "graph.view"}, View{"graph", "graph.space"}}) {
        window.workspaces().show(QLatin1String(view.workspace));
        if (view.command != nullptr) window.commands().run(QLatin1String(view.command));
        letWork(100);
        waitWhileBusy(window);
        letWork(500);
        window.session().transport().setPlayhead(0);
        window.commands().run(QStringLiteral("transport.play"));
        letWork(300);
        watch.reset();
        painted.times = 0;
        QElapsedTimer clock;
        clock.start();
        letWork(4000);
        const double seconds = 1e-3 * double(clock.elapsed());
        window.commands().run(QStringLiteral("transport.play"));
        rates.push_back(painted.times / seconds);
        std::printf("%-8s %-12s %5.1f pictures a second   longest gap %5.1f ms\n", view.workspace,
                    view.command != nullptr ? view.command : "", rates.back(),
                    watch.longest().milliseconds);
        std::fflush(stdout);
    }
    bench::addRow({"pictures a second while playing: Segment, Label, Graph in three views",
                   sizeOf(window.session()),
                   bench::rangeText(quantile(rates, 0), quantile(rates, 1), 0)});
}

/// The acts of a session, each watched until nothing is computed any more.
class WatchedSession {
public:
    explicit WatchedSession(MainWindow& window) : window_(window), recovery_(window.session()) {}

    void act(const char* name, const std::function<void()>& what) {
        letWork(50);
        watch_.reset();
        watch_.note(QString::fromLatin1(name));
        what();
        letWork(50);
        waitWhileBusy(window_);
        letWork(300);
        const LoopGap& gap = watch_.longest();
        std::printf("%-28s longest gap %6.1f ms, work %6.1f ms, in %s; %zu above %.0f ms\n", name,
                    gap.milliseconds, gap.work, qPrintable(gap.event), watch_.gaps().size(),
                    LoopWatch::kBlink);
        std::fflush(stdout);
        acts_.push_back({name, gap.milliseconds});
    }
    void run(const char* command) {
        act(command, [&] { window_.commands().run(QLatin1String(command)); });
    }
    void play(const QString& project);
    /// The longest gap of all acts, and that of those which make no view anew.
    void addRows() const {
        Act longest, usual;
        for (const Act& act : acts_) {
            if (act.milliseconds > longest.milliseconds) longest = act;
            const bool makesAnew = act.name == "open" || act.name.starts_with("view.theme");
            if (!makesAnew && act.milliseconds > usual.milliseconds) usual = act;
        }
        const std::string size =
            sizeOf(window_.session()) + ", " + std::to_string(acts_.size()) + " acts";
        const auto text = [](const Act& act) {
            return bench::timeText(1e-3 * act.milliseconds) + " (" + act.name + ")";
        };
        bench::addRow({"longest gap of a scripted session", size, text(longest)});
        bench::addRow({"longest gap of that session but for opening and changes of theme", size,
                       text(usual)});
    }

private:
    struct Act {
        std::string name;
        double milliseconds = 0;  ///< its longest gap
    };

    TimelineView& timeline() { return window_.timeline(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&timeline(), key, modifiers);
    }
    /// Presses, moves in steps with the window at work, lets go.
    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&timeline(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= 20; ++i) {
            QTest::mouseMove(&timeline(), from + (to - from) * i / 20);
            letWork(10);
        }
        QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, to);
    }
    void slide(QSlider& slider, int steps) {
        slider.setSliderDown(true);
        for (int i = 0; i < steps; ++i) {
            slider.setValue(slider.value() + 2);
            letWork(15);
        }
        slider.setSliderDown(false);
    }

    MainWindow& window_;
    Recovery recovery_;
    LoopWatch watch_;
    std::vector<Act> acts_;
};

void WatchedSession::play(const QString& project) {
    Session& session = window_.session();
    QTemporaryDir folder;
    act("open", [&] { window_.files().open({project}); });
    if (session.playerCount() == 0) return;
    window_.timeline().setFocus();
    act("resize", [&] {
        for (const QSize size : {QSize(1500, 900), QSize(1900, 1000), QSize(1280, 800)}) {
            window_.resize(size);
            letWork(100);
        }
    });
    for (const char* command : {"view.theme1", "view.theme2", "timeline.handSpeed",
                                "timeline.footSpeed", "timeline.rawForce"}) {
        run(command);
    }
    act("scrub", [&] { drag({400, 10}, {900, 10}); });
    act("zoom", [&] {
        for (int i = 0; i < 30; ++i) {
            QWheelEvent turn({600, 80}, timeline().mapToGlobal(QPointF(600, 80)), {}, {0, 120}, {},
                             Qt::ControlModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&timeline(), &turn);
            letWork(5);
        }
    });
    act("play", [&] {
        key(Qt::Key_Space);
        letWork(2000);
        key(Qt::Key_Space);
    });
    act("next suspect", [&] { key(Qt::Key_N); });
    act("remove", [&] { key(Qt::Key_Delete); });
    act("undo", [&] { key(Qt::Key_Z, Qt::ControlModifier); });
    act("drag a boundary", [&] {
        const std::vector<int> frames = detectedFrames(session);
        const BoundaryRef boundary{0, frames[frames.size() / 2]};
        session.examine(boundary);
        const QPoint at = timeline().pointOf(boundary).toPoint();
        drag(at, at + QPoint(12, 0));
    });
    auto sliders = window_.findChildren<QSlider*>();
    for (QSlider* slider : sliders) {
        if (!slider->isVisible()) continue;
        act(qPrintable(QStringLiteral("slide ") + slider->accessibleName().left(18)),
            [&] { slide(*slider, 20); });
        if (slider == sliders.front()) {
            act("edits while it computes", [&] {
                slider->setValue(slider->value() + 9);
                key(Qt::Key_Delete);
                key(Qt::Key_S);
                letWork(20);
                key(Qt::Key_N);
            });
        }
    }
    act("history back", [&] { session.document().goToStep(0); });
    act("many edits", [&] {
        const std::vector<int> frames = detectedFrames(session);
        for (std::size_t i = 1; i < frames.size() && i < 60; ++i) {
            session.goTo({0, frames[i]});
            key(Qt::Key_Delete);
            letWork(10);
        }
    });
    act("autosave", [&] { recovery_.autosave(); });
    act("save", [&] { window_.files().saveTo(folder.filePath("saved.kumite")); });
    act("export", [&] { window_.files().exportTo(folder.filePath("actions.csv")); });
    for (const char* command :
         {"fighter.properties", "help.keys", "app.palette", "app.preferences", "view.measure",
          "view.nextJoint", "view.all", "view.panels", "view.panels", "take.next"}) {
        run(command);
    }
    act("open again", [&] { window_.files().open({folder.filePath("saved.kumite")}); });
}

}  // namespace

int main(int argc, char** argv) {
    prepareBenchmark();
    QApplication application(argc, argv);
    const QStringList arguments = benchmarkFiles(application, "kumite-edit-benchmark",
                                                 "PROJECT.kumite [edits|playing|session]");
    const QString only = arguments.value(1);
    MainWindow window;
    window.resize(1280, 800);
    window.show();
    QApplication::setActiveWindow(&window);
    const auto wanted = [&only](const char* part) {
        return only.isEmpty() || only == QLatin1String(part);
    };
    if (wanted("edits") || wanted("playing")) {
        window.files().open({arguments.front()});
        waitWhileBusy(window);
        if (window.session().playerCount() == 0) return 1;
        letWork(500);
        window.timeline().setFocus();
    }
    if (wanted("edits")) {
        measureEdits("whole take in view", window);
        window.session().setVisible({0, 20});
        measureEdits("20 s in view", window);
    }
    if (wanted("playing")) measurePlaying(window);
    if (wanted("session")) {
        WatchedSession session(window);
        session.play(arguments.front());
        if (window.session().playerCount() == 0) return 1;
        session.addRows();
    }
    return 0;
}
