#include "studio/workspaces/sequence/sequence_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <utility>

#include "studio/app/commands.h"
#include "studio/app/panel_parts.h"
#include "studio/workspaces/sequence/actions_model.h"
#include "studio/workspaces/sequence/sequence_session.h"
#include "studio/workspaces/sequence/transition_box.h"

namespace kumite::studio {

SequencePanel::SequencePanel(SequenceSession& sequence, QWidget* parent)
    : QStackedWidget(parent),
      sequence_(sequence),
      search_(new QLineEdit(this)),
      table_(new QTableView(this)),
      model_(new ActionsModel(sequence, this)),
      count_(new QLabel(this)),
      buttons_(new QHBoxLayout),
      empty_(new QWidget(this)),
      full_(new QWidget(this)),
      why_(new QLabel(empty_)) {
    auto* none = new QVBoxLayout(empty_);
    none->setContentsMargins(8, 8, 8, 8);
    none->setSpacing(8);
    why_->setWordWrap(true);
    why_->setProperty("role", "second");
    why_->setAccessibleName(tr("What appears here"));
    none->addWidget(why_);
    none->addStretch(1);

    auto* layout = new QVBoxLayout(full_);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    auto* head = new QHBoxLayout;
    head->addWidget(headingLabel(tr("Actions"), full_), 1);
    count_->setProperty("role", "second");
    head->addWidget(count_);
    layout->addLayout(head);
    search_->setPlaceholderText(tr("Search"));
    search_->setAccessibleName(tr("Search actions"));
    search_->setToolTip(tr("Shows the actions in which every word appears: right kick"));
    search_->setClearButtonEnabled(true);
    layout->addWidget(search_);
    table_->setModel(model_);
    table_->setAccessibleName(tr("Actions to choose from"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setDragEnabled(true);
    table_->setDragDropMode(QAbstractItemView::DragOnly);
    table_->setShowGrid(false);
    table_->setTabKeyNavigation(false);
    table_->setWordWrap(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    auto* header = table_->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(ActionsModel::TitleColumn, QHeaderView::Stretch);
    header->setMinimumSectionSize(24);
    header->resizeSection(ActionsModel::PlaceColumn,
                          fontMetrics().horizontalAdvance("1  00:00") + 14);
    header->resizeSection(ActionsModel::SecondsColumn,
                          fontMetrics().horizontalAdvance("00.0") + 14);
    layout->addWidget(table_, 1);
    layout->addWidget(new TransitionBox(sequence_, full_));
    buttons_->setSpacing(4);
    layout->addLayout(buttons_);
    addWidget(empty_);
    addWidget(full_);

    connect(search_, &QLineEdit::textChanged, this, [this](const QString& words) {
        model_->setFilter(words);
        refresh();
    });
    connect(search_, &QLineEdit::returnPressed, this, [this] {
        if (model_->rowCount() == 0) return;
        table_->setFocus();
        table_->selectRow(0);
    });
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        if (table_->hasFocus()) sequence_.preview(chosen());
    });
    connect(table_, &QTableView::clicked, this, [this] { sequence_.preview(chosen()); });
    connect(table_, &QTableView::doubleClicked, this, [this] {
        if (const auto action = chosen()) sequence_.insert(*action);
    });
    connect(&sequence_, &SequenceSession::libraryChanged, this, [this] {
        model_->refresh();
        refresh();
    });
    connect(&sequence_, &SequenceSession::stateChanged, this, &SequencePanel::refresh);
    refresh();
}

std::optional<LibraryAction> SequencePanel::chosen() const {
    const QModelIndex index = table_->currentIndex();
    if (!index.isValid() || sequence_.library() == nullptr) return std::nullopt;
    return model_->at(index.row());
}

void SequencePanel::addCommands(CommandTable& commands) {
    const std::pair<const char*, QString> all[] = {{"sequence.clips", tr("Clips…")},
                                                   {"sequence.keep", tr("Keep…")},
                                                   {"sequence.export", tr("Export…")}};
    for (const auto& [id, text] : all) {
        const QAction* action = commands.action(QLatin1String(id));
        auto* button = new QPushButton(text, full_);
        button->setFocusPolicy(Qt::TabFocus);
        button->setToolTip(commands.find(QLatin1String(id))->plainText());
        commands.tellKey(button, QLatin1String(id));
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        buttons_->addWidget(button, 1);
    }
}

void SequencePanel::addStep(const QString& text, const QString& tip, std::function<void()> run) {
    auto* button = new QPushButton(text, empty_);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, std::move(run));
    auto* layout = static_cast<QVBoxLayout*>(empty_->layout());
    layout->insertWidget(layout->count() - 1, button);
}

void SequencePanel::refresh() {
    const bool nothing = sequence_.library() == nullptr;
    const QString why = sequence_.whyNothing();
    why_->setText(!why.isEmpty() ? why
                                 : tr("Actions of the takes, and clips of other files, in any "
                                      "order, led over to each other: they appear here."));
    for (auto* button : empty_->findChildren<QPushButton*>())
        button->setVisible(!why.isEmpty());
    const int shown = model_->rowCount();
    const int all = nothing ? 0 : static_cast<int>(sequence_.library()->actions.size());
    count_->setText(shown == all ? QString::number(all) : tr("%1 of %2").arg(shown).arg(all));
    setCurrentWidget(nothing ? empty_ : full_);
}

}  // namespace kumite::studio
