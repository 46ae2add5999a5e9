#include "studio/workspaces/bout/bout_stage.h"

#include <array>

#include "core/project/kept_bout.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/bout/bout_session.h"

namespace kumite::studio {

BoutStage::BoutStage(BoutSession& bout, StageView& stage, QObject* parent)
    : QObject(parent), bout_(bout), stage_(stage) {
    connect(&bout_, &BoutSession::begun, this, &BoutStage::begin);
    connect(&bout_, &BoutSession::moved, this, &BoutStage::show);
    connect(&bout_, &BoutSession::stateChanged, this, [this] {
        if (isShown() != stage_.isLiveFor(this)) begin();
        stage_.setPointingAtFloor(isShown() && bout_.steers());
        showMark();
    });
    connect(&stage_, &StageView::floorHovered, this, [this](const auto& place) {
        pointed_ = place;
        showMark();
    });
    connect(&stage_, &StageView::floorClicked, this,
            [this](const Eigen::Vector2d& place) { bout_.setTarget(place); });
}

bool BoutStage::isShown() const {
    return bout_.isActive() && bout_.tape() != nullptr;
}

void BoutStage::begin() {
    if (!isShown()) {
        if (stage_.isLiveFor(this)) stage_.setPointingAtFloor(false);
        stage_.endLive(this);
        framed_ = false;
        return;
    }
    std::array<std::vector<Bone>, 2> bones;
    for (const int player : {0, 1}) {
        const Fighter& fighter = bout_.like(player);
        bones[static_cast<std::size_t>(player)] =
            bonesOf(*fighter.motion->skeleton, fighter.roles, fighter.space.metresPerUnit);
    }
    stage_.beginLive(this, std::move(bones));
    stage_.setPointingAtFloor(bout_.steers());
    show();
    if (!framed_) stage_.frameAll();
    framed_ = true;
}

void BoutStage::show() {
    if (!isShown() || !stage_.isLiveFor(this)) return;
    std::array<FigurePose, 2> poses;
    for (const int player : {0, 1}) {
        for (const Eigen::Vector3d& joint : bout_.tape()->now().shown(player).joints.positions)
            poses[static_cast<std::size_t>(player)].joints.push_back(joint.cast<float>());
    }
    stage_.showLive(std::move(poses));
    showMark();
}

/// Where the avatar shall be; else faintly where a click would say so.
void BoutStage::showMark() {
    if (!isShown() || !bout_.steers()) return;
    const auto& target = bout_.tape()->now().target();
    stage_.setFloorMark(target ? target : pointed_, !target);
}

}  // namespace kumite::studio
