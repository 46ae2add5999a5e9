#pragma once

#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace kumite::studio {

class LabelSession;

/// How far labelling has come: a bar with what hands said and what was accepted, "12 % labelled,
/// expected accuracy 93 %", in words what to do next, and the step that accepts the sure rest.
class ProgressBox : public QWidget {
    Q_OBJECT

public:
    /// The first key of a command, as people read it; empty without one.
    using KeyOf = std::function<QString(const QString& id)>;

    ProgressBox(LabelSession& labels, KeyOf keyOf, QWidget* parent);

    void refresh();
    /// From which confidence on the rest is accepted.
    double threshold() const;
    void moveThreshold(double by);

Q_SIGNALS:
    /// The rest that is sure enough is to be accepted.
    void acceptWanted();

private:
    QString adviceText() const;
    QString finishedText() const;
    /// Learnt aspects of which a single class was labelled so far.
    QStringList seenOnce() const;

    LabelSession& labels_;
    KeyOf keyOf_;
    QWidget* bar_;
    QLabel* counts_;
    QLabel* advice_;
    QDoubleSpinBox* threshold_;
    QPushButton* accept_;
};

}  // namespace kumite::studio
