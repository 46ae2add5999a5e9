#include "studio/timeline/wheel.h"

#include <QWheelEvent>

#include <cmath>

namespace kumite::studio {

TimeMapping afterWheel(const TimeMapping& shown, const QWheelEvent& event) {
    const QPoint turned = event.angleDelta();
    const double delta = turned.y() != 0 ? turned.y() : turned.x();
    return event.modifiers() & Qt::ControlModifier
               ? shown.zoomedAbout(event.position().x(), std::pow(1.002, delta))
               : shown.panned(0.8 * delta);
}

}  // namespace kumite::studio
