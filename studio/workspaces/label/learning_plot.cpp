#include "studio/workspaces/label/learning_plot.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

const QColor kAsked("#009e73");

QPainterPath pathOf(const std::vector<QPointF>& points) {
    QPainterPath path;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i == 0) {
            path.moveTo(points[i]);
        } else {
            path.lineTo(points[i]);
        }
    }
    return path;
}

/// The last point at or before so many labels; nothing where the curve begins later.
template <typename Point, typename LabelsOf>
const Point* lastBefore(const std::vector<Point>& points, double labels, LabelsOf labelsOf) {
    const Point* last = nullptr;
    for (const Point& point : points) {
        if (labelsOf(point) <= labels + 0.5) last = &point;
    }
    return last;
}

}  // namespace

QPointF LearningPlotAxes::pointOf(double labels, double share) const {
    return {area.left() + labels / mostLabels * area.width(),
            area.bottom() - (share - leastShare) / (1 - leastShare) * area.height()};
}

double LearningPlotAxes::labelsAt(double x) const {
    return (x - area.left()) / area.width() * mostLabels;
}

LearningPlotAxes axesOf(const LearningPlotValues& values, const QRectF& area) {
    LearningPlotAxes axes;
    axes.area = area;
    double most = 10;
    double least = 1;
    for (const QPointF& point : values.expected) {
        most = std::max(most, point.x());
        least = std::min(least, point.y());
    }
    for (const OrderPoint& point : values.orders.points) {
        most = std::max<double>(most, point.labelled);
        least = std::min({least, point.asked, point.random});
    }
    axes.leastShare = std::clamp(std::floor(10 * least - 0.5) / 10, 0.0, 0.9);
    // About four steps of 1, 2 or 5 times a power of ten.
    const double power = std::pow(10.0, std::floor(std::log10(most / 4)));
    const double rest = most / 4 / power;
    axes.labelStep = std::max(1, int(std::lround(power * (rest < 1.5 ? 1 : rest < 3.5 ? 2 : 5))));
    axes.mostLabels = int(std::ceil(most / axes.labelStep)) * axes.labelStep;
    return axes;
}

