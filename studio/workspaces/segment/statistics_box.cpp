#include "studio/workspaces/segment/statistics_box.h"

#include <QGridLayout>
#include <QLabel>

#include "core/project/review.h"
#include "studio/app/session.h"
#include "studio/app/words.h"

namespace kumite::studio {

StatisticsBox::StatisticsBox(const Session& session, QWidget* parent)
    : QWidget(parent), session_(session) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(1);
    const struct {
        QString text, toolTip;
    } headers[kColumns] = {
        {{}, {}},
        {tr("actions"), tr("Actions that the stream is cut into")},
        {tr("min/s"), tr("Minima a second that cut by themselves")},
        {tr("corr."), tr("Share of boundaries that a hand removed, moved or added")},
        {tr("left"),
         tr("Suspects that nobody has decided yet. Every decision teaches what is suspect, so that "
            "others may be cleared, too")}};
    for (int column = 0; column < kColumns; ++column) {
        auto* header = new QLabel(headers[column].text, this);
        header->setProperty("role", "second");
        header->setToolTip(headers[column].toolTip);
        grid->addWidget(header, 0, column, column == 0 ? Qt::AlignLeft : Qt::AlignRight);
        for (int row = 0; row < kRows; ++row) {
            cells_[row][column] = new QLabel(this);
            cells_[row][column]->setToolTip(headers[column].toolTip);
            grid->addWidget(cells_[row][column], row + 1, column,
                            column == 0 ? Qt::AlignLeft : Qt::AlignRight);
        }
    }
    grid->setColumnStretch(0, 1);
    refresh();
}

void StatisticsBox::refresh() {
    const double threshold = session_.document().analysis().settings.prominence;
    ReviewStatistics together;
    std::size_t actions = 0;
    const auto show = [this](int row, const QString& who, std::size_t count,
                             const ReviewStatistics& numbers) {
        cells_[row][0]->setText(who);
        cells_[row][1]->setText(QString::number(count));
        cells_[row][2]->setText(numberText(numbers.minimaPerSecond(), 2));
        cells_[row][3]->setText(percentText(numbers.shareCorrected()));
        cells_[row][4]->setText(QString::number(numbers.toReview));
    };
    const int players = session_.playerCount();
    for (int player = 0; player < std::min(players, 2); ++player) {
        const FighterAnalysis* fighter = session_.fighter(player);
        const ReviewStatistics own =
            fighter ? reviewStatistics(*fighter, threshold) : ReviewStatistics{};
        const std::size_t count = fighter ? fighter->segmentation->actions.size() : 0;
        show(player, fighterText(player), count, own);
        together += own;
        actions += count;
    }
    show(2, tr("take"), actions, together);
    for (int row = 0; row < kRows; ++row) {
        const bool needed = row < 2 ? row < players : players > 1;
        for (QLabel* cell : cells_[row])
            cell->setVisible(needed);
    }
}

}  // namespace kumite::studio
