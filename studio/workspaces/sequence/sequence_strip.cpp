#include "studio/workspaces/sequence/sequence_strip.h"

#include <QDropEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/timeline/wheel.h"
#include "studio/workspaces/sequence/actions_model.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

namespace {
double rulerHeight() {
    return withTextSize(20.0);
}
constexpr double kLeft = 12;
constexpr double kShortest = 0.5, kLongest = 600;  // seconds visible
constexpr double kEdge = 5;                        // pixels in which an edge is taken
constexpr int kLeastFrames = 3;                    // of a trimmed block
}  // namespace

SequenceStrip::SequenceStrip(SequenceSession& sequence, QWidget* parent)
    : QWidget(parent), sequence_(sequence) {
    setAccessibleName(tr("Blocks of the sequence"));
    setMouseTracking(true);
    setAcceptDrops(true);
    setMinimumHeight(90);
    connect(&sequence_, &SequenceSession::motionChanged, this, [this] {
        if (sequence_.motion() != nullptr && sequence_.motion()->clip.seconds() > begin_ + length_)
            showAll();
        update();
    });
    connect(&sequence_, &SequenceSession::draftChanged, this, qOverload<>(&QWidget::update));
    connect(&sequence_, &SequenceSession::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(&sequence_, &SequenceSession::stateChanged, this, qOverload<>(&QWidget::update));
    connect(&sequence_, &SequenceSession::moved, this, [this] {
        if (drag_ == Drag::None) follow();
        update();
    });
}

QSize SequenceStrip::sizeHint() const {
    return {800, 130};
}

TimeMapping SequenceStrip::mapping() const {
    return {begin_, begin_ + length_, kLeft, std::max(10.0, width() - kLeft - 12)};
}

QRectF SequenceStrip::row() const {
    return {kLeft, rulerHeight() + 4, std::max(10.0, width() - kLeft - 12),
            height() - rulerHeight() - 10.0};
}

QRectF SequenceStrip::rectOf(const SequencePiece& piece) const {
    const TimeMapping map = mapping();
    const double rate = sequence_.motion()->clip.rate;
    const double begin = map.xOf(piece.frames.begin / rate);
    return {begin, row().top(), piece.frames.size() / rate * map.pixelsPerSecond(), row().height()};
}

void SequenceStrip::showAll() {
    begin_ = 0;
    if (sequence_.motion() != nullptr)
        length_ = std::clamp(1.05 * sequence_.motion()->clip.seconds(), 4.0, kLongest);
    update();
}

void SequenceStrip::follow() {
    if (sequence_.showing() != SequenceSession::Showing::Sequence) return;
    const double now = sequence_.seconds();
    if (now < begin_ || now > begin_ + length_) begin_ = std::max(0.0, now - 0.25 * length_);
}

void SequenceStrip::paintPiece(QPainter& painter, const SequencePiece& piece) const {
    const QRectF rect = rectOf(piece).adjusted(0.5, 0.5, -0.5, -0.5);
    const QRectF seen = rect.intersected(row());
    if (seen.width() < 1) return;
    const Colours& c = coloursFor(palette());
    const bool isTransition = piece.transition.has_value();
    const bool chosen =
        sequence_.selected() == std::optional(SequencePart{piece.block, isTransition});
    const auto index = static_cast<std::size_t>(piece.block);
    if (index >= sequence_.draft().blocks.size()) return;
    const DraftBlock& block = sequence_.draft().blocks[index];
    if (isTransition) {
        painter.fillRect(seen, mixed(c.ground, c.secondText, 0.15));
        painter.fillRect(seen, QBrush(mixed(c.ground, c.secondText, 0.4), Qt::BDiagPattern));
    } else {
        painter.fillRect(seen, mixed(c.ground, c.fighters[0], chosen ? 0.55 : 0.35));
    }
    if (chosen) {
        painter.setPen(QPen(c.accent, 2));
        painter.drawRect(seen.adjusted(1, 1, -1, -1));
    }
    const QRectF text = seen.adjusted(5, 3, -4, -3);
    if (isTransition) {
        if (block.locked) {
            painter.fillRect(QRectF(seen.left(), seen.bottom() - 3, seen.width(), 3), c.accent);
        }
        return;
    }
    if (text.width() < 14) return;
    painter.setPen(c.text);
    QString name = sequence_.titleOf(block);
    if (block.repeats > 1) name += tr("  (%1 of %2)").arg(piece.repeat + 1).arg(block.repeats);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     QStringLiteral("%1  %2").arg(piece.block + 1).arg(name));
    painter.setPen(c.secondText);
    const QString seconds =
        numberText(piece.frames.size() / sequence_.motion()->clip.rate, 2) + QStringLiteral(" s");
    if (painter.fontMetrics().horizontalAdvance(seconds) < text.width())
        painter.drawText(text, Qt::AlignLeft | Qt::AlignBottom, seconds);
}

