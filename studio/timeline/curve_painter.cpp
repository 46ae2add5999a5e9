#include "studio/timeline/curve_painter.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

namespace {

/// What is clipped need not be drawn to its end, pixels.
constexpr double kBeyond = 20;

/// Lines of one pixel are drawn much faster than wider ones: a wider curve of many samples is drawn
/// twice, half of the rest above and half below.
void paintLine(QPainter& painter, const CurvePyramid& curve, const SampleAxis& axis,
               const ValueAxis& values, const QRectF& plot, const QColor& colour, double width) {
    constexpr std::size_t kMany = 60;
    const SampleRange range = samplesWithin(axis, curve.size(), plot.left(), plot.right());
    QPolygonF line;
    line.reserve(static_cast<qsizetype>(range.end - range.begin));
    for (std::size_t i = range.begin; i < range.end; ++i) {
        line << QPointF(axis.xOf(static_cast<double>(i)),
                        std::clamp(values.yOf(curve.at(i), plot), plot.top() - kBeyond,
                                   plot.bottom() + kBeyond));
    }
    const bool twice = width > 1 && range.end - range.begin > kMany;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, twice ? 1.0 : width));
    if (twice) {
        line.translate(0, (1 - width) / 2);
        painter.drawPolyline(line);
        line.translate(0, width - 1);
    }
    painter.drawPolyline(line);
}

/// A rectangle of whole pixels per column.
void paintColumns(QPainter& painter, const CurvePyramid& curve, const SampleAxis& axis,
                  const ValueAxis& values, const QRectF& plot, const QColor& colour, double width) {
    QList<QRect> columns;
    for (const CurveColumn& column : curveColumns(curve, axis, plot.left(), plot.right())) {
        const double high = std::max(values.yOf(column.high, plot), plot.top() - kBeyond);
        const double low = std::min(values.yOf(column.low, plot), plot.bottom() + kBeyond);
        const int top = static_cast<int>(std::lround(high - width / 2));
        const int bottom = static_cast<int>(std::lround(low + width / 2));
        columns.append(
            QRect(static_cast<int>(std::floor(column.x)), top, 1, std::max(1, bottom - top)));
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRects(columns.constData(), static_cast<int>(columns.size()));
    painter.restore();
}

}  // namespace

void paintCurve(QPainter& painter, const CurvePyramid& curve, const SampleAxis& axis,
                const ValueAxis& values, const QRectF& plot, const QColor& colour, double width) {
    if (curve.size() == 0) return;
    const auto paint = needsColumns(axis) ? paintColumns : paintLine;
    paint(painter, curve, axis, values, plot, colour, width);
}

}  // namespace kumite::studio
