#pragma once

#include <QWidget>

class QLabel;

namespace kumite::studio {

class BoutSession;
class CommandTable;

/// The row above the strip of actions: play buttons, the moment that is shown, how far the bout
/// goes, speed.
class BoutBar : public QWidget {
    Q_OBJECT

public:
    BoutBar(BoutSession& bout, CommandTable& commands, QWidget* parent = nullptr);

private:
    void showMoment();

    BoutSession& bout_;
    QLabel* time_;
    QLabel* end_;
    QLabel* speed_;
};

}  // namespace kumite::studio
