#pragma once

#include <QWidget>

#include <optional>

#include "studio/timeline/time_mapping.h"

class QPainter;

namespace kumite::studio {

class HitSession;
class KeySession;

/// The keys over time and the playhead. A click on a key chooses it, a drag moves it, a double
/// click on nothing adds one, elsewhere a drag scrubs; the wheel scrolls, with Ctrl it zooms. Esc
/// leaves a drag. While the hit tool is on the strike's motion with the moment of the hit instead.
class KeyStrip : public QWidget {
    Q_OBJECT

public:
    KeyStrip(KeySession& keys, HitSession& hit, QWidget* parent = nullptr);

    TimeMapping mapping() const;
    /// Where a frame's key is drawn.
    QPointF placeOf(double frame) const;
    QSize sizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
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
    void scrubTo(double x);
    void paintRuler(QPainter& painter) const;
    void paintKeys(QPainter& painter) const;
    void paintHit(QPainter& painter) const;

    KeySession& keys_;
    HitSession& hit_;
    double begin_ = 0, length_ = 3;  ///< visible, seconds
    std::optional<int> dragged_;     ///< the key's frame
    bool moved_ = false;
    bool scrubbing_ = false;
    bool over_ = false;  ///< left by Esc while the button is held
    int to_ = 0;
};

}  // namespace kumite::studio
