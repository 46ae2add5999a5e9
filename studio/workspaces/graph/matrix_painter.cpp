#include "studio/workspaces/graph/matrix_painter.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

constexpr double kNumberCell = 30;  ///< cells from this size on hold their number
constexpr double kLineCell = 10;    ///< from this on they stand apart

QString cellText(double value, bool difference) {
    if (std::abs(value) < 0.005) return {};
    QString text = numberText(std::abs(value), 2);
    if (text.startsWith(QLatin1Char('0'))) text.remove(0, 1);
    if (!difference) return text;
    return (value < 0 ? QStringLiteral("−") : QStringLiteral("+")) + text;
}

}  // namespace

MatrixPainter::MatrixPainter(QPainter& painter, const MatrixTable& table, const MatrixOrder& order,
                             const MatrixGrid& grid, const ColourScale& scale,
                             const Colours& colours)
    : painter_(painter),
      table_(table),
      order_(order),
      grid_(grid),
      scale_(scale),
      colours_(colours) {}

double MatrixPainter::nameRoom(const QFontMetrics& metrics,
                               const std::vector<MatrixTable::Line>& lines, double most) {
    double widest = 40;
    for (const MatrixTable::Line& line : lines)
        widest = std::max(widest, metrics.horizontalAdvance(line.name) + 14.0);
    return std::min(widest, most);
}

void MatrixPainter::paint() {
    painter_.fillRect(QRectF(QPointF(), grid_.view), colours_.ground);
    painter_.save();
    painter_.setClipRect(grid_.body());
    paintCells();
    painter_.restore();
    paintRowNames();
    paintColumnNames();
}

void MatrixPainter::paintCells() {
    const auto rows = grid_.visibleRows();
    const auto columns = grid_.visibleColumns();
    const double gap = grid_.cell >= kLineCell ? 1 : 0;
    const bool numbers = grid_.cell >= kNumberCell;
    for (int row = rows.begin; row < rows.end; ++row) {
        for (int column = columns.begin; column < columns.end; ++column) {
            const MatrixPlace at = order_.inTable({row, column});
            const double value = table_.values(at.row, at.column);
            const QColor colour = scale_.colourOf(value);
            const QRectF rect = grid_.cellRect({row, column});
            painter_.fillRect(rect.adjusted(0, 0, -gap, -gap), colour);
            if (!numbers) {
                // What was never seen is told from what was, whatever the prior says.
                if (grid_.cell >= kLineCell && table_.counts(at.row, at.column) > 0) {
                    painter_.fillRect(QRectF(rect.center() - QPointF(1, 1), QSizeF(2, 2)),
                                      withAlpha(inkOn(colour), 0.6));
                }
                continue;
            }
            const QString text = cellText(value, table_.isDifference);
            if (text.isEmpty()) continue;
            painter_.setPen(inkOn(colour));
            painter_.drawText(rect, Qt::AlignCenter, text);
        }
    }
    for (const int group : order_.groups) {
        if (group < rows.begin || group > rows.end) continue;
        const QRectF first = grid_.cellRect({group, 0});
        const double right = grid_.cellRect({group, grid_.columns}).left();
        painter_.fillRect(QRectF(first.left(), first.top() - 1, right - first.left(), 1),
                          colours_.secondText);
    }
}

void MatrixPainter::paintRowNames() {
    painter_.save();
    painter_.setClipRect(QRectF(0, grid_.columnHeader, grid_.rowHeader, grid_.body().height()));
    const QFontMetrics metrics = painter_.fontMetrics();
    const auto rows = grid_.visibleRows();
    // Where cells are lower than a line of text, only as many names as have room.
    const int step = std::max(1, static_cast<int>(std::ceil((metrics.height() - 4) / grid_.cell)));
    for (int row = rows.begin; row < rows.end; ++row) {
        if (row % step != 0) continue;
        const auto& line = table_.rows[static_cast<std::size_t>(order_.inTable({row, 0}).row)];
        const QRectF rect = grid_.rowName(row);
        painter_.setPen(colours_.text);
        painter_.drawText(
            QRectF(4, rect.center().y() - metrics.height() / 2.0, rect.width() - 10,
                   metrics.height()),
            Qt::AlignRight | Qt::AlignVCenter,
            metrics.elidedText(line.name, Qt::ElideMiddle, static_cast<int>(rect.width() - 10)));
    }
    painter_.restore();
}

