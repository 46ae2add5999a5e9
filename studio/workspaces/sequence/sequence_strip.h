#pragma once

#include <QWidget>

#include <optional>

#include "core/transition/sequence.h"
#include "studio/timeline/time_mapping.h"

namespace kumite::studio {

class SequenceSession;

/// The blocks of the sequence over time, the transitions between them, and the playhead. A click
/// chooses a block or a transition, a drag moves a block to another place, a drag of its edge trims
/// it, a drag of the ruler scrubs, an action that is dropped is added; the wheel scrolls, with Ctrl
/// it zooms.
class SequenceStrip : public QWidget {
    Q_OBJECT

public:
    explicit SequenceStrip(SequenceSession& sequence, QWidget* parent = nullptr);

    TimeMapping mapping() const;
    QRectF rectOf(const SequencePiece& piece) const;
    QSize sizeHint() const override;
    /// The whole sequence.
    void showAll();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    enum class Drag { None, Press, Scrub, Move, TrimBegin, TrimEnd };

    QRectF row() const;
    const SequencePiece* pieceAt(const QPointF& position) const;
    /// The block whose edge is there, and whether it is the end.
    std::optional<std::pair<int, bool>> edgeAt(const QPointF& position) const;
    /// Where a dragged block would come to stand.
    int placeAt(double x) const;
    /// Before which block an action that is dropped there comes.
    int placeOfNew(double x) const;
    void trim(double x);
    void tell(const QPointF& position);
    void follow();
    void paintPiece(QPainter& painter, const SequencePiece& piece) const;

    SequenceSession& sequence_;
    double begin_ = 0, length_ = 10;  ///< visible, seconds
    Drag drag_ = Drag::None;
    int block_ = 0;  ///< that is dragged
    QPointF pressed_, at_;
};

}  // namespace kumite::studio
