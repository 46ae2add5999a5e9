#include "studio/workspaces/graph/trace_box.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/panel_parts.h"
#include "studio/app/words.h"

namespace kumite::studio {

TraceModel::TraceModel(const GraphSession& graph, QObject* parent)
    : QAbstractTableModel(parent), graph_(graph) {}

void TraceModel::show(int mover, std::vector<int> transitions) {
    beginResetModel();
    mover_ = mover;
    rows_ = std::move(transitions);
    endResetModel();
}

int TraceModel::rowOf(const TransitionRef& transition) const {
    if (transition.mover != mover_) return -1;
    const auto found = std::find(rows_.begin(), rows_.end(), transition.index);
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int TraceModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int TraceModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant TraceModel::data(const QModelIndex& index, int role) const {
    const TransitionRef ref = at(index.row());
    const Transition& t = graph_.transitionOf(ref);
    const auto words = [&] {
        return tr("%1 → %2 | %3")
            .arg(graph_.nameOf(ref.mover, t.ownNode), graph_.nameOf(ref.mover, t.nextNode),
                 graph_.nameOf(1 - ref.mover, t.opponentNode));
    };
    switch (role) {
        case Qt::DisplayRole: {
            const TransitionPlace place = graph_.placeOf(ref);
            if (index.column() == TimeColumn) return timeText(place.seconds, 0.01);
            if (index.column() == SurpriseColumn) return numberText(graph_.shownSurprise(ref), 1);
            return words();
        }
        case Qt::TextAlignmentRole:
            return index.column() == SurpriseColumn ? int(Qt::AlignRight | Qt::AlignVCenter)
                                                    : int(Qt::AlignLeft | Qt::AlignVCenter);
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole: {
            const TransitionPlace place = graph_.placeOf(ref);
            const auto& take = graph_.graph().takes[static_cast<std::size_t>(place.take)];
            return tr("%1, %2: %3\n%4\nA click plays it")
                .arg(QString::fromStdString(take), timeText(place.seconds), words(),
                     surpriseWords(graph_.surpriseOf(ref)));
        }
        default:
            return {};
    }
}

QVariant TraceModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) {
        return section == SurpriseColumn ? int(Qt::AlignRight) : int(Qt::AlignLeft);
    }
    if (role == Qt::ToolTipRole && section == SurpriseColumn) {
        return tr("Surprise (%1), nats: how unexpected it was to a model that had not seen it")
            .arg(surpriseName(graph_.surpriseKind()));
    }
    if (role != Qt::DisplayRole) return {};
    const QString texts[] = {tr("time"), tr("own → next"), tr("surprise")};
    return texts[section];
}

TraceBox::TraceBox(GraphSession& graph, QWidget* parent)
    : QWidget(parent),
      graph_(graph),
      model_(new TraceModel(graph, this)),
      what_(new QLabel(this)),
      table_(new QTableView(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* heading = headingLabel(tr("Behind it"), this);
    layout->addWidget(heading);
    what_->setWordWrap(true);
    what_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    what_->setProperty("role", "second");
    what_->setAccessibleName(tr("What is selected"));
    layout->addWidget(what_);
    table_->setModel(model_);
    table_->setAccessibleName(tr("Transitions behind it"));
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->setMinimumHeight(70);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(20);
    QHeaderView* header = table_->horizontalHeader();
    header->setHighlightSections(false);
    header->setTextElideMode(Qt::ElideRight);
    header->setMinimumSectionSize(20);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(TraceModel::WhatColumn, QHeaderView::Stretch);
    header->resizeSection(TraceModel::TimeColumn,
                          fontMetrics().horizontalAdvance(QStringLiteral("00:00.00")) + 6);
    header->resizeSection(TraceModel::SurpriseColumn,
                          header->fontMetrics().horizontalAdvance(tr("surprise")) + 14);
    layout->addWidget(table_, 1);
    connect(table_, &QTableView::clicked, this,
            [this](const QModelIndex& index) { graph_.play(model_->at(index.row())); });
    connect(&graph_, &GraphSession::selectionChanged, this, &TraceBox::showSelection);
    connect(&graph_, &GraphSession::valuesChanged, this, &TraceBox::showSelection);
    connect(&graph_, &GraphSession::optionsChanged, this, &TraceBox::showSelection);
    connect(&graph_, &GraphSession::surpriseKindChanged, this, &TraceBox::showSelection);
    connect(&graph_, &GraphSession::currentChanged, this, &TraceBox::showCurrent);
    showSelection();
}

QString TraceBox::selectionText() const {
    const auto& selection = graph_.selection();
    if (!selection || !graph_.hasGraph()) {
        return tr(
            "Choose a cell, a node, an edge or a row above: the moments behind it appear "
            "here, and a click plays them.");
    }
    const int mover = selection->mover;
    const TransitionFilter& filter = selection->filter;
    QString text = fighterText(mover) + QStringLiteral(": ");
    if (filter.own != kAnyNode) text += graph_.nameOf(mover, filter.own) + QStringLiteral(" ");
    text += QStringLiteral("→ ") + graph_.nameOf(mover, filter.next);
    if (filter.opponent != kAnyNode) {
        text += QStringLiteral(" | ") + graph_.nameOf(1 - mover, filter.opponent);
    }
    const std::vector<int>& behind = graph_.selected();
    const auto fits = [&](int index) {
        return filter.matches(graph_.transitionOf({mover, index}));
    };
    if (behind.empty()) return tr("%1. Never seen.").arg(text);
    if (fits(behind.front())) {
        return behind.size() == 1 ? tr("%1. Seen once.").arg(text)
                                  : tr("%1. Seen %2 times.").arg(text).arg(behind.size());
    }
    const bool sharesOwn = graph_.transitionOf({mover, behind.front()}).ownNode == filter.own;
    return (sharesOwn ? tr("%1. Never seen so; these share the own label.")
                      : tr("%1. Never seen so; these share the opponent's label."))
        .arg(text);
}

void TraceBox::showSelection() {
    what_->setText(selectionText());
    const auto& selection = graph_.selection();
    model_->show(selection ? selection->mover : 0,
                 graph_.hasGraph() ? graph_.selected() : std::vector<int>{});
    table_->setVisible(model_->rowCount() > 0);
    showCurrent();
}

void TraceBox::showCurrent() {
    const auto current = graph_.current();
    const int row = current ? model_->rowOf(*current) : -1;
    if (row >= 0) {
        table_->selectRow(row);
        table_->scrollTo(model_->index(row, 0));
    } else {
        table_->clearSelection();
    }
}

}  // namespace kumite::studio
