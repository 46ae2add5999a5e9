#pragma once

#include <QCoreApplication>

#include "studio/app/session.h"
#include "studio/app/theme.h"
#include "studio/timeline/level_of_detail.h"
#include "studio/timeline/track.h"

class QPainter;

namespace kumite::studio {

/// Paints what a fighter's row is made of: header, axes and curves. What stands in it (minima,
/// boundaries, actions) is MarkPainter's.
class TrackPainter {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::TrackPainter)

public:
    TrackPainter(QPainter& painter, const Session& session, const Colours& colours,
                 const TimeMapping& mapping);

    void paint(const Track& track, int player);

private:
    void paintNote(const Track& track, const QString& text);
    void paintHeader(const Track& track, int player);
    void paintForceAxis(const Track& track);
    void paintSpeedAxis(const SpeedRow& row, int player);
    void paintCurves(const Track& track, const Fighter& fighter, int player);

    QPainter& painter_;
    const Session& session_;
    const Colours& colours_;
    const TimeMapping& mapping_;
};

/// Where a fighter's frames lie on the timeline.
SampleAxis frameAxis(const Fighter& fighter, const TimeMapping& mapping);

/// The font of axes and captions.
QFont smallFont(const QPainter& painter);

}  // namespace kumite::studio
