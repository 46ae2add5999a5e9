#include "studio/workspaces/keyframe/joint_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <numbers>

#include "studio/app/panel_parts.h"
#include "studio/app/words.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {
constexpr double kDegrees = 180 / std::numbers::pi;
}

JointBox::JointBox(KeySession& keys, QWidget* parent)
    : QWidget(parent), keys_(keys), joint_(new QComboBox(this)), limits_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(headingLabel(tr("Joint"), this));
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    joint_->setAccessibleName(tr("Joint to turn"));
    joint_->setToolTip(tr("Which joint has rings in the 3D view; J chooses the next one"));
    joint_->setMinimumContentsLength(8);
    joint_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form->addRow(tr("Joint"), joint_);
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    const char* const axes[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto* field = new QDoubleSpinBox(this);
        field->setRange(-360, 360);
        field->setDecimals(1);
        field->setSingleStep(5);
        field->setButtonSymbols(QAbstractSpinBox::NoButtons);
        field->setKeyboardTracking(false);
        field->setMinimumWidth(10);
        field->setAccessibleName(tr("Turn about %1, degrees").arg(QLatin1String(axes[axis])));
        field->setToolTip(tr("About the parent's %1, degrees; turned about y first, then x, then z")
                              .arg(QLatin1String(axes[axis])));
        connect(field, &QDoubleSpinBox::valueChanged, this, &JointBox::turn);
        row->addWidget(field, 1);
        angles_[axis] = field;
    }
    form->addRow(tr("x y z, °"), row);
    layout->addLayout(form);
    limits_->setWordWrap(true);
    limits_->setProperty("role", "second");
    limits_->setAccessibleName(tr("How much of the joint's limits that takes"));
    layout->addWidget(limits_);
    connect(joint_, &QComboBox::activated, this, [this](int index) {
        const int joint = joint_->itemData(index).toInt();
        keys_.setJoint(joint < 0 ? std::nullopt : std::optional(joint));
    });
    for (auto signal : {&KeySession::chosen, &KeySession::moved, &KeySession::draftChanged,
                        &KeySession::stateChanged})
        connect(&keys_, signal, this, &JointBox::refresh);
    refresh();
}

void JointBox::fill() {
    const Rig* rig = keys_.draft().track.rig.get();
    if (rig == filledFor_) return;
    filledFor_ = rig;
    joint_->clear();
    joint_->addItem(tr("none"), -1);
    for (const int joint : keys_.joints())
        joint_->addItem(keys_.jointName(joint), joint);
}

void JointBox::refresh() {
    fill();
    const bool editable = keys_.isEditable() && keys_.pose() != nullptr;
    const auto joint = keys_.joint();
    joint_->setCurrentIndex(joint_->findData(joint.value_or(-1)));
    joint_->setEnabled(editable);
    const bool shown = editable && joint;
    Eigen::Vector3d angles = Eigen::Vector3d::Zero();
    QString text;
    if (shown) {
        const Rig& rig = *keys_.draft().track.rig;
        const auto& turn = keys_.pose()->turns[static_cast<std::size_t>(*joint)];
        angles = jointAngles(turn);
        const auto limit = jointLimit(rig, *joint);
        const auto bend = jointBend(rig, *joint, turn);
        text = limit && bend ? tr("Bent by %1° of %2°, twisted by %3° of %4° from rest.")
                                   .arg(numberText(kDegrees * bend->swing, 0))
                                   .arg(numberText(kDegrees * limit->swing, 0))
                                   .arg(numberText(kDegrees * bend->twist, 0))
                                   .arg(numberText(kDegrees * limit->twist, 0))
                             : tr("This joint has no limits.");
    } else if (editable) {
        text = tr("A chosen joint has rings in the 3D view: drag one to turn it.");
    }
    limits_->setText(text);
    limits_->setVisible(!text.isEmpty());
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = angles_[static_cast<std::size_t>(axis)];
        const QSignalBlocker quiet(field);
        field->setEnabled(shown);
        field->setValue(angles[axis]);
    }
}

void JointBox::turn() {
    if (!keys_.isEditable() || !keys_.joint() || keys_.pose() == nullptr) return;
    // What was not typed stays exactly: the fields round.
    const auto& turn = keys_.pose()->turns[static_cast<std::size_t>(*keys_.joint())];
    Eigen::Vector3d angles = jointAngles(turn);
    for (int axis = 0; axis < 3; ++axis) {
        const double typed = angles_[static_cast<std::size_t>(axis)]->value();
        if (std::abs(typed - angles[axis]) > 0.051) angles[axis] = typed;
    }
    keys_.turnTo(turnOfAngles(angles));
}

}  // namespace kumite::studio
