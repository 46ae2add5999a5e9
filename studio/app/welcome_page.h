#pragma once

#include <QWidget>

class QVBoxLayout;

namespace kumite::studio {

class CommandTable;

/// What the window shows while nothing is open: what the studio is for, the steps that begin a
/// bout, and what was opened lately.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(CommandTable& commands, QWidget* parent = nullptr);
    void refresh();

Q_SIGNALS:
    void chosen(const QStringList& files);

private:
    void addSteps(CommandTable& commands, QVBoxLayout* column);

    QWidget* recent_;
    QVBoxLayout* list_;
};

}  // namespace kumite::studio
