#pragma once

#include <QAbstractListModel>
#include <QStyledItemDelegate>

#include <vector>

#include "studio/workspaces/graph/graph_session.h"

namespace kumite::studio {

/// What a fighter may do next, the likeliest first.
class WhatIfModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit WhatIfModel(const GraphSession& graph, QObject* parent = nullptr);

    /// `geometry`: the rows hold a geometry term.
    void show(int mover, std::vector<NextLabel> rows, bool geometry);
    const std::vector<NextLabel>& rows() const { return rows_; }
    int mover() const { return mover_; }
    bool hasGeometry() const { return geometry_; }
    int rowOf(int node) const;
    /// What really came next; kAnyNode: not known.
    void setActual(int node);
    bool isActual(int row) const { return rows_[static_cast<std::size_t>(row)].node == actual_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    const GraphSession& graph_;
    std::vector<NextLabel> rows_;
    int mover_ = 0;
    int actual_ = kAnyNode;
    bool geometry_ = false;
};

/// Two lines a candidate: its name and probability; both terms over bars, and how many examples
/// support it.
class WhatIfDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    explicit WhatIfDelegate(const WhatIfModel& model, QObject* parent);
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    const WhatIfModel& model_;
};

}  // namespace kumite::studio