void SequenceStrip::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    QPainter painter(this);
    painter.fillRect(rect(), c.ground);
    painter.setPen(c.line);
    painter.drawLine(QPointF(0, 0.5), QPointF(width(), 0.5));
    QFont small = font();
    small.setPointSizeF(std::max(7.5, small.pointSizeF() - 1.0));
    painter.setFont(small);
    if (sequence_.motion() == nullptr || sequence_.draft().blocks.empty()) {
        painter.setPen(c.secondText);
        painter.drawText(rect().adjusted(20, 0, -20, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         !sequence_.problem().isEmpty() ? sequence_.problem()
                         : sequence_.draft().blocks.empty()
                             ? tr("Actions in the order in which they shall be played. Choose one "
                                  "at the right and press Return to add it.")
                             : tr("The motion is being made."));
        return;
    }
    const TimeMapping map = mapping();
    painter.setClipRect(QRectF(kLeft - 1, 0, map.width + 2, height()));
    const double step = rulerStep(map.pixelsPerSecond(), 70);
    for (double t = step * std::floor(map.begin / step); t <= map.end; t += step) {
        const double x = std::round(map.xOf(t)) + 0.5;
        painter.setPen(c.line);
        painter.drawLine(QPointF(x, rulerHeight() - 5), QPointF(x, height()));
        painter.setPen(c.secondText);
        painter.drawText(QRectF(x + 3, 0, 90, rulerHeight() - 2), Qt::AlignLeft | Qt::AlignVCenter,
                         timeText(t, std::min(1.0, step)));
    }
    painter.setOpacity(sequence_.isCurrent() ? 1.0 : 0.6);
    for (const SequencePiece& piece : sequence_.motion()->pieces)
        paintPiece(painter, piece);
    painter.setOpacity(1);
    if (!sequence_.problem().isEmpty()) {
        painter.fillRect(row(), withAlpha(c.ground, 0.85));
        painter.setPen(c.text);
        painter.drawText(row(), Qt::AlignCenter | Qt::TextWordWrap, sequence_.problem());
    }
    if (drag_ == Drag::Move) {
        // Where the block would go.
        const int place = placeAt(at_.x());
        double x = row().left();
        for (const SequencePiece& piece : sequence_.motion()->pieces) {
            if (piece.transition) continue;
            if (piece.block < place || (place > block_ && piece.block == place))
                x = rectOf(piece).right();
        }
        painter.setPen(QPen(c.accent, 3));
        painter.drawLine(QPointF(x, row().top() - 3), QPointF(x, row().bottom() + 3));
    }
    if (sequence_.showing() == SequenceSession::Showing::Sequence) {
        const double head = std::floor(map.xOf(sequence_.seconds())) + 0.5;
        painter.setPen(QPen(c.accent, 1.5));
        painter.drawLine(QPointF(head, 0), QPointF(head, height()));
    }
}

const SequencePiece* SequenceStrip::pieceAt(const QPointF& position) const {
    if (sequence_.motion() == nullptr || !sequence_.isCurrent()) return nullptr;
    if (!row().contains(position)) return nullptr;
    const SequencePiece* found = nullptr;
    for (const SequencePiece& piece : sequence_.motion()->pieces) {
        // A transition may be a pixel wide: it is taken from a little around it.
        const double more = piece.transition ? std::max(0.0, 4 - rectOf(piece).width() / 2) : 0;
        const QRectF rect = rectOf(piece).adjusted(-more, 0, more, 0);
        if (rect.contains(position) && (found == nullptr || piece.transition)) found = &piece;
    }
    return found;
}

std::optional<std::pair<int, bool>> SequenceStrip::edgeAt(const QPointF& position) const {
    const auto chosen = sequence_.selected();
    if (!chosen || chosen->transition || !sequence_.isCurrent()) return std::nullopt;
    if (!row().contains(position) || sequence_.motion() == nullptr) return std::nullopt;
    for (const SequencePiece& piece : sequence_.motion()->pieces) {
        if (piece.transition || piece.block != chosen->block) continue;
        const QRectF rect = rectOf(piece);
        if (std::abs(position.x() - rect.left()) < kEdge) return std::pair(piece.block, false);
        if (std::abs(position.x() - rect.right()) < kEdge) return std::pair(piece.block, true);
    }
    return std::nullopt;
}

int SequenceStrip::placeAt(double x) const {
    int place = 0;
    for (const SequencePiece& piece : sequence_.motion()->pieces) {
        if (!piece.transition && piece.block != block_ && x > rectOf(piece).center().x())
            place = piece.block + (piece.block < block_ ? 1 : 0);
    }
    return place;
}

int SequenceStrip::placeOfNew(double x) const {
    int place = 0;
    if (sequence_.motion() == nullptr) return place;
    for (const SequencePiece& piece : sequence_.motion()->pieces) {
        if (!piece.transition && x > rectOf(piece).center().x()) place = piece.block + 1;
    }
    return place;
}

void SequenceStrip::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(ActionsModel::kMimeType)))
        event->acceptProposedAction();
}

void SequenceStrip::dropEvent(QDropEvent* event) {
    const std::string name =
        event->mimeData()->data(QLatin1String(ActionsModel::kMimeType)).toStdString();
    if (sequence_.library() == nullptr) return;
    for (const LibraryAction& action : sequence_.library()->actions) {
        if (action.name != name) continue;
        sequence_.insert(action, placeOfNew(event->position().x()));
        event->acceptProposedAction();
        return;
    }
}

