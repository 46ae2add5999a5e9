// Measuring in the 3D view, by mouse and by keys.

#include <algorithm>
#include <vector>

#include "studio/app/core_words.h"
#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/view3d/stage_scene.h"

namespace kumite::studio {

namespace {

/// The joints of a body in the order in which keys lead through them: those with a role, then the
/// rest.
std::vector<int> jointOrder(const FighterAnalysis& fighter) {
    std::vector<int> order;
    const auto add = [&order](int joint) {
        if (std::find(order.begin(), order.end(), joint) == order.end()) order.push_back(joint);
    };
    for (const Role role : allRoles()) {
        if (const auto joint = fighter.input.roles[role]) add(*joint);
    }
    for (int joint = 0; joint < fighter.motion->positions.jointCount; ++joint)
        add(joint);
    return order;
}

std::optional<Role> roleOf(const FighterAnalysis& fighter, int joint) {
    for (const Role role : allRoles()) {
        if (fighter.input.roles[role] == joint) return role;
    }
    return std::nullopt;
}

QString metresText(double metres) {
    return StageView::tr("%1 m").arg(numberText(metres, 2));
}

}  // namespace

bool StageView::isMeasuring() const {
    return scene_->measuring.isOn;
}

const Measuring& StageView::measuring() const {
    return scene_->measuring;
}

void StageView::setMeasuring(bool on) {
    on = on && !live_;  // joints and speeds are the recording's
    scene_->measuring = Measuring{};
    scene_->measuring.isOn = on;
    setMouseTracking(on || pointsAtFloor_);
    setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    showLabels();
    tellMeasured();
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

/// "left wrist" where the joint has a role, else its name in the file.
QString StageView::jointText(const JointRef& joint, bool withSpeed) const {
    const FighterAnalysis* fighter = session_.fighter(joint.player);
    if (fighter == nullptr || joint.joint >= fighter->motion->positions.jointCount) return {};
    const auto& joints = fighter->input.motion->skeleton->joints;
    const auto role = roleOf(*fighter, joint.joint);
    const QString text =
        role ? roleWords(*role)
             : QString::fromStdString(joints[static_cast<std::size_t>(joint.joint)].name);
    if (!withSpeed) return text;
    const float speed = jointSpeed(fighter->motion->positions, joint.joint,
                                   session_.shownFrame(joint.player), fighter->input.rate);
    return tr("%1   %2 m/s").arg(text, numberText(speed, 1));
}

QString StageView::measuredText() const {
    const Measuring& measuring = scene_->measuring;
    const auto whose = [this](const JointRef& joint, bool withSpeed) {
        return tr("%1: %2").arg(fighterText(joint.player), jointText(joint, withSpeed));
    };
    QStringList parts;
    if (measuring.hovered) parts.append(whose(*measuring.hovered, true));
    if (const auto distance = measuredDistance()) {
        parts.append(tr("%1 from %2 to %3")
                         .arg(metresText(*distance), whose(*measuring.from, false),
                              whose(*measuring.to, false)));
    } else if (measuring.from) {
        const auto from = jointPlace(*measuring.from);
        const auto to = measuring.hovered ? jointPlace(*measuring.hovered) : std::nullopt;
        const QString start = whose(*measuring.from, false);
        parts.append(from && to && measuring.hovered != measuring.from
                         ? tr("%1 from %2").arg(metresText((*from - *to).norm()), start)
                         : tr("from %1").arg(start));
    }
    return parts.join(QStringLiteral("   ·   "));
}

void StageView::tellMeasured() {
    const QString text = measuredText();
    if (text == told_) return;
    told_ = text;
    setAccessibleDescription(text);
    Q_EMIT session_.hovered(text);
}

void StageView::stepJoint(int direction) {
    if (!isMeasuring()) setMeasuring(true);
    const int player = session_.activePlayer();
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) return;
    const std::vector<int> order = jointOrder(*fighter);
    const auto count = static_cast<std::ptrdiff_t>(order.size());
    if (count == 0) return;
    auto& pointed = scene_->measuring.hovered;
    std::ptrdiff_t next = direction > 0 ? 0 : count - 1;
    if (pointed && pointed->player == player) {
        const auto now = std::find(order.begin(), order.end(), pointed->joint) - order.begin();
        next = (now + direction + count) % count;
    }
    pointed = JointRef{player, order[static_cast<std::size_t>(next)]};
    showLabels();
}

void StageView::takeJoint() {
    Measuring& measuring = scene_->measuring;
    if (!measuring.hovered) {
        Q_EMIT session_.hinted(tr("No joint is chosen. %1").arg(measuringHint_));
        return;
    }
    measuring.click(measuring.hovered);
    showLabels();
}

/// Keys go on at the same joint of the fighter that has become active.
void StageView::pointToOtherFighter() {
    auto& pointed = scene_->measuring.hovered;
    const int player = session_.activePlayer();
    if (!pointed || pointed->player == player) return;
    const FighterAnalysis* before = session_.fighter(pointed->player);
    const FighterAnalysis* now = session_.fighter(player);
    const auto role = before != nullptr ? roleOf(*before, pointed->joint) : std::nullopt;
    const auto joint = now != nullptr && role ? now->input.roles[*role] : std::nullopt;
    pointed = joint ? std::optional(JointRef{player, *joint}) : std::nullopt;
    showLabels();
}

}  // namespace kumite::studio
