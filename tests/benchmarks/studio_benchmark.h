#pragma once

#include <QString>
#include <QStringList>

#include <vector>

class QApplication;

namespace kumite::studio {

/// What every benchmark of the window needs before it: the dark theme, settings of its own, and the
/// files that are named on its command line. `QApplication` must not exist before `prepare`.
void prepareBenchmark();
/// The files named; without any, says how to call and ends the program.
QStringList benchmarkFiles(QApplication& application, const char* name, const char* usage);

/// A share of the sorted times, 0.5: the median.
double quantile(std::vector<double> milliseconds, double share);

}  // namespace kumite::studio
