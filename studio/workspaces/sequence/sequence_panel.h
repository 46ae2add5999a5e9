#pragma once

#include <QStackedWidget>

#include <functional>
#include <optional>

#include "core/motion/motion_library.h"

class QAbstractButton;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QTableView;

namespace kumite::studio {

class ActionsModel;
class CommandTable;
class SequenceSession;

/// The Sequence workspace's panel: the actions to choose from, and the transition to the chosen
/// block; or what to do where there is nothing to make a sequence of.
class SequencePanel : public QStackedWidget {
    Q_OBJECT

public:
    explicit SequencePanel(SequenceSession& sequence, QWidget* parent = nullptr);

    /// Buttons that run commands of the table.
    void addCommands(CommandTable& commands);
    /// Offers a step where there is nothing.
    void addStep(const QString& text, const QString& tip, std::function<void()> run);

    QLineEdit& search() { return *search_; }
    QTableView& table() { return *table_; }
    /// The action that is chosen in the list.
    std::optional<LibraryAction> chosen() const;

private:
    void refresh();

    SequenceSession& sequence_;
    QLineEdit* search_;
    QTableView* table_;
    ActionsModel* model_;
    QLabel* count_;
    QHBoxLayout* buttons_;
    QWidget* empty_;
    QWidget* full_;
    QLabel* why_;
};

}  // namespace kumite::studio
