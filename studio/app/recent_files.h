#pragma once

#include <QStringList>

namespace kumite::studio {

/// What was opened lately, newest first. An entry is the list of files of one bout: a project
/// file, or one or two recordings. Kept in the user's settings.
QList<QStringList> recentFiles();
void rememberFiles(const QStringList& files);
/// "60_01.bvh + 61_01.bvh".
QString recentText(const QStringList& files);

}  // namespace kumite::studio
