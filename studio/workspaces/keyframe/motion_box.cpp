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
#include "studio/app/words.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/library_tile.h"
#include "studio/workspaces/keyframe/part_words.h"

namespace kumite::studio {

namespace {

constexpr int kChosen = 100;  // beside PartChoice::Kind: a place of its own
constexpr std::size_t kTiles = 5;

}  // namespace

MotionBox::MotionBox(KeySession& keys, QWidget* parent)
    : QWidget(parent),
      keys_(keys),
      text_(new QLabel(this)),
      scope_(new QComboBox(this)),
      tiles_(new ActionTiles(this)),
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
    scope_->addItem(tr("whole body"), -1);
    for (const BodyPart part : allParts())
        scope_->addItem(partText(part), static_cast<int>(part));
    scope_->setAccessibleName(tr("What is looked for"));
    scope_->setToolTip(tr("In what the places are like the keys: the whole body or one part"));
    auto* likeness = new QFormLayout;
    likeness->setContentsMargins(0, 0, 0, 0);
    likeness->addRow(tr("Similar in"), scope_);
    layout->addLayout(likeness);
    tiles_->setAccessibleName(tr("The keys and places like them"));
    tiles_->setToolTip(tr("First the keys, then what is most like them; a click takes it"));
    layout->addWidget(tiles_, 3);
    list_->setAccessibleName(tr("Places that are like the keys"));
    list_->setToolTip(
        tr("The places that are most like the keys, the best first; a click, or "
           "Return, takes the body or the part from there"));
    list_->setMinimumHeight(70);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(list_, 2);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(3);
    for (const BodyPart part : allParts()) {
        auto* box = new QComboBox(this);
        box->addItem(tr("what fits better"), static_cast<int>(PartChoice::Kind::Automatic));
        box->addItem(tr("with the body"), static_cast<int>(PartChoice::Kind::WithBody));
        box->addItem(tr("its own best"), static_cast<int>(PartChoice::Kind::Own));
        box->addItem(tr("as chosen above"), kChosen);
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setAccessibleName(tr("Where the %1 comes from").arg(partText(part)));
        box->setToolTip(box->accessibleName());
        const auto index = static_cast<std::size_t>(part);
        connect(box, &QComboBox::activated, this, [this, box, index](int chosen) {
            if (box->itemData(chosen).toInt() == kChosen) {
                // Which one is said by the list.
                scope_->setCurrentIndex(scope_->findData(static_cast<int>(index)));
                return refresh();
            }
            const auto kind = static_cast<PartChoice::Kind>(box->itemData(chosen).toInt());
            keys_.change(tr("Take a part from elsewhere"), [&](KeyDraft& draft) {
                draft.parts[index] = kind;
                draft.places[index].clear();
            });
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
    connect(scope_, &QComboBox::currentIndexChanged, this, [this] {
        refresh();
        showTiles();
    });
    // What is said of the draft while it is made anew leaves the views as they are.
    connect(&keys_, &KeySession::motionChanged, this, &MotionBox::showTiles);
    connect(&keys_, &KeySession::libraryChanged, this, &MotionBox::showTiles);
    connect(tiles_, &ActionTiles::chosenChanged, this, [this] {
        const auto chosen = tiles_->chosen();
        if (chosen.size() == 1) take(chosen.front() - 1);
    });
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
                           .arg(numberText(100 * body.distance, 0)));
    }
    list_->clear();
    for (std::size_t i = 0; found() != nullptr && i < found()->size(); ++i) {
        const PoseMatch& match = (*found())[i];
        auto* item = new QListWidgetItem(
            (isTaken(match) ? QStringLiteral("● ") : QStringLiteral("○ ")) + keys_.placeOf(match),
            list_);
        item->setToolTip(tr("%1 features differ, %2 cm from the keys")
                             .arg(match.match.mismatches)
                             .arg(numberText(100 * match.distance, 0)));
    }
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        const int kind = draft.places[part].empty() ? static_cast<int>(draft.parts[part]) : kChosen;
        parts_[part]->setCurrentIndex(parts_[part]->findData(kind));
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

std::optional<BodyPart> MotionBox::part() const {
    const int part = scope_->currentData().toInt();
    return part < 0 ? std::nullopt : std::optional(static_cast<BodyPart>(part));
}

const std::vector<PoseMatch>* MotionBox::found() const {
    const KeyMotion* motion = keys_.motion();
    if (motion == nullptr) return nullptr;
    return part() ? &motion->foundOfPart[static_cast<std::size_t>(*part())] : &motion->found;
}

bool MotionBox::isTaken(const PoseMatch& match) const {
    const AssemblyPlan& plan = keys_.motion()->plan;
    const auto& own = part() ? plan.parts[static_cast<std::size_t>(*part())] : std::nullopt;
    const KeyMatch& taken = own ? own->match : plan.body.match;
    return match.match.clip == taken.clip && match.match.frames == taken.frames;
}

void MotionBox::showTiles() {
    const auto* all = found();
    std::vector<PoseMatch> wanted;
    for (std::size_t i = 0; all != nullptr && i < all->size() && i < kTiles; ++i)
        wanted.push_back((*all)[i]);
    tiles_->setVisible(!wanted.empty());
    std::vector<ActionTile> tiles;
    const auto& library = keys_.motions();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (i == 0) {
            const Clip keys = clipOf(keys_.draft().track);
            tiles.push_back(tileOf(*library, keys, {0, keys.frameCount()}));
            tiles.back().title = tr("the keys");
            tiles.back().detail = timeText(keys.seconds(), 0.1);
        }
        const PoseMatch& match = wanted[i];
        const LibraryMotion& motion = keys_.library()->motion(match.match.clip);
        tiles.push_back(tileOf(*library, motion.clip,
                               {match.match.frames.front(), match.match.frames.back() + 1}));
        tiles.back().title = (isTaken(match) ? QStringLiteral("● ") : QString()) +
                             QString::fromStdString(motion.name);
        tiles.back().detail = timeText(match.match.frames.front() / motion.clip.rate, 0.1);
    }
    tiles_->show(std::move(tiles));
}

void MotionBox::take(int row) {
    if (found() == nullptr || row < 0 || row >= static_cast<int>(found()->size())) return;
    const PoseMatch& match = (*found())[static_cast<std::size_t>(row)];
    const LibraryMotion& from = keys_.library()->motion(match.match.clip);
    const double perFrame = from.sourceRate / keys_.library()->features.rate;
    // A little room around it: the same place is found again.
    const int begin = static_cast<int>(std::floor(match.match.frames.front() * perFrame));
    const int end = static_cast<int>(std::ceil(match.match.frames.back() * perFrame)) + 1;
    const std::string place = from.name + "@" + std::to_string(begin) + ":" + std::to_string(end);
    if (const auto own = part()) {
        keys_.change(tr("Take the %1 from elsewhere").arg(partText(*own)), [&](KeyDraft& draft) {
            draft.parts[static_cast<std::size_t>(*own)] = PartChoice::Kind::Own;
            draft.places[static_cast<std::size_t>(*own)] = place;
        });
        return;
    }
    keys_.change(tr("Take the body from elsewhere"), [&](KeyDraft& draft) { draft.body = place; });
}

}  // namespace kumite::studio
