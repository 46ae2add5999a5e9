#include "studio/app/view_commands.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>

#include "studio/app/commands.h"
#include "studio/app/questions.h"
#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/view3d/stage_tools.h"
#include "studio/view3d/stage_view.h"

namespace kumite::studio {

namespace {

/// Translations of this file, in the window's context.
/// Translations of this file.
struct StageCommands {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::StageCommands)
};

void savePicture(StageView& stage, const Session& session) {
    QSettings settings;
    const QString key = QStringLiteral("pictureFolder");
    const QString name = QFileInfo(session.document().name()).completeBaseName();
    QString path = fileToSave(
        stage.window(), StageCommands::tr("Save a picture of the 3D view"),
        settings.value(key).toString() + QLatin1Char('/') + name + QStringLiteral(".png"),
        StageCommands::tr("Pictures (*.png)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".png");
    settings.setValue(key, QFileInfo(path).absolutePath());
    if (stage.picture().save(path, "PNG")) return;
    notify(stage.window(), StageCommands::tr("Picture of the 3D view"),
           StageCommands::tr("%1: the picture cannot be written there.").arg(path));
}

void stepTrail(StageView& stage, int frames) {
    Overlays overlays = stage.overlays();
    overlays.trails = true;
    overlays.trailBefore += frames;
    stage.setOverlays(overlays);
}

}  // namespace

void addStageCommands(CommandTable& commands, StageView& stage, const Session& session) {
    const QString menu = StageCommands::tr("3&D view");
    const QString group = QLatin1Char('-') + menu;
    const auto open = [&session] { return session.playerCount() > 0; };
    StageView* view = &stage;
    // What looks at the recording has nothing to do while a made motion is shown.
    const auto recorded = [&session, view] { return session.playerCount() > 0 && !view->isLive(); };
    const auto two = [&session, view] { return session.playerCount() > 1 && !view->isLive(); };

    commands.add({"view.front",
                  menu,
                  StageCommands::tr("From the f&ront"),
                  {QKeySequence("Alt+1")},
                  [view] { view->lookFromFront(); },
                  open});
    commands.add({"view.side",
                  menu,
                  StageCommands::tr("From the &side"),
                  {QKeySequence("Alt+2")},
                  [view] { view->lookFromSide(); },
                  open});
    commands.add({"view.top",
                  menu,
                  StageCommands::tr("From a&bove"),
                  {QKeySequence("Alt+3")},
                  [view] { view->lookFromTop(); },
                  open});
    commands.add({"view.shoulder1",
                  menu,
                  StageCommands::tr("Over the shoulder of fighter 1"),
                  {QKeySequence("Alt+4")},
                  [view] { view->lookOverShoulder(0); },
                  recorded});
    commands.add({"view.shoulder2",
                  menu,
                  StageCommands::tr("Over the shoulder of fighter 2"),
                  {QKeySequence("Alt+5")},
                  [view] { view->lookOverShoulder(1); },
                  two});
    commands.add({"view.follow",
                  menu,
                  StageCommands::tr("&Follow the fighters"),
                  {QKeySequence("Shift+F")},
                  [view] { view->setFollowing(!view->isFollowing()); },
                  open,
                  [view] { return view->isFollowing(); }});

    const auto overlay = [&](const QString& id, const QString& where, const QString& title,
                             const QString& key, bool Overlays::*field) {
        commands.add({id,
                      where,
                      title,
                      {QKeySequence(key)},
                      [view, field] {
                          Overlays overlays = view->overlays();
                          overlays.*field = !(overlays.*field);
                          view->setOverlays(overlays);
                      },
                      open,
                      [view, field] { return view->overlays().*field; }});
    };
    overlay("view.contacts", group, StageCommands::tr("Foot &contacts"), "Alt+C",
            &Overlays::contacts);
    overlay("view.trails", menu, StageCommands::tr("&Trails of hands and feet"), "Alt+T",
            &Overlays::trails);
    overlay("view.centreOfMass", menu, StageCommands::tr("Centre of &mass"), "Alt+M",
            &Overlays::centreOfMass);
    overlay("view.force", menu, StageCommands::tr("Contact f&orce"), "Alt+O", &Overlays::force);
    overlay("view.ghosts", menu, StageCommands::tr("&Ghosts"), "Ctrl+G", &Overlays::ghosts);
    commands.add({"view.trailLonger",
                  group,
                  StageCommands::tr("Longer trails"),
                  {QKeySequence("Alt+.")},
                  [view] { stepTrail(*view, 10); },
                  open});
    commands.add({"view.trailShorter",
                  menu,
                  StageCommands::tr("Shorter trails"),
                  {QKeySequence("Alt+,")},
                  [view] { stepTrail(*view, -10); },
                  open});
    commands.add({"view.addGhost",
                  menu,
                  StageCommands::tr("&Leave a ghost here"),
                  {QKeySequence("G")},
                  [view] { view->addGhost(); },
                  recorded});
    commands.add({"view.clearGhosts",
                  menu,
                  StageCommands::tr("Remove all ghosts"),
                  {QKeySequence("Shift+G")},
                  [view] { view->clearGhosts(); },
                  [view] { return view->ghostCount() > 0; }});

    commands.add({"view.measure",
                  group,
                  StageCommands::tr("M&easure"),
                  {QKeySequence("M")},
                  [view] { view->setMeasuring(!view->isMeasuring()); },
                  recorded,
                  [view] { return view->isMeasuring(); }});
    commands.add({"view.nextJoint",
                  menu,
                  StageCommands::tr("Measure: next joint"),
                  {QKeySequence("Alt+PgDown")},
                  [view] { view->stepJoint(1); },
                  recorded});
    commands.add({"view.previousJoint",
                  menu,
                  StageCommands::tr("Measure: joint before"),
                  {QKeySequence("Alt+PgUp")},
                  [view] { view->stepJoint(-1); },
                  recorded});
    commands.add({"view.takeJoint",
                  menu,
                  StageCommands::tr("Measure from, then to this joint"),
                  {QKeySequence("Shift+M")},
                  [view] { view->takeJoint(); },
                  [view] { return view->isMeasuring(); }});
    // Enabled only while measuring, so that Esc keeps its other meanings.
    Command leave{"view.leaveMeasuring",
                  menu,
                  StageCommands::tr("Leave measuring"),
                  {QKeySequence("Esc")},
                  [view] { view->setMeasuring(false); },
                  [view] { return view->isMeasuring(); }};
    // Nothing is measured on made motions, where Esc leaves something else.
    leave.workspace = QStringLiteral("segment label graph");
    commands.add(std::move(leave));
    commands.add({"view.copyPicture",
                  group,
                  StageCommands::tr("Co&py a picture"),
                  {QKeySequence("Ctrl+Shift+C")},
                  [view] { QApplication::clipboard()->setImage(view->picture()); },
                  open});
    commands.add({"view.savePicture",
                  menu,
                  StageCommands::tr("Save a p&icture…"),
                  {},
                  [view, &session] { savePicture(*view, session); },
                  open});

    const auto actions = [&](std::initializer_list<const char*> ids) {
        QList<QAction*> found;
        for (const char* id : ids)
            found.append(commands.action(QLatin1String(id)));
        return found;
    };
    auto* tools = new StageTools(stage);
    tools->setCameraActions(
        actions({"view.all", "view.selection", "view.front", "view.side", "view.top",
                 "view.shoulder1", "view.shoulder2", "view.follow"}));
    tools->setOverlayActions(
        actions({"view.contacts", "view.trails", "view.centreOfMass", "view.force", "view.ghosts",
                 "view.addGhost", "view.clearGhosts"}));
    tools->setMeasureAction(commands.action(QStringLiteral("view.measure")));
    stage.setTools(tools);
    const auto hint = [&commands, view] {
        const auto key = [&commands](const char* id) {
            return commands.find(QLatin1String(id))->keysText();
        };
        view->setMeasuringHint(
            StageCommands::tr("Click two joints; or %1 and %2 lead to a joint, %3 takes it")
                .arg(key("view.nextJoint"), key("view.previousJoint"), key("view.takeJoint")));
    };
    hint();
    QObject::connect(&commands, &CommandTable::renamed, &stage, hint);
    QObject::connect(&stage, &StageView::switchesChanged, &commands, &CommandTable::refresh);
}

}  // namespace kumite::studio
