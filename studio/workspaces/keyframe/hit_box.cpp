#include "studio/workspaces/keyframe/hit_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "studio/app/core_words.h"
#include "studio/app/panel_parts.h"
#include "studio/app/words.h"
#include "studio/workspaces/keyframe/hit_session.h"

namespace kumite::studio {

HitBox::HitBox(HitSession& hit, QWidget* parent)
    : QWidget(parent),
      hit_(hit),
      strike_(new QComboBox(this)),
      aim_(new QComboBox(this)),
      distance_(new QDoubleSpinBox(this)),
      text_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(headingLabel(tr("Hit a target"), this));
    auto* about =
        new QLabel(tr("Drag the target in the 3D view: the strike follows it. Dots: where "
                      "whole examples hit; the box: what is reached."),
                   this);
    about->setWordWrap(true);
    about->setProperty("role", "second");
    layout->addWidget(about);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    strike_->setAccessibleName(tr("Strike"));
    strike_->setToolTip(tr("Which strike; its examples are the actions with that label"));
    strike_->setMinimumContentsLength(8);
    strike_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form->addRow(tr("Strike"), strike_);
    aim_->addItem(tr("a place"), -1);
    for (const Role role : HitSession::aims())
        aim_->addItem(roleWords(role), static_cast<int>(role));
    aim_->setAccessibleName(tr("Aim at"));
    aim_->setToolTip(
        tr("A place in space, or the opponent as the recording's playhead shows it; "
           "a click on its marks in the 3D view aims there"));
    form->addRow(tr("Aim at"), aim_);
    distance_->setRange(0.2, 3);
    distance_->setDecimals(2);
    distance_->setSingleStep(0.05);
    distance_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    distance_->setKeyboardTracking(false);
    distance_->setAccessibleName(tr("Distance of the opponent, metres"));
    distance_->setToolTip(tr("How far ahead the opponent stands, from pelvis to pelvis"));
    form->addRow(tr("Away, m"), distance_);
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    const QString axes[] = {tr("to the left"), tr("up"), tr("ahead")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto* field = new QDoubleSpinBox(this);
        field->setRange(-3, 3);
        field->setDecimals(2);
        field->setSingleStep(0.02);
        field->setButtonSymbols(QAbstractSpinBox::NoButtons);
        field->setKeyboardTracking(false);
        field->setMinimumWidth(10);
        field->setAccessibleName(tr("Target, metres %1").arg(axes[axis]));
        field->setToolTip(field->accessibleName());
        connect(field, &QDoubleSpinBox::valueChanged, this, [this, axis](double metres) {
            // The other two stay exactly: the fields round.
            Eigen::Vector3d target = hit_.target();
            target[static_cast<int>(axis)] = metres;
            hit_.setTarget(target);
        });
        row->addWidget(field, 1);
        place_[axis] = field;
    }
    form->addRow(tr("Target, m"), row);
    layout->addLayout(form);
    text_->setWordWrap(true);
    text_->setAccessibleName(tr("How well it is hit"));
    layout->addWidget(text_);
    layout->addStretch(1);
    connect(strike_, &QComboBox::activated, this, [this](int index) {
        hit_.setStrike(strike_->itemData(index).toString().toStdString());
    });
    connect(aim_, &QComboBox::activated, this, [this](int index) {
        const int role = aim_->itemData(index).toInt();
        hit_.setAim(role < 0 ? std::nullopt : std::optional(static_cast<Role>(role)));
    });
    connect(distance_, &QDoubleSpinBox::valueChanged, &hit_, &HitSession::setDistance);
    connect(&hit_, &HitSession::changed, this, &HitBox::refresh);
    refresh();
}

void HitBox::refresh() {
    const QSignalBlocker quiet(strike_);
    strike_->clear();
    for (const std::string& strike : hit_.strikes())
        strike_->addItem(hit_.nameOf(strike), QString::fromStdString(strike));
    strike_->setCurrentIndex(strike_->findData(QString::fromStdString(hit_.strike())));
    aim_->setCurrentIndex(aim_->findData(hit_.aim() ? static_cast<int>(*hit_.aim()) : -1));
    const QSignalBlocker calm(distance_);
    distance_->setValue(hit_.distance());
    distance_->setEnabled(hit_.aim().has_value());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QSignalBlocker still(place_[axis]);
        place_[axis]->setEnabled(hit_.space() != nullptr);
        place_[axis]->setValue(hit_.target()[static_cast<int>(axis)]);
    }
    if (!hit_.problem().isEmpty()) {
        text_->setText(hit_.problem());
        return;
    }
    if (hit_.space() == nullptr) {
        text_->setText(hit_.jobs().isRunning() ? tr("The strikes are being aligned.") : QString());
        return;
    }
    const auto& motion = hit_.motion();
    if (!motion) return text_->setText({});
    const QString error = numberText(100 * motion->error, 1);
    const QString where =
        motion->solution.insideNaturalRegion ? tr("A blend of whole examples reaches it.")
        : hit_.reach().contains(hit_.target())
            ? tr("No blend of whole examples reaches it: parts of the body are blended and turned.")
            : tr("It is outside of the box that is reached.");
    text_->setText((motion->hits ? tr("Hit, %1 cm off. %2 %3 examples.")
                                 : tr("Missed by %1 cm: the nearest that can be reached. %2 %3 "
                                      "examples."))
                       .arg(error, where)
                       .arg(hit_.space()->examples.size()));
}

}  // namespace kumite::studio
