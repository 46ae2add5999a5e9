#pragma once

#include <QCoreApplication>

#include "studio/app/session.h"
#include "studio/app/theme.h"
#include "studio/timeline/track.h"

class QPainter;

namespace kumite::studio {

/// Paints what stands in a fighter's row: minima, boundaries, actions and their notes. Marks that
/// would fall on each other are thinned, so that the time depends on the width, not on the length.
class MarkPainter {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::MarkPainter)

public:
    MarkPainter(QPainter& painter, const Session& session, const Colours& colours,
                const TimeMapping& mapping);

    void paintActions(const Track& track, int player);
    void paintMinima(const Track& track, int player);
    void paintBoundaries(const Track& track, int player);
    /// Minima that are worth a look: amber, as big as the suspicion.
    void paintSuspects(const Track& track, int player);
    /// Boundaries that only the settings compared with would give, and those that they would not.
    void paintComparison(const Track& track, int player);
    /// A selected boundary: a band and a grip.
    void paintSelection(const Track& track, const BoundaryRef& boundary);
    /// A selected action: an outline over its stretch.
    void paintSelection(const Track& track, const ActionRef& action);
    /// The button on top of a boundary that removes or restores it.
    void paintHandle(const QRectF& handle, bool live, bool under);

private:
    void paintBoundary(const Track& track, const BoundaryMark& mark, double x, double density);
    void paintNoteMark(const QRectF& block);

    QPainter& painter_;
    const Session& session_;
    const Colours& colours_;
    const TimeMapping& mapping_;
};

}  // namespace kumite::studio
