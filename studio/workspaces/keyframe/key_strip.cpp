#include "studio/workspaces/keyframe/key_strip.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/wheel.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {
double rulerHeight() {
    return withTextSize(20.0);
}
constexpr double kMargin = 16;
constexpr double kShortest = 0.3, kLongest = 120;  // seconds visible
constexpr double kReach = 9;                       // pixels
}  // namespace

KeyStrip::KeyStrip(KeySession& keys, HitSession& hit, QWidget* parent)
    : QWidget(parent), keys_(keys), hit_(hit) {
    setAccessibleName(tr("Key poses over time"));
    setMouseTracking(true);
    setFocusPolicy(Qt::ClickFocus);
    setMinimumHeight(80);
    for (auto signal : {&KeySession::draftChanged, &KeySession::motionChanged, &KeySession::chosen,
                        &KeySession::moved, &KeySession::stateChanged})
        connect(&keys_, signal, this, qOverload<>(&QWidget::update));
    connect(&hit_, &HitSession::changed, this, [this] {
        setAccessibleName(hit_.isOn() ? tr("The strike over time") : tr("Key poses over time"));
        update();
    });
    connect(&hit_, &HitSession::moved, this, qOverload<>(&QWidget::update));
    connect(&keys_, &KeySession::draftChanged, this, [this] {
        const double last = keys_.lastFrame() / keys_.rate();
        if (last > begin_ + length_) length_ = std::min(kLongest, 1.2 * last - begin_);
    });
}

QSize KeyStrip::sizeHint() const {
    return {800, 120};
}

TimeMapping KeyStrip::mapping() const {
    return {begin_, begin_ + length_, kMargin, std::max(10.0, width() - 2 * kMargin)};
}

QPointF KeyStrip::placeOf(double frame) const {
    return {mapping().xOf(frame / keys_.rate()), rulerHeight() + (height() - rulerHeight()) / 2.0};
}

