// What the mouse does in the 3D view, and what is written over its picture.

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/view3d/picking.h"
#include "studio/view3d/stage_scene.h"

namespace kumite::studio {

namespace {

/// "left wrist" where the joint has a role, else its name in the file.
QString jointText(const FighterAnalysis& fighter, int joint) {
    for (const Role role : allRoles()) {
        if (fighter.input.roles[role] != joint) continue;
        return QString::fromLatin1(roleName(role).data(), qsizetype(roleName(role).size()))
            .replace(QLatin1Char('_'), QLatin1Char(' '));
    }
    const auto& joints = fighter.input.motion->skeleton->joints;
    return QString::fromStdString(joints[static_cast<std::size_t>(joint)].name);
}

}  // namespace

bool StageView::isMeasuring() const {
    return scene_->measuring.isOn;
}

const Measuring& StageView::measuring() const {
    return scene_->measuring;
}

void StageView::setMeasuring(bool on) {
    scene_->measuring = Measuring{};
    scene_->measuring.isOn = on;
    setMouseTracking(on);
    setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    showLabels();
    Q_EMIT session_.hovered({});
    Q_EMIT switchesChanged();
}

std::optional<Eigen::Vector3d> StageView::jointPlace(const JointRef& joint) const {
    const auto& joints = scene_->poses[static_cast<std::size_t>(joint.player)].joints;
    if (joint.joint < 0 || joint.joint >= static_cast<int>(joints.size())) return std::nullopt;
    return joints[static_cast<std::size_t>(joint.joint)].cast<double>();
}

std::optional<QPointF> StageView::jointPosition(const JointRef& joint) const {
    const auto place = jointPlace(joint);
    if (!place) return std::nullopt;
    const Eigen::Vector3d at = scene_->camera.project(*place, viewport());
    if (at.z() <= 0) return std::nullopt;
    return QPointF(at.x(), at.y());
}

std::optional<double> StageView::measuredDistance() const {
    const Measuring& measuring = scene_->measuring;
    if (!measuring.from || !measuring.to) return std::nullopt;
    const auto from = jointPlace(*measuring.from);
    const auto to = jointPlace(*measuring.to);
    if (!from || !to) return std::nullopt;
    return (*from - *to).norm();
}

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
                          tr("%1 m").arg(QString::number(measuredDistance().value_or(0), 'f', 2))};
    } else if (from) {
        marks.points.push_back({*from, {}});
    }
    if (measuring.hovered) {
        const JointRef& joint = *measuring.hovered;
        const FighterAnalysis* fighter = session_.fighter(joint.player);
        const auto at = jointPosition(joint);
        if (fighter != nullptr && at) {
            const float speed = jointSpeed(fighter->motion->positions, joint.joint,
                                           session_.shownFrame(joint.player), fighter->input.rate);
            marks.points.push_back(
                {*at, tr("%1   %2 m/s")
                          .arg(jointText(*fighter, joint.joint), QString::number(speed, 'f', 1))});
        }
    }
    scene_->labels->show(std::move(marks));
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
    const auto& points = scene_->labels->marks().points;
    Q_EMIT session_.hovered(joint && !points.empty()
                                ? tr("%1: %2").arg(fighterText(joint->player), points.back().text)
                                : QString());
}

void StageView::mousePressEvent(QMouseEvent* event) {
    pressed_ = lastPointer_ = event->position();
    dragged_ = false;
}

void StageView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        if (isMeasuring()) hoverAt(event->position());
        return;
    }
    const QPointF moved = event->position() - lastPointer_;
    if ((event->position() - pressed_).manhattanLength() > 3) dragged_ = true;
    if (!dragged_) return;
    lastPointer_ = event->position();
    const bool pan =
        (event->buttons() & Qt::MiddleButton) || (event->modifiers() & Qt::ShiftModifier);
    if (pan) {
        scene_->camera.pan(moved.x(), moved.y(), viewport());
    } else {
        scene_->camera.orbit(mouseSpeed_ * moved.x(), mouseSpeed_ * moved.y(), viewport());
    }
    applyCamera();
}

void StageView::mouseReleaseEvent(QMouseEvent* event) {
    if (dragged_) return;
    const bool menu = event->button() == Qt::RightButton;
    if (event->button() == Qt::LeftButton && isMeasuring()) {
        scene_->measuring.click(jointUnder(event->position()));
        showLabels();
    } else if (event->button() == Qt::LeftButton || menu) {
        const auto player = fighterAt(event->position());
        if (player) session_.setActivePlayer(*player);
        if (menu) Q_EMIT menuWanted(player, event->globalPosition().toPoint());
    }
}

void StageView::contextMenuEvent(QContextMenuEvent* event) {
    // The right button turns, too: its menu waits for the release.
    if (event->reason() == QContextMenuEvent::Mouse || session_.playerCount() == 0) return;
    Q_EMIT menuWanted(session_.activePlayer(), mapToGlobal(rect().center()));
}

void StageView::leaveEvent(QEvent*) {
    if (!scene_->measuring.hovered) return;
    scene_->measuring.hovered.reset();
    showLabels();
    Q_EMIT session_.hovered({});
}

void StageView::wheelEvent(QWheelEvent* event) {
    const double factor = std::pow(1.0015, mouseSpeed_ * event->angleDelta().y());
    scene_->camera.zoomAbout(event->position().x(), event->position().y(), factor, viewport());
    applyCamera();
    event->accept();
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
