#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QHBoxLayout;
class QStackedWidget;

namespace kumite::studio {

class CommandTable;

/// A way to work on the open bout, such as Segment. It brings the panel at the right, maybe a view
/// beside the 3D view, and commands whose menus and keys are there only while it is shown; 3D view,
/// timeline and the left panel are shared.
struct Workspace {
    QString id;    ///< "segment"; also how the last one shown is remembered
    QString name;  ///< "Segment"
    QString icon;  ///< of resources/icons
    QString tip;   ///< one sentence: what is done here
    QWidget* panel = nullptr;
    std::function<void()> addCommands = {};  ///< adds them to the window's table
    QWidget* centre = nullptr;               ///< beside the 3D view; none: it has all the room
};

/// The workspaces of a window, in the order of the work, and which of them is shown.
class Workspaces : public QObject {
    Q_OBJECT

public:
    /// Panels are shown in `panels`, what they bring beside the 3D view in `centres`.
    Workspaces(CommandTable& commands, QStackedWidget* panels, QStackedWidget* centres,
               QObject* parent = nullptr);

    /// The first one that is added is shown.
    void add(Workspace workspace);
    /// A command for each, once there is more than one to choose from. `menu` as in Command.
    void addSwitchCommands(const QString& menu);

    const std::vector<Workspace>& all() const { return all_; }
    QString current() const { return current_; }
    /// Does nothing for an unknown id.
    void show(const QString& id);

Q_SIGNALS:
    void changed();

private:
    CommandTable& commands_;
    QStackedWidget* panels_;
    QStackedWidget* centres_;
    std::vector<Workspace> all_;
    QString current_;
};

/// The workspaces as tabs in the window's top bar; a single one is a quiet name.
class WorkspaceBar : public QWidget {
    Q_OBJECT

public:
    explicit WorkspaceBar(Workspaces& workspaces, QWidget* parent = nullptr);

    /// Only the workspace that is shown has its name: menus need the room.
    void setCompact(bool compact);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void refresh();

    Workspaces& workspaces_;
    QHBoxLayout* row_;
    bool compact_ = false;
};

}  // namespace kumite::studio
