#pragma once

#include <QCoreApplication>

#include "studio/app/session.h"
#include "studio/app/theme.h"
#include "studio/timeline/track.h"

class QPainter;

namespace kumite::studio {

/// Paints one fighter's row: axes, curves, minima, boundaries and actions.
class TrackPainter {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::TrackPainter)

public:
    TrackPainter(QPainter& painter, const Session& session, const Colours& colours,
                 const TimeMapping& mapping);

    /// Everything that stays while the pointer and the playhead move.
    void paint(const Track& track, int player);
    /// A selected boundary: a band and a grip.
    void paintSelection(const Track& track, const BoundaryRef& boundary);
    /// The button on top of a boundary that removes or restores it.
    void paintHandle(const QRectF& handle, bool live, bool under);

    double xOfFrame(const Fighter& fighter, double frame) const;

private:
    void paintNote(const Track& track, const QString& text);
    void paintHeader(const Track& track, int player);
    void paintAxes(const Track& track);
    void paintCurve(const Track& track, const Fighter& fighter, bool force, const QColor& colour);
    void paintActions(const Track& track, const FighterAnalysis& fighter, int player);
    void paintMinima(const Track& track, const FighterAnalysis& fighter, int player);
    void paintBoundaries(const Track& track, const FighterAnalysis& fighter, int player);
    void paintBoundary(const Track& track, const BoundaryMark& mark, double x, double density);

    QPainter& painter_;
    const Session& session_;
    const Colours& colours_;
    const TimeMapping& mapping_;
};

}  // namespace kumite::studio
