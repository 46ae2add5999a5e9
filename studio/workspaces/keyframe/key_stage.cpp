#include "studio/workspaces/keyframe/key_stage.h"

#include "studio/view3d/stage_view.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {
constexpr double kRing = 0.16;  // metres
}

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
                if (!isShown() || hit_.isOn()) return;
                const Handle handle = handles_[static_cast<std::size_t>(index)];
                keys_.setHandle(handle);
                if (modifiers & Qt::ControlModifier) keys_.setPinned(handle, !keys_.pins()[handle]);
            });
    connect(&stage_, &StageView::handleDragged, this,
            [this](int index, const Eigen::Vector3d& place) {
                if (!isShown()) return;
                if (hit_.isOn()) {
                    hit_.drag(place);
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
    stage_.beginLive(this, std::move(bones));
    show();
}

void KeyStage::show() {
    if (!isShown()) return;
    std::array<FigurePose, 2> poses;
    StageHandles shown;
    handles_.clear();
    const Pose* pose = hit_.isOn() ? hit_.pose() : keys_.pose();
    if (hit_.isOn() && hit_.space() != nullptr) {
        shown.all.push_back({hit_.target(), true, false});
        shown.boxes.push_back({hit_.space()->natural.low, hit_.space()->natural.high, true});
        shown.boxes.push_back({hit_.reach().low, hit_.reach().high, false});
    }
    if (pose != nullptr) {
        JointFrames frames;
        jointFrames(*library_->rig, *pose, frames);
        for (const Eigen::Vector3d& joint : frames.positions)
            poses[0].joints.push_back(joint.cast<float>());
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
    const bool empty = poses[0].joints.empty();
    stage_.showLive(std::move(poses));
    stage_.setHandles(std::move(shown));
    if (!empty && !framed_) {
        stage_.frameAll();
        framed_ = true;
    }
}

}  // namespace kumite::studio
