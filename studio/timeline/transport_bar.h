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

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void addRowChooser(CommandTable& commands, QHBoxLayout* layout);
    void showMoment();
    void showState();
    void fitSelection();

    Session& session_;
    QLabel* time_;
    QLabel* frame_;
    QLabel* speed_;
    QLabel* selection_;
    QString selected_;  ///< all that it would say if there were room
};

}  // namespace kumite::studio
