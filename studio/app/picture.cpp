#include "studio/app/picture.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QPixmap>

#include <cstdio>

#include "studio/app/main_window.h"
#include "studio/app/message_strip.h"

namespace kumite::studio {

void letWork(int milliseconds) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < milliseconds) {
        QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

void waitWhileBusy(const MainWindow& window) {
    while (window.isBusy())
        letWork(20);
}

bool takePicture(MainWindow& window, const QString& file, std::optional<double> seconds) {
    letWork(100);
    waitWhileBusy(window);
    if (!window.session().document().isOpen() && !window.messages().text().isEmpty()) {
        std::fprintf(stderr, "%s\n", qPrintable(window.messages().text()));
        return false;
    }
    if (seconds) {
        window.session().transport().setPlayhead(*seconds);
        window.session().reveal(*seconds);
    }
    letWork(300);
    // A dialog or page that is open is the picture.
    QWidget* shown = &window;
    if (QWidget* above = QApplication::activeModalWidget()) shown = above;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (widget->isVisible() && widget->parentWidget() == &window && widget->isWindow()) {
            shown = widget;
        }
    }
    if (!shown->grab().save(file, "PNG")) {
        std::fprintf(stderr, "%s: the picture cannot be written there.\n", qPrintable(file));
        return false;
    }
    return true;
}

}  // namespace kumite::studio
