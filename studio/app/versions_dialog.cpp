#include "studio/app/versions_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "studio/app/core_words.h"
#include "studio/app/opening.h"
#include "studio/app/words.h"

namespace kumite::studio {

QDateTime momentOf(const KeptVersion& version) {
    const auto since = version.saved.time_since_epoch();
    return QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<std::chrono::milliseconds>(since).count());
}

VersionsDialog::VersionsDialog(const QString& project, QWidget* parent)
    : QDialog(parent),
      text_(new QLabel(this)),
      list_(new QTreeWidget(this)),
      restore_(new QPushButton(tr("Restore"), this)),
      copy_(new QPushButton(tr("Open a copy"), this)) {
    setWindowTitle(tr("Versions"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    text_->setWordWrap(true);
    layout->addWidget(text_);
    list_->setAccessibleName(tr("Versions, the newest first"));
    list_->setToolTip(tr("States that were saved over; a double-click restores one"));
    list_->setHeaderLabels({tr("Saved"), tr("Takes"), tr("Corrections")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setMinimumHeight(28 + kKeptVersions * 24);
    layout->addWidget(list_, 1);
    auto* buttons = new QHBoxLayout;
    auto* close = new QPushButton(tr("Close"), this);
    copy_->setToolTip(tr("Open the chosen version as a project without a file"));
    restore_->setToolTip(
        tr("Make the chosen version the open project; undo takes it back (Enter)"));
    close->setToolTip(tr("Leave everything as it is (Esc)"));
    restore_->setProperty("role", "step");
    restore_->setDefault(true);
    buttons->addWidget(copy_);
    buttons->addStretch(1);
    buttons->addWidget(close);
    buttons->addWidget(restore_);
    layout->addLayout(buttons);
    resize(520, sizeHint().height());
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(list_, &QTreeWidget::currentItemChanged, this, &VersionsDialog::refresh);
    connect(list_, &QTreeWidget::itemDoubleClicked, restore_, &QPushButton::click);
    connect(restore_, &QPushButton::clicked, this, [this] {
        if (const KeptVersion* version = chosen()) Q_EMIT restoreWanted(*version);
        accept();
    });
    connect(copy_, &QPushButton::clicked, this, [this] {
        if (const KeptVersion* version = chosen()) Q_EMIT copyWanted(*version);
        accept();
    });
    connect(&reading_, &JobRunner::failed, text_, &QLabel::setText);
    refresh();
    if (project.isEmpty()) {
        fill({});
    } else {
        text_->setText(tr("Looking…"));
        reading_.start(
            tr("Reading versions"),
            [path = toPath(project)](const Progress&) { return keptVersions(path); },
            [this](std::vector<KeptVersion> versions) { fill(std::move(versions)); });
    }
    list_->setFocus();
}

void VersionsDialog::fill(std::vector<KeptVersion> versions) {
    versions_ = std::move(versions);
    text_->setText(
        versions_.empty()
            ? tr("No earlier version yet. Every save keeps what the file held before; the last "
                 "ten are listed here.")
            : tr("What the project file held before each of the last saves. Restoring is an edit: "
                 "undo takes it back, and the file changes only when you save."));
    for (const KeptVersion& version : versions_) {
        auto* row = new QTreeWidgetItem(
            list_, {momentText(momentOf(version), true), QString::number(version.takes),
                    QString::number(version.corrections)});
        if (version.problem.empty()) continue;
        row->setText(1, tr("cannot be read"));
        row->setText(2, {});
        row->setToolTip(1, coreWords(version.problem));
    }
    list_->setColumnWidth(0, 220);
    list_->setColumnWidth(1, 110);
    list_->setCurrentItem(list_->topLevelItem(0));
    refresh();
}

const KeptVersion* VersionsDialog::chosen() const {
    const int index = list_->indexOfTopLevelItem(list_->currentItem());
    return index < 0 ? nullptr : &versions_[static_cast<std::size_t>(index)];
}

void VersionsDialog::refresh() {
    const KeptVersion* version = chosen();
    const bool usable = version != nullptr && version->problem.empty();
    restore_->setEnabled(usable);
    copy_->setEnabled(usable);
}

}  // namespace kumite::studio
