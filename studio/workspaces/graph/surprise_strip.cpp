#include "studio/workspaces/graph/surprise_strip.h"

#include <QActionGroup>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/timeline_view.h"

namespace kumite::studio {

namespace {
double rowHeight() {
    return withTextSize(24.0);
}
constexpr double kBar = 3;
constexpr double kReach = 5;        // pixels
constexpr double kMostGuesses = 6;  ///< even guesses that fill a row at most

/// The surprise that all but one in thirty stay below: a single odd pose must not flatten the rest.
double usualTop(const std::vector<Surprise>& all, SurpriseKind kind) {
    std::vector<double> values;
    for (const Surprise& each : all)
        values.push_back(valueOf(each, kind));
    if (values.empty()) return 0;
    const auto rank = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 29 / 30);
    std::nth_element(values.begin(), rank, values.end());
    return *rank;
}
}  // namespace

SurpriseStrip::SurpriseStrip(GraphSession& graph, TimelineView& timeline, QWidget* parent)
    : QWidget(parent), graph_(graph), timeline_(timeline), kind_(new QToolButton(this)) {
    setAccessibleName(tr("Surprise of the transitions"));
    setMouseTracking(true);
    setFixedHeight(static_cast<int>(2 * rowHeight()));
    addChoice();
    Session& session = graph_.session();
    connect(&graph_, &GraphSession::valuesChanged, this, &SurpriseStrip::takeValues);
    connect(&graph_, &GraphSession::optionsChanged, this, &SurpriseStrip::takeValues);
    connect(&graph_, &GraphSession::surpriseKindChanged, this, &SurpriseStrip::takeValues);
    connect(&graph_, &GraphSession::currentChanged, this, &SurpriseStrip::invalidate);
    connect(&session, &Session::visibleChanged, this, &SurpriseStrip::invalidate);
    connect(&session, &Session::takeChanged, this, &SurpriseStrip::invalidate);
    connect(&session.transport(), &Transport::moved, this, qOverload<>(&QWidget::update));
    hide();
}

void SurpriseStrip::addChoice() {
    struct Entry {
        SurpriseKind kind;
        QString text;
        QString tip;
    };
    const Entry entries[] = {
        {SurpriseKind::Both, tr("Both terms"),
         tr("−log P(next | own, opponent, motion): seen how it moves, another label was likelier. "
            "Finds labels that are wrong.")},
        {SurpriseKind::Label, tr("Label term alone"),
         tr("−log P(next | own, opponent): a label that seldom follows. Finds rare decisions.")},
        {SurpriseKind::Geometry, tr("Geometry term alone"),
         tr("−log density of places, facing and poses under the label, from its mean: no "
            "probability. Finds odd poses and places.")}};
    auto* menu = new QMenu(kind_);
    menu->setToolTipsVisible(true);
    auto* group = new QActionGroup(menu);
    for (const Entry& entry : entries) {
        QAction* action = menu->addAction(entry.text);
        action->setToolTip(entry.tip);
        action->setCheckable(true);
        action->setData(static_cast<int>(entry.kind));
        group->addAction(action);
        connect(action, &QAction::triggered, this,
                [this, kind = entry.kind] { graph_.setSurpriseKind(kind); });
    }
    const auto follow = [this, group] {
        const SurpriseKind kind = graph_.surpriseKind();
        kind_->setText(surpriseName(kind) + QStringLiteral(" ▾"));
        for (QAction* action : group->actions()) {
            if (action->data().toInt() != static_cast<int>(kind)) continue;
            action->setChecked(true);
            kind_->setToolTip(tr("How unexpected each transition was to a model that had not seen "
                                 "it, in nats.\n%1")
                                  .arg(action->toolTip()));
        }
        layOutChoice();
    };
    kind_->setMenu(menu);
    kind_->setPopupMode(QToolButton::InstantPopup);
    kind_->setStyleSheet(
        QStringLiteral("QToolButton { padding: 0 2px; } "
                       "QToolButton::menu-indicator { image: none; }"));
    kind_->setFocusPolicy(Qt::TabFocus);
    kind_->setAccessibleName(tr("Which surprise is shown"));
    connect(&graph_, &GraphSession::surpriseKindChanged, this, follow);
    follow();
}

