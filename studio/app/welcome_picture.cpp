#include "studio/app/welcome_picture.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

constexpr int kWidth = 760;
constexpr int kHeight = 316;
constexpr double kFloor = 196;    // pixels from the top
constexpr double kMetre = 98;     // pixels
constexpr double kCaptions = 84;  // pixels that the rows' captions take
constexpr double kRowHeight = 48;
constexpr double kStrip = 14;

using Limb = std::vector<QPointF>;  // metres, x forward, y up

/// A drawn person who looks along +x.
struct Pose {
    QPointF head;
    Limb trunk;
    std::array<Limb, 2> far;   ///< arm and leg behind the trunk
    std::array<Limb, 2> near;  ///< arm and leg before it
};

const Pose kPunch = {{0.13, 1.58},
                     {{0.07, 1.38}, {-0.04, 0.95}},
                     {{{{0.02, 1.37}, {-0.12, 1.12}, {0.16, 1.30}},
                       {{-0.06, 0.92}, {-0.26, 0.52}, {-0.58, 0.12}, {-0.45, 0.05}}}},
                     {{{{0.09, 1.38}, {0.38, 1.36}, {0.68, 1.42}},
                       {{-0.01, 0.92}, {0.27, 0.56}, {0.24, 0.10}, {0.41, 0.05}}}}};

const Pose kKick = {{-0.36, 1.54},
                    {{-0.25, 1.36}, {-0.01, 0.98}},
                    {{{{-0.28, 1.34}, {-0.50, 1.12}, {-0.36, 0.94}},
                      {{-0.02, 0.95}, {-0.09, 0.52}, {-0.02, 0.10}, {0.14, 0.05}}}},
                    {{{{-0.22, 1.35}, {-0.03, 1.20}, {0.03, 1.42}},
                      {{0.04, 0.98}, {0.40, 1.14}, {0.76, 1.33}, {0.87, 1.43}}}}};

void drawLimb(QPainter& painter, const Limb& limb, const QColor& colour, double thickness) {
    QPainterPath path(limb.front());
    for (std::size_t i = 1; i < limb.size(); ++i)
        path.lineTo(limb[i]);
    painter.setPen(QPen(colour, thickness, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

/// `facing` 1 looks to the right, -1 to the left.
void drawPerson(QPainter& painter, const Pose& pose, double x, int facing, const QColor& colour,
                const Colours& c) {
    painter.save();
    painter.translate(x, kFloor);
    painter.setPen(Qt::NoPen);
    painter.setBrush(withAlpha(Qt::black, c.dark ? 0.35 : 0.10));
    painter.drawEllipse(QPointF(0, 2), 52, 6);
    painter.scale(facing * kMetre, -kMetre);
    const QColor far = mixed(colour, c.ground, 0.42);
    for (const Limb& limb : pose.far)
        drawLimb(painter, limb, far, 0.105);
    drawLimb(painter, pose.trunk, colour, 0.23);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(pose.head, 0.115, 0.135);
    for (const Limb& limb : pose.near)
        drawLimb(painter, limb, colour, 0.105);
    painter.restore();
}

void drawForce(QPainter& painter, QPointF foot, double length, const QColor& colour) {
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::FlatCap));
    const QPointF tip = foot - QPointF(0, length);
    painter.drawLine(foot, tip + QPointF(0, 6));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF({tip, tip + QPointF(-4.5, 8), tip + QPointF(4.5, 8)}));
}

/// A row of the drawn timeline: where it is cut, as shares of its length, and how high the curve
/// rises between two cuts.
struct Row {
    std::vector<double> cuts;
    std::vector<double> rises;
    int spurious;  ///< cut that the picture marks as suspicious; -1: none
};

const Row kFirstRow = {{0, .09, .19, .32, .40, .455, .60, .70, .83, .92, 1},
                       {.5, .9, .6, 1.0, .16, .95, .5, .85, .4, .7},
                       5};
const Row kSecondRow = {
    {0, .14, .26, .36, .50, .58, .66, .80, .90, 1}, {.7, .45, .95, .6, .8, .4, 1.0, .55, .8}, -1};

