#pragma once

#include <QStackedWidget>

#include <functional>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace kumite::studio {

class BoutPanel;
class BoutSession;
class CommandTable;

/// The Bout workspace's panel, or what makes a bout possible where there is none.
class BoutPage : public QStackedWidget {
    Q_OBJECT

public:
    explicit BoutPage(BoutSession& bout, QWidget* parent = nullptr);

    BoutPanel& panel() { return *panel_; }
    /// Buttons that run commands of the table.
    void addCommands(CommandTable& commands);
    /// Offers a step where there is no bout.
    void addStep(const QString& text, const QString& tip, std::function<void()> run);

private:
    void refresh();

    BoutSession& bout_;
    BoutPanel* panel_;
    QWidget* empty_;
    QLabel* why_;
};

}  // namespace kumite::studio
