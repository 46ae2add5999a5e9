#pragma once

#include <QWidget>

class QLabel;

namespace kumite::studio {

class LabelSession;

/// How far labelling has come: a bar with what hands said and what was accepted, "12 % labelled,
/// expected accuracy 93 %", and in words what to do next.
class ProgressBox : public QWidget {
    Q_OBJECT

public:
    explicit ProgressBox(LabelSession& labels, QWidget* parent);

    void refresh();

private:
    QString adviceText() const;

    LabelSession& labels_;
    QWidget* bar_;
    QLabel* counts_;
    QLabel* advice_;
};

}  // namespace kumite::studio
