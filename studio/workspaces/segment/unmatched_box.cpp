#include "studio/workspaces/segment/unmatched_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

#include "core/project/edits.h"
#include "studio/app/panel_parts.h"
#include "studio/app/session.h"
#include "studio/app/words.h"

namespace kumite::studio {

UnmatchedBox::UnmatchedBox(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      list_(new QListWidget(this)),
      add_(new QPushButton(tr("Put boundary"), this)),
      forget_(new QPushButton(tr("Forget"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* heading = headingLabel(tr("Corrections without a minimum"), this);
    heading->setWordWrap(true);
    layout->addWidget(heading);
    list_->setAccessibleName(heading->text());
    list_->setToolTip(tr("With the present settings these corrections mean nothing any more."));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(list_);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(add_);
    buttons->addWidget(forget_);
    buttons->addStretch(1);
    layout->addLayout(buttons);
    add_->setToolTip(tr("Put a boundary by hand where the correction had one"));
    forget_->setToolTip(tr("Drop the correction from the project"));
    connect(list_, &QListWidget::currentRowChanged, this, &UnmatchedBox::showChoices);
    connect(list_, &QListWidget::itemActivated, this, [this] {
        const Row& row = rows_[static_cast<std::size_t>(list_->currentRow())];
        const int frame = boundaryOf(row.correction).value_or(row.correction.frame);
        session_.transport().setPlayhead(session_.timeOf({row.player, frame}));
        session_.reveal(session_.transport().playhead());
    });
    connect(add_, &QPushButton::clicked, this, [this] { decide(true); });
    connect(forget_, &QPushButton::clicked, this, [this] { decide(false); });
    refresh();
}

void UnmatchedBox::refresh() {
    const int chosen = list_->currentRow();
    rows_.clear();
    list_->clear();
    for (int player = 0; player < session_.playerCount(); ++player) {
        const FighterAnalysis* fighter = session_.fighter(player);
        if (fighter == nullptr) continue;
        for (const Correction& correction : fighter->segmentation->unmatched) {
            rows_.push_back({player, correction});
            list_->addItem(QStringLiteral("%1 · %2").arg(
                QString::number(player + 1), correctionWords(correction, fighter->input)));
        }
    }
    const int rows = list_->count();
    list_->setCurrentRow(std::clamp(chosen, 0, std::max(0, rows - 1)));
    list_->setFixedHeight(std::clamp(rows, 1, 3) * std::max(18, list_->sizeHintForRow(0)) + 2);
    setVisible(rows > 0);
    showChoices();
}

void UnmatchedBox::showChoices() {
    const auto row = static_cast<std::size_t>(std::max(0, list_->currentRow()));
    add_->setEnabled(row < rows_.size() && boundaryOf(rows_[row].correction).has_value());
    forget_->setEnabled(row < rows_.size());
}

void UnmatchedBox::decide(bool add) {
    const auto index = static_cast<std::size_t>(std::max(0, list_->currentRow()));
    if (index >= rows_.size()) return;
    const Row row = rows_[index];
    session_.whenCurrent([this, row, add] {
        session_.document().apply([&](const Project& project, const Analysis& analysis) {
            const FighterAddress address{session_.take(), row.player};
            return add ? addBoundaryOfCorrection(project, analysis, address, row.correction)
                       : forgetCorrection(project, analysis, address, row.correction);
        });
    });
}

}  // namespace kumite::studio
