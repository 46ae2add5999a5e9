#include "studio/workspaces/keyframe/pose_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "studio/app/panel_parts.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {

QString handleText(Handle handle) {
    switch (handle) {
        case Handle::LeftHand:
            return PoseBox::tr("left hand");
        case Handle::RightHand:
            return PoseBox::tr("right hand");
        case Handle::LeftFoot:
            return PoseBox::tr("left foot");
        case Handle::RightFoot:
            return PoseBox::tr("right foot");
        case Handle::Hips:
            return PoseBox::tr("hips");
        case Handle::Chest:
            return PoseBox::tr("chest");
        case Handle::Head:
            return PoseBox::tr("head");
    }
    return {};
}

constexpr Easing kEasings[] = {Easing::Smooth, Easing::Linear, Easing::In, Easing::Out,
                               Easing::Hold};

QString easingText(Easing easing) {
    switch (easing) {
        case Easing::Linear:
            return PoseBox::tr("even");
        case Easing::Smooth:
            return PoseBox::tr("smooth");
        case Easing::In:
            return PoseBox::tr("from rest");
        case Easing::Out:
            return PoseBox::tr("to rest");
        case Easing::Hold:
            return PoseBox::tr("hold");
    }
    return {};
}

}  // namespace

PoseBox::PoseBox(KeySession& keys, QWidget* parent)
    : QWidget(parent),
      keys_(keys),
      text_(new QLabel(this)),
      handle_(new QComboBox(this)),
      pinned_(new QCheckBox(tr("stays where it is"), this)),
      easing_(new QComboBox(this)),
      frame_(new QSpinBox(this)),
      along_(new QCheckBox(tr("and later keys"), this)),
      stretch_(new QDoubleSpinBox(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    text_->setWordWrap(true);
    text_->setProperty("role", "second");
    text_->setAccessibleName(tr("The chosen key"));
    layout->addWidget(text_);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    for (const Handle handle : allHandles())
        handle_->addItem(handleText(handle), static_cast<int>(handle));
    handle_->setAccessibleName(tr("Handle"));
    handle_->setToolTip(tr("What is drawn: drag it in the 3D view, or give its place below"));
    form->addRow(tr("Handle"), handle_);
    pinned_->setToolTip(
        tr("While another handle is drawn this one stays; Ctrl and a click on it does the same"));
    form->addRow(QString(), pinned_);
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    const char* const axes[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto* field = new QDoubleSpinBox(this);
        field->setRange(-20, 20);
        field->setDecimals(2);
        field->setSingleStep(0.02);
        field->setButtonSymbols(QAbstractSpinBox::NoButtons);
        field->setKeyboardTracking(false);
        field->setMinimumWidth(10);
        field->setAccessibleName(tr("Place, %1 in metres").arg(QLatin1String(axes[axis])));
        field->setToolTip(tr("%1, metres; y is up").arg(QLatin1String(axes[axis])));
        connect(field, &QDoubleSpinBox::valueChanged, this,
                [this, axis](double metres) { place(static_cast<int>(axis), metres); });
        row->addWidget(field, 1);
        place_[axis] = field;
    }
    form->addRow(tr("x y z, m"), row);
    for (const Easing easing : kEasings)
        easing_->addItem(easingText(easing), static_cast<int>(easing));
    easing_->setAccessibleName(tr("Way to the next key"));
    easing_->setToolTip(tr("How the way to the next key goes"));
    form->addRow(tr("Way on"), easing_);
    addTimes(form);
    layout->addLayout(form);
    connect(handle_, &QComboBox::activated, this, [this](int index) {
        keys_.setHandle(static_cast<Handle>(handle_->itemData(index).toInt()));
    });
    connect(pinned_, &QCheckBox::clicked, this,
            [this](bool on) { keys_.setPinned(keys_.handle(), on); });
    connect(easing_, &QComboBox::activated, this, [this](int index) {
        keys_.setEasing(static_cast<Easing>(easing_->itemData(index).toInt()));
    });
    for (auto signal : {&KeySession::chosen, &KeySession::moved, &KeySession::draftChanged,
                        &KeySession::stateChanged})
        connect(&keys_, signal, this, &PoseBox::refresh);
    refresh();
}

void PoseBox::addTimes(QFormLayout* form) {
    frame_->setRange(0, 100000);
    frame_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    frame_->setKeyboardTracking(false);
    frame_->setMinimumWidth(10);
    frame_->setAccessibleName(tr("Frame of the key"));
    frame_->setToolTip(tr("Moves the key to that frame"));
    along_->setToolTip(tr("Later keys go as many frames along"));
    form->addRow(tr("Frame"), frame_);
    form->addRow(QString(), along_);
    stretch_->setRange(0.1, 10);
    stretch_->setDecimals(2);
    stretch_->setSingleStep(0.1);
    stretch_->setValue(1);
    stretch_->setPrefix(QStringLiteral("× "));
    stretch_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    stretch_->setKeyboardTracking(false);
    stretch_->setAccessibleName(tr("Time from this key on, times"));
    stretch_->setToolTip(
        tr("All later keys that many times as far from this one: 2 is half as fast"));
    form->addRow(tr("Time on"), stretch_);
    connect(frame_, &QSpinBox::valueChanged, this, [this](int frame) {
        if (!keys_.key()) return;
        if (along_->isChecked()) {
            keys_.shiftKeys(*keys_.key(), frame);
        } else {
            keys_.moveKey(*keys_.key(), frame);
        }
        refresh();  // what could not be done
    });
    connect(stretch_, &QDoubleSpinBox::valueChanged, this, [this](double factor) {
        keys_.retime(factor);
        const QSignalBlocker quiet(stretch_);
        stretch_->setValue(1);
    });
}

void PoseBox::refresh() {
    const bool editable = keys_.isEditable();
    text_->setText(editable ? tr("Frame %1. Drag hands, feet, hips, chest or head in the 3D view.")
                                  .arg(*keys_.key())
                   : keys_.draft().track.keys.empty() ? tr("Return makes a key.")
                                                      : tr("Choose a key to change its pose."));
    handle_->setCurrentIndex(handle_->findData(static_cast<int>(keys_.handle())));
    pinned_->setChecked(keys_.pins()[keys_.handle()]);
    for (QWidget* field : {static_cast<QWidget*>(handle_), static_cast<QWidget*>(pinned_),
                           static_cast<QWidget*>(easing_), static_cast<QWidget*>(frame_),
                           static_cast<QWidget*>(along_), static_cast<QWidget*>(stretch_)})
        field->setEnabled(editable);
    const QSignalBlocker still(frame_);
    frame_->setValue(keys_.key().value_or(0));
    const auto at = editable && keys_.pose() != nullptr
                        ? handlePoint(*keys_.draft().track.rig, *keys_.pose(), keys_.handle())
                        : std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QSignalBlocker quiet(place_[axis]);
        place_[axis]->setEnabled(at.has_value());
        place_[axis]->setValue(at ? (*at)[static_cast<int>(axis)] : 0);
    }
    if (editable) {
        const auto& track = keys_.draft().track;
        const auto index = static_cast<std::size_t>(*track.find(*keys_.key()));
        easing_->setCurrentIndex(easing_->findData(static_cast<int>(track.keys[index].easing)));
    }
}

void PoseBox::place(int axis, double metres) {
    if (!keys_.isEditable() || keys_.pose() == nullptr) return;
    // The other two stay exactly: the fields round.
    auto at = handlePoint(*keys_.draft().track.rig, *keys_.pose(), keys_.handle());
    if (!at) return;
    (*at)[axis] = metres;
    keys_.place(keys_.handle(), *at);
}

}  // namespace kumite::studio