void drawRow(QPainter& painter, const QRectF& area, const Row& row, const QColor& colour,
             const QColor& line, const Colours& c) {
    const QRectF strip(area.left(), area.bottom() - kStrip, area.width(), kStrip);
    const QRectF plot = area.adjusted(0, 4, 0, -kStrip - 3);
    const auto xOf = [&](double share) { return area.left() + share * area.width(); };
    QPainterPath curve;
    for (std::size_t i = 0; i + 1 < row.cuts.size(); ++i) {
        const double from = row.cuts[i];
        const double to = row.cuts[i + 1];
        constexpr int kSteps = 24;
        for (int step = 0; step <= kSteps; ++step) {
            const double u = static_cast<double>(step) / kSteps;
            const double bump = std::sin(std::numbers::pi * u);
            const double y = plot.bottom() - 3 - row.rises[i] * (plot.height() - 5) * bump * bump;
            const QPointF at(xOf(from + u * (to - from)), y);
            curve.elementCount() == 0 ? curve.moveTo(at) : curve.lineTo(at);
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(mixed(c.ground, colour, i % 2 == 0 ? 0.50 : 0.36));
        painter.drawRect(
            QRectF(xOf(from) + 0.75, strip.top(), xOf(to) - xOf(from) - 1.5, strip.height()));
    }
    painter.setPen(QPen(withAlpha(c.secondText, 0.45), 1));
    for (std::size_t i = 1; i + 1 < row.cuts.size(); ++i) {
        const double x = std::round(xOf(row.cuts[i])) + 0.5;
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, strip.bottom()));
    }
    painter.setPen(QPen(line, 1.75, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(curve);
    if (row.spurious < 0) return;
    const QPointF mark(xOf(row.cuts[static_cast<std::size_t>(row.spurious)]), plot.bottom() - 3);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.accent);
    painter.drawPolygon(QPolygonF({mark + QPointF(0, -5), mark + QPointF(5, 0),
                                   mark + QPointF(0, 5), mark + QPointF(-5, 0)}));
}

}  // namespace

WelcomePicture::WelcomePicture(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);  // it does not grow with the text
    setAccessibleName(
        tr("Two fighters over the curves of their contact force, which is cut into "
           "actions at its minima"));
}

QSize WelcomePicture::sizeHint() const {
    return {kWidth, kHeight};
}

void WelcomePicture::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 100 / textSize());
    painter.setFont(small);
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
    painter.fillPath(frame, c.ground);
    painter.setClipPath(frame);

    // The floor in perspective.
    const double vanishing = kFloor - 150;
    painter.setPen(QPen(mixed(c.ground, c.line, 0.8), 1));
    for (int i = -14; i <= 14; ++i) {
        const double near = kWidth / 2.0 + i * 96;
        const double far = kWidth / 2.0 + i * 44;
        painter.drawLine(QPointF(far, kFloor - 34), QPointF(near, kFloor + 24));
    }
    for (const double y : {kFloor - 34, kFloor - 20, kFloor - 2, kFloor + 22})
        painter.drawLine(QPointF(0, y), QPointF(kWidth, y));
    QLinearGradient haze(0, vanishing, 0, kFloor + 10);
    haze.setColorAt(0.7, c.ground);
    haze.setColorAt(1, withAlpha(c.ground, 0));
    painter.fillRect(QRectF(0, 0, kWidth, kFloor + 10), haze);

    constexpr double kLeftX = 312;
    constexpr double kRightX = 478;
    drawPerson(painter, kKick, kRightX, -1, c.fighters[1], c);
    drawPerson(painter, kPunch, kLeftX, 1, c.fighters[0], c);
    drawForce(painter, {kLeftX - 14, kFloor + 2}, 56, mixed(c.fighters[0], Qt::white, 0.55));
    drawForce(painter, {kRightX + 20, kFloor + 2}, 84, mixed(c.fighters[1], Qt::white, 0.55));

    // The two rows of the timeline below them.
    const double top = kFloor + 24;
    painter.fillRect(QRectF(0, top - 8, kWidth, kHeight - top + 8), c.panel);
    const std::array<const Row*, 2> rows = {&kFirstRow, &kSecondRow};
    for (int i = 0; i < 2; ++i) {
        const QRectF area(kCaptions, top + i * kRowHeight, kWidth - kCaptions - 12, kRowHeight - 8);
        drawRow(painter, area, *rows[static_cast<std::size_t>(i)], c.fighters[i], c.fighterText[i],
                c);
        painter.setPen(c.secondText);
        painter.drawText(QRectF(12, area.top(), kCaptions - 16, kRowHeight - 8 - kStrip),
                         Qt::AlignLeft | Qt::AlignVCenter, tr("force"));
        painter.drawText(QRectF(12, area.bottom() - kStrip, kCaptions - 16, kStrip),
                         Qt::AlignLeft | Qt::AlignVCenter, tr("actions"));
    }
    const double playhead = std::round(kCaptions + 0.53 * (kWidth - kCaptions - 12)) + 0.5;
    painter.setPen(QPen(c.accent, 1.5));
    painter.drawLine(QPointF(playhead, top - 8), QPointF(playhead, kHeight));
    painter.setClipping(false);
    painter.setPen(QPen(c.line, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(frame);
}

}  // namespace kumite::studio
