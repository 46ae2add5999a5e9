#pragma once

#include <QWidget>

#include <optional>

#include "studio/timeline/time_mapping.h"

namespace kumite::studio {

class KeySession;

/// The keys over time and the playhead. A click on a key chooses it, a drag moves it, a double
/// click on nothing adds one, elsewhere a drag scrubs; the wheel scrolls, with Ctrl it zooms.
class KeyStrip : public QWidget {
    Q_OBJECT

public:
    explicit KeyStrip(KeySession& keys, QWidget* parent = nullptr);

    TimeMapping mapping() const;
    /// Where a frame's key is drawn.
    QPointF placeOf(double frame) const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    std::optional<int> keyAt(const QPointF& position) const;
    int frameAt(double x) const;

    KeySession& keys_;
    double begin_ = 0, length_ = 3;  ///< visible, seconds
    std::optional<int> dragged_;     ///< the key's frame
    bool moved_ = false;
    bool scrubbing_ = false;
    int to_ = 0;
};

}  // namespace kumite::studio
