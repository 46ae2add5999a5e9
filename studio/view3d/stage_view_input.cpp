// What the mouse does in the 3D view, and what is marked over its picture.

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/view3d/picking.h"
#include "studio/view3d/stage_scene.h"

namespace kumite::studio {

void StageView::showLabels() {
    StageMarks marks;
    const Colours& colours = coloursFor(palette());
    for (std::size_t player = 0; player < 2; ++player) {
        const auto& centre = scene_->poses[player].centreOfMass;
        if (!overlays_.centreOfMass || !centre) continue;
        const Eigen::Vector3d at = scene_->camera.project(centre->cast<double>(), viewport());
        if (at.z() > 0) marks.centres.push_back({{at.x(), at.y()}, colours.fighters[player]});
    }
    const Measuring& measuring = scene_->measuring;
    const auto from = measuring.from ? jointPosition(*measuring.from) : std::nullopt;
    const auto to = measuring.to ? jointPosition(*measuring.to) : std::nullopt;
    if (from && to) {
        marks.distance = {*from, *to,
                          tr("%1 m").arg(numberText(measuredDistance().value_or(0), 2))};
    } else if (from) {
        marks.points.push_back({*from, {}});
    }
    for (const StageBox& box : scene_->handles.boxes) {
        // Its edges lead from each corner to those that differ in one direction.
        for (int corner = 0; corner < 8; ++corner) {
            for (int axis = 0; axis < 3; ++axis) {
                if ((corner >> axis & 1) != 0) continue;
                const auto project = [&](int which) {
                    Eigen::Vector3d at = box.low;
                    for (int k = 0; k < 3; ++k) {
                        if ((which >> k & 1) != 0) at[k] = box.high[k];
                    }
                    return scene_->camera.project(at, viewport());
                };
                const Eigen::Vector3d from = project(corner), to = project(corner | 1 << axis);
                if (from.z() > 0 && to.z() > 0)
                    marks.edges.push_back({{from.x(), from.y()}, {to.x(), to.y()}, box.strong});
            }
        }
    }
    for (std::size_t i = 0; i < scene_->handles.all.size(); ++i) {
        const auto at = handlePosition(static_cast<int>(i));
        const StageHandle& handle = scene_->handles.all[i];
        if (at) marks.handles.push_back({*at, handle.chosen, handle.pinned});
    }
    if (measuring.hovered) {
        const auto at = jointPosition(*measuring.hovered);
        if (at) marks.points.push_back({*at, jointText(*measuring.hovered, true)});
    }
    scene_->labels->show(std::move(marks));
    if (isMeasuring()) tellMeasured();
}

std::optional<JointRef> StageView::jointUnder(const QPointF& position) const {
    constexpr double kReach = 16;  // pixels
    std::optional<PickedJoint> best;
    int player = 0;
    for (int candidate = 0; candidate < 2; ++candidate) {
        const auto& joints = scene_->poses[static_cast<std::size_t>(candidate)].joints;
        const auto picked =
            jointNear(scene_->camera, viewport(), joints, position.x(), position.y(), kReach);
        if (!picked || (best && !isNearer(*picked, *best))) continue;
        best = picked;
        player = candidate;
    }
    if (!best) return std::nullopt;
    return JointRef{player, best->joint};
}

void StageView::hoverAt(const QPointF& position) {
    Measuring& measuring = scene_->measuring;
    const auto joint = jointUnder(position);
    if (joint == measuring.hovered) return;
    measuring.hovered = joint;
    showLabels();
}

void StageView::setHandles(std::vector<StageHandle> handles, std::vector<StageBox> boxes) {
    scene_->handles.all = std::move(handles);
    scene_->handles.boxes = std::move(boxes);
    if (scene_->handles.dragged &&
        *scene_->handles.dragged >= static_cast<int>(scene_->handles.all.size()))
        scene_->handles.dragged.reset();
    showLabels();
}

std::optional<QPointF> StageView::handlePosition(int handle) const {
    const auto& all = scene_->handles.all;
    if (handle < 0 || handle >= static_cast<int>(all.size())) return std::nullopt;
    const Eigen::Vector3d at =
        scene_->camera.project(all[static_cast<std::size_t>(handle)].place, viewport());
    return at.z() > 0 ? std::optional(QPointF(at.x(), at.y())) : std::nullopt;
}

std::optional<int> StageView::handleAt(const QPointF& position) const {
    constexpr double kReach = 12;  // pixels
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

Eigen::Vector3d StageView::facingPoint(const QPointF& position,
                                       const Eigen::Vector3d& through) const {
    const Ray ray = scene_->camera.rayThrough(position.x(), position.y(), viewport());
    const Ray middle = scene_->camera.rayThrough(width() / 2.0, height() / 2.0, viewport());
    const double slope = ray.direction.dot(middle.direction);
    if (slope < 1e-3) return through;
    return ray.origin + (through - ray.origin).dot(middle.direction) / slope * ray.direction;
}

void StageView::mousePressEvent(QMouseEvent* event) {
    const auto handle =
        event->button() == Qt::LeftButton ? handleAt(event->position()) : std::nullopt;
    if (handle) {
        scene_->handles.dragged = handle;
        Q_EMIT handlePressed(*handle, event->modifiers());
        return;
    }
    hand_.press(*event);
}

void StageView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        if (isMeasuring()) hoverAt(event->position());
        if (pointsAtFloor_) Q_EMIT floorHovered(floorAt(event->position()));
    } else if (scene_->handles.dragged) {
        const int handle = *scene_->handles.dragged;
        Q_EMIT handleDragged(
            handle, facingPoint(event->position(),
                                scene_->handles.all[static_cast<std::size_t>(handle)].place));
    } else if (hand_.drag(*event, scene_->camera, viewport())) {
        applyCamera();
    }
}

