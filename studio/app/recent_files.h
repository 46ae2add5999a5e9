#pragma once

#include <QDateTime>
#include <QList>
#include <QStringList>

namespace kumite::studio {

/// A bout that was opened lately: a project file, or one or two recordings.
struct RecentBout {
    QStringList files;
    QDateTime opened;  ///< invalid where it is not known
};

/// What was opened lately and is still there, newest first. Kept in the user's settings.
QList<RecentBout> recentBouts();
/// The files alone.
QList<QStringList> recentFiles();
void rememberFiles(const QStringList& files);
/// "60_01.bvh + 61_01.bvh".
QString recentText(const QStringList& files);
/// The folder of the first file, with ~ for the user's own: "~/mocap/salsa".
QString folderText(const QStringList& files);
/// "today 14:05", "yesterday 9:30", "12 Mar 2026"; empty for an invalid time.
QString whenText(const QDateTime& time, const QDateTime& now = QDateTime::currentDateTime());

}  // namespace kumite::studio
