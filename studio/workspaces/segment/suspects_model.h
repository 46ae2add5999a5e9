#pragma once

#include <QAbstractTableModel>

#include <optional>
#include <vector>

#include "core/project/review.h"
#include "studio/workspaces/segment/review.h"

namespace kumite::studio {

/// The minima of the shown take as a table, in the order of `suspectsOf`.
class SuspectsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { TimeColumn, ReasonColumn, SuspicionColumn, ColumnCount };

    explicit SuspectsModel(const Session& session, QObject* parent = nullptr);

    void refresh();
    const Suspect& suspectAt(int row) const { return rows_[static_cast<std::size_t>(row)]; }
    /// Nothing where the fighter has no force.
    std::optional<SuspectReason> reasonOf(int row) const;
    /// Why it is suspected and what was decided, in words.
    QString reasonAt(int row) const;
    /// The same with all else that is known about a row.
    QString toldAt(int row) const;
    /// -1 where the boundary is not in the list.
    int rowOf(const BoundaryRef& boundary) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const Session& session_;
    std::vector<Suspect> rows_;
};

}  // namespace kumite::studio
