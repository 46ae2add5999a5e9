#include <gtest/gtest.h>

#include <QApplication>
#include <QEvent>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QWidget>

#include "studio/app/language.h"
#include "studio/app/main_window.h"
#include "studio/app/theme.h"

namespace {

/// A key that a test presses in a window makes it the active one first, as it is for whoever
/// presses keys: what the display says of it comes at its own time, and until then shortcuts of the
/// main window would take the keys of its dialogs.
class ActiveIsWhereKeysGo : public QObject {
public:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride || !watched->isWidgetType()) return false;
        QWidget* window = static_cast<QWidget*>(watched)->window();
        const bool usual = window->windowType() == Qt::Window || window->windowType() == Qt::Dialog;
        if (usual && QApplication::activeWindow() != window && window->isVisible() &&
            QApplication::activePopupWidget() == nullptr)
            QApplication::setActiveWindow(window);
        return false;
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && !qEnvironmentVariableIsEmpty("DISPLAY")) {
        qputenv("QT_QPA_PLATFORM", "xcb");
    }
    kumite::studio::MainWindow::prepareGraphics();
    // Nothing of the user's is read or written.
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    QApplication application(argc, argv);
    QApplication::setOrganizationName("kumite");
    QApplication::setApplicationName("kumite-studio-tests");
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
    kumite::studio::useLanguage("en");
    kumite::studio::applyTheme(kumite::studio::ThemeChoice::Dark);
    ActiveIsWhereKeysGo active;
    application.installEventFilter(&active);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
