#include "studio/app/import/import_preview.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

constexpr int kPlotHeight = 112;
constexpr int kGap = 8;
constexpr double kMargin = 0.25;  // metres around the fighters

/// The largest of 1, 2, 5 × 10ⁿ that cuts `range` into at least `pieces`.
double niceStep(double range, double pieces) {
    const double raw = std::max(1e-6, range / pieces);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double step : {5.0, 2.0}) {
        if (raw >= step * power) return step * power;
    }
    return power;
}

/// Metres of the bout's space to pixels of a view; y grows upwards or, from above, z downwards.
struct Mapping {
    double scale = 1;
    QPointF middle;  // pixels
    double across = 0, along = 0;
    bool fromAbove = false;

    QPointF operator()(const Eigen::Vector3d& point) const {
        const double up = fromAbove ? -point.z() : point.y();
        return middle + QPointF((point.x() - across) * scale, -(up - along) * scale);
    }
};

Mapping mappingFor(const ImportLook& look, const QRectF& rect, bool fromAbove) {
    Mapping map;
    map.fromAbove = fromAbove;
    const double width = look.high.x() - look.low.x() + 2 * kMargin;
    const double bottom = fromAbove ? -look.high.z() : std::min(0.0, look.low.y());
    const double top = fromAbove ? -look.low.z() : look.high.y();
    const double height = top - bottom + 2 * kMargin;
    map.scale = std::min(rect.width() / width, rect.height() / height);
    map.middle = rect.center();
    map.across = (look.high.x() + look.low.x()) / 2;
    map.along = (top + bottom) / 2;
    return map;
}

}  // namespace

ImportPreview::ImportPreview(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 300);
    setAccessibleName(tr("Preview of both fighters"));
    setAccessibleDescription(tr("From above, from the side, and their distance over time"));
    setToolTip(tr("Space plays, ← → steps, a drag on the distance scrubs"));
    timer_.setInterval(16);
    connect(&timer_, &QTimer::timeout, this, &ImportPreview::advance);
}

void ImportPreview::setLook(std::shared_ptr<const ImportLook> look, const QString& text) {
    look_ = std::move(look);
    text_ = text;
    if (!look_ && timer_.isActive()) togglePlaying();
    if (look_) seconds_ = std::clamp(seconds_, look_->span.begin, look_->span.end);
    update();
}

void ImportPreview::togglePlaying() {
    if (timer_.isActive()) {
        timer_.stop();
    } else if (look_) {
        if (seconds_ >= look_->span.end) seconds_ = look_->span.begin;
        clock_.start();
        timer_.start();
    }
    Q_EMIT playingChanged();
}

void ImportPreview::advance() {
    const double passed = static_cast<double>(clock_.restart()) / 1000.0;
    goTo(seconds_ + passed);
    if (seconds_ >= look_->span.end) togglePlaying();
}

void ImportPreview::goTo(double seconds) {
    if (!look_) return;
    seconds_ = std::clamp(seconds, look_->span.begin, look_->span.end);
    update();
}

QRectF ImportPreview::plotRect() const {
    const bool has = look_ && !look_->distances.empty();
    const double line = fontMetrics().height();
    const double left = withTextSize(44);
    const double height = has ? withTextSize(kPlotHeight) : line + 8;
    return QRectF(left, this->height() - height, width() - left - 12, height - line - 6);
}

QRectF ImportPreview::viewRect(bool fromAbove) const {
    const double bottom = plotRect().top() - kGap - fontMetrics().height();
    const double half = (width() - kGap) / 2.0;
    return {fromAbove ? 0.0 : half + kGap, 0, half, bottom};
}

