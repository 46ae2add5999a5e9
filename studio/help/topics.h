#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace kumite::studio {

/// Places of the help ("method#margin") that explain what a widget shows: those of the nearest of
/// its parents, or of itself, that shows numbers of its own.
QStringList topicsOf(const QWidget& widget);
/// All places that any widget leads to.
QStringList allTopics();

/// The heading of a place.
QString topicTitle(const QString& place);
/// The first paragraph below it, as rich text without links.
QString topicSummary(const QString& place);

}  // namespace kumite::studio
