#pragma once

#include <QWidget>

class QLabel;

namespace kumite::studio {

class CommandTable;
class HitSession;
class KeySession;

/// Buttons and the clock of what the Keyframe workspace plays.
class KeyBar : public QWidget {
    Q_OBJECT

public:
    KeyBar(KeySession& keys, HitSession& hit, CommandTable& commands, QWidget* parent = nullptr);

private:
    void refresh();

    KeySession& keys_;
    HitSession& hit_;
    QLabel* time_;
    QLabel* what_;
};

}  // namespace kumite::studio