void ImportPreview::paintView(QPainter& painter, bool fromAbove) const {
    const Colours& c = coloursFor(palette());
    const QRectF rect = viewRect(fromAbove);
    painter.save();
    painter.setClipRect(rect);
    painter.fillRect(rect, c.ground);
    const QRectF inner = rect.adjusted(8, fontMetrics().height() + 6, -8, -8);
    const Mapping map = mappingFor(*look_, inner, fromAbove);
    painter.setPen(QPen(c.line, 1));
    // A grid of metres; from the side the floor alone.
    const double reach = std::hypot(rect.width(), rect.height()) / map.scale;
    const double step = niceStep(reach, 12) < 1 ? 1 : niceStep(reach, 12);
    if (fromAbove) {
        for (double at = -std::ceil(reach / step) * step; at <= reach; at += step) {
            const double x = std::round(map.across / step) * step + at;
            const double z = std::round(-map.along / step) * step + at;
            const double px = map({x, 0, 0}).x();
            const double pz = map({0, 0, z}).y();
            painter.drawLine(QPointF(px, rect.top()), QPointF(px, rect.bottom()));
            painter.drawLine(QPointF(rect.left(), pz), QPointF(rect.right(), pz));
        }
    } else {
        const double floor = map({0, 0, 0}).y();
        painter.setPen(QPen(c.secondText, 1));
        painter.drawLine(QPointF(rect.left(), floor), QPointF(rect.right(), floor));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const int players = static_cast<int>(look_->imported.take.fighters.size());
    for (int player = 0; player < players; ++player) {
        const auto& fighter = look_->imported.take.fighters[static_cast<std::size_t>(player)];
        const auto pose = poseAt(*look_, player, seconds_);
        painter.setPen(QPen(c.fighters[player], 3, Qt::SolidLine, Qt::RoundCap));
        for (int joint = 1; joint < fighter.motion->skeleton->jointCount(); ++joint) {
            const auto index = static_cast<std::size_t>(joint);
            const int parent = fighter.motion->skeleton->joints[index].parent;
            if (parent < 0) continue;
            painter.drawLine(map(pose[static_cast<std::size_t>(parent)]), map(pose[index]));
        }
        if (const auto head = fighter.roles[Role::Head]) {
            painter.setBrush(c.fighters[player]);
            painter.setPen(Qt::NoPen);
            const double radius = std::max(2.5, 0.1 * map.scale);
            painter.drawEllipse(map(pose[static_cast<std::size_t>(*head)]), radius, radius);
        }
    }
    painter.setPen(c.secondText);
    painter.drawText(rect.adjusted(8, 4, -8, 0), Qt::AlignLeft | Qt::AlignTop,
                     fromAbove ? tr("from above, grid %1 m").arg(step) : tr("from the side"));
    painter.restore();
}

void ImportPreview::paintPlot(QPainter& painter) const {
    const Colours& c = coloursFor(palette());
    const QRectF rect = plotRect();
    const auto& distances = look_->distances;
    const double length = std::max(1e-9, look_->span.end - look_->span.begin);
    const auto xOf = [&](double seconds) {
        return rect.left() + rect.width() * (seconds - look_->span.begin) / length;
    };
    painter.setPen(c.secondText);
    const double line = fontMetrics().height();
    const QString time = timeText(seconds_);
    const QString now =
        distances.empty()
            ? time
            : tr("%1   distance %2 m").arg(time, numberText(look_->distanceAt(seconds_), 2));
    const QRectF caption(0, rect.top() - line - 2, width() - 4, line);
    painter.drawText(caption, Qt::AlignRight | Qt::AlignVCenter, now);
    const double step = niceStep(length, std::min(6.0, rect.width() / withTextSize(64.0)));
    if (!distances.empty()) {
        const double rest = caption.width() - fontMetrics().horizontalAdvance(now) - 8;
        painter.drawText(caption, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(tr("distance of the pelvises, m"), Qt::ElideRight,
                                                  static_cast<int>(rest)));
        const double high = *std::max_element(distances.begin(), distances.end());
        const double most = std::max(0.5, high * 1.1);
        const double rung = niceStep(most, std::min(2.5, rect.height() / line));
        const auto yOf = [&](double metres) {
            return rect.bottom() - rect.height() * metres / most;
        };
        for (double metres = 0; metres <= most; metres += rung) {
            painter.setPen(c.line);
            painter.drawLine(QPointF(rect.left(), yOf(metres)), QPointF(rect.right(), yOf(metres)));
            painter.setPen(c.secondText);
            painter.drawText(QRectF(0, yOf(metres) - line / 2, rect.left() - 6, line),
                             Qt::AlignRight | Qt::AlignVCenter, numberText(metres));
        }
        QPainterPath curve;
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const QPointF point(rect.left() + rect.width() * static_cast<double>(i) /
                                                  static_cast<double>(distances.size() - 1),
                                yOf(distances[i]));
            i == 0 ? curve.moveTo(point) : curve.lineTo(point);
        }
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(c.text, 1.2));
        painter.drawPath(curve);
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
    painter.setPen(c.secondText);
    for (double at = std::ceil(look_->span.begin / step) * step; at <= look_->span.end;
         at += step) {
        painter.drawText(
            QRectF(xOf(at) - withTextSize(40), rect.bottom() + 3, withTextSize(80), line),
            Qt::AlignHCenter, timeText(at, step));
    }
    painter.setPen(QPen(c.accent, 1.5));
    painter.drawLine(QPointF(xOf(seconds_), rect.top()), QPointF(xOf(seconds_), rect.bottom()));
}

void ImportPreview::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const Colours& c = coloursFor(palette());
    if (!look_) {
        painter.fillRect(rect(), c.ground);
        painter.setPen(c.secondText);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         text_.isEmpty() ? tr("Both fighters move here once their recordings are "
                                              "read. Choose them above, or drop them here.")
                                         : text_);
        return;
    }
    paintView(painter, true);
    paintView(painter, false);
    paintPlot(painter);
    if (hasFocus()) {
        painter.setPen(QPen(c.accent, 1));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void ImportPreview::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) mouseMoveEvent(event);
}

void ImportPreview::mouseMoveEvent(QMouseEvent* event) {
    const QRectF plot = plotRect();
    if (!look_ || event->position().y() < plot.top() - 4) return;
    const double share = (event->position().x() - plot.left()) / plot.width();
    goTo(look_->span.begin + share * (look_->span.end - look_->span.begin));
}

void ImportPreview::keyPressEvent(QKeyEvent* event) {
    if (!look_) return QWidget::keyPressEvent(event);
    const double frame = 1.0 / look_->imported.take.fighters.front().rate;
    switch (event->key()) {
        case Qt::Key_Space:
            return togglePlaying();
        case Qt::Key_Left:
            return goTo(seconds_ - frame);
        case Qt::Key_Right:
            return goTo(seconds_ + frame);
        case Qt::Key_Home:
            return goTo(look_->span.begin);
        case Qt::Key_End:
            return goTo(look_->span.end);
        default:
            QWidget::keyPressEvent(event);
    }
}

}  // namespace kumite::studio