LearningPlot::LearningPlot(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setAccessibleName(tr("Learning curve"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

bool LearningPlot::isEmpty() const {
    return values_.expected.empty() && values_.orders.points.empty();
}

void LearningPlot::show(const LearningPlotValues& values) {
    values_ = values;
    setAccessibleDescription(textAt(axes().mostLabels));
    update();
}

LearningPlotAxes LearningPlot::axes() const {
    const QFontMetricsF metrics(font());
    const double left = metrics.horizontalAdvance(QStringLiteral("100 %")) + 6;
    const double top = metrics.height() + 4;  // the legend
    return axesOf(values_,
                  QRectF(left, top, width() - left - 8, height() - top - 2 * metrics.height() - 6));
}

QString LearningPlot::textAt(double labels) const {
    QStringList parts;
    double shown = 0;
    const QPointF* expected =
        lastBefore(values_.expected, labels, [](const QPointF& p) { return p.x(); });
    const OrderPoint* order = lastBefore(values_.orders.points, labels,
                                         [](const OrderPoint& p) { return double(p.labelled); });
    if (expected != nullptr) {
        shown = expected->x();
        parts.append(tr("expected %1").arg(percentText(expected->y())));
    }
    if (order != nullptr) {
        shown = std::max<double>(shown, order->labelled);
        parts.append(tr("as asked %1").arg(percentText(order->asked)));
        parts.append(tr("random %1").arg(percentText(order->random)));
    }
    if (parts.isEmpty()) return {};
    return tr("%1 labels: %2").arg(int(shown)).arg(parts.join(QStringLiteral(", ")));
}

void LearningPlot::mouseMoveEvent(QMouseEvent* event) {
    const LearningPlotAxes now = axes();
    pointer_ = std::clamp(now.labelsAt(event->position().x()), 0.0, double(now.mostLabels));
    Q_EMIT pointed(textAt(*pointer_));
    update();
}

void LearningPlot::leaveEvent(QEvent*) {
    pointer_.reset();
    Q_EMIT pointed({});
    update();
}

void LearningPlot::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) update();
    QWidget::changeEvent(event);
}

void LearningPlot::paintAxes(QPainter& painter, const LearningPlotAxes& axes) const {
    const Colours& c = coloursFor(palette());
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    const double stepOfShares = axes.leastShare < 0.55 ? 0.25 : axes.leastShare < 0.8 ? 0.1 : 0.05;
    for (double share = 1; share > axes.leastShare - 1e-9; share -= stepOfShares) {
        const double y = std::round(axes.pointOf(0, share).y()) + 0.5;
        painter.setPen(QPen(c.line, 1));
        painter.drawLine(QPointF(axes.area.left(), y), QPointF(axes.area.right(), y));
        painter.setPen(c.secondText);
        painter.drawText(QRectF(0, y - line / 2, axes.area.left() - 6, line),
                         Qt::AlignRight | Qt::AlignVCenter, percentText(share));
    }
    for (int labels = 0; labels <= axes.mostLabels; labels += axes.labelStep) {
        const double x = axes.pointOf(labels, 0).x();
        painter.setPen(c.secondText);
        const QString text = QString::number(labels);
        const double width = metrics.horizontalAdvance(text) + 4;
        const double left = std::min(x - width / 2, this->width() - width);
        painter.drawText(QRectF(left, axes.area.bottom() + 2, width, line), Qt::AlignCenter, text);
    }
    painter.drawText(
        QRectF(axes.area.left(), axes.area.bottom() + 2 + line, axes.area.width(), line),
        Qt::AlignCenter, tr("labels by hand"));
}

void LearningPlot::paintCurves(QPainter& painter, const LearningPlotAxes& axes) const {
    const Colours& c = coloursFor(palette());
    std::vector<QPointF> expected, asked, random;
    for (const QPointF& point : values_.expected)
        expected.push_back(axes.pointOf(point.x(), point.y()));
    for (const OrderPoint& point : values_.orders.points) {
        asked.push_back(axes.pointOf(point.labelled, point.asked));
        random.push_back(axes.pointOf(point.labelled, point.random));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(c.secondText, 1.5, Qt::DashLine));
    painter.drawPath(pathOf(random));
    painter.setPen(QPen(kAsked, 2));
    painter.drawPath(pathOf(asked));
    painter.setPen(QPen(c.text, 1.5));
    painter.drawPath(pathOf(expected));
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.text);
    for (const QPointF& point : expected)
        painter.drawEllipse(point, 1.8, 1.8);
    if (values_.mayStop && !expected.empty()) {
        painter.setBrush(c.accent);
        painter.drawEllipse(expected.back(), 4, 4);
        painter.setPen(QPen(c.accent, 1, Qt::DotLine));
        painter.drawLine(expected.back(), QPointF(expected.back().x(), axes.area.bottom()));
    }
    if (pointer_) {
        const double x = axes.pointOf(*pointer_, 0).x();
        painter.setPen(QPen(c.accent, 1));
        painter.drawLine(QPointF(x, axes.area.top()), QPointF(x, axes.area.bottom()));
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void LearningPlot::paintLegend(QPainter& painter, const LearningPlotAxes& axes) const {
    const Colours& c = coloursFor(palette());
    const QFontMetricsF metrics(font());
    const double top = axes.area.top();
    if (pointer_) {
        painter.setPen(c.text);
        painter.drawText(QRectF(0, 0, width(), top - 2), Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(textAt(*pointer_), Qt::ElideRight, width()));
        return;
    }
    struct Entry {
        QPen pen;
        QString text;
    };
    std::vector<Entry> entries;
    if (!values_.expected.empty()) entries.push_back({QPen(c.text, 1.5), tr("expected")});
    if (!values_.orders.points.empty()) {
        entries.push_back({QPen(kAsked, 2), tr("as asked")});
        entries.push_back({QPen(c.secondText, 1.5, Qt::DashLine), tr("random")});
    }
    constexpr double kLine = 10, kGap = 3, kBetween = 8;
    double all = -kBetween;
    for (const Entry& entry : entries)
        all += kLine + kGap + metrics.horizontalAdvance(entry.text) + kBetween;
    // Above the curves, or as far left as a narrow panel asks for.
    double x = std::max(0.0, std::min(axes.area.left(), width() - all));
    for (const Entry& entry : entries) {
        painter.setPen(entry.pen);
        painter.drawLine(QPointF(x, top / 2 - 1), QPointF(x + kLine, top / 2 - 1));
        x += kLine + kGap;
        painter.setPen(c.secondText);
        const double wide = metrics.horizontalAdvance(entry.text);
        painter.drawText(QRectF(x, 0, wide + 2, top - 2), Qt::AlignVCenter, entry.text);
        x += wide + kBetween;
    }
}

void LearningPlot::paintEvent(QPaintEvent*) {
    if (isEmpty()) return;
    QPainter painter(this);
    const LearningPlotAxes now = axes();
    paintAxes(painter, now);
    paintCurves(painter, now);
    paintLegend(painter, now);
}

}  // namespace kumite::studio
