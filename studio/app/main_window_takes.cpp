// The commands on takes and fighters.

#include "studio/app/commands.h"
#include "studio/app/document_panel.h"
#include "studio/app/file_actions.h"
#include "studio/app/main_window.h"
#include "studio/app/status_line.h"
#include "studio/app/takes_list.h"
#include "studio/view3d/stage_view.h"

namespace kumite::studio {

void MainWindow::addTakeCommands() {
    const auto open = [this] { return session_.document().isOpen(); };
    const auto has = [this] { return hasTake(); };
    const auto two = [this] { return session_.playerCount() > 1; };
    const auto count = [this] {
        return static_cast<int>(session_.document().project().takes.size());
    };
    const QString menu = tr("Ta&ke");
    const QString group = QLatin1Char('-') + menu;
    commands_->add({"take.add",
                    menu,
                    tr("&Add recordings as a take…"),
                    {QKeySequence("Ctrl+Shift+A")},
                    [this] { files_->askForRecordings(); },
                    open,
                    {},
                    "add"});
    commands_->add({"take.rename",
                    menu,
                    tr("&Rename take"),
                    {QKeySequence("F2")},
                    [this] {
                        setPanelsShown(true);
                        documentPanel_->takes().renameShown();
                    },
                    has});
    commands_->add({"take.remove",
                    menu,
                    tr("Re&move take"),
                    {QKeySequence("Ctrl+Shift+Del")},
                    [this] { removeShownTake(); },
                    has});
    commands_->add({"take.up",
                    group,
                    tr("Move take &up"),
                    {QKeySequence("Alt+Up")},
                    [this] { documentPanel_->takes().moveShown(-1); },
                    [this, has] { return has() && session_.take() > 0; }});
    commands_->add({"take.down",
                    menu,
                    tr("Move take &down"),
                    {QKeySequence("Alt+Down")},
                    [this] { documentPanel_->takes().moveShown(1); },
                    [this, count] { return session_.take() + 1 < count(); }});
    commands_->add({"take.previous",
                    menu,
                    tr("Show the take &before"),
                    {QKeySequence("Ctrl+PgUp")},
                    [this] { stepTake(-1); },
                    [this, has] { return has() && session_.take() > 0; }});
    commands_->add({"take.next",
                    menu,
                    tr("Show the take a&fter"),
                    {QKeySequence("Ctrl+PgDown")},
                    [this] { stepTake(1); },
                    [this, count] { return session_.take() + 1 < count(); }});
    commands_->add({"fighter.other",
                    group,
                    tr("&Other fighter active"),
                    {QKeySequence("Tab")},
                    [this] { session_.setActivePlayer(1 - session_.activePlayer()); },
                    two,
                    {},
                    {},
                    {stage_, timelineBox_}});
    commands_->add({"fighter.properties",
                    menu,
                    tr("Fighter &properties…"),
                    {QKeySequence("Ctrl+I")},
                    [this] { showFighterProperties(); },
                    has,
                    {},
                    "adjust"});
    commands_->add({"fighter.swap",
                    menu,
                    tr("&Swap fighters"),
                    {},
                    [this] {
                        session_.document().apply([this](const Project& project) {
                            return swapFighters(project, session_.take());
                        });
                    },
                    two,
                    {},
                    "swap"});
    commands_->add({"project.findings",
                    group,
                    tr("F&indings on the recordings"),
                    {},
                    [this] { showFindings(); },
                    open});
}

void MainWindow::stepTake(int direction) {
    session_.setTake(session_.take() + direction);
}

void MainWindow::removeShownTake() {
    const QString name = QString::fromStdString(
        session_.document().project().takes[static_cast<std::size_t>(session_.take())].name);
    const bool removed = session_.document().apply(
        [this](const Project& project) { return removeTake(project, session_.take()); });
    if (removed) {
        status_->say(tr("Removed take %1. %2 brings it back.")
                         .arg(name, commands_->find("edit.undo")->keysText()));
    }
}

}  // namespace kumite::studio
