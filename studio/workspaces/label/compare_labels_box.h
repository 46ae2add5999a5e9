#pragma once

#include <QAbstractTableModel>
#include <QWidget>

#include <optional>
#include <vector>

#include "core/project/agreement.h"
#include "core/project/label_files.h"

class QLabel;
class QPushButton;
class QTableView;
class QTableWidget;

namespace kumite::studio {

class LabelSession;

/// Where two people's labels differ, as a table: time and fighter, aspect, mine, theirs.
class DifferencesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { TimeColumn, AspectColumn, MineColumn, TheirsColumn, ColumnCount };
    enum class Decision { Open, Mine, Theirs };
    struct Row {
        LabelDifference difference;
        int peak = 0;  ///< of its action
        Decision decision = Decision::Open;
    };

    explicit DifferencesModel(LabelSession& labels, QObject* parent = nullptr);

    void show(std::vector<Row> rows);
    void decide(int row, Decision decision);
    const std::vector<Row>& rows() const { return rows_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString qualifierText(int aspect, int qualifier) const;

    LabelSession& labels_;
    std::vector<Row> rows_;
};

/// Another person's labels beside the project's own: how far the two agree (Cohen's κ per aspect),
/// every difference, to be decided one by one or all at once, and what only the other has.
class CompareLabelsBox : public QWidget {
    Q_OBJECT

public:
    explicit CompareLabelsBox(LabelSession& labels, QWidget* parent);

    void compare(const QString& name, const MatchedLabels& theirs);
    bool isComparing() const { return theirs_.has_value(); }
    const std::optional<Agreement>& agreement() const { return agreement_; }
    const DifferencesModel& model() const { return *model_; }
    /// In it the keys of the comparison work.
    QWidget* list() const;

    /// To the next (+1) or previous (-1) open difference.
    void step(int direction);
    /// Decides the current difference and goes on to the next.
    void takeTheirs();
    void keepMine();
    /// Takes theirs for all that are still open, as one step.
    void takeAllTheirs();
    /// Takes over what they say of actions that the project has no label by hand of, as one step.
    void addOnlyTheirs();
    /// Ends the comparison.
    void close();

Q_SIGNALS:
    void changed();

private:
    void follow();
    void fillTable();
    void showButtons();
    void goToRow(int row);
    int current() const;

    LabelSession& labels_;
    QString name_;
    std::optional<MatchedLabels> theirs_;
    std::optional<Agreement> agreement_;
    QLabel* sentence_;
    QTableWidget* aspects_;
    DifferencesModel* model_;
    QTableView* table_;
    QPushButton* theirsButton_;
    QPushButton* mineButton_;
    QPushButton* allButton_;
    QPushButton* addButton_;
    QPushButton* closeButton_;
    bool choosing_ = false;
};

}  // namespace kumite::studio
