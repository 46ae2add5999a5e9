#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QAction;
class QMenu;
class QMenuBar;
class QWidget;

namespace kumite::studio {

/// One thing that the studio can do. Menus, shortcuts, buttons and the page of keys all come from
/// these entries.
struct Command {
    QString id;    ///< "boundary.remove"; also the name under which tests and scripts call it
    QString menu;  ///< "File"; "-" before it starts a new group; empty: in no menu
    QString text;
    QList<QKeySequence> keys;
    std::function<void()> run;
    std::function<bool()> enabled = {};
    std::function<bool()> checked = {};  ///< a switch; tells whether it is on
    QString icon = {};
    /// Its keys work only where one of these or a child has the focus; none: in the whole window.
    QList<QWidget*> scopes = {};
};

/// All commands of a window, in the order in which menus show them.
class CommandTable : public QObject {
    Q_OBJECT

public:
    explicit CommandTable(QWidget* window);

    void add(Command command);
    QAction* action(const QString& id) const;
    const std::vector<Command>& commands() const { return commands_; }
    void run(const QString& id) const;
    /// Brings enabled and checked states up to date.
    void refresh();
    /// Draws icons anew in the colour of the window's text.
    void refreshIcons();
    void fillMenus(QMenuBar* bar);
    QMenu* menu(const QString& title) const;

private:
    QWidget* window_;
    std::vector<Command> commands_;
    std::vector<QAction*> actions_;
    std::vector<QMenu*> menus_;
};

}  // namespace kumite::studio
