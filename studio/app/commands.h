#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QAction;
class QMenu;
class QMenuBar;
class QWidget;

namespace kumite::studio {

/// One thing that the studio can do. Menus, shortcuts, buttons, the palette and the page of keys
/// all come from these entries.
struct Command {
    QString id;    ///< "boundary.remove"; also the name under which tests and scripts call it
    QString menu;  ///< "File"; "-" before it starts a new group; empty: in no menu
    QString text;
    QList<QKeySequence> keys;  ///< in force; those given to `add` are the defaults
    std::function<void()> run;
    std::function<bool()> enabled = {};
    std::function<bool()> checked = {};  ///< a switch; tells whether it is on
    QString icon = {};
    /// Its keys work only where one of these or a child has the focus; none: in the whole window.
    QList<QWidget*> scopes = {};
    /// Ids of the workspaces that it belongs to, separated by blanks; empty: to all.
    QString workspace = {};
    bool repeats = true;  ///< runs again and again while its key is held down
    /// Leads on in the job of its workspace: the keys that follow are meant for the views, whatever
    /// control had the focus.
    bool leadsOn = false;

    /// Whether it is offered in a workspace.
    bool isOf(const QString& id) const;
    QString words = {};                ///< other words that people look for it by: "delete, cut"
    std::function<bool()> shown = {};  ///< whether menus have it now; none: always

    /// The text without the marks that menus need: "Open recordings…".
    QString plainText() const;
    /// The menu's title without marks: "File".
    QString plainMenu() const;
    /// The keys in force as the platform writes them: "Ctrl+Y · Ctrl+Shift+Z".
    QString keysText() const;
};

/// All commands of a window, in the order in which menus show them.
class CommandTable : public QObject {
    Q_OBJECT

public:
    explicit CommandTable(QWidget* window);

    void add(Command command);
    /// What `addAll` adds belongs to one or several workspaces (ids separated by blanks): it is
    /// offered and its keys work only while one of them is shown.
    void addFor(const QString& workspaces, const std::function<void()>& addAll);
    void showWorkspace(const QString& workspace);

    /// Null where there is no such command.
    const Command* find(const QString& id) const;
    QAction* action(const QString& id) const;
    const std::vector<Command>& commands() const { return commands_; }
    void run(const QString& id) const;
    /// Whether it can be run now.
    bool isEnabled(const Command& command) const;

    /// Keys as the studio brings them, and those in force from now on.
    const QList<QKeySequence>& defaultKeys(const QString& id) const;
    void setKeys(const QString& id, const QList<QKeySequence>& keys);
    /// Other keys as the studio brings them; they are in force unless the user gave others.
    void setDefaultKeys(const QString& id, const QList<QKeySequence>& keys);
    void setText(const QString& id, const QString& text);
    void setWords(const QString& id, const QString& words);
    /// A tip that names the first key in force of a command, if it has one: "Keep it (Return)".
    QString withKey(const QString& tip, const QString& id) const;
    /// Has the widget's tip, or the command's if it has none, name the command's key from now on,
    /// whatever the key becomes.
    void tellKey(QWidget* widget, const QString& id);

    /// Brings enabled and checked states up to date.
    void refresh();
    /// Draws icons anew in the colour of the window's text.
    void refreshIcons();
    void fillMenus(QMenuBar* bar);
    QMenu* menu(const QString& title) const;
    /// Shows some commands at a point of the screen; "-" begins a new group. Commands of other
    /// workspaces are left out.
    void popUp(const QStringList& ids, const QPoint& at);
    /// The same as the context menu of a widget that needs nothing done before.
    void offerMenu(QWidget* widget, const QStringList& ids);

Q_SIGNALS:
    /// Keys or texts are others now.
    void renamed();
    /// A command is about to run.
    void running(const QString& id);

private:
    std::size_t indexOf(const QString& id) const;
    void describe(std::size_t index);

    QWidget* window_;
    std::vector<Command> commands_;
    std::vector<QList<QKeySequence>> defaultKeys_;
    std::vector<QAction*> actions_;
    std::vector<QMenu*> menus_;
    QString adding_;     ///< workspace of the commands that are being added
    QString workspace_;  ///< the one that is shown
};

}  // namespace kumite::studio
