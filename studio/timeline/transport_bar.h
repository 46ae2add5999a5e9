#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace kumite::studio {

class CommandTable;
class Session;

/// The row above the ruler: play buttons, the moment that is shown, speed and loop.
class TransportBar : public QWidget {
    Q_OBJECT

public:
    TransportBar(Session& session, CommandTable& commands, QWidget* parent = nullptr);

private:
    void addRowChooser(CommandTable& commands, QHBoxLayout* layout);
    void showMoment();
    void showState();

    Session& session_;
    QLabel* time_;
    QLabel* frame_;
    QLabel* speed_;
    QLabel* selection_;
};

}  // namespace kumite::studio
