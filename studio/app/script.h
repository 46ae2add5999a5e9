#pragma once

#include <QStringList>

#include <optional>

namespace kumite::studio {

class LoopWatch;
class MainWindow;

/// Runs commands in the window as keys would, once nothing is read or computed any more: names of
/// the command table
/// ("boundary.add"), and
///   time S          moves the playhead
///   take N          shows a take, counted from 1
///   wait MS         lets the window work
///   idle            lets it work until nothing is read or computed
///   import FILE…    opens the import dialog on recordings
///   compare FILE    holds another person's labels against the project's
///   save FILE       saves under a name
///   recover         opens what the last crash left behind
/// After each the line is written to standard output, so that whoever drives the studio knows how
/// far it is, and noted with the watch. False, with a sentence on standard error, at the first line
/// that cannot be run.
bool runScript(MainWindow& window, const QStringList& lines, LoopWatch* watch = nullptr);

/// The lines of a file that say something; nothing where it cannot be read.
std::optional<QStringList> scriptLines(const QString& file);

}  // namespace kumite::studio
