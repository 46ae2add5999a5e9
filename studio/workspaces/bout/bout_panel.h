#pragma once

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListView;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace kumite::studio {

class BoutSession;
class CandidatesModel;

/// The Bout workspace's panel: who decides and how, why a choice was made and what else could have
/// been (a click takes it and goes on), how good the bout is beside the recording.
class BoutPanel : public QWidget {
    Q_OBJECT

public:
    explicit BoutPanel(BoutSession& bout, QWidget* parent = nullptr);

    const CandidatesModel& candidates() const { return *candidates_; }
    QListView* list() const { return list_; }
    QTableWidget* quality() const { return quality_; }
    void addButton(QWidget* button);

private:
    QWidget* makeSettings();
    QWidget* makeChoice();
    QWidget* makeQuality();
    void showSettings();
    void showChoice();
    void showQuality();
    void showState();

    BoutSession& bout_;
    CandidatesModel* candidates_;
    QButtonGroup* modes_;
    QComboBox* who_;
    QLabel* whoText_;
    QCheckBox* reactFirst_;
    QSpinBox* seed_;
    QDoubleSpinBox* temperature_;
    QLabel* state_;
    QLabel* choiceText_;
    QListView* list_;
    QTableWidget* quality_;
    QPushButton* judge_;
    QWidget* buttons_;
    bool showing_ = false;
};

}  // namespace kumite::studio
