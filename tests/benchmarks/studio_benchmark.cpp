#include "tests/benchmarks/studio_benchmark.h"

#include <QApplication>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "studio/app/main_window.h"
#include "studio/app/theme.h"

namespace kumite::studio {

void prepareBenchmark() {
    // VTK 9.1 finds its OpenGL functions through GLX only.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
    MainWindow::prepareGraphics();
}

QStringList benchmarkFiles(QApplication& application, const char* name, const char* usage) {
    QApplication::setOrganizationName(QStringLiteral("kumite"));
    QApplication::setApplicationName(QString::fromLatin1(name));
    applyTheme(ThemeChoice::Dark);
    const QStringList files = application.arguments().mid(1);
    if (files.isEmpty()) {
        std::fprintf(stderr, "%s %s\n", name, usage);
        std::exit(2);
    }
    return files;
}

double quantile(std::vector<double> milliseconds, double share) {
    if (milliseconds.empty()) return 0;
    std::sort(milliseconds.begin(), milliseconds.end());
    return milliseconds[static_cast<std::size_t>(share * double(milliseconds.size() - 1))];
}

}  // namespace kumite::studio
