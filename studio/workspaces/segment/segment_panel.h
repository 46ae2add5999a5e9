#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableView;

namespace kumite::studio {

class Session;
class SuspectsModel;

/// What the Segment workspace is about: the minima that are most likely spurious, how streams are
/// cut, and how many actions come out.
class SegmentPanel : public QWidget {
    Q_OBJECT

public:
    explicit SegmentPanel(Session& session, QWidget* parent = nullptr);

private:
    QWidget* makeSettings();
    void showFighters();
    void showSettings();
    void showSelection();
    void applySettings();
    void chooseRow(int row);
    void forgetUnmatched();

    Session& session_;
    SuspectsModel* model_;
    QTableView* table_;
    QLabel* empty_;
    QPushButton* remove_;
    QDoubleSpinBox* cutoff_;
    QDoubleSpinBox* prominence_;
    QLabel* counts_;
    QLabel* unmatched_;
    QPushButton* forget_;
    bool filling_ = false;
};

}  // namespace kumite::studio
