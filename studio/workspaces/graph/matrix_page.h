#pragma once

#include <QWidget>

#include <array>

#include "core/interaction/transition_table.h"
#include "studio/workspaces/graph/graph_session.h"
#include "studio/workspaces/graph/matrix_table.h"

class QCheckBox;
class QComboBox;

namespace kumite::studio {

class MatrixView;

/// The matrix of the Graph workspace and how it is shown: what the rows know, in which order, on
/// which scale; beside another or as a difference where two are compared.
class MatrixPage : public QWidget {
    Q_OBJECT

public:
    explicit MatrixPage(GraphSession& graph, QWidget* parent = nullptr);

    /// The matrix at the left (or the only one).
    MatrixView& view() { return *views_[0]; }
    MatrixView& otherView() { return *views_[1]; }
    void setRows(TableRows rows);
    void setSort(MatrixSort sort);
    void setDifference(bool difference);
    /// All of the shown matrices, for pictures.
    QSize wholeSize() const;
    void paintWhole(QPainter& painter) const;

protected:
    void changeEvent(QEvent* event) override;

private:
    /// One of the tables that are compared, and whose it is.
    struct Side : GraphSide {
        TransitionTable table;
    };

    void layOut();
    void refresh();
    Side sideOf(int number) const;
    MatrixTable tableOf(int number) const;
    QString rowName(const TablePairing::Place& place) const;
    QString columnName(const TablePairing::Place& place) const;
    void showSelection();
    void showMoment();
    void choose(int number, const MatrixPlace& place);
    void tell(int number, const std::optional<MatrixPlace>& place);
    /// What of a side's table a place means; nothing where that side lacks it.
    std::optional<TransitionFilter> filterOf(int number, const MatrixPlace& place) const;
    std::optional<MatrixPlace> placeOf(int number, const TransitionFilter& filter) const;

    GraphSession& graph_;
    QComboBox* rows_;
    QComboBox* sort_;
    QComboBox* values_;
    QComboBox* how_;
    QCheckBox* logarithmic_;
    std::array<MatrixView*, 2> views_{};
    std::shared_ptr<const GraphValues> shown_;  ///< what the sides are part of
    std::array<Side, 2> sides_;
    TablePairing pairing_;
};

}  // namespace kumite::studio
