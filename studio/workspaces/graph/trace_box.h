#pragma once

#include <QAbstractTableModel>
#include <QWidget>

#include <vector>

#include "studio/workspaces/graph/graph_session.h"

class QLabel;
class QTableView;

namespace kumite::studio {

/// The transitions behind what is selected, in order of time.
class TraceModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { TimeColumn, WhatColumn, SurpriseColumn, ColumnCount };

    explicit TraceModel(const GraphSession& graph, QObject* parent = nullptr);

    void show(int mover, std::vector<int> transitions);
    TransitionRef at(int row) const { return {mover_, rows_[static_cast<std::size_t>(row)]}; }
    int rowOf(const TransitionRef& transition) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const GraphSession& graph_;
    int mover_ = 0;
    std::vector<int> rows_;
};

/// Traces what is selected back to the recording: a click on a row (or Return) plays it.
class TraceBox : public QWidget {
    Q_OBJECT

public:
    explicit TraceBox(GraphSession& graph, QWidget* parent = nullptr);

    QTableView* table() const { return table_; }
    const TraceModel& model() const { return *model_; }

private:
    void showSelection();
    void showCurrent();
    QString selectionText() const;

    GraphSession& graph_;
    TraceModel* model_;
    QLabel* what_;
    QTableView* table_;
};

}  // namespace kumite::studio