void SequenceStrip::trim(double x) {
    const SequencePiece* first = nullptr;
    const SequencePiece* last = nullptr;
    for (const SequencePiece& piece : sequence_.motion()->pieces) {
        if (piece.transition || piece.block != block_) continue;
        if (first == nullptr) first = &piece;
        last = &piece;
    }
    if (first == nullptr || sequence_.library() == nullptr) return;
    const double rate = sequence_.motion()->clip.rate;
    const int frame = static_cast<int>(std::lround(mapping().timeAt(x) * rate));
    const DraftBlock& block = sequence_.draft().blocks[static_cast<std::size_t>(block_)];
    int all = 0;
    try {
        const SequenceBlock named = blockNamed(*sequence_.library(), block.clip);
        all = named.made ? named.made->clip.frameCount() : named.action.frames.size();
    } catch (const std::exception&) {
        return;
    }
    FrameRange range = block.trim.value_or(FrameRange{0, all});
    if (drag_ == Drag::TrimBegin) {
        range.begin =
            std::clamp(range.begin + frame - first->frames.begin, 0, range.end - kLeastFrames);
    } else {
        range.end =
            std::clamp(range.end + frame - last->frames.end, range.begin + kLeastFrames, all);
    }
    const bool whole = range.begin == 0 && range.end == all;
    const QString name = sequence_.titleOf(block);
    sequence_.change(block_, tr("Trim %1").arg(name), [&](DraftBlock& each) {
        each.trim = whole ? std::nullopt : std::optional(range);
    });
}

void SequenceStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || sequence_.motion() == nullptr) return;
    pressed_ = at_ = event->position();
    sequence_.preview({});
    if (const auto edge = edgeAt(pressed_)) {
        block_ = edge->first;
        drag_ = edge->second ? Drag::TrimEnd : Drag::TrimBegin;
        return;
    }
    if (const SequencePiece* piece = pieceAt(pressed_); piece != nullptr) {
        block_ = piece->block;
        sequence_.select(SequencePart{piece->block, piece->transition.has_value()});
        drag_ = piece->transition ? Drag::None : Drag::Press;
        return;
    }
    drag_ = Drag::Scrub;
    sequence_.setPlaying(false);
    sequence_.seek(mapping().timeAt(pressed_.x()));
}

void SequenceStrip::mouseMoveEvent(QMouseEvent* event) {
    at_ = event->position();
    if (drag_ == Drag::Press && std::abs(at_.x() - pressed_.x()) > 6) drag_ = Drag::Move;
    if (drag_ == Drag::Scrub) sequence_.seek(mapping().timeAt(at_.x()));
    if (drag_ == Drag::None) tell(at_);
    update();
}

void SequenceStrip::mouseReleaseEvent(QMouseEvent* event) {
    const Drag was = drag_;
    if (was == Drag::Move) {
        const int place = placeAt(event->position().x());
        drag_ = Drag::None;
        sequence_.move(block_, place);
    } else if (was == Drag::TrimBegin || was == Drag::TrimEnd) {
        trim(event->position().x());
    }
    drag_ = Drag::None;
    update();
}

void SequenceStrip::mouseDoubleClickEvent(QMouseEvent* event) {
    if (sequence_.motion() == nullptr) return;
    if (const SequencePiece* piece = pieceAt(event->position()); piece != nullptr) {
        sequence_.seek(piece->frames.begin / sequence_.motion()->clip.rate);
        sequence_.setPlaying(true);
    }
}

void SequenceStrip::wheelEvent(QWheelEvent* event) {
    const TimeMapping changed = afterWheel(mapping(), *event);
    length_ = std::clamp(changed.end - changed.begin, kShortest, kLongest);
    const double last = sequence_.motion() != nullptr ? sequence_.motion()->clip.seconds() : 0;
    begin_ = std::clamp(changed.begin, 0.0, std::max(0.0, last - 0.2 * length_));
    update();
    event->accept();
}

void SequenceStrip::tell(const QPointF& position) {
    const auto edge = edgeAt(position);
    const SequencePiece* piece = pieceAt(position);
    setCursor(edge               ? Qt::SizeHorCursor
              : piece != nullptr ? Qt::PointingHandCursor
                                 : Qt::ArrowCursor);
    QString text;
    if (edge) {
        text = tr("Drag to trim");
    } else if (piece != nullptr) {
        const double rate = sequence_.motion()->clip.rate;
        const QString name =
            sequence_.titleOf(sequence_.draft().blocks[static_cast<std::size_t>(piece->block)]);
        text = (piece->transition ? tr("transition to %1 · %2 to %3") : tr("%1 · %2 to %3"))
                   .arg(name, timeText(piece->frames.begin / rate),
                        timeText(piece->frames.end / rate));
    }
    Q_EMIT sequence_.session().hovered(text);
}

void SequenceStrip::leaveEvent(QEvent*) {
    Q_EMIT sequence_.session().hovered({});
}

}  // namespace kumite::studio