void MatrixPainter::paintColumnNames() {
    painter_.save();
    painter_.setClipRect(QRectF(grid_.rowHeader, 0, grid_.body().width(), grid_.columnHeader));
    const QFontMetrics metrics = painter_.fontMetrics();
    const auto columns = grid_.visibleColumns();
    const int step = std::max(1, static_cast<int>(std::ceil((metrics.height() - 4) / grid_.cell)));
    painter_.setPen(colours_.text);
    for (int column = columns.begin; column < columns.end; ++column) {
        if (column % step != 0) continue;
        const auto& line =
            table_.columns[static_cast<std::size_t>(order_.inTable({0, column}).column)];
        const QRectF rect = grid_.columnName(column);
        painter_.save();
        painter_.translate(rect.center().x(), rect.bottom() - 5);
        painter_.rotate(-90);
        const double room = grid_.columnHeader - 9;
        painter_.drawText(QRectF(0, -metrics.height() / 2.0, room, metrics.height()),
                          Qt::AlignLeft | Qt::AlignVCenter,
                          metrics.elidedText(line.name, Qt::ElideMiddle, static_cast<int>(room)));
        painter_.restore();
    }
    painter_.restore();
}

void MatrixPainter::paintFrame(const MatrixPlace& shown, const QColor& colour, bool band,
                               bool dashed) {
    const QRectF body = grid_.body();
    const double right = std::min(body.right(), grid_.cellRect({0, grid_.columns}).left());
    const double bottom = std::min(body.bottom(), grid_.cellRect({grid_.rows, 0}).top());
    const auto draw = [&](const QRectF& rect) {
        painter_.setPen(QPen(colour, 2, dashed ? Qt::DashLine : Qt::SolidLine));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawRect(rect.adjusted(0, 0, -1, -1));
    };
    painter_.save();
    painter_.setClipRect(QRectF(QPointF(0, 0), QPointF(right + 2, bottom + 2)));
    if (shown.row >= 0 && (band || !shown.isCell())) {
        const QRectF name = grid_.rowName(shown.row);
        if (name.top() >= body.top() - 1) {
            painter_.fillRect(name.adjusted(0, 0, -1, -1), withAlpha(colour, 0.18));
        }
    }
    if (shown.column >= 0 && (band || !shown.isCell())) {
        const QRectF name = grid_.columnName(shown.column);
        if (name.left() >= body.left() - 1) {
            painter_.fillRect(name.adjusted(0, 0, -1, -1), withAlpha(colour, 0.18));
        }
    }
    painter_.setClipRect(QRectF(body.topLeft(), QPointF(right + 2, bottom + 2)));
    if (shown.isCell()) {
        draw(grid_.cellRect(shown));
    } else if (shown.row >= 0) {
        const QRectF first = grid_.cellRect({shown.row, 0});
        draw(QRectF(QPointF(body.left(), first.top()), QPointF(right, first.bottom())));
    } else if (shown.column >= 0) {
        const QRectF first = grid_.cellRect({0, shown.column});
        draw(QRectF(QPointF(first.left(), body.top()), QPointF(first.right(), bottom)));
    }
    painter_.restore();
}

void MatrixPainter::paintLegend(const QRectF& area, const QString& caption) {
    const QFontMetrics metrics = painter_.fontMetrics();
    painter_.setPen(colours_.secondText);
    const double text = metrics.horizontalAdvance(caption);
    painter_.drawText(QRectF(area.left(), area.top(), text + 2, area.height()), Qt::AlignVCenter,
                      caption);
    const double left = area.left() + text + 10;
    const double width = std::min(220.0, area.right() - left - 24);
    if (width < 60) return;
    const double barHeight = 8;
    const QRectF bar(left, area.top() + 3, width, barHeight);
    const bool both = scale_.kind == ColourScale::Kind::Difference;
    for (int x = 0; x < static_cast<int>(width); ++x) {
        const double share = x / (width - 1);
        painter_.fillRect(QRectF(left + x, bar.top(), 1.2, barHeight),
                          scale_.colourAt(both ? 2 * share - 1 : share));
    }
    double free = area.left();  // what is right of the last number
    for (const ColourScale::Tick& tick : scale_.ticks()) {
        const double share = both ? 0.5 * (tick.position + 1) : tick.position;
        const double x = left + share * width;
        const double room = metrics.horizontalAdvance(tick.text) + 2;
        const double from = std::clamp(x - room / 2, left, area.right() - room);
        if (from < free) continue;
        free = from + room + 4;
        painter_.drawText(QRectF(from, bar.bottom() + 1, room, metrics.height()), Qt::AlignCenter,
                          tick.text);
    }
}

}  // namespace kumite::studio
