#include "studio/workspaces/sequence/transition_box.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "studio/app/panel_parts.h"
#include "studio/app/words.h"
#include "studio/workspaces/sequence/distance_grid_view.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

TransitionBox::TransitionBox(SequenceSession& sequence, QWidget* parent)
    : QWidget(parent),
      sequence_(sequence),
      text_(new QLabel(this)),
      list_(new QListWidget(this)),
      grid_(new DistanceGridView(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(headingLabel(tr("Transition"), this));
    text_->setWordWrap(true);
    text_->setProperty("role", "second");
    text_->setAccessibleName(tr("The transition"));
    layout->addWidget(text_);
    list_->setAccessibleName(tr("Ways that the transition can go"));
    list_->setToolTip(tr("A click, or Return, takes another way"));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(list_);
    layout->addWidget(grid_);
    connect(list_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { take(list_->row(item)); });
    connect(list_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { take(list_->row(item)); });
    for (auto signal : {&SequenceSession::selectionChanged, &SequenceSession::motionChanged,
                        &SequenceSession::draftChanged, &SequenceSession::libraryChanged})
        connect(&sequence_, signal, this, &TransitionBox::refresh);
    refresh();
}

QString TransitionBox::wayOf(const TransitionReport& report) {
    switch (report.method) {
        case TransitionMethod::Bezier:
            return tr("on a curve");
        case TransitionMethod::Graph:
            return report.visited.size() > 1
                       ? tr("along recorded clips past %1 poses").arg(report.visited.size())
                       : tr("between poses that are alike");
        case TransitionMethod::Linear:
            break;
    }
    return tr("straight from pose to pose");
}

void TransitionBox::refresh() {
    const auto block = sequence_.selectedBlock();
    const SequencePiece* found = nullptr;
    if (block && sequence_.isCurrent()) {
        for (const SequencePiece& piece : sequence_.motion()->pieces) {
            // Repeats are led over to each other, too: the first one is chosen here.
            if (piece.block == *block && piece.transition && piece.repeat == 0) found = &piece;
        }
    }
    const int row = list_->currentRow();
    list_->clear();
    list_->setVisible(found != nullptr);
    if (found == nullptr) {
        grid_->show({});
        text_->setText(!block                  ? tr("Choose a block, or the transition before it.")
                       : *block == 0           ? tr("The first block begins where it was recorded.")
                       : sequence_.isCurrent() ? tr("There is no transition.")
                                               : tr("The motion is being made."));
        return;
    }
    const TransitionReport& report = *found->transition;
    const DraftBlock& planned = sequence_.draft().blocks[static_cast<std::size_t>(*block)];
    const double rate = sequence_.motion()->clip.rate;
    const QString seconds = numberText(found->frames.size() / rate, 2);
    text_->setText(tr("To %1: %2 s, %3%4")
                       .arg(sequence_.titleOf(planned), seconds, wayOf(report),
                            planned.locked ? tr(". Locked.") : QStringLiteral(".")));
    const auto add = [&](const QString& text, bool taken, bool wished) {
        auto* item = new QListWidgetItem(
            (taken ? QStringLiteral("● ") : QStringLiteral("○ ")) + text, list_);
        if (wished) {
            QFont bold = list_->font();
            bold.setBold(true);
            item->setFont(bold);
        }
    };
    const TransitionRequest& request = planned.transition;
    add(tr("drawn by cost"), false, !request.method && !request.path);
    for (std::size_t i = 0; i < report.candidates.size(); ++i) {
        const CandidatePath& path = report.candidates[i];
        const auto clips = path.nodes.empty() ? 0 : path.nodes.size() - 1;
        add(clips == 0 ? tr("path %1 · they meet as they are").arg(i + 1)
                       : tr("path %1 · cost %2 · clips: %3")
                             .arg(i + 1)
                             .arg(numberText(path.cost, 1))
                             .arg(clips),
            report.chosen == static_cast<int>(i), request.path == static_cast<int>(i));
    }
    add(tr("curve (Bézier)"), report.method == TransitionMethod::Bezier,
        request.method == TransitionMethod::Bezier);
    add(tr("straight, for comparison"), report.method == TransitionMethod::Linear,
        request.method == TransitionMethod::Linear);
    list_->setCurrentRow(row < list_->count() ? row : -1);
    list_->setFixedHeight(list_->count() * list_->sizeHintForRow(0) + 2 * list_->frameWidth() + 2);
    grid_->show(report.grids);
}

void TransitionBox::take(int row) {
    const auto block = sequence_.selectedBlock();
    if (!block || row < 0) return;
    const int count = list_->count();
    sequence_.change(*block, tr("Take another transition"), [&](DraftBlock& each) {
        each.transition.path.reset();
        each.transition.method.reset();
        if (row == count - 1) {
            each.transition.method = TransitionMethod::Linear;
        } else if (row == count - 2) {
            each.transition.method = TransitionMethod::Bezier;
        } else if (row > 0) {
            each.transition.method = TransitionMethod::Graph;
            each.transition.path = row - 1;
        }
    });
}

}  // namespace kumite::studio
