#pragma once

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

#include "core/synthesis/bout_tape.h"
#include "studio/timeline/time_mapping.h"

namespace kumite::studio {

class BoutSession;

/// Both fighters' actions as they come, over the time of the bout: what was shown, and of what is
/// going on how it is planned. A drag scrubs, a click on an action explains the choice of it, the
/// wheel zooms with Ctrl and scrolls without. Follows the head while the bout plays.
class BoutStrip : public QWidget {
    Q_OBJECT

public:
    explicit BoutStrip(BoutSession& bout, QWidget* parent = nullptr);

    /// An action of the bout on the strip.
    struct Block {
        int player = 0;
        int begin = 0;  ///< frames
        int end = 0;
        int node = -1;
        std::shared_ptr<const BoutChoice> choice;  ///< that began it; null: the start
        bool planned = false;                      ///< goes on behind what was shown
    };
    const std::vector<Block>& blocks() const { return blocks_; }
    QRectF rectOf(const Block& block) const;
    TimeMapping mapping() const;

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void gather();
    void follow();
    void clampView();
    QRectF rowOf(int player) const;
    const Block* blockAt(const QPointF& position) const;
    void scrubTo(double x);
    void tell(const Block* block);
    void paintBlock(QPainter& painter, const Block& block) const;

    BoutSession& bout_;
    std::vector<Block> blocks_;
    std::size_t gathered_ = 0;  ///< choices that the blocks know
    double begin_ = 0;          ///< what is visible, seconds
    double length_ = 12;
    bool scrubbing_ = false;
    bool dragged_ = false;
    QPointF pressed_;
};

}  // namespace kumite::studio
