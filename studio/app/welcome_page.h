#pragma once

#include <QWidget>

#include <vector>

class QPushButton;
class QVBoxLayout;

namespace kumite::studio {

class CommandTable;

/// What the window shows while nothing is open: what the studio is for, the steps that begin a
/// bout, and what was opened lately. Arrow keys lead from choice to choice, Return takes one; the
/// marked step has the focus at first.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(CommandTable& commands, QWidget* parent = nullptr);
    void refresh();

Q_SIGNALS:
    void chosen(const QStringList& files);

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addSteps(CommandTable& commands, QVBoxLayout* column);

    void addChoice(std::vector<QPushButton*>& column, QPushButton* button);
    bool pressKey(QPushButton* button, int key);

    QWidget* recent_;
    QVBoxLayout* list_;
    std::vector<QPushButton*> steps_;    ///< the first one is marked
    std::vector<QPushButton*> recents_;  ///< what was opened lately, the last one first
};

}  // namespace kumite::studio
