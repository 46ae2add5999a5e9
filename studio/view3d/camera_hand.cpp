#include "studio/view3d/camera_hand.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

#include "studio/view3d/camera_controller.h"

namespace kumite::studio {

void CameraHand::press(const QMouseEvent& event) {
    pressed_ = last_ = event.position();
    dragging_ = false;
}

bool CameraHand::drag(const QMouseEvent& event, CameraController& camera, const Viewport& viewport,
                      bool turns) {
    constexpr double kStart = 3;  // pixels
    if ((event.position() - pressed_).manhattanLength() > kStart) dragging_ = true;
    if (!dragging_) return false;
    const QPointF way = event.position() - last_;
    last_ = event.position();
    const bool moves =
        !turns || (event.buttons() & Qt::MiddleButton) || (event.modifiers() & Qt::ShiftModifier);
    if (moves) {
        camera.pan(way.x(), way.y(), viewport);
    } else {
        camera.orbit(speed_ * way.x(), speed_ * way.y(), viewport);
    }
    return true;
}

void CameraHand::zoom(QWheelEvent& event, CameraController& camera,
                      const Viewport& viewport) const {
    const double factor = std::pow(1.0015, speed_ * event.angleDelta().y());
    camera.zoomAbout(event.position().x(), event.position().y(), factor, viewport);
    event.accept();
}

}  // namespace kumite::studio
