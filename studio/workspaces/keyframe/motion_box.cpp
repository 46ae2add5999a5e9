#include "studio/workspaces/keyframe/motion_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <cmath>

#include "studio/app/panel_parts.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {

QString partText(BodyPart part) {
    switch (part) {
        case BodyPart::LeftArm:
            return MotionBox::tr("left arm");
        case BodyPart::RightArm:
            return MotionBox::tr("right arm");
        case BodyPart::LeftLeg:
            return MotionBox::tr("left leg");
        case BodyPart::RightLeg:
            return MotionBox::tr("right leg");
        case BodyPart::Trunk:
            return MotionBox::tr("trunk, head");
    }
    return {};
}

}  // namespace

MotionBox::MotionBox(KeySession& keys, QWidget* parent)
    : QWidget(parent),
      keys_(keys),
      text_(new QLabel(this)),
      list_(new QListWidget(this)),
      adjusted_(new QCheckBox(tr("joints adjusted"), this)),
      meet_(new QSlider(Qt::Horizontal, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->setSpacing(4);
    text_->setWordWrap(true);
    text_->setProperty("role", "second");
    text_->setAccessibleName(tr("What the motion is made of"));
    layout->addWidget(text_);
    list_->setAccessibleName(tr("Places that are like the keys"));
    list_->setToolTip(
        tr("The places that are most like the keys, the best first; a click, or "
           "Return, takes the whole body from there"));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(list_, 1);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(3);
    for (const BodyPart part : allParts()) {
        auto* box = new QComboBox(this);
        box->addItem(tr("what fits better"), static_cast<int>(PartChoice::Kind::Automatic));
        box->addItem(tr("with the body"), static_cast<int>(PartChoice::Kind::WithBody));
        box->addItem(tr("its own best"), static_cast<int>(PartChoice::Kind::Own));
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setAccessibleName(tr("Where the %1 comes from").arg(partText(part)));
        box->setToolTip(box->accessibleName());
        const auto index = static_cast<std::size_t>(part);
        connect(box, &QComboBox::activated, this, [this, box, index](int chosen) {
            const auto kind = static_cast<PartChoice::Kind>(box->itemData(chosen).toInt());
            keys_.change(tr("Take a part from elsewhere"),
                         [&](KeyDraft& draft) { draft.parts[index] = kind; });
        });
        form->addRow(partText(part), box);
        parts_[index] = box;
    }
    layout->addLayout(form);
    adjusted_->setToolTip(
        tr("Where parts are joined the joints' mean and spread become those of "
           "the keys (paper C, 4.2.2)"));
    layout->addWidget(adjusted_);
    auto* near = new QFormLayout;
    near->setContentsMargins(0, 0, 0, 0);
    meet_->setRange(0, 100);
    meet_->setAccessibleName(tr("How far the motion is drawn to the keys"));
    meet_->setToolTip(tr("Left: as it was found; right: through the keys' poses"));
    near->addRow(tr("Meet keys"), meet_);
    layout->addLayout(near);
    connect(list_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { take(list_->row(item)); });
    connect(list_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { take(list_->row(item)); });
    connect(adjusted_, &QCheckBox::clicked, this, [this](bool on) {
        keys_.change(tr("Join parts otherwise"),
                     [&](KeyDraft& draft) { draft.assembly.adjusted = on; });
    });
    connect(meet_, &QSlider::sliderReleased, this, [this] {
        keys_.change(tr("Draw the motion to the keys"),
                     [this](KeyDraft& draft) { draft.assembly.meetKeys = meet_->value() / 100.0; });
    });
    connect(meet_, &QSlider::valueChanged, this, [this](int value) {
        if (meet_->isSliderDown()) return;
        keys_.change(tr("Draw the motion to the keys"),
                     [&](KeyDraft& draft) { draft.assembly.meetKeys = value / 100.0; });
    });
    for (auto signal : {&KeySession::motionChanged, &KeySession::draftChanged,
                        &KeySession::stateChanged, &KeySession::libraryChanged})
        connect(&keys_, signal, this, &MotionBox::refresh);
    refresh();
}

void MotionBox::refresh() {
    const KeyMotion* motion = keys_.motion();
    const KeyDraft& draft = keys_.draft();
    if (motion == nullptr) {
        text_->setText(!keys_.problem().isEmpty() ? keys_.problem()
                       : draft.track.keys.size() < 2
                           ? tr("Two keys or more become a motion, put together from the takes "
                                "and clips.")
                           : tr("The motion is being made."));
    } else {
        const PoseMatch& body = motion->plan.body;
        text_->setText(tr("Body: %1, %2 of %3 features differ, %4 cm from the keys.")
                           .arg(keys_.placeOf(body))
                           .arg(body.match.mismatches)
                           .arg(static_cast<int>(draft.track.keys.size()) * kPoseBitCount)
                           .arg(100 * body.distance, 0, 'f', 0));
    }
    list_->clear();
    for (std::size_t i = 0; motion != nullptr && i < motion->found.size(); ++i) {
        const PoseMatch& match = motion->found[i];
        const bool taken = match.match.clip == motion->plan.body.match.clip &&
                           match.match.frames == motion->plan.body.match.frames;
        auto* item = new QListWidgetItem(
            (taken ? QStringLiteral("● ") : QStringLiteral("○ ")) + keys_.placeOf(match), list_);
        item->setToolTip(tr("%1 features differ, %2 cm from the keys")
                             .arg(match.match.mismatches)
                             .arg(100 * match.distance, 0, 'f', 0));
    }
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        parts_[part]->setCurrentIndex(parts_[part]->findData(static_cast<int>(draft.parts[part])));
        parts_[part]->setEnabled(motion != nullptr);
        const auto& own = motion != nullptr ? motion->plan.parts[part] : std::nullopt;
        parts_[part]->setToolTip(
            own ? tr("%1, %2 features differ").arg(keys_.placeOf(*own)).arg(own->match.mismatches)
                : parts_[part]->accessibleName());
    }
    const QSignalBlocker quiet(meet_);
    adjusted_->setChecked(draft.assembly.adjusted);
    adjusted_->setEnabled(motion != nullptr);
    if (!meet_->isSliderDown())
        meet_->setValue(static_cast<int>(std::lround(100 * draft.assembly.meetKeys)));
    meet_->setEnabled(motion != nullptr);
}

void MotionBox::take(int row) {
    const KeyMotion* motion = keys_.motion();
    if (motion == nullptr || row < 0 || row >= static_cast<int>(motion->found.size())) return;
    const PoseMatch& match = motion->found[static_cast<std::size_t>(row)];
    const LibraryMotion& from = keys_.library()->motion(match.match.clip);
    const double perFrame = from.sourceRate / keys_.library()->features.rate;
    // A little room around it: the same place is found again.
    const int begin = static_cast<int>(std::floor(match.match.frames.front() * perFrame));
    const int end = static_cast<int>(std::ceil(match.match.frames.back() * perFrame)) + 1;
    keys_.change(tr("Take the body from elsewhere"), [&](KeyDraft& draft) {
        draft.body = from.name + "@" + std::to_string(begin) + ":" + std::to_string(end);
    });
}

}  // namespace kumite::studio
