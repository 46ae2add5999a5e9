#include "studio/workspaces/graph/surprise_strip.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/timeline_view.h"

namespace kumite::studio {

namespace {
constexpr double kRow = 24;
constexpr double kBar = 3;
constexpr double kReach = 5;  // pixels

/// The surprise that all but one in thirty stay below: a single odd pose must not flatten the rest.
double usualTop(const std::vector<Surprise>& all) {
    std::vector<double> totals;
    for (const Surprise& each : all)
        totals.push_back(each.total);
    if (totals.empty()) return 0;
    const auto rank = totals.begin() + static_cast<std::ptrdiff_t>(totals.size() * 29 / 30);
    std::nth_element(totals.begin(), rank, totals.end());
    return *rank;
}
}  // namespace

SurpriseStrip::SurpriseStrip(GraphSession& graph, TimelineView& timeline, QWidget* parent)
    : QWidget(parent), graph_(graph), timeline_(timeline) {
    setAccessibleName(tr("Surprise of the transitions"));
    setMouseTracking(true);
    setFixedHeight(static_cast<int>(2 * kRow));
    Session& session = graph_.session();
    connect(&graph_, &GraphSession::valuesChanged, this, &SurpriseStrip::takeValues);
    connect(&graph_, &GraphSession::currentChanged, this, &SurpriseStrip::invalidate);
    connect(&session, &Session::visibleChanged, this, &SurpriseStrip::invalidate);
    connect(&session, &Session::takeChanged, this, &SurpriseStrip::invalidate);
    connect(&session.transport(), &Transport::moved, this, qOverload<>(&QWidget::update));
    hide();
}

QSize SurpriseStrip::sizeHint() const {
    return {800, static_cast<int>(2 * kRow)};
}

QRectF SurpriseStrip::rowOf(int player) const {
    const TimeMapping map = timeline_.mapping();
    return {map.left, player * kRow + 3, map.width, kRow - 5};
}

double SurpriseStrip::surpriseOf(const TransitionRef& transition) const {
    const auto& all = graph_.values()->surprises[static_cast<std::size_t>(transition.mover)];
    return all[static_cast<std::size_t>(transition.index)].total;
}

void SurpriseStrip::takeValues() {
    hovered_.reset();
    top_ = 1;
    for (const int mover : {0, 1}) {
        if (!graph_.hasGraph()) break;
        top_ = std::max(top_, 1.15 * uniformSurprise(graph_.model(mover)));
        top_ =
            std::max(top_, usualTop(graph_.values()->surprises[static_cast<std::size_t>(mover)]));
    }
    setVisible(graph_.isActive() && graph_.hasGraph());
    invalidate();
}

void SurpriseStrip::invalidate() {
    stillValid_ = false;
    update();
}

QRectF SurpriseStrip::barOf(const TransitionRef& transition) const {
    const TransitionPlace place = graph_.placeOf(transition);
    const TimeMapping map = timeline_.mapping();
    if (place.take != graph_.session().take()) return {};
    const double x = map.xOf(place.seconds);
    if (x < map.left - kBar || x > map.left + map.width + kBar) return {};
    const QRectF row = rowOf(transition.mover);
    const double height = std::clamp(surpriseOf(transition) / top_, 0.04, 1.0) * row.height();
    return {x - kBar / 2, row.bottom() - height, kBar, height};
}

void SurpriseStrip::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    if (!stillValid_ || still_.size() != pixels) {
        still_ = QPixmap(pixels);
        still_.setDevicePixelRatio(ratio);
        still_.fill(c.ground);
        QPainter painter(&still_);
        if (graph_.hasGraph()) paintStill(painter);
        stillValid_ = true;
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, still_);
    if (hovered_) {
        const QRectF bar = barOf(*hovered_);
        if (!bar.isEmpty()) {
            painter.fillRect(bar.adjusted(-1, -2, 1, 0), c.fighterText[hovered_->mover]);
        }
    }
    const TimeMapping map = timeline_.mapping();
    const double x = std::floor(map.xOf(graph_.session().transport().playhead())) + 0.5;
    if (x >= map.left && x <= map.left + map.width) {
        painter.setPen(c.accent);
        painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    }
}

