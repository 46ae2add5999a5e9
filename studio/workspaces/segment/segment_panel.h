#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;

namespace kumite::studio {

class CommandTable;
class CompareBox;
class Session;
class StatisticsBox;
class SuspectsModel;
class UnmatchedBox;

/// What the Segment workspace is about: the minima that are most likely spurious and what to do
/// with them, how far that has come, and how streams are cut.
class SegmentPanel : public QWidget {
    Q_OBJECT

public:
    explicit SegmentPanel(Session& session, QWidget* parent = nullptr);

    /// The list of suspects: the keys of a review work in it.
    QWidget* list() const;
    CompareBox& comparison() { return *compare_; }
    /// Tips and hints name the keys of these from now on.
    void tellKeys(CommandTable& commands);

private:
    QTableView* makeTable();
    QWidget* makeDecisions();
    void showFighters();
    void showSelection();
    void showTips(bool removed);
    void chooseRow(int row);

    Session& session_;
    const CommandTable* commands_ = nullptr;
    SuspectsModel* model_;
    QTableView* table_;
    QLabel* empty_;
    QLabel* reason_;
    QPushButton* accept_;
    QPushButton* remove_;
    StatisticsBox* statistics_;
    UnmatchedBox* unmatched_;
    CompareBox* compare_;
    bool filling_ = false;
};

}  // namespace kumite::studio
