#include "studio/app/recovery_dialog.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/words.h"

namespace kumite::studio {

RecoveryDialog::RecoveryDialog(std::vector<RecoveryCopy> copies, QWidget* parent)
    : QDialog(parent),
      copies_(std::move(copies)),
      list_(new QTreeWidget(this)),
      recover_(new QPushButton(tr("Recover"), this)),
      discard_(new QPushButton(tr("Discard"), this)) {
    setWindowTitle(tr("Recovery"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    auto* text = new QLabel(
        tr("Kumite ended unexpectedly. The edits that were not saved are kept here; recovered, "
           "they stand in the project as unsaved changes."),
        this);
    text->setWordWrap(true);
    layout->addWidget(text);
    list_->setAccessibleName(tr("Projects that can be recovered"));
    list_->setToolTip(tr("What was not saved; a double-click recovers it"));
    list_->setHeaderLabels({tr("Project"), tr("Last edit"), tr("Not saved"), tr("Folder")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    for (const RecoveryCopy& copy : copies_) {
        const QString folder =
            copy.original.isEmpty() ? tr("never saved") : QFileInfo(copy.original).absolutePath();
        auto* row = new QTreeWidgetItem(
            list_, {copy.name, momentText(copy.time), editsText(copy.edits), folder});
        row->setToolTip(3, folder);
    }
    list_->setCurrentItem(list_->topLevelItem(0));
    for (int column = 0; column < 3; ++column) {
        list_->resizeColumnToContents(column);
        list_->setColumnWidth(column, list_->columnWidth(column) + 16);
    }
    list_->header()->setStretchLastSection(true);
    list_->setTextElideMode(Qt::ElideMiddle);
    const int rows = std::clamp(static_cast<int>(copies_.size()), 2, 8);
    list_->setFixedHeight(28 + rows * 20);
    layout->addWidget(list_);
    auto* buttons = new QHBoxLayout;
    auto* later = new QPushButton(tr("Later"), this);
    discard_->setToolTip(tr("Delete the chosen edits for good (Del)"));
    recover_->setToolTip(tr("Open the chosen project with its unsaved edits (Enter)"));
    later->setToolTip(tr("Keep them and ask again at the next start (Esc)"));
    recover_->setProperty("role", "step");
    recover_->setDefault(true);
    buttons->addWidget(discard_);
    buttons->addStretch(1);
    buttons->addWidget(later);
    buttons->addWidget(recover_);
    layout->addLayout(buttons);
    resize(640, sizeHint().height());
    connect(recover_, &QPushButton::clicked, this, &RecoveryDialog::recover);
    connect(list_, &QTreeWidget::itemDoubleClicked, this, &RecoveryDialog::recover);
    connect(discard_, &QPushButton::clicked, this, &RecoveryDialog::discard);
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    list_->setFocus();
}

void RecoveryDialog::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete) {
        discard();
    } else {
        QDialog::keyPressEvent(event);
    }
}

int RecoveryDialog::chosen() const {
    return list_->indexOfTopLevelItem(list_->currentItem());
}

void RecoveryDialog::recover() {
    const int index = chosen();
    if (index < 0) return;
    Q_EMIT recoveryWanted(copies_[static_cast<std::size_t>(index)]);
    accept();
}

void RecoveryDialog::discard() {
    const int index = chosen();
    if (index < 0) return;
    Recovery::discard(copies_[static_cast<std::size_t>(index)]);
    copies_.erase(copies_.begin() + index);
    delete list_->takeTopLevelItem(index);
    if (copies_.empty()) reject();
}

}  // namespace kumite::studio
