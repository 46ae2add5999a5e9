#include "studio/workspaces/keyframe/key_stage.h"

#include "studio/view3d/stage_view.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {
constexpr double kRing = 0.16;  // metres
constexpr std::size_t kMostDots = 500;
constexpr double kBeside = 1.2;  // metres
}  // namespace

KeyStage::KeyStage(KeySession& keys, HitSession& hit, StageView& stage, QObject* parent)
    : QObject(parent), keys_(keys), hit_(hit), stage_(stage) {
    connect(&hit_, &HitSession::changed, this, &KeyStage::show);
    connect(&hit_, &HitSession::moved, this, &KeyStage::show);
    connect(&keys_, &KeySession::libraryChanged, this, &KeyStage::begin);
    connect(&keys_, &KeySession::stateChanged, this, &KeyStage::begin);
    connect(&keys_, &KeySession::moved, this, &KeyStage::show);
    connect(&keys_, &KeySession::chosen, this, &KeyStage::show);
    connect(&stage_, &StageView::handlePressed, this,
            [this](int index, Qt::KeyboardModifiers modifiers) {
                if (!isShown()) return;
                if (hit_.isOn()) {
                    const auto aim = static_cast<std::size_t>(index - 1);
                    if (index > 0 && aim < aims_.size()) hit_.setAim(aims_[aim]);
                    return;
                }
                const Handle handle = handles_[static_cast<std::size_t>(index)];
                keys_.setHandle(handle);
                if (modifiers & Qt::ControlModifier) keys_.setPinned(handle, !keys_.pins()[handle]);
            });
    connect(&stage_, &StageView::handleDragged, this,
            [this](int index, const Eigen::Vector3d& place) {
                if (!isShown()) return;
                if (hit_.isOn()) {
                    if (index == 0) hit_.drag(place);
                } else {
                    keys_.drag(handles_[static_cast<std::size_t>(index)], place);
                }
            });
    connect(&stage_, &StageView::handleReleased, this, [this] {
        if (!isShown()) return;
        if (hit_.isOn()) {
            hit_.release();
        } else {
            keys_.release();
        }
    });
    connect(&stage_, &StageView::ringTurned, this, [this](int ring, double angle) {
        if (isShown() && !hit_.isOn()) keys_.turn(ring, angle);
    });
    connect(&stage_, &StageView::ringReleased, this, [this] {
        if (isShown() && !hit_.isOn()) keys_.release();
    });
    connect(&stage_, &StageView::dragCancelled, this, [this] {
        hit_.cancelDrag();
        keys_.cancelDrag();
    });
}

bool KeyStage::isShown() const {
    return library_ != nullptr && stage_.isLiveFor(this);
}

void KeyStage::begin() {
    const auto wanted = keys_.isActive() ? keys_.motions() : nullptr;
    if (wanted == library_ && (wanted == nullptr || stage_.isLiveFor(this))) return show();
    library_ = wanted;
    framed_ = false;
    if (library_ == nullptr) {
        stage_.endLive(this);
        return;
    }
    std::array<std::vector<Bone>, 2> bones;
    bones[0] = bonesOf(*library_->skeleton, library_->rig->roles, library_->space.metresPerUnit);
    bones[1] = bones[0];  // for what stands beside it
    ghosts_.clear();
    stage_.beginLive(this, std::move(bones));
    show();
}

std::vector<Eigen::Vector3f> KeyStage::jointsOf(const Pose& pose) const {
    JointFrames frames;
    jointFrames(*library_->rig, pose, frames);
    std::vector<Eigen::Vector3f> joints;
    for (const Eigen::Vector3d& joint : frames.positions)
        joints.push_back(joint.cast<float>());
    return joints;
}

void KeyStage::showTarget(StageHandles& shown, FigurePose& opponent) {
    aims_.clear();
    if (hit_.space() == nullptr) return;
    shown.all.push_back({hit_.target(), true, false});
    shown.boxes.push_back({hit_.reach().low, hit_.reach().high, false});
    const auto points = hit_.space()->points.points();
    const std::size_t step = points.size() / kMostDots + 1;
    for (std::size_t i = 0; i < points.size(); i += step)
        shown.dots.push_back(points[i]);
    if (hit_.opponent() == nullptr) return;
    opponent.joints = jointsOf(*hit_.opponent());
    for (const Role role : HitSession::aims()) {
        const auto joint = library_->rig->roles[role];
        if (!joint || role == hit_.aim()) continue;
        aims_.push_back(role);
        shown.all.push_back(
            {opponent.joints[static_cast<std::size_t>(*joint)].cast<double>(), false, true});
    }
}

void KeyStage::showNeighbours() {
    std::vector<StageGhost> ghosts;
    if (!hit_.isOn() && keys_.showsNeighbours() && !keys_.isPlaying()) {
        for (const Pose& pose : keys_.neighbours())
            ghosts.push_back({0, jointsOf(pose)});
    }
    if (ghosts == ghosts_) return;
    ghosts_ = std::move(ghosts);
    stage_.setLiveGhosts(ghosts_);
}

void KeyStage::show() {
    if (!isShown()) return;
    std::array<FigurePose, 2> poses;
    StageHandles shown;
    handles_.clear();
    const Pose* pose = hit_.isOn() ? hit_.pose() : keys_.pose();
    if (hit_.isOn()) showTarget(shown, poses[1]);
    if (pose != nullptr) {
        JointFrames frames;
        jointFrames(*library_->rig, *pose, frames);
        poses[0].joints = jointsOf(*pose);
        if (!hit_.isOn() && keys_.isEditable() && keys_.joint()) {
            const int joint = *keys_.joint(), parent = library_->rig->joint(joint).parent;
            const Eigen::Quaterniond axes = parent < 0
                                                ? Eigen::Quaterniond::Identity()
                                                : frames.turns[static_cast<std::size_t>(parent)];
            for (int axis = 0; axis < 3; ++axis)
                shown.rings.push_back({frames.positions[static_cast<std::size_t>(joint)],
                                       axes * Eigen::Vector3d::Unit(axis), kRing});
        }
        for (const Handle handle : allHandles()) {
            if (hit_.isOn()) break;
            const auto at =
                keys_.isEditable() ? handlePoint(*library_->rig, *pose, handle) : std::nullopt;
            if (!at) continue;
            handles_.push_back(handle);
            shown.all.push_back({*at, handle == keys_.handle(), keys_.pins()[handle]});
        }
    }
    if (const auto direct = hit_.isOn() ? std::nullopt : keys_.directPose()) {
        Pose beside = *direct;
        beside.root.x() += kBeside;
        poses[1].joints = jointsOf(beside);
    }
    const bool empty = poses[0].joints.empty();
    stage_.showLive(std::move(poses));
    stage_.setHandles(std::move(shown));
    showNeighbours();
    if (!empty && !framed_) {
        stage_.frameAll();
        framed_ = true;
    }
}

}  // namespace kumite::studio
