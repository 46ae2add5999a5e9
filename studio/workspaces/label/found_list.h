#pragma once

#include <QAbstractTableModel>
#include <QWidget>

#include <optional>
#include <vector>

#include "studio/workspaces/label/shown_action.h"

class QLabel;
class QTableView;

namespace kumite::studio {

class LabelSession;

/// An action in a list, known by its peak, so that the row stays true when labels change.
struct FoundRow {
    FighterAddress fighter;
    int peak = 0;
    QString label;  ///< what is shown of it
    QString source;
    std::optional<double> confidence;
};

/// Actions as a table: time and fighter, label, source, confidence.
class FoundModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { TimeColumn, LabelColumn, SourceColumn, ConfidenceColumn, ColumnCount };

    explicit FoundModel(LabelSession& labels, QObject* parent = nullptr);

    void show(std::vector<FoundRow> rows);
    const std::vector<FoundRow>& rows() const { return rows_; }
    int rowOf(FighterAddress fighter, int peak) const;
    /// Without the column of sources: the last one says "hand" instead of a hand's 1.00.
    void setBrief(bool brief);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString toolTip(const FoundRow& row) const;

    LabelSession& labels_;
    std::vector<FoundRow> rows_;
    bool brief_ = false;
};

/// A list of actions: choosing a row goes to the action and loops it; several rows are chosen
/// together for labelling.
class FoundList : public QWidget {
    Q_OBJECT

public:
    FoundList(LabelSession& labels, const QString& name, QWidget* parent);

    /// `said` stands where nothing is in the list.
    void show(std::vector<FoundRow> rows, const QString& said);
    const FoundModel& model() const { return *model_; }
    QTableView* table() const { return table_; }
    /// To the next (+1) or previous (-1) action of the list, round at the ends.
    void step(int direction);
    /// Chooses all actions of the list that belong to the shown take.
    void chooseAll();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void goToRow(int row);
    void rowsChosen();
    void followCurrent();

    LabelSession& labels_;
    FoundModel* model_;
    QTableView* table_;
    QLabel* empty_;
    bool following_ = false;  ///< the table follows the session, not a hand
};

}  // namespace kumite::studio
