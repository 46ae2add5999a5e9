#pragma once

#include <QAbstractTableModel>

#include <vector>

#include "studio/app/session.h"

namespace kumite::studio {

/// The force minima of the shown take that cut actions, or did until a hand removed them, the
/// most suspicious first.
class SuspectsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { TimeColumn, ProminenceColumn, SuspicionColumn, ColumnCount };

    explicit SuspectsModel(const Session& session, QObject* parent = nullptr);

    void refresh();
    BoundaryRef boundaryAt(int row) const;
    bool isRemoved(int row) const;
    /// -1 where the boundary is not in the list.
    int rowOf(const BoundaryRef& boundary) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        BoundaryRef boundary;
        double seconds = 0;
        double prominence = 0;
        double suspicion = 0;
        bool removed = false;
    };

    const Session& session_;
    std::vector<Row> rows_;
};

}  // namespace kumite::studio