void SurpriseStrip::layOutChoice() {
    // Below the word, left of the numbers.
    const int room = static_cast<int>(rowOf(0).left()) - 46 - 8;
    kind_->setGeometry(8, static_cast<int>(rowHeight()), std::min(kind_->sizeHint().width(), room),
                       static_cast<int>(rowHeight()) - 2);
}

void SurpriseStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layOutChoice();
}

QSize SurpriseStrip::sizeHint() const {
    return {800, static_cast<int>(2 * rowHeight())};
}

QRectF SurpriseStrip::rowOf(int player) const {
    const TimeMapping map = timeline_.mapping();
    return {map.left, player * rowHeight() + 3, map.width, rowHeight() - 5};
}

void SurpriseStrip::takeValues() {
    hovered_.reset();
    top_ = 1;
    const SurpriseKind kind = graph_.surpriseKind();
    const bool isProbability = kind != SurpriseKind::Geometry;
    for (const std::size_t mover : {0U, 1U}) {
        if (!graph_.hasGraph()) break;
        const double usual = usualTop(graph_.values()->surprises[mover], kind);
        // Worse than an even guess; where there is no such thing, what few exceed.
        odd_[mover] =
            isProbability ? uniformSurprise(graph_.model(static_cast<int>(mover))) : usual;
        // What is much worse than an even guess need not be told apart.
        const double most = isProbability ? kMostGuesses * odd_[mover] : usual;
        top_ = std::max({top_, std::min(usual, most), isProbability ? 1.15 * odd_[mover] : 0.0});
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
    const double height =
        std::clamp(graph_.shownSurprise(transition) / top_, 0.04, 1.0) * row.height();
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
        painter.fillRect(QRectF(0, mover * rowHeight() + 1, 4, rowHeight() - 2), c.fighters[mover]);
        painter.setPen(c.secondText);
        if (mover == 0) {
            painter.drawText(QRectF(12, row.top() - 2, row.left() - 50, row.height() + 4),
                             Qt::AlignLeft | Qt::AlignVCenter, tr("surprise"));
        }
        painter.drawText(QRectF(row.left() - 40, row.top() - 2, 35, row.height() + 4),
                         Qt::AlignRight | Qt::AlignVCenter, numberText(top_, 1));
        painter.setPen(c.line);
        painter.drawLine(QPointF(row.left(), row.bottom()), row.bottomRight());
        const double odd = odd_[static_cast<std::size_t>(mover)];
        painter.setPen(QPen(mixed(c.line, c.secondText, 0.5), 1, Qt::DashLine));
        const double y = std::round(row.bottom() - odd / top_ * row.height()) + 0.5;
        painter.drawLine(QPointF(row.left(), y), QPointF(row.right(), y));
        painter.save();
        painter.setClipRect(row.adjusted(-2, -3, 2, 1));
        const auto& all = graph_.graph().transitionsOf(mover);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const TransitionRef ref{mover, static_cast<int>(i)};
            const QRectF bar = barOf(ref);
            if (bar.isEmpty()) continue;
            const bool above = graph_.shownSurprise(ref) > odd;
            QColor colour = above ? c.fighterText[mover] : mixed(c.ground, c.fighters[mover], 0.6);
            if (ref == graph_.current()) colour = c.accent;
            painter.fillRect(bar, colour);
            // Beyond the axis: it goes on.
            if (graph_.shownSurprise(ref) > top_) {
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
    const int mover = position.y() < rowHeight() ? 0 : 1;
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
        text = tr("%1 · %2 · %3 → %4 while %5   ·   %6")
                   .arg(fighterText(mover), timeText(graph_.placeOf(*hovered_).seconds),
                        graph_.nameOf(mover, t.ownNode), graph_.nameOf(mover, t.nextNode),
                        graph_.nameOf(1 - mover, t.opponentNode),
                        surpriseWords(graph_.surpriseOf(*hovered_)));
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
