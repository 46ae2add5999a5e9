#pragma once

#include <QRectF>

#include "studio/app/theme.h"
#include "studio/timeline/lanes.h"
#include "studio/timeline/time_mapping.h"

class QPainter;

namespace kumite::studio {

/// Where the lanes of a row lie.
struct LanePlace {
    QRectF area;
    double height = 0;       ///< of one lane
    bool collapsed = false;  ///< all of them in one strip, for want of room

    /// The lane at a height; -1 beside them, or collapsed.
    int laneAt(double y, int count) const;
};

/// The place that `count` lanes take of `room` pixels: of their usual height, lower ones, or a
/// single strip.
double laneHeight(double room, int count);

/// Paints a fighter's lanes. Cells that would fall on one pixel are gathered, what says something
/// before what says nothing, so that the time depends on the width, not on the number of actions.
void paintLanes(QPainter& painter, const LaneSource& lanes, const Session& session, int player,
                const LanePlace& place, const Colours& colours, const TimeMapping& mapping);

/// A vocabulary's colour on the ground of a theme: lighter or darker where it would not be seen.
QColor classColour(const QColor& colour, const Colours& colours);

}  // namespace kumite::studio
