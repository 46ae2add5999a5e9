#include "studio/workspaces/sequence/sequence_stage.h"

#include <array>

#include "studio/view3d/stage_view.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

SequenceStage::SequenceStage(SequenceSession& sequence, StageView& stage, QObject* parent)
    : QObject(parent), sequence_(sequence), stage_(stage) {
    connect(&sequence_, &SequenceSession::libraryChanged, this, &SequenceStage::begin);
    connect(&sequence_, &SequenceSession::stateChanged, this, &SequenceStage::begin);
    connect(&sequence_, &SequenceSession::moved, this, &SequenceStage::show);
}

void SequenceStage::begin() {
    const auto wanted = sequence_.isActive() ? sequence_.sharedLibrary() : nullptr;
    if (wanted == library_) return;
    library_ = wanted;
    if (library_ == nullptr) {
        if (followed_) stage_.setFollowing(*followed_);
        followed_.reset();
        stage_.endLive(this);
        framed_ = false;
        return;
    }
    // Motions of many places follow each other: the camera goes along.
    if (!followed_) followed_ = stage_.isFollowing();
    stage_.setFollowing(true);
    std::array<std::vector<Bone>, 2> bones;
    bones[0] = bonesOf(*library_->skeleton, library_->rig->roles, library_->space.metresPerUnit);
    stage_.beginLive(this, std::move(bones));
    framed_ = false;
    show();
}

void SequenceStage::show() {
    if (library_ == nullptr || !stage_.isLiveFor(this)) return;
    std::array<FigurePose, 2> poses;
    const Pose* pose = sequence_.pose();
    if (pose != nullptr) {
        JointFrames frames;
        jointFrames(*library_->rig, *pose, frames);
        for (const Eigen::Vector3d& joint : frames.positions)
            poses[0].joints.push_back(joint.cast<float>());
    }
    stage_.showLive(std::move(poses));
    if (pose != nullptr && !framed_) {
        stage_.frameAll();
        framed_ = true;
    }
}

}  // namespace kumite::studio
