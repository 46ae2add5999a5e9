#include "studio/timeline/curve_painter.h"

#include <QPainter>

#include <algorithm>

namespace kumite::studio {

void paintCurve(QPainter& painter, const CurvePyramid& curve, const SampleAxis& axis,
                const ValueAxis& values, const QRectF& plot, const QColor& colour, double width) {
    if (curve.size() == 0) return;
    if (!needsColumns(axis)) {
        const SampleRange range = samplesWithin(axis, curve.size(), plot.left(), plot.right());
        QPolygonF line;
        line.reserve(static_cast<qsizetype>(range.end - range.begin));
        for (std::size_t i = range.begin; i < range.end; ++i) {
            line << QPointF(axis.xOf(static_cast<double>(i)), values.yOf(curve.at(i), plot));
        }
        painter.setPen(QPen(colour, width));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(line);
        return;
    }
    // A rectangle per column: what a stroked line of the same extent costs many times.
    for (const CurveColumn& column : curveColumns(curve, axis, plot.left(), plot.right())) {
        const double top = values.yOf(column.high, plot) - width / 2;
        const double bottom = values.yOf(column.low, plot) + width / 2;
        painter.fillRect(QRectF(column.x, top, 1, bottom - top), colour);
    }
}

}  // namespace kumite::studio
