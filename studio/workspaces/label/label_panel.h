#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTabWidget;

namespace kumite::studio {

class CommandTable;
class LabelPalette;
class LabelReview;
class LabelSession;
class ProgressBox;
struct ShownAction;

/// What the Label workspace is about: how far labelling has come, the question that is asked with
/// its two best answers, and in pages below all keys and the queue.
class LabelPanel : public QWidget {
    Q_OBJECT

public:
    LabelPanel(LabelReview& review, CommandTable& commands, QWidget* parent = nullptr);

    /// Accepts what is at least as sure as the field says.
    void acceptSure();
    /// Moves the bar from which on answers count as sure.
    void moveBar(double by);

private:
    QWidget* makeQuestion();
    QWidget* makeKeys();
    QWidget* makeQueue();
    void showLabels();
    void showChoice();
    void showAnswers(const ShownAction& action);
    void showQueue();
    QString keyOf(const QString& command) const;

    LabelReview& review_;
    LabelSession& labels_;
    CommandTable& commands_;
    ProgressBox* progress_;
    QLabel* which_;
    QPushButton* best_;
    QPushButton* second_;
    QLabel* reason_;
    LabelPalette* palette_;
    QCheckBox* advance_;
    QComboBox* order_;
    QListWidget* queue_;
    QTabWidget* pages_;
};

}  // namespace kumite::studio