void SurpriseStrip::paintStill(QPainter& painter) const {
    const Colours& c = coloursFor(palette());
    QFont small = font();
    small.setPointSizeF(std::max(7.5, small.pointSizeF() - 1.0));
    painter.setFont(small);
    for (const int mover : {0, 1}) {
        const QRectF row = rowOf(mover);
        painter.fillRect(QRectF(0, mover * kRow + 1, 4, kRow - 2), c.fighters[mover]);
        painter.setPen(c.secondText);
        painter.drawText(QRectF(12, row.top() - 2, row.left() - 46, row.height() + 4),
                         Qt::AlignLeft | Qt::AlignVCenter, tr("surprise"));
        painter.drawText(QRectF(row.left() - 40, row.top() - 2, 35, row.height() + 4),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(top_, 'f', 1));
        painter.setPen(c.line);
        painter.drawLine(QPointF(row.left(), row.bottom()), row.bottomRight());
        // Above this line the model was worse than an even guess.
        const double even = uniformSurprise(graph_.model(mover)) / top_;
        painter.setPen(QPen(mixed(c.line, c.secondText, 0.5), 1, Qt::DashLine));
        const double y = std::round(row.bottom() - even * row.height()) + 0.5;
        painter.drawLine(QPointF(row.left(), y), QPointF(row.right(), y));
        painter.save();
        painter.setClipRect(row.adjusted(-2, -3, 2, 1));
        const auto& all = graph_.graph().transitionsOf(mover);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const TransitionRef ref{mover, static_cast<int>(i)};
            const QRectF bar = barOf(ref);
            if (bar.isEmpty()) continue;
            const bool above = surpriseOf(ref) / top_ > even;
            QColor colour = above ? c.fighterText[mover] : mixed(c.ground, c.fighters[mover], 0.6);
            if (ref == graph_.current()) colour = c.accent;
            painter.fillRect(bar, colour);
            // Beyond the axis: it goes on.
            if (surpriseOf(ref) > top_) {
                painter.fillRect(QRectF(bar.left() - 1, row.top() - 2, kBar + 2, 2), colour);
            }
        }
        painter.restore();
    }
    painter.setPen(c.line);
    painter.drawLine(QPointF(0, 0.5), QPointF(width(), 0.5));
}

void SurpriseStrip::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) invalidate();
}

std::optional<TransitionRef> SurpriseStrip::transitionNear(const QPointF& position) const {
    if (!graph_.hasGraph()) return std::nullopt;
    const int mover = position.y() < kRow ? 0 : 1;
    const auto& all = graph_.graph().transitionsOf(mover);
    std::optional<TransitionRef> best;
    double nearest = kReach;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const TransitionRef ref{mover, static_cast<int>(i)};
        const QRectF bar = barOf(ref);
        if (bar.isEmpty()) continue;
        // Of two that are as near the higher one is meant.
        const double distance = std::abs(bar.center().x() - position.x()) - 0.01 * bar.height();
        if (distance > nearest) continue;
        nearest = distance;
        best = ref;
    }
    return best;
}

void SurpriseStrip::hover(const std::optional<TransitionRef>& transition) {
    if (transition == hovered_) return;
    hovered_ = transition;
    setCursor(hovered_ ? Qt::PointingHandCursor : Qt::ArrowCursor);
    QString text;
    if (hovered_) {
        const Transition& t = graph_.transitionOf(*hovered_);
        const int mover = hovered_->mover;
        const Surprise& surprise =
            graph_.values()->surprises[static_cast<std::size_t>(mover)]
                                      [static_cast<std::size_t>(hovered_->index)];
        text = tr("%1 · %2 · %3 → %4 while %5   ·   surprise %6 nats: labels %7, geometry %8")
                   .arg(fighterText(mover), timeText(graph_.placeOf(*hovered_).seconds),
                        graph_.nameOf(mover, t.ownNode), graph_.nameOf(mover, t.nextNode),
                        graph_.nameOf(1 - mover, t.opponentNode),
                        QString::number(surprise.total, 'f', 1),
                        QString::number(surprise.label, 'f', 1),
                        QString::number(surprise.geometry, 'f', 1));
    }
    Q_EMIT graph_.session().hovered(text);
    update();
}

void SurpriseStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const auto transition = transitionNear(event->position())) graph_.goTo(*transition);
}

void SurpriseStrip::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const auto transition = transitionNear(event->position())) graph_.play(*transition);
}

void SurpriseStrip::mouseMoveEvent(QMouseEvent* event) {
    hover(transitionNear(event->position()));
}

void SurpriseStrip::leaveEvent(QEvent*) {
    hover(std::nullopt);
}

}  // namespace kumite::studio
