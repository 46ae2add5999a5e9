#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "studio/app/language.h"
#include "studio/app/main_window.h"
#include "studio/app/theme.h"

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
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