void KeyStrip::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    QPainter painter(this);
    painter.fillRect(rect(), c.ground);
    painter.setPen(c.line);
    painter.drawLine(QPointF(0, 0.5), QPointF(width(), 0.5));
    QFont small = font();
    small.setPointSizeF(std::max(7.5, small.pointSizeF() - 1.0));
    painter.setFont(small);
    paintRuler(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    if (hit_.isOn()) {
        paintHit(painter);
    } else {
        paintKeys(painter);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (hit_.isOn() && !hit_.motion()) return;
    const double now = hit_.isOn() ? hit_.seconds() : keys_.frame() / keys_.rate();
    const double head = std::floor(mapping().xOf(now)) + 0.5;
    painter.setPen(QPen(c.accent, 1.5));
    painter.drawLine(QPointF(head, 0), QPointF(head, height()));
}

void KeyStrip::paintRuler(QPainter& painter) const {
    const Colours& c = coloursFor(palette());
    const TimeMapping map = mapping();
    const double step = rulerStep(map.pixelsPerSecond(), 70);
    for (double t = step * std::floor(map.begin / step); t <= map.end; t += step) {
        const double x = std::round(map.xOf(t)) + 0.5;
        painter.setPen(c.line);
        painter.drawLine(QPointF(x, rulerHeight() - 5), QPointF(x, height()));
        painter.setPen(c.secondText);
        // A time that would be cut off is left out.
        const QString time = timeText(t, std::min(1.0, step));
        if (x + 3 + painter.fontMetrics().horizontalAdvance(time) > width()) continue;
        painter.drawText(QRectF(x + 3, 0, 90, rulerHeight() - 2), Qt::AlignLeft | Qt::AlignVCenter,
                         time);
    }
}

void KeyStrip::paintHit(QPainter& painter) const {
    const Colours& c = coloursFor(palette());
    const auto& motion = hit_.motion();
    if (!motion) {
        painter.setPen(c.secondText);
        painter.drawText(rect().adjusted(20, int(rulerHeight()), -20, 0),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         !hit_.problem().isEmpty() ? hit_.problem()
                         : hit_.jobs().isRunning() ? tr("The strikes are being aligned.")
                                                   : tr("No strike to bring to a target."));
        return;
    }
    const double rate = keys_.rate();
    const QPointF begin = placeOf(0), end = placeOf(motion->clip.seconds() * rate);
    painter.setPen(QPen(withAlpha(c.fighters[0], 0.6), 4));
    painter.drawLine(begin, end);
    const double moment = motion->hit / motion->clip.rate;
    const QPointF at = placeOf(moment * rate);
    painter.setPen(QPen(c.text, 1.2));
    painter.setBrush(c.accent);
    painter.drawEllipse(at, 7, 7);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(c.secondText);
    painter.drawText(QRectF(at.x() - withTextSize(60), at.y() + 9, withTextSize(120),
                            painter.fontMetrics().height()),
                     Qt::AlignCenter, tr("hit, %1").arg(timeText(moment, 0.01)));
}

void KeyStrip::paintKeys(QPainter& painter) const {
    const Colours& c = coloursFor(palette());
    const auto& keys = keys_.draft().track.keys;
    if (keys.empty()) {
        painter.setPen(c.secondText);
        painter.drawText(rect().adjusted(20, int(rulerHeight()), -20, 0),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         !keys_.problem().isEmpty()
                             ? keys_.problem()
                             : tr("No key poses yet. Return makes the first one, of the pose that "
                                  "the take shows now."));
    }
    if (keys.size() > 1) {
        const QColor colour = keys_.showsMotion() ? c.fighters[0] : c.secondText;
        painter.setPen(QPen(withAlpha(colour, 0.6), keys_.showsMotion() ? 4 : 2));
        painter.drawLine(placeOf(keys.front().frame), placeOf(keys.back().frame));
    }
    for (const KeyPose& key : keys) {
        const bool isDragged = dragged_ == std::optional(key.frame) && moved_;
        const QPointF at = placeOf(isDragged ? to_ : key.frame);
        const bool isChosen = keys_.key() == std::optional(key.frame);
        const double radius = isChosen ? 9 : 7;
        const QPointF diamond[] = {at + QPointF(0, -radius), at + QPointF(radius, 0),
                                   at + QPointF(0, radius), at + QPointF(-radius, 0)};
        painter.setPen(QPen(c.text, 1.2));
        painter.setBrush(isChosen ? c.accent : c.fighters[0]);
        painter.drawPolygon(diamond, 4);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(c.secondText);
        painter.drawText(QRectF(at.x() - withTextSize(30), at.y() + radius + 1, withTextSize(60),
                                painter.fontMetrics().height()),
                         Qt::AlignCenter, QString::number(isDragged ? to_ : key.frame));
    }
}

std::optional<int> KeyStrip::keyAt(const QPointF& position) const {
    for (const KeyPose& key : keys_.draft().track.keys) {
        const QPointF away = placeOf(key.frame) - position;
        if (std::abs(away.x()) < kReach && std::abs(away.y()) < 2 * kReach) return key.frame;
    }
    return std::nullopt;
}

int KeyStrip::frameAt(double x) const {
    return std::max(0, static_cast<int>(std::lround(mapping().timeAt(x) * keys_.rate())));
}

void KeyStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    over_ = false;
    dragged_ = hit_.isOn() ? std::nullopt : keyAt(event->position());
    moved_ = false;
    if (dragged_) {
        keys_.choose(dragged_);
        return;
    }
    scrubbing_ = true;
    scrubTo(event->position().x());
}

void KeyStrip::scrubTo(double x) {
    if (hit_.isOn()) return hit_.seek(mapping().timeAt(x));
    keys_.setPlaying(false);
    keys_.seek(frameAt(x));
}

void KeyStrip::mouseMoveEvent(QMouseEvent* event) {
    if (dragged_) {
        to_ = frameAt(event->position().x());
        moved_ = moved_ || to_ != *dragged_;
        update();
    } else if (scrubbing_) {
        scrubTo(event->position().x());
    } else if (!over_) {
        const auto key = hit_.isOn() ? std::nullopt : keyAt(event->position());
        setCursor(key ? Qt::PointingHandCursor : Qt::ArrowCursor);
        Q_EMIT keys_.session().hovered(key ? tr("key at frame %1 · drag to move it").arg(*key)
                                           : QString());
    }
}

void KeyStrip::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    over_ = false;
    scrubbing_ = false;
    const auto from = dragged_;
    dragged_.reset();
    if (from && moved_) keys_.moveKey(*from, to_);
    update();
}

bool KeyStrip::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && dragged_ &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void KeyStrip::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape || !dragged_) return QWidget::keyPressEvent(event);
    dragged_.reset();
    over_ = true;
    update();
}

void KeyStrip::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || hit_.isOn()) return;
    if (keyAt(event->position())) return;
    keys_.seek(frameAt(event->position().x()));
    keys_.addKey();
}

void KeyStrip::wheelEvent(QWheelEvent* event) {
    const TimeMapping changed = afterWheel(mapping(), *event);
    length_ = std::clamp(changed.end - changed.begin, kShortest, kLongest);
    begin_ = std::max(0.0, changed.begin);
    update();
    event->accept();
}

void KeyStrip::leaveEvent(QEvent*) {
    Q_EMIT keys_.session().hovered({});
}

}  // namespace kumite::studio
