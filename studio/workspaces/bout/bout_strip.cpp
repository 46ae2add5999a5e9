#include "studio/workspaces/bout/bout_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/wheel.h"
#include "studio/workspaces/bout/bout_session.h"

namespace kumite::studio {

namespace {
double rulerHeight() {
    return withTextSize(20.0);
}
double leftGutter() {
    return withTextSize(84.0);
}
constexpr double kShortest = 2, kLongest = 600;  // seconds visible
constexpr double kAhead = 0.25;  // share of the view that stays free before the head
}  // namespace

BoutStrip::BoutStrip(BoutSession& bout, QWidget* parent) : QWidget(parent), bout_(bout) {
    setAccessibleName(tr("Actions of the bout"));
    setMouseTracking(true);
    setMinimumHeight(96);
    connect(&bout_, &BoutSession::begun, this, [this] {
        blocks_.clear();
        begin_ = 0;
        gather();
        update();
    });
    connect(&bout_, &BoutSession::moved, this, [this] {
        gather();
        if (!scrubbing_) follow();
        update();
    });
    connect(&bout_, &BoutSession::choicesChanged, this, qOverload<>(&QWidget::update));
}

QSize BoutStrip::sizeHint() const {
    return {800, 150};
}

TimeMapping BoutStrip::mapping() const {
    return {begin_, begin_ + length_, leftGutter(), std::max(10.0, width() - leftGutter() - 12)};
}

QRectF BoutStrip::rowOf(int player) const {
    const double height = (this->height() - rulerHeight() - 6) / 2;
    return {leftGutter(), rulerHeight() + player * (height + 3),
            std::max(10.0, width() - leftGutter() - 12), height};
}

QRectF BoutStrip::rectOf(const Block& block) const {
    const TimeMapping map = mapping();
    const double rate = bout_.rate();
    const QRectF row = rowOf(block.player);
    return {map.xOf(block.begin / rate), row.top(),
            (block.end - block.begin) / rate * map.pixelsPerSecond(), row.height()};
}

/// From the choices of the tape; the action that is going on ends as it is planned now.
void BoutStrip::gather() {
    blocks_.clear();
    const BoutTape* tape = bout_.tape();
    if (tape == nullptr) return;
    for (int player = 0; player < 2; ++player) {
        for (const ShownAction& action : actionsShown(*tape, player))
            blocks_.push_back(
                {player, action.begin, action.end, action.node, action.choice, false});
        Block& last = blocks_.back();
        const FighterShown& shown = tape->now().shown(player);
        const bool isShown = tape->frame() >= last.begin;
        last.end = std::max({last.begin + 1, tape->end(), isShown ? shown.actionEnd : 0});
        last.planned = true;
    }
}

void BoutStrip::clampView() {
    length_ = std::clamp(length_, kShortest, kLongest);
    const double last = bout_.tape() ? bout_.tape()->end() / bout_.rate() : 0;
    begin_ = std::clamp(begin_, 0.0, std::max(0.0, last - 0.2 * length_));
}

void BoutStrip::follow() {
    if (bout_.tape() == nullptr) return;
    const double now = bout_.tape()->frame() / bout_.rate();
    if (bout_.isPlaying() && now > begin_ + (1 - kAhead) * length_)
        begin_ = now - (1 - kAhead) * length_;
    if (now < begin_ || now > begin_ + length_) begin_ = now - 0.5 * length_;
    begin_ = std::max(0.0, begin_);
}

void BoutStrip::paintBlock(QPainter& painter, const Block& block) const {
    const QRectF rect = rectOf(block).adjusted(1, 1, -1, -1);
    const QRectF row = rowOf(block.player);
    const QRectF seen = rect.intersected(row);
    if (seen.width() < 1) return;
    const Colours& c = coloursFor(palette());
    const QColor colour = c.fighters[block.player];
    const int head = bout_.tape()->frame();
    const bool now = block.begin <= head && head < block.end;
    QColor fill = mixed(c.ground, colour, now ? 0.55 : 0.3);
    painter.fillRect(seen, fill);
    if (block.planned) {
        // Behind the end of what was shown: a plan.
        const double end = mapping().xOf(bout_.tape()->end() / bout_.rate());
        QRectF plan = seen;
        plan.setLeft(std::max(seen.left(), end));
        if (plan.width() > 0) painter.fillRect(plan, QBrush(c.ground, Qt::BDiagPattern));
    }
    const auto told = bout_.choice();
    if (told && block.choice == told) {
        painter.setPen(QPen(c.accent, 2));
        painter.drawRect(seen.adjusted(1, 1, -1, -1));
    }
    if (block.choice && (block.choice->commanded || block.choice->forced)) {
        painter.fillRect(QRectF(seen.left(), seen.bottom() - 3, seen.width(), 3), c.accent);
    }
    const QRectF text = seen.adjusted(4, 2, -3, -2);
    if (text.width() < 14) return;
    painter.setPen(c.text);
    const QString name = bout_.nameOf(block.player, block.node);
    const int wrapped = Qt::AlignLeft | Qt::TextWordWrap;
    const QRectF needed = painter.boundingRect(text, wrapped, name);
    if (needed.height() <= text.height() && needed.width() <= text.width()) {
        painter.drawText(text, wrapped | Qt::AlignVCenter, name);
    } else {
        // A word a line; what is too long ends in dots rather than in the middle of a letter.
        const QFontMetrics metrics = painter.fontMetrics();
        QStringList lines;
        for (const QString& word : name.split(QLatin1Char(' ')))
            lines.append(metrics.elidedText(word, Qt::ElideRight, static_cast<int>(text.width())));
        const auto room = static_cast<qsizetype>(text.height() / metrics.lineSpacing());
        while (lines.size() > std::max<qsizetype>(1, room))
            lines.removeLast();
        painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, lines.join(QLatin1Char('\n')));
    }
}

