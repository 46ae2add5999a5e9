#include "studio/view3d/stage_view.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QWheelEvent>

#include <array>
#include <cmath>
#include <numbers>

#include "studio/app/session.h"
#include "studio/view3d/stage.h"
#include "studio/view3d/vtk_widget.h"

namespace kumite::studio {

namespace {

/// A fighter as it stands at a frame, in the bout's space.
FigurePose poseAt(const FighterAnalysis& fighter, int frame) {
    FigurePose pose;
    const double floor = fighter.body ? fighter.body->floor : 0.0;
    const auto place = [&](const Eigen::Vector3d& point) {
        return Eigen::Vector3f(placed(fighter.input, floor, point).cast<float>());
    };
    const JointPositions& positions = fighter.motion->positions;
    pose.joints.reserve(static_cast<std::size_t>(positions.jointCount));
    for (int joint = 0; joint < positions.jointCount; ++joint) {
        pose.joints.push_back(place(positions.at(frame, joint).cast<double>()));
    }
    const auto index = static_cast<std::size_t>(frame);
    if (fighter.body && index < fighter.body->com.position.size()) {
        const Eigen::Vector3d& com = fighter.body->com.position[index];
        pose.centreOfMass = place(com);
        if (fighter.force && index < fighter.force->force.force.size()) {
            pose.force = place(com + fighter.force->force.force[index]) - *pose.centreOfMass;
        }
    }
    return pose;
}

/// Where the fighter goes during the take, with room for its body; of a skeleton that is no body,
/// where its joints go.
void addPath(Box& box, const FighterAnalysis& fighter) {
    const double floor = fighter.body ? fighter.body->floor : 0.0;
    const JointPositions& positions = fighter.motion->positions;
    const int step = std::max(1, positions.frameCount / 500);
    for (int frame = 0; frame < positions.frameCount; frame += step) {
        for (int joint = 0; joint < positions.jointCount && !fighter.force; ++joint) {
            box.add(placed(fighter.input, floor, positions.at(frame, joint).cast<double>()));
        }
        if (!fighter.force) continue;
        const Eigen::Vector3d root =
            placed(fighter.input, floor, positions.at(frame, 0).cast<double>());
        box.add({root.x() - 0.35, 0.0, root.z() - 0.35});
        box.add({root.x() + 0.35, 1.75, root.z() + 0.35});
    }
}

}  // namespace

struct StageView::Scene {
    explicit Scene(QWidget* parent) : canvas(new VtkWidget(parent)), stage(canvas->renderer()) {}

