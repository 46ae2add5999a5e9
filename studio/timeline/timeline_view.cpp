#include "studio/timeline/timeline_view.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/lanes.h"
#include "studio/timeline/mark_painter.h"
#include "studio/timeline/note_field.h"
#include "studio/timeline/ruler.h"
#include "studio/timeline/track_painter.h"

namespace kumite::studio {

namespace {
double leftGutter() {
    return withTextSize(118.0);
}
double rightGutter() {
    return withTextSize(48.0);
}
double rulerHeight() {
    return withTextSize(22.0);
}
constexpr double kHandle = 14;
}  // namespace

TimelineView::TimelineView(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), note_(new NoteField(session, this)) {
    setAccessibleName(tr("Timeline"));
    setAccessibleDescription(
        tr("Force curves of the fighters, the boundaries that cut them, and the actions between"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&session_, &Session::takeChanged, this, [this] {
        if (dragged_) endDrag(false);
        refresh();
    });
    connect(&session_, &Session::fightersChanged, this, &TimelineView::refresh);
    connect(&session_, &Session::visibleChanged, this, [this] {
        invalidate();
        hoverAgain();
    });
    connect(&session_, &Session::activePlayerChanged, this, &TimelineView::invalidate);
    connect(&session_, &Session::comparisonChanged, this, &TimelineView::invalidate);
    connect(&session_, &Session::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(&session_.transport(), &Transport::stateChanged, this, &TimelineView::invalidate);
    connect(&session_.transport(), &Transport::moved, this, [this] {
        // What a hand holds stays under it.
        const bool follow = session_.transport().isPlaying() && gesture_ == Gesture::None;
        if (follow) session_.reveal(session_.transport().playhead());
        update();
    });
    refresh();
}

TimeMapping TimelineView::mapping() const {
    const TimeSpan visible = session_.visible();
    return {visible.begin, visible.end, leftGutter(),
            std::max(10.0, width() - leftGutter() - rightGutter())};
}

QRectF TimelineView::ruler() const {
    return QRectF(0, 0, width(), rulerHeight());
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

QRectF TimelineView::blockOf(const ActionRef& action) const {
    const auto index = static_cast<std::size_t>(action.player);
    if (index >= tracks_.size() || session_.actionOf(action) == nullptr) return {};
    const TimeMapping map = mapping();
    const TimeSpan span = session_.spanOf(action);
    const QRectF strip = tracks_[index].strip();
    const double left = std::max(map.xOf(span.begin), strip.left());
    const double right = std::min(map.xOf(span.end), strip.right());
    return right > left ? QRectF(left, strip.top(), right - left, strip.height()) : QRectF();
}

void TimelineView::setOptions(const TimelineOptions& options) {
    if (options == options_) return;
    options_ = options;
    refresh();
}

void TimelineView::setLanes(LaneSource* lanes) {
    if (lanes == lanes_) return;
    if (lanes_) disconnect(lanes_, nullptr, this, nullptr);
    lanes_ = lanes;
    if (lanes_) connect(lanes_, &LaneSource::changed, this, &TimelineView::invalidate);
    refresh();
}

void TimelineView::editNote() {
    const auto action = session_.currentAction();
    if (!action) return;
    session_.setActivePlayer(action->player);
    session_.selectAction(action);
    if (blockOf(*action).isEmpty()) session_.frameSelection();
    const QRectF block = blockOf(*action);
    const int width = std::max(240, static_cast<int>(block.width()));
    const int height = note_->sizeHint().height();
    const int left =
        std::clamp(static_cast<int>(block.left()), 0, std::max(0, this->width() - width));
    const int top = static_cast<int>(block.center().y()) - height / 2;
    note_->open(*action, {left, std::min(top, this->height() - height), width, height});
}

int TimelineView::speedRows() const {
    return (options_.handSpeed ? 1 : 0) + (options_.footSpeed ? 1 : 0);
}

QSize TimelineView::sizeHint() const {
    constexpr int kLane = 11;
    const int lanes = lanes_ ? 2 * kLane * lanes_->laneCount() : 0;
    return {800, 140 + 100 * speedRows() + lanes};
}

void TimelineView::layOut() {
    const double height = std::max(10.0, this->height() - rulerHeight());
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        const double each = height / static_cast<double>(tracks_.size());
        const double top = std::round(rulerHeight() + each * static_cast<double>(i));
        const double bottom = std::round(rulerHeight() + each * static_cast<double>(i + 1));
        tracks_[i].setGeometry(QRectF(0, top, width(), bottom - top), leftGutter(), rightGutter(),
                               lanes_ ? lanes_->laneCount() : 0);
    }
}

void TimelineView::refresh() {
    const BoundaryMark* held = dragged_ ? markOf(dragged_->boundary) : nullptr;
    if (dragged_ && (held == nullptr || !held->isLive())) endDrag(false);
    tracks_.resize(static_cast<std::size_t>(session_.playerCount()));
    bool lacking = false;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        lacking |= tracks_[i].setFighter(session_.fighter(static_cast<int>(i)), options_,
                                         session_.document().analysis().settings.curve);
    }
    if (lacking) prepareCurves();
    setMinimumHeight(120 + 64 * speedRows());
    updateGeometry();
    layOut();
    hovered_.reset();
    invalidate();
    hoverAgain();
}

void TimelineView::prepareCurves() {
    std::vector<CurveWish> wishes;
    for (const Track& track : tracks_)
        wishes.push_back(track.wish());
    preparing_.start(
        tr("Preparing curves"),
        [wishes](const Progress& progress) {
            std::vector<WishedCurves> made;
            for (const CurveWish& wish : wishes) {
                progress.update(double(made.size()) / double(wishes.size()));
                made.push_back(makeCurves(wish));
            }
            return made;
        },
        [this, wishes](std::vector<WishedCurves> made) {
            for (std::size_t i = 0; i < std::min(made.size(), tracks_.size()); ++i) {
                // A fighter may have gone meanwhile, with nothing to be made in its place.
                if (tracks_[i].wish() == wishes[i]) tracks_[i].setCurves(std::move(made[i]));
            }
            layOut();
            invalidate();
        });
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
        if (still_.size() != pixels) still_ = QPixmap(pixels);
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
        if (lanes_) {
            paintLanes(painter, *lanes_, session_, static_cast<int>(i), tracks_[i].lanes(), c, map);
        }
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(c.line);
        const double y = tracks_[i].row().bottom() - 0.5;
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
    }
    paintRuler(painter, ruler(), session_, c, map, options_.ruler);
}

void TimelineView::paintMoving(QPainter& painter) {
    const Colours& c = coloursFor(palette());
    const TimeMapping map = mapping();
    MarkPainter marks(painter, session_, c, map);
    const auto trackOf = [this](int player) -> const Track& {
        return tracks_[static_cast<std::size_t>(player)];
    };
    const auto players = static_cast<int>(tracks_.size());
    if (pointer_ && gesture_ == Gesture::None && pointer_->x() >= map.left) {
        TimeMarker guide{
            map.timeAt(pointer_->x()), {}, withAlpha(c.secondText, 0.8), c.ground, Qt::DotLine, 1};
        if (hovered_) guide.seconds = session_.timeOf(*hovered_);
        paintMarker(painter, ruler(), height(), map, guide);
    }
    const auto& action = session_.selectedAction();
    if (action && action->player < players) marks.paintSelection(trackOf(action->player), *action);
    if (lanes_) {
        for (const ActionRef& chosen : lanes_->chosen()) {
            if (chosen != action && chosen.player < players) {
                marks.paintSelection(trackOf(chosen.player), chosen);
            }
        }
    }
    const auto& selected = session_.selection();
    if (selected && selected->player < players) {
        marks.paintSelection(trackOf(selected->player), *selected);
    }
    const FighterAnalysis* active = session_.fighter(session_.activePlayer());
    const double now = session_.transport().playhead();
    const QString frame =
        active ? QString::number(frameAtTime(active->input, now)) : QStringLiteral("–");
    const QColor dark("#1e1f22");
    QString moment = timeText(now) + QStringLiteral(" · ") + frame;
    if (options_.ruler == RulerUnits::Time) moment = timeText(now);
    if (options_.ruler == RulerUnits::Frames) moment = frame;
    paintMarker(painter, ruler(), height(), map, {now, moment, c.accent, dark});
    if (dragged_) {
        const BoundaryRef at{dragged_->boundary.player, dragged_->frame};
        const double seconds = session_.timeOf(at);
        marks.paintSelection(trackOf(at.player), at);
        const QColor colour = c.fighterText[at.player];
        QString text = tr("%1 · frame %2").arg(timeText(seconds)).arg(at.frame);
        if (dragged_->snap) text += QStringLiteral(" · ") + snapText(*dragged_->snap);
        paintMarker(painter, ruler(), height(), map, {seconds, text, colour, c.ground});
    } else if (hovered_ && markOf(*hovered_) != nullptr) {
        const QRectF handle = handleOf(*hovered_);
        marks.paintHandle(handle, markOf(*hovered_)->isLive(),
                          pointer_ && handle.contains(*pointer_));
    }
}

QString TimelineView::describe(int player, double seconds) const {
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) return timeText(seconds);
    int frame = frameAtTime(fighter->input, seconds);
    if (hovered_) frame = hovered_->frame;
    QString text = tr("%1 · %2 · frame %3")
                       .arg(fighterText(player), timeText(timeOfFrame(fighter->input, frame)))
                       .arg(frame);
    if (fighter->force) {
        const auto& curve = fighter->force->force.curve;
        text += QStringLiteral(" · ") + bodyWeightsText(curve[static_cast<std::size_t>(frame)]);
    }
    if (const auto action = session_.actionAt(player, frame); action && !hovered_) {
        text += tr(" · action %1").arg(session_.numberOf(*action));
        const QString note = session_.noteOf(*action);
        if (!note.isEmpty()) text += tr(" · note: %1").arg(note);
    }
    const BoundaryMark* mark = hovered_ ? markOf(*hovered_) : nullptr;
    if (mark == nullptr) return text;
    switch (mark->state) {
        case MarkState::Removed:
            text += tr(" · removed boundary");
            break;
        case MarkState::Accepted:
            text += tr(" · accepted boundary");
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
    if (mark->minimum) text += QStringLiteral(" · ") + suspicionText(*fighter, *mark);
    return text;
}

}  // namespace kumite::studio