void BoutStrip::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    QPainter painter(this);
    painter.fillRect(rect(), c.ground);
    QFont small = font();
    small.setPointSizeF(std::max(7.5, small.pointSizeF() - 1.0));
    painter.setFont(small);
    for (int player = 0; player < 2; ++player) {
        const QRectF row = rowOf(player);
        painter.fillRect(QRectF(0, row.top(), 4, row.height()), c.fighters[player]);
        painter.setPen(player == bout_.player() ? c.text : c.secondText);
        painter.drawText(QRectF(12, row.top(), leftGutter() - 16, row.height()),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, fighterText(player));
    }
    if (bout_.tape() == nullptr) return;
    const TimeMapping map = mapping();
    painter.save();
    painter.setClipRect(QRectF(leftGutter(), 0, map.width, height()));
    const double step = rulerStep(map.pixelsPerSecond(), 70);
    for (double t = step * std::floor(map.begin / step); t <= map.end; t += step) {
        const double x = std::round(map.xOf(t)) + 0.5;
        painter.setPen(c.line);
        painter.drawLine(QPointF(x, rulerHeight() - 5), QPointF(x, height()));
        painter.setPen(c.secondText);
        painter.drawText(QRectF(x + 3, 0, 90, rulerHeight() - 2), Qt::AlignLeft | Qt::AlignVCenter,
                         timeText(t, step < 0.1 ? 0.01
                                     : step < 1 ? 0.1
                                                : 1.0));
    }
    for (const Block& block : blocks_)
        paintBlock(painter, block);
    const double head = std::floor(map.xOf(bout_.tape()->frame() / bout_.rate())) + 0.5;
    painter.setPen(QPen(c.accent, 1.5));
    painter.drawLine(QPointF(head, 0), QPointF(head, height()));
    painter.restore();
    painter.setPen(c.line);
    painter.drawLine(QPointF(0, 0.5), QPointF(width(), 0.5));
}

const BoutStrip::Block* BoutStrip::blockAt(const QPointF& position) const {
    for (const Block& block : blocks_) {
        if (rectOf(block).intersected(rowOf(block.player)).contains(position)) return &block;
    }
    return nullptr;
}

void BoutStrip::scrubTo(double x) {
    bout_.seek(static_cast<int>(std::lround(mapping().timeAt(x) * bout_.rate())));
}

void BoutStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || bout_.tape() == nullptr) return;
    pressed_ = event->position();
    dragged_ = false;
    scrubbing_ = true;
    if (pressed_.y() < rulerHeight()) {
        bout_.setPlaying(false);
        scrubTo(pressed_.x());
        dragged_ = true;
    }
}

void BoutStrip::mouseMoveEvent(QMouseEvent* event) {
    if (!scrubbing_) {
        tell(blockAt(event->position()));
        return;
    }
    if (std::abs(event->position().x() - pressed_.x()) > 3) dragged_ = true;
    if (!dragged_) return;
    bout_.setPlaying(false);
    scrubTo(event->position().x());
}

void BoutStrip::mouseReleaseEvent(QMouseEvent* event) {
    if (!scrubbing_) return;
    scrubbing_ = false;
    if (dragged_) return;
    // A click explains the action that it hits.
    const Block* block = blockAt(event->position());
    if (block != nullptr && block->choice) {
        bout_.pointTo(block->choice);
    } else {
        bout_.setPlaying(false);
        scrubTo(event->position().x());
    }
}

void BoutStrip::wheelEvent(QWheelEvent* event) {
    const TimeMapping changed = afterWheel(mapping(), *event);
    begin_ = changed.begin;
    length_ = changed.end - changed.begin;
    clampView();
    update();
    event->accept();
}

void BoutStrip::tell(const Block* block) {
    setCursor(block != nullptr && block->choice ? Qt::PointingHandCursor : Qt::ArrowCursor);
    QString text;
    if (block != nullptr) {
        text =
            tr("%1 · %2 to %3 · %4")
                .arg(fighterText(block->player), timeText(block->begin / bout_.rate()),
                     timeText(block->end / bout_.rate()), bout_.nameOf(block->player, block->node));
        if (block->choice && block->choice->commanded) text += tr("   ·   as asked for");
        if (block->choice && block->choice->forced) text += tr("   ·   chosen by hand");
    }
    Q_EMIT bout_.session().hovered(text);
}

void BoutStrip::leaveEvent(QEvent*) {
    tell(nullptr);
}

}  // namespace kumite::studio