    VtkWidget* canvas;
    Stage stage;
    CameraController camera;
    std::array<std::vector<Bone>, 2> bones;
    QLabel* caption = nullptr;
};

StageView::StageView(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), scene_(std::make_unique<Scene>(this)) {
    setAccessibleName(tr("3D view"));
    setFocusPolicy(Qt::ClickFocus);
    setMinimumSize(320, 200);
    scene_->caption = new QLabel(this);
    scene_->caption->setProperty("role", "second");
    scene_->caption->setAttribute(Qt::WA_TransparentForMouseEvents);
    scene_->caption->setText(tr("grid 1 m   ·   arrow: contact force, 0.5 m per BW"));
    connect(&session_, &Session::takeChanged, this, &StageView::takeChanged);
    connect(&session_, &Session::fightersChanged, this, &StageView::bodiesChanged);
    connect(&session_, &Session::activePlayerChanged, this, &StageView::showColours);
    connect(&session_.transport(), &Transport::moved, this, &StageView::showPose);
    connect(&session_.transport(), &Transport::stateChanged, this, [this] {
        // Without a graphics card smooth motion matters more than smooth edges.
        const bool hurry = scene_->canvas->isSoftware() && session_.transport().isPlaying();
        scene_->stage.setSmooth(!hurry);
        scene_->canvas->markDirty();
    });
    showColours();
    applyCamera();
}

StageView::~StageView() {
    // Before the scene: the widget's context must still be there when VTK lets go of it.
    delete scene_->canvas;
}

void StageView::takeChanged() {
    bodiesChanged();
    frameAll();
}

void StageView::bodiesChanged() {
    for (int player = 0; player < 2; ++player) {
        auto& bones = scene_->bones[static_cast<std::size_t>(player)];
        bones.clear();
        const FighterAnalysis* fighter = session_.fighter(player);
        if (fighter == nullptr || !fighter->input.motion) continue;
        bones = bonesOf(*fighter->input.motion->skeleton, fighter->input.roles,
                        fighter->input.space.metresPerUnit);
    }
    showPose();
}

void StageView::showPose() {
    for (int player = 0; player < 2; ++player) {
        const FighterAnalysis* fighter = session_.fighter(player);
        Figure& figure = scene_->stage.figure(player);
        if (fighter == nullptr) {
            figure.hide();
        } else {
            figure.show(scene_->bones[static_cast<std::size_t>(player)],
                        poseAt(*fighter, session_.shownFrame(player)));
        }
    }
    scene_->canvas->markDirty();
}

void StageView::showColours() {
    const int active = session_.playerCount() > 1 ? session_.activePlayer() : -1;
    scene_->stage.setColours(coloursFor(palette()), active);
    scene_->canvas->markDirty();
}

void StageView::applyCamera() {
    scene_->stage.setCamera(scene_->camera);
    scene_->canvas->markDirty();
}

void StageView::frameAll() {
    Box box;
    for (int player = 0; player < 2; ++player) {
        if (const FighterAnalysis* fighter = session_.fighter(player)) addPath(box, *fighter);
    }
    scene_->stage.setFloor(box);
    scene_->camera.frame(box, {double(width()), double(height())});
    applyCamera();
}

void StageView::frameActiveFighter() {
    const FighterAnalysis* fighter = session_.fighter(session_.activePlayer());
    if (fighter == nullptr) return;
    Box box;
    const FigurePose pose = poseAt(*fighter, session_.shownFrame(session_.activePlayer()));
    for (const auto& joint : pose.joints)
        box.add(joint.cast<double>());
    box.low.array() -= 0.15;
    box.high.array() += 0.15;
    scene_->camera.frame(box, {double(width()), double(height())});
    applyCamera();
}

void StageView::lookFrom(double yaw, double pitch) {
    scene_->camera.lookFrom(yaw, pitch);
    applyCamera();
}

void StageView::lookFromFront() {
    lookFrom(0, 0);
}

void StageView::lookFromSide() {
    lookFrom(std::numbers::pi / 2, 0);
}

void StageView::lookFromTop() {
    lookFrom(0, std::numbers::pi / 2);
}

void StageView::resizeEvent(QResizeEvent*) {
    scene_->canvas->setGeometry(rect());
    QLabel* caption = scene_->caption;
    caption->adjustSize();
    caption->move(12, height() - caption->height() - 8);
}

void StageView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) showColours();
    QWidget::changeEvent(event);
}

void StageView::mousePressEvent(QMouseEvent* event) {
    pressed_ = lastPointer_ = event->position();
    dragged_ = false;
}

void StageView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - lastPointer_;
    if ((event->position() - pressed_).manhattanLength() > 3) dragged_ = true;
    if (!dragged_ || event->buttons() == Qt::NoButton) return;
    lastPointer_ = event->position();
    const Viewport viewport{double(width()), double(height())};
    const bool pan =
        (event->buttons() & Qt::MiddleButton) || (event->modifiers() & Qt::ShiftModifier);
    if (pan) {
        scene_->camera.pan(moved.x(), moved.y(), viewport);
    } else {
        scene_->camera.orbit(mouseSpeed_ * moved.x(), mouseSpeed_ * moved.y(), viewport);
    }
    applyCamera();
}

void StageView::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragged_ && event->button() == Qt::LeftButton) activateFighterAt(event->position());
}

void StageView::wheelEvent(QWheelEvent* event) {
    const double factor = std::pow(1.0015, mouseSpeed_ * event->angleDelta().y());
    scene_->camera.zoomAbout(event->position().x(), event->position().y(), factor,
                             {double(width()), double(height())});
    applyCamera();
    event->accept();
}

void StageView::activateFighterAt(const QPointF& position) {
    const Viewport viewport{double(width()), double(height())};
    constexpr double kReach = 24;  // pixels
    double nearest = kReach;
    int found = -1;
    for (int player = 0; player < 2; ++player) {
        const FighterAnalysis* fighter = session_.fighter(player);
        if (fighter == nullptr) continue;
        for (const auto& joint : poseAt(*fighter, session_.shownFrame(player)).joints) {
            const Eigen::Vector3d at = scene_->camera.project(joint.cast<double>(), viewport);
            const double distance = std::hypot(at.x() - position.x(), at.y() - position.y());
            if (at.z() > 0 && distance < nearest) {
                nearest = distance;
                found = player;
            }
        }
    }
    if (found >= 0) session_.setActivePlayer(found);
}

}  // namespace kumite::studio
