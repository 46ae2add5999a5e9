#pragma once

#include <QWidget>

class QLabel;

namespace kumite::studio {

class CommandTable;
class SequenceSession;

/// Buttons and the clock of what the Sequence workspace plays.
class SequenceBar : public QWidget {
    Q_OBJECT

public:
    SequenceBar(SequenceSession& sequence, CommandTable& commands, QWidget* parent = nullptr);

private:
    void refresh();

    SequenceSession& sequence_;
    QLabel* time_;
    QLabel* what_;
};

}  // namespace kumite::studio
