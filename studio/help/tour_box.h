#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace kumite::studio {

class CommandTable;
struct TourStep;

/// The box of the tour: what to do now, whether it is done, and the ways back, on and out. Never
/// takes the focus by itself, so that keys go on to where the work is.
class TourBox : public QFrame {
    Q_OBJECT

public:
    TourBox(CommandTable& commands, QWidget* window);

    void show(const TourStep& step, int number, int count);
    void setDone(bool done);
    bool showsDone() const;
    QString text() const;
    QPushButton* helpButton() const { return help_; }

Q_SIGNALS:
    void helpWanted();

private:
    QLabel* title_;
    QLabel* text_;
    QLabel* done_;
    QPushButton* help_;
    QPushButton* back_;
    QPushButton* next_;
};

}  // namespace kumite::studio
