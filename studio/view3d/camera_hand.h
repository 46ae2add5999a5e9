#pragma once

#include <QPointF>

class QMouseEvent;
class QWheelEvent;

namespace kumite::studio {

class CameraController;
struct Viewport;

/// What a hand does with a camera: a drag turns it, with the middle button or Shift it moves it,
/// the wheel zooms about the pointer. A press that leads nowhere is a click.
class CameraHand {
public:
    /// How fast a drag turns and the wheel zooms; 1 as usual.
    void setSpeed(double speed) { speed_ = speed; }
    void press(const QMouseEvent& event);
    /// Leads the camera along while a button is held; whether it moved. `turns`: false where it may
    /// only be moved.
    bool drag(const QMouseEvent& event, CameraController& camera, const Viewport& viewport,
              bool turns = true);
    void zoom(QWheelEvent& event, CameraController& camera, const Viewport& viewport) const;
    /// Whether the release that follows is the end of a drag, not a click.
    bool isDragging() const { return dragging_; }
    /// The release that follows is no click.
    void swallowClick() { dragging_ = true; }

private:
    QPointF pressed_;
    QPointF last_;
    bool dragging_ = false;
    double speed_ = 1;
};

}  // namespace kumite::studio
