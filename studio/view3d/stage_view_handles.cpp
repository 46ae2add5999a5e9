// What of live figures can be dragged and turned in the 3D view.

#include <QKeyEvent>
#include <QMouseEvent>

#include <cmath>
#include <numbers>

#include "studio/view3d/stage_scene.h"

namespace kumite::studio {

namespace {
constexpr double kReach = 12;     // pixels, of a handle
constexpr double kRingReach = 7;  // pixels
constexpr int kRingCorners = 60;
constexpr double kSlowest = 25;  // pixels a radian, of a ring that is seen from its edge

double angleOf(int corner) {
    return 2 * std::numbers::pi * corner / kRingCorners;
}
}  // namespace

std::optional<QPointF> StageView::placeInView(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d at = scene_->camera.project(point, viewport());
    return at.z() > 0 ? std::optional(QPointF(at.x(), at.y())) : std::nullopt;
}

void StageView::setHandles(StageHandles handles) {
    scene_->handles = std::move(handles);
    StageDrag& drag = scene_->drag;
    if ((drag.handle && *drag.handle >= static_cast<int>(scene_->handles.all.size())) ||
        (drag.ring && *drag.ring >= static_cast<int>(scene_->handles.rings.size())))
        drag.over = true;
    showLabels();
}

std::optional<QPointF> StageView::handlePosition(int handle) const {
    const auto& all = scene_->handles.all;
    if (handle < 0 || handle >= static_cast<int>(all.size())) return std::nullopt;
    return placeInView(all[static_cast<std::size_t>(handle)].place);
}

std::optional<QPointF> StageView::ringPosition(int ring, double angle) const {
    const auto& rings = scene_->handles.rings;
    if (ring < 0 || ring >= static_cast<int>(rings.size())) return std::nullopt;
    return placeInView(rings[static_cast<std::size_t>(ring)].at(angle));
}

void StageView::markHandles(StageMarks& marks) const {
    const StageHandles& handles = scene_->handles;
    for (const StageBox& box : handles.boxes) {
        // Its edges lead from each corner to those that differ in one direction.
        for (int corner = 0; corner < 8; ++corner) {
            for (int axis = 0; axis < 3; ++axis) {
                if ((corner >> axis & 1) != 0) continue;
                const auto project = [&](int which) {
                    Eigen::Vector3d at = box.low;
                    for (int k = 0; k < 3; ++k) {
                        if ((which >> k & 1) != 0) at[k] = box.high[k];
                    }
                    return placeInView(at);
                };
                const auto from = project(corner), to = project(corner | 1 << axis);
                if (from && to) marks.edges.push_back({*from, *to, box.strong});
            }
        }
    }
    for (const Eigen::Vector3d& dot : handles.dots) {
        if (const auto at = placeInView(dot)) marks.dots.push_back(*at);
    }
    for (int ring = 0; ring < static_cast<int>(handles.rings.size()); ++ring) {
        StageMarks::Ring mark{{}, ring, scene_->drag.isOn() && scene_->drag.ring == ring};
        for (int corner = 0; corner <= kRingCorners; ++corner) {
            if (const auto at = ringPosition(ring, angleOf(corner))) mark.points.push_back(*at);
        }
        marks.rings.push_back(std::move(mark));
    }
    for (std::size_t i = 0; i < handles.all.size(); ++i) {
        const auto at = handlePosition(static_cast<int>(i));
        if (at) marks.handles.push_back({*at, handles.all[i].chosen, handles.all[i].pinned});
    }
}

std::optional<int> StageView::handleAt(const QPointF& position) const {
    std::optional<int> found;
    double least = kReach;
    for (int i = 0; i < static_cast<int>(scene_->handles.all.size()); ++i) {
        const auto at = handlePosition(i);
        if (!at) continue;
        const double away = std::hypot(at->x() - position.x(), at->y() - position.y());
        if (away >= least) continue;
        least = away;
        found = i;
    }
    return found;
}

std::optional<std::pair<int, double>> StageView::ringAt(const QPointF& position) const {
    std::optional<std::pair<int, double>> found;
    double least = kRingReach;
    for (int ring = 0; ring < static_cast<int>(scene_->handles.rings.size()); ++ring) {
        for (int corner = 0; corner < 4 * kRingCorners; ++corner) {
            const double angle = angleOf(corner) / 4;
            const auto at = ringPosition(ring, angle);
            if (!at) continue;
            const double away = std::hypot(at->x() - position.x(), at->y() - position.y());
            if (away >= least) continue;
            least = away;
            found = {ring, angle};
        }
    }
    return found;
}

Eigen::Vector3d StageView::facingPoint(const QPointF& position,
                                       const Eigen::Vector3d& through) const {
    const Ray ray = scene_->camera.rayThrough(position.x(), position.y(), viewport());
    const Ray middle = scene_->camera.rayThrough(width() / 2.0, height() / 2.0, viewport());
    const double slope = ray.direction.dot(middle.direction);
    if (slope < 1e-3) return through;
    return ray.origin + (through - ray.origin).dot(middle.direction) / slope * ray.direction;
}

bool StageView::beginDrag(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    const QPointF at = event.position();
    StageDrag drag;
    drag.begun = {at.x(), at.y()};
    drag.handle = handleAt(at);
    if (!drag.handle) {
        const auto ring = ringAt(at);
        if (!ring) return false;
        drag.ring = ring->first;
        constexpr double kStep = 0.02;  // radians
        const auto before = ringPosition(ring->first, ring->second - kStep);
        const auto after = ringPosition(ring->first, ring->second + kStep);
        if (!before || !after) return false;
        const QPointF way = (*after - *before) / (2 * kStep);
        drag.along = {way.x(), way.y()};
    }
    scene_->drag = drag;
    if (drag.handle) Q_EMIT handlePressed(*drag.handle, event.modifiers());
    return true;
}

void StageView::dragTo(const QPointF& position) {
    const StageDrag& drag = scene_->drag;
    if (drag.handle) {
        const auto handle = static_cast<std::size_t>(*drag.handle);
        Q_EMIT handleDragged(*drag.handle,
                             facingPoint(position, scene_->handles.all[handle].place));
    } else {
        // Along the ring where it was taken, as far as the hand goes.
        const double speed = drag.along.norm();
        if (speed < 1e-9) return;
        const Eigen::Vector2d way = Eigen::Vector2d(position.x(), position.y()) - drag.begun;
        Q_EMIT ringTurned(*drag.ring, way.dot(drag.along) / speed / std::max(kSlowest, speed));
    }
}

bool StageView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && scene_->drag.isOn() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        // What is dragged is left before any tool that Esc would leave, too.
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void StageView::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape || !scene_->drag.isOn())
        return QWidget::keyPressEvent(event);
    scene_->drag.over = true;
    Q_EMIT dragCancelled();
}

}  // namespace kumite::studio
