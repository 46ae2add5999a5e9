#include "studio/timeline/timeline_view.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/ruler.h"
#include "studio/timeline/track_painter.h"

namespace kumite::studio {

namespace {
constexpr double kLeftGutter = 118;
constexpr double kRightGutter = 48;
constexpr double kRulerHeight = 22;
constexpr double kHandle = 14;
}  // namespace

TimelineView::TimelineView(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
    setAccessibleName(tr("Timeline"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumHeight(120);
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&session_, &Session::takeChanged, this, &TimelineView::refresh);
    connect(&session_, &Session::fightersChanged, this, &TimelineView::refresh);
    connect(&session_, &Session::visibleChanged, this, &TimelineView::invalidate);
    connect(&session_, &Session::activePlayerChanged, this, &TimelineView::invalidate);
    connect(&session_, &Session::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(&session_.transport(), &Transport::stateChanged, this, &TimelineView::invalidate);
    connect(&session_.transport(), &Transport::moved, this, [this] {
        if (session_.transport().isPlaying()) session_.reveal(session_.transport().playhead());
        update();
    });
    refresh();
}

TimeMapping TimelineView::mapping() const {
    const TimeSpan visible = session_.visible();
    return {visible.begin, visible.end, kLeftGutter,
            std::max(10.0, width() - kLeftGutter - kRightGutter)};
}

QRectF TimelineView::ruler() const {
    return QRectF(0, 0, width(), kRulerHeight);
}

QPointF TimelineView::pointOf(const BoundaryRef& boundary) const {
    const auto index = static_cast<std::size_t>(boundary.player);
    if (index >= tracks_.size()) return {};
    return {mapping().xOf(session_.timeOf(boundary)), tracks_[index].plot().center().y()};
}

QRectF TimelineView::handleOf(const BoundaryRef& boundary) const {
    const auto index = static_cast<std::size_t>(boundary.player);
    if (index >= tracks_.size()) return {};
    const double x = pointOf(boundary).x();
    return QRectF(x - kHandle / 2, tracks_[index].row().top() + 1, kHandle, kHandle);
}

void TimelineView::layOut() {
    const double height = std::max(10.0, this->height() - kRulerHeight);
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        const double each = height / static_cast<double>(tracks_.size());
        const double top = std::round(kRulerHeight + each * static_cast<double>(i));
        const double bottom = std::round(kRulerHeight + each * static_cast<double>(i + 1));
        tracks_[i].setGeometry(QRectF(0, top, width(), bottom - top), kLeftGutter, kRightGutter);
    }
}

void TimelineView::refresh() {
    tracks_.resize(static_cast<std::size_t>(session_.playerCount()));
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        tracks_[i].setFighter(session_.fighter(static_cast<int>(i)));
    }
    layOut();
    hovered_.reset();
    invalidate();
}

void TimelineView::invalidate() {
    stillValid_ = false;
    update();
}

void TimelineView::resizeEvent(QResizeEvent*) {
    layOut();
    invalidate();
}

void TimelineView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) invalidate();
    QWidget::changeEvent(event);
}

void TimelineView::paintEvent(QPaintEvent*) {
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    if (!stillValid_ || still_.size() != pixels) {
        still_ = QPixmap(pixels);
        still_.setDevicePixelRatio(ratio);
        QPainter painter(&still_);
        painter.setFont(font());
        paintStill(painter);
        stillValid_ = true;
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, still_);
    paintMoving(painter);
}

void TimelineView::paintStill(QPainter& painter) {
    const Colours& c = coloursFor(palette());
    const TimeMapping map = mapping();
    painter.fillRect(rect(), c.ground);
    TrackPainter tracks(painter, session_, c, map);
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        tracks.paint(tracks_[i], static_cast<int>(i));
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(c.line);
        const double y = tracks_[i].row().bottom() - 0.5;
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
    }
    paintRuler(painter, ruler(), session_, c, map);
}

void TimelineView::paintMoving(QPainter& painter) {
    const Colours& c = coloursFor(palette());
    const TimeMapping map = mapping();
    TrackPainter tracks(painter, session_, c, map);
    const auto trackOf = [this](int player) -> const Track& {
        return tracks_[static_cast<std::size_t>(player)];
    };
    if (pointer_ && gesture_ == Gesture::None && pointer_->x() >= map.left) {
        TimeMarker guide{
            map.timeAt(pointer_->x()), {}, withAlpha(c.secondText, 0.8), c.ground, Qt::DotLine, 1};
        if (hovered_) guide.seconds = session_.timeOf(*hovered_);
        paintMarker(painter, ruler(), height(), map, guide);
    }
    const auto& selected = session_.selection();
    if (selected && selected->player < static_cast<int>(tracks_.size())) {
        tracks.paintSelection(trackOf(selected->player), *selected);
    }
    const FighterAnalysis* active = session_.fighter(session_.activePlayer());
    const double now = session_.transport().playhead();
    const QString frame =
        active ? QString::number(frameAtTime(active->input, now)) : QStringLiteral("–");
    const QColor dark("#1e1f22");
    paintMarker(painter, ruler(), height(), map,
                {now, timeText(now) + QStringLiteral(" · ") + frame, c.accent, dark});
    if (dragged_) {
        const BoundaryRef at{dragged_->boundary.player, dragged_->frame};
        const double seconds = session_.timeOf(at);
        tracks.paintSelection(trackOf(at.player), at);
        const QColor colour = c.fighterText[at.player];
        paintMarker(
            painter, ruler(), height(), map,
            {seconds, tr("%1 · frame %2").arg(timeText(seconds)).arg(at.frame), colour, c.ground});
    } else if (hovered_ && markOf(*hovered_) != nullptr) {
        const QRectF handle = handleOf(*hovered_);
        tracks.paintHandle(handle, markOf(*hovered_)->isLive(),
                           pointer_ && handle.contains(*pointer_));
    }
}

QString TimelineView::describe(int player, double seconds) const {
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) return timeText(seconds);
    int frame = frameAtTime(fighter->input, seconds);
    if (hovered_) frame = hovered_->frame;
    QString text =
        tr("%1 · %2 · frame %3 · %4")
            .arg(fighterText(player), timeText(timeOfFrame(fighter->input, frame)))
            .arg(frame)
            .arg(bodyWeightsText(fighter->force->force.curve[static_cast<std::size_t>(frame)]));
    const BoundaryMark* mark = hovered_ ? markOf(*hovered_) : nullptr;
    if (mark == nullptr) return text;
    switch (mark->state) {
        case MarkState::Removed:
            text += tr(" · removed boundary");
            break;
        case MarkState::Moved:
            text += tr(" · moved boundary");
            break;
        case MarkState::Added:
            text += tr(" · added boundary");
            break;
        case MarkState::Detected:
        case MarkState::End:
            break;
    }
    if (mark->minimum) {
        const auto& minimum = fighter->force->minima[static_cast<std::size_t>(*mark->minimum)];
        text += tr(" · minimum, prominence %1, suspicion %2")
                    .arg(bodyWeightsText(minimum.prominence), percentText(mark->suspicion));
    }
    return text;
}

}  // namespace kumite::studio
