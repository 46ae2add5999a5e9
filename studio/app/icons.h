#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace kumite::studio {

/// A line icon of resources/icons by its name ("play"), drawn in `colour`; disabled states are
/// fainter.
QIcon lineIcon(const QString& name, const QColor& colour);

/// The same as a picture of `size` logical pixels for a screen of `ratio` device pixels each.
QPixmap linePixmap(const QString& name, const QColor& colour, int size, double ratio);

/// The program's own icon.
QIcon applicationIcon();

}  // namespace kumite::studio
