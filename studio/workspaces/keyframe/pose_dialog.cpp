#include "studio/workspaces/keyframe/pose_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/words.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/library_tile.h"

namespace kumite::studio {

PoseDialog::PoseDialog(KeySession& keys, QWidget* parent)
    : QDialog(parent),
      keys_(keys),
      library_(keys.motions()),
      motions_(new QComboBox(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      frame_(new QSpinBox(this)),
      time_(new QLabel(this)),
      view_(new ActionTiles(this)) {
    setWindowTitle(tr("Copy a pose"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(8);
    motions_->setAccessibleName(tr("Take or clip"));
    motions_->setToolTip(tr("Whose pose is copied: a fighter of a take, or a clip"));
    for (const LibraryMotion& motion : library_->motions)
        motions_->addItem(QString::fromStdString(motion.name));
    layout->addWidget(motions_);
    view_->setMinimumSize(360, 320);
    view_->setAccessibleName(tr("The pose"));
    view_->setFocusPolicy(Qt::NoFocus);
    layout->addWidget(view_, 1);
    auto* row = new QHBoxLayout;
    slider_->setAccessibleName(tr("Moment"));
    slider_->setToolTip(tr("Which moment; arrow keys go on by one frame"));
    row->addWidget(slider_, 1);
    frame_->setAccessibleName(tr("Frame of the take or clip"));
    frame_->setToolTip(frame_->accessibleName());
    frame_->setMinimumWidth(76);
    row->addWidget(frame_);
    time_->setMinimumWidth(64);
    time_->setAccessibleName(tr("Time"));
    row->addWidget(time_);
    layout->addLayout(row);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Copy the pose"));
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &PoseDialog::take);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(motions_, &QComboBox::currentIndexChanged, this, &PoseDialog::showMotion);
    connect(slider_, &QSlider::valueChanged, frame_, &QSpinBox::setValue);
    connect(frame_, &QSpinBox::valueChanged, slider_, &QSlider::setValue);
    connect(frame_, &QSpinBox::valueChanged, this, &PoseDialog::showFrame);
    showMotion();
    slider_->setFocus();
}

const LibraryMotion* PoseDialog::motion() const {
    const int index = motions_->currentIndex();
    return index < 0 ? nullptr : &library_->motions[static_cast<std::size_t>(index)];
}

void PoseDialog::showMotion() {
    if (motion() == nullptr) return;
    const int last = motion()->clip.frameCount() - 1;
    slider_->setRange(0, last);
    frame_->setRange(0, last);
    showFrame();
}

void PoseDialog::showFrame() {
    if (motion() == nullptr) return;
    const int frame = frame_->value();
    ActionTile tile = tileOf(*library_, motion()->clip, {frame, frame + 1});
    tile.title = motions_->currentText();
    tile.detail = tr("frame %1 at %2 Hz").arg(frame).arg(numberText(motion()->clip.rate));
    view_->show({std::move(tile)});
    time_->setText(timeText(frame / motion()->clip.rate, 0.01));
}

void PoseDialog::take() {
    if (motion() != nullptr) {
        const auto frame = static_cast<std::size_t>(frame_->value());
        keys_.usePose(motion()->clip.frames[frame],
                      tr("Copy the pose of %1").arg(motions_->currentText()));
    }
    accept();
}

}  // namespace kumite::studio
