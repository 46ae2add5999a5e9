#include "studio/view3d/stage_labels.h"

#include <QPainter>

#include <cmath>

#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

constexpr double kCentreRadius = 7;
constexpr double kPointRadius = 4;

/// A label's rectangle; `beside` is its left middle.
QRectF boxOf(const QFontMetrics& metrics, const QString& text, const QPointF& beside,
             const QRectF& within) {
    const QSizeF size(metrics.horizontalAdvance(text) + 12, metrics.height() + 6);
    QRectF box(beside - QPointF(0, size.height() / 2), size);
    if (box.right() > within.right() - 4) box.moveRight(within.right() - 4);
    if (box.left() < within.left() + 4) box.moveLeft(within.left() + 4);
    if (box.top() < within.top() + 4) box.moveTop(within.top() + 4);
    if (box.bottom() > within.bottom() - 4) box.moveBottom(within.bottom() - 4);
    return box;
}

QPointF besidePoint(const QPointF& at) {
    return at + QPointF(12, -14);
}

QPointF besideLine(const StageMarks::Distance& line) {
    return 0.5 * (line.from + line.to) + QPointF(10, 0);
}

void writeBox(QPainter& painter, const QRectF& box, const QString& text, const Colours& c) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(withAlpha(c.panel, 0.88));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(c.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

/// The sign for a centre of mass: a disc in quarters.
void drawCentre(QPainter& painter, const StageMarks::CentreOfMass& centre) {
    const QRectF disc(centre.at - QPointF(kCentreRadius, kCentreRadius),
                      QSizeF(2 * kCentreRadius, 2 * kCentreRadius));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor("#f4f4f4"));
    painter.drawEllipse(disc);
    painter.setBrush(QColor("#1a1b1e"));
    painter.drawPie(disc, 0, 90 * 16);
    painter.drawPie(disc, 180 * 16, 90 * 16);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(centre.colour, 2));
    painter.drawEllipse(disc);
}

void drawPoint(QPainter& painter, const QPointF& at, const Colours& c) {
    painter.setPen(QPen(c.dark ? QColor("#1a1b1e") : QColor("#ffffff"), 1.5));
    painter.setBrush(c.accent);
    painter.drawEllipse(at, kPointRadius, kPointRadius);
}

}  // namespace

StageLabels::StageLabels(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

void StageLabels::show(StageMarks marks) {
    if (marks == marks_) return;
    // Only what changes is drawn anew: all else would cost as much as the 3D picture itself.
    const QRegion before = extent();
    marks_ = std::move(marks);
    update(before.united(extent()));
}

QRegion StageLabels::extent() const {
    QRegion region;
    const auto add = [&](const QRectF& box) {
        region += box.adjusted(-3, -3, 3, 3).toAlignedRect();
    };
    const auto around = [](const QPointF& at, double radius) {
        return QRectF(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    };
    for (const auto& centre : marks_.centres)
        add(around(centre.at, kCentreRadius));
    for (const auto& edge : marks_.edges)
        add(QRectF(edge.from, edge.to).normalized());
    if (!marks_.dots.isEmpty()) add(marks_.dots.boundingRect());
    for (const auto& ring : marks_.rings)
        add(ring.points.boundingRect());
    for (const auto& handle : marks_.handles)
        add(around(handle.at, kPointRadius + 3));
    for (const auto& point : marks_.points) {
        add(around(point.at, kPointRadius));
        if (!point.text.isEmpty())
            add(boxOf(fontMetrics(), point.text, besidePoint(point.at), rect()));
    }
    if (marks_.distance) {
        const auto& line = *marks_.distance;
        add(QRectF(line.from, line.to).normalized());
        add(around(line.from, kPointRadius));
        add(around(line.to, kPointRadius));
        add(boxOf(fontMetrics(), line.text, besideLine(line), rect()));
    }
    return region.intersected(rect());
}

void StageLabels::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Colours& c = coloursFor(palette());
    for (const auto& centre : marks_.centres)
        drawCentre(painter, centre);
    if (marks_.distance) {
        const auto& line = *marks_.distance;
        painter.setPen(QPen(c.dark ? QColor(0, 0, 0, 140) : QColor(255, 255, 255, 170), 4));
        painter.drawLine(line.from, line.to);
        painter.setPen(QPen(c.accent, 2));
        painter.drawLine(line.from, line.to);
        drawPoint(painter, line.from, c);
        drawPoint(painter, line.to, c);
        writeBox(painter, boxOf(fontMetrics(), line.text, besideLine(line), rect()), line.text, c);
    }
    for (const auto& edge : marks_.edges) {
        painter.setPen(
            QPen(withAlpha(edge.strong ? c.accent : c.secondText, 0.8), edge.strong ? 1.5 : 1.0));
        painter.drawLine(edge.from, edge.to);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(withAlpha(c.accent, 0.55));
    for (const QPointF& dot : marks_.dots)
        painter.drawEllipse(dot, 1.3, 1.3);
    painter.setBrush(Qt::NoBrush);
    for (const auto& ring : marks_.rings) {
        const QColor axes[] = {QColor("#d9534f"), QColor("#4a9d4f"), QColor("#4478d6")};
        painter.setPen(QPen(axes[ring.axis % 3], ring.turned ? 3.5 : 2));
        painter.drawPolyline(ring.points);
    }
    for (const auto& handle : marks_.handles) {
        // A square stays where it is.
        const double radius = handle.chosen ? 7 : 5;
        const QRectF box(handle.at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
        painter.setPen(QPen(c.dark ? QColor("#ffffff") : QColor("#1e1f22"), 1.5));
        painter.setBrush(handle.chosen ? c.accent : withAlpha(c.ground, 0.7));
        if (handle.pinned) {
            painter.drawRect(box.adjusted(1, 1, -1, -1));
        } else {
            painter.drawEllipse(box);
        }
        painter.setBrush(Qt::NoBrush);
    }
    for (const auto& point : marks_.points) {
        drawPoint(painter, point.at, c);
        if (point.text.isEmpty()) continue;
        const QRectF box = boxOf(fontMetrics(), point.text, besidePoint(point.at), rect());
        writeBox(painter, box, point.text, c);
    }
}

}  // namespace kumite::studio
