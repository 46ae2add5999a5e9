// How long it takes from a key press that edits a boundary until everything is derived anew and
// every view has painted it.
//     kumite-edit-benchmark PROJECT.kumite

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "studio/app/file_actions.h"
#include "studio/app/main_window.h"
#include "studio/app/picture.h"
#include "studio/app/theme.h"
#include "studio/timeline/timeline_view.h"

namespace {

using namespace kumite;
using namespace kumite::studio;

/// Sees when a widget is painted.
class Painted : public QObject {
public:
    explicit Painted(QWidget& widget) { widget.installEventFilter(this); }
    bool since = false;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) since = true;
        return false;
    }
};

/// Removes boundaries of fighter 1 all over the take, one by one, and times each.
void measure(const char* name, MainWindow& window) {
    constexpr std::size_t kEdits = 40;
    Session& session = window.session();
    std::vector<int> frames;
    for (const BoundaryMark& mark : session.marks(0)) {
        if (mark.isLive() && mark.isEditable()) frames.push_back(mark.frame);
    }
    std::vector<double> milliseconds;
    Painted timeline(window.timeline());
    for (std::size_t i = 0; i < kEdits && i < frames.size(); ++i) {
        session.goTo({0, frames[i * frames.size() / kEdits]});
        letWork(100);
        timeline.since = false;
        QElapsedTimer clock;
        clock.start();
        QTest::keyClick(&window.timeline(), Qt::Key_Delete);
        // Widgets of a window are painted in one go.
        while (!timeline.since)
            QApplication::processEvents();
        milliseconds.push_back(1e-6 * double(clock.nsecsElapsed()));
    }
    const std::size_t done = session.document().history().position();
    session.document().goToStep(0);
    letWork(200);
    std::sort(milliseconds.begin(), milliseconds.end());
    std::printf("%-24s %zu edits   median %6.2f ms   worst %6.2f ms\n", name, done,
                milliseconds[milliseconds.size() / 2], milliseconds.back());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    // VTK 9.1 finds its OpenGL functions through GLX only.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
    MainWindow::prepareGraphics();
    QApplication application(argc, argv);
    QApplication::setOrganizationName("kumite");
    QApplication::setApplicationName("kumite-edit-benchmark");
    applyTheme(ThemeChoice::Dark);
    const QStringList files = application.arguments().mid(1);
    if (files.size() != 1) {
        std::fprintf(stderr, "kumite-edit-benchmark PROJECT.kumite\n");
        return 2;
    }
    MainWindow window;
    window.resize(1280, 800);
    window.show();
    window.files().open(files);
    waitWhileBusy(window);
    if (window.session().playerCount() == 0) return 1;
    letWork(500);
    QApplication::setActiveWindow(&window);
    window.timeline().setFocus();
    measure("whole take in view", window);
    window.session().setVisible({0, 20});
    measure("20 s in view", window);
    return 0;
}
