#include "studio/workspaces/keyframe/part_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "studio/app/core_words.h"
#include "studio/app/words.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/library_tile.h"
#include "studio/workspaces/keyframe/part_words.h"

namespace kumite::studio {

PartDialog::PartDialog(KeySession& keys, QWidget* parent)
    : QDialog(parent),
      keys_(keys),
      library_(keys.motions()),
      part_(new QComboBox(this)),
      adjusted_(new QCheckBox(tr("joints adjusted"), this)),
      views_(new ActionTiles(this)),
      text_(new QLabel(this)) {
    setWindowTitle(tr("Replace a part of a take"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(8);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    take_ = addStretch(form, tr("In"), tr("take that is changed"));
    for (const BodyPart part : allParts())
        part_->addItem(partText(part), static_cast<int>(part));
    part_->setCurrentIndex(part_->findData(static_cast<int>(BodyPart::RightArm)));
    part_->setAccessibleName(tr("Part that is replaced"));
    part_->setToolTip(part_->accessibleName());
    adjusted_->setToolTip(
        tr("Where the part hangs on the rest its joint keeps the take's mean and spread"));
    auto* row = new QHBoxLayout;
    row->addWidget(part_, 1);
    row->addWidget(adjusted_);
    form->addRow(tr("The"), row);
    source_ = addStretch(form, tr("By that of"), tr("take or clip that lends the part"));
    layout->addLayout(form);
    views_->setMinimumSize(560, 260);
    views_->setAccessibleName(tr("The take, what lends the part, and the result"));
    layout->addWidget(views_, 1);
    text_->setWordWrap(true);
    text_->setProperty("role", "second");
    text_->setAccessibleName(tr("What becomes of it"));
    layout->addWidget(text_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    keep_ = buttons->addButton(tr("Keep as a take…"), QDialogButtonBox::ActionRole);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(keep_, &QPushButton::clicked, this,
            [this] { keepMotion(keys_.session(), keys_.writing(), madeMotion(), this); });
    chooseUsual();
    for (const Stretch& stretch : {take_, source_}) {
        connect(stretch.motion, &QComboBox::currentIndexChanged, this, [this, stretch] {
            limit(stretch);
            edit();
        });
        connect(stretch.begin, &QSpinBox::valueChanged, this, &PartDialog::edit);
        connect(stretch.end, &QSpinBox::valueChanged, this, &PartDialog::edit);
    }
    connect(part_, &QComboBox::currentIndexChanged, this, &PartDialog::edit);
    connect(adjusted_, &QCheckBox::toggled, this, &PartDialog::edit);
    edit();
}

PartDialog::Stretch PartDialog::addStretch(QFormLayout* form, const QString& title,
                                           const QString& name) {
    const Stretch stretch{new QComboBox(this), new QSpinBox(this), new QSpinBox(this)};
    for (const LibraryMotion& motion : library_->motions)
        stretch.motion->addItem(QString::fromStdString(motion.name));
    stretch.motion->setAccessibleName(tr("The %1").arg(name));
    stretch.motion->setToolTip(stretch.motion->accessibleName());
    stretch.begin->setAccessibleName(tr("First frame of the %1").arg(name));
    stretch.end->setAccessibleName(tr("Last frame of the %1").arg(name));
    auto* row = new QHBoxLayout;
    row->addWidget(stretch.motion, 1);
    for (QSpinBox* field : {stretch.begin, stretch.end}) {
        field->setToolTip(tr("%1, at %2 Hz").arg(field->accessibleName()).arg(library_->rate));
        field->setKeyboardTracking(false);
        field->setMinimumWidth(76);
        row->addWidget(field);
    }
    form->addRow(title, row);
    limit(stretch);
    return stretch;
}

const LibraryMotion& PartDialog::motionOf(const Stretch& stretch) const {
    return library_->motions[static_cast<std::size_t>(stretch.motion->currentIndex())];
}

void PartDialog::limit(const Stretch& stretch) {
    const int last = motionOf(stretch).clip.frameCount() - 1;
    for (QSpinBox* field : {stretch.begin, stretch.end}) {
        const QSignalBlocker quiet(field);
        field->setRange(0, last);
    }
}

/// The active fighter around the playhead, and the other one at the same time.
void PartDialog::chooseUsual() {
    const Session& session = keys_.session();
    for (std::size_t m = 0; m < library_->motions.size(); ++m) {
        const LibraryMotion& motion = library_->motions[m];
        if (motion.take != session.take()) continue;
        (motion.player == session.activePlayer() ? take_ : source_)
            .motion->setCurrentIndex(static_cast<int>(m));
    }
    const double seconds =
        session.fighter(session.activePlayer()) != nullptr
            ? session.shownFrame(session.activePlayer()) / motionOf(take_).sourceRate
            : 0.0;
    for (const Stretch& stretch : {take_, source_}) {
        limit(stretch);
        const int half = static_cast<int>(library_->rate / 2);
        const int middle = std::max(half, static_cast<int>(std::lround(seconds * library_->rate)));
        stretch.end->setValue(middle + half);
        stretch.begin->setValue(std::max(0, stretch.end->value() - 2 * half));
    }
}

MadeMotion PartDialog::madeMotion() const {
    return {library_, result_, QStringLiteral("edited")};
}

void PartDialog::edit() {
    const Clip& take = motionOf(take_).clip;
    const Clip& source = motionOf(source_).clip;
    PartEdit edit;
    edit.frames = {take_.begin->value(), take_.end->value() + 1};
    edit.part = static_cast<BodyPart>(part_->currentData().toInt());
    edit.sourceBegin = source_.begin->value();
    edit.sourceEnd = source_.end->value();
    edit.adjusted = adjusted_->isChecked();
    result_.reset();
    std::vector<ActionTile> tiles;
    try {
        result_ = std::make_shared<const Clip>(withPart(take, source, edit));
        const int room = static_cast<int>(library_->rate / 3);
        const FrameRange around{edit.frames.begin - room, edit.frames.end + room};
        tiles.push_back(tileOf(*library_, take, around));
        tiles.back().title = tr("as it is");
        tiles.push_back(
            tileOf(*library_, source, {source_.begin->value(), source_.end->value() + 1}));
        tiles.back().title = tr("what lends the %1").arg(partText(edit.part));
        tiles.push_back(tileOf(*library_, *result_, around));
        tiles.back().title = tr("the result");
        for (std::size_t i = 0; i < tiles.size(); ++i)
            tiles[i].detail = (i == 1 ? source_ : take_).motion->currentText();
        text_->setText(tr("%1 of the take's %2 are changed, in the %3 only; all else stays.")
                           .arg(timeText(edit.frames.size() / library_->rate, 0.01),
                                timeText(take.seconds(), 0.01), partText(edit.part)));
    } catch (const std::exception& error) {
        text_->setText(coreWords(error.what()));
    }
    views_->show(std::move(tiles));
    keep_->setEnabled(result_ != nullptr);
}

}  // namespace kumite::studio