void StageView::mouseReleaseEvent(QMouseEvent* event) {
    if (scene_->handles.dragged) {
        const int handle = *scene_->handles.dragged;
        scene_->handles.dragged.reset();
        Q_EMIT handleReleased(handle);
        return;
    }
    if (hand_.isDragging()) return;
    const bool menu = event->button() == Qt::RightButton;
    if (event->button() == Qt::LeftButton && isMeasuring()) {
        scene_->measuring.click(jointUnder(event->position()));
        showLabels();
    } else if (event->button() == Qt::LeftButton || menu) {
        const auto player = fighterAt(event->position());
        if (player) {
            session_.setActivePlayer(*player);
        } else if (pointsAtFloor_ && !menu) {
            if (const auto floor = floorAt(event->position())) Q_EMIT floorClicked(*floor);
        }
        if (menu) Q_EMIT menuWanted(player, event->globalPosition().toPoint());
    }
}

void StageView::contextMenuEvent(QContextMenuEvent* event) {
    // The right button turns, too: its menu waits for the release.
    if (event->reason() == QContextMenuEvent::Mouse || session_.playerCount() == 0) return;
    Q_EMIT menuWanted(session_.activePlayer(), mapToGlobal(rect().center()));
}

void StageView::leaveEvent(QEvent*) {
    if (pointsAtFloor_) Q_EMIT floorHovered(std::nullopt);
    if (!scene_->measuring.hovered) return;
    scene_->measuring.hovered.reset();
    showLabels();
}

void StageView::wheelEvent(QWheelEvent* event) {
    hand_.zoom(*event, scene_->camera, viewport());
    applyCamera();
}

std::optional<Eigen::Vector2d> StageView::floorAt(const QPointF& position) const {
    constexpr double kFarthest = 15;  // metres from what is looked at
    const Ray ray = scene_->camera.rayThrough(position.x(), position.y(), viewport());
    if (ray.direction.y() > -1e-3) return std::nullopt;
    const Eigen::Vector3d at = ray.origin - ray.origin.y() / ray.direction.y() * ray.direction;
    if ((at - scene_->camera.target()).norm() > kFarthest) return std::nullopt;
    return Eigen::Vector2d(at.x(), at.z());
}

std::optional<int> StageView::fighterAt(const QPointF& position) const {
    constexpr double kSlack = 6;  // pixels: thin limbs are hard to hit
    const Ray ray = scene_->camera.rayThrough(position.x(), position.y(), viewport());
    const double pixel = CameraController::metresPerPixel(scene_->camera.distance(), viewport());
    for (const double slack : {0.0, kSlack * pixel}) {
        std::optional<double> nearest;
        std::optional<int> found;
        for (int player = 0; player < 2; ++player) {
            const auto index = static_cast<std::size_t>(player);
            const auto& joints = scene_->poses[index].joints;
            if (joints.empty()) continue;
            const auto hit = hitBody(ray, scene_->bones[index], joints, slack);
            if (!hit || (nearest && *nearest <= *hit)) continue;
            nearest = hit;
            found = player;
        }
        if (found) return found;
    }
    return std::nullopt;
}

}  // namespace kumite::studio
