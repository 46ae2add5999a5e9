#pragma once

#include <QWidget>

class QLabel;

namespace kumite::studio {

class LabelSession;
class ProgressBox;

/// What the Label workspace is about: how far labelling has come and what to do next.
class LabelPanel : public QWidget {
    Q_OBJECT

public:
    explicit LabelPanel(LabelSession& labels, QWidget* parent = nullptr);

private:
    void showLabels();
    void showChoice();

    LabelSession& labels_;
    ProgressBox* progress_;
    QLabel* action_;
};

}  // namespace kumite::studio
