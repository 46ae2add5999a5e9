#pragma once

#include <QRectF>

#include "studio/app/session.h"
#include "studio/app/theme.h"
#include "studio/timeline/time_mapping.h"
#include "studio/timeline/timeline_options.h"

class QPainter;

namespace kumite::studio {

/// Paints the ruler over the tracks: times, frames of the active fighter or both, and the range of
/// the loop with its handles.
void paintRuler(QPainter& painter, const QRectF& ruler, const Session& session,
                const Colours& colours, const TimeMapping& mapping, RulerUnits units);

/// A label on the ruler and a line through all tracks below it: the playhead, a guide.
struct TimeMarker {
    double seconds = 0;
    QString text;
    QColor colour;
    QColor textColour;
    Qt::PenStyle line = Qt::SolidLine;
    double width = 1.5;  ///< of the line, pixels
};
void paintMarker(QPainter& painter, const QRectF& ruler, double bottom, const TimeMapping& mapping,
                 const TimeMarker& marker);

}  // namespace kumite::studio
