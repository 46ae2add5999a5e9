// What the mouse does in the 3D view, and what is marked over its picture.

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

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
    markHandles(marks);
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

void StageView::mousePressEvent(QMouseEvent* event) {
    if (scene_->drag.handle || scene_->drag.ring) return;  // another button changes nothing
    if (!beginDrag(*event)) hand_.press(*event);
}

void StageView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        if (isMeasuring()) hoverAt(event->position());
        if (pointsAtFloor_) Q_EMIT floorHovered(floorAt(event->position()));
    } else if (scene_->drag.handle || scene_->drag.ring) {
        if (scene_->drag.isOn()) dragTo(event->position());
    } else if (hand_.drag(*event, scene_->camera, viewport())) {
        applyCamera();
    }
}

void StageView::mouseReleaseEvent(QMouseEvent* event) {
    if (scene_->drag.handle || scene_->drag.ring) {
        if (event->button() != Qt::LeftButton) return;
        const StageDrag drag = std::exchange(scene_->drag, {});
        if (drag.isOn() && drag.handle) Q_EMIT handleReleased(*drag.handle);
        if (drag.isOn() && drag.ring) Q_EMIT ringReleased(*drag.ring);
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
