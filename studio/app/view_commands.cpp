#include "studio/app/view_commands.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
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
QString text(const char* source) {
    return QApplication::translate("kumite::studio::StageCommands", source);
}

void savePicture(StageView& stage, const Session& session) {
    QSettings settings;
    const QString key = QStringLiteral("pictureFolder");
    const QString name = QFileInfo(session.document().name()).completeBaseName();
    QString path = fileToSave(
        stage.window(), text("Save a picture of the 3D view"),
        settings.value(key).toString() + QLatin1Char('/') + name + QStringLiteral(".png"),
        text("Pictures (*.png)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".png");
    settings.setValue(key, QFileInfo(path).absolutePath());
    if (stage.picture().save(path, "PNG")) return;
    notify(stage.window(), text("Picture of the 3D view"),
           text("%1: the picture cannot be written there.").arg(path));
}

void stepTrail(StageView& stage, int frames) {
    Overlays overlays = stage.overlays();
    overlays.trails = true;
    overlays.trailBefore += frames;
    stage.setOverlays(overlays);
}

}  // namespace

void addStageCommands(CommandTable& commands, StageView& stage, const Session& session) {
    const QString menu = text("3&D view");
    const QString group = QLatin1Char('-') + menu;
    const auto open = [&session] { return session.playerCount() > 0; };
    StageView* view = &stage;
    // What looks at the recording has nothing to do while a made motion is shown.
    const auto recorded = [&session, view] { return session.playerCount() > 0 && !view->isLive(); };
    const auto two = [&session, view] { return session.playerCount() > 1 && !view->isLive(); };

    commands.add({"view.front",
                  menu,
                  text("From the f&ront"),
                  {QKeySequence("Alt+1")},
                  [view] { view->lookFromFront(); },
                  open});
    commands.add({"view.side",
                  menu,
                  text("From the &side"),
                  {QKeySequence("Alt+2")},
                  [view] { view->lookFromSide(); },
                  open});
    commands.add({"view.top",
                  menu,
                  text("From a&bove"),
                  {QKeySequence("Alt+3")},
                  [view] { view->lookFromTop(); },
                  open});
    commands.add({"view.shoulder1",
                  menu,
                  text("Over the shoulder of fighter 1"),
                  {QKeySequence("Alt+4")},
                  [view] { view->lookOverShoulder(0); },
                  recorded});
    commands.add({"view.shoulder2",
                  menu,
                  text("Over the shoulder of fighter 2"),
                  {QKeySequence("Alt+5")},
                  [view] { view->lookOverShoulder(1); },
                  two});
    commands.add({"view.follow",
                  menu,
                  text("&Follow the fighters"),
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
    overlay("view.contacts", group, text("Foot &contacts"), "Alt+C", &Overlays::contacts);
    overlay("view.trails", menu, text("&Trails of hands and feet"), "Alt+T", &Overlays::trails);
    overlay("view.centreOfMass", menu, text("Centre of &mass"), "Alt+M", &Overlays::centreOfMass);
    overlay("view.force", menu, text("Contact f&orce"), "Alt+O", &Overlays::force);
    overlay("view.ghosts", menu, text("&Ghosts"), "Ctrl+G", &Overlays::ghosts);
    commands.add({"view.trailLonger",
                  group,
                  text("Longer trails"),
                  {QKeySequence("Alt+.")},
                  [view] { stepTrail(*view, 10); },
                  open});
    commands.add({"view.trailShorter",
                  menu,
                  text("Shorter trails"),
                  {QKeySequence("Alt+,")},
                  [view] { stepTrail(*view, -10); },
                  open});
    commands.add({"view.addGhost",
                  menu,
                  text("&Leave a ghost here"),
                  {QKeySequence("G")},
                  [view] { view->addGhost(); },
                  recorded});
    commands.add({"view.clearGhosts",
                  menu,
                  text("Remove all ghosts"),
                  {QKeySequence("Shift+G")},
                  [view] { view->clearGhosts(); },
                  [view] { return view->ghostCount() > 0; }});

    commands.add({"view.measure",
                  group,
                  text("&Measure"),
                  {QKeySequence("M")},
                  [view] { view->setMeasuring(!view->isMeasuring()); },
                  recorded,
                  [view] { return view->isMeasuring(); }});
    commands.add({"view.nextJoint",
                  menu,
                  text("Measure: next joint"),
                  {QKeySequence("Alt+PgDown")},
                  [view] { view->stepJoint(1); },
                  recorded});
    commands.add({"view.previousJoint",
                  menu,
                  text("Measure: joint before"),
                  {QKeySequence("Alt+PgUp")},
                  [view] { view->stepJoint(-1); },
                  recorded});
    commands.add({"view.takeJoint",
                  menu,
                  text("Measure from, then to this joint"),
                  {QKeySequence("Shift+M")},
                  [view] { view->takeJoint(); },
                  [view] { return view->isMeasuring(); }});
    // Enabled only while measuring, so that Esc keeps its other meanings.
    Command leave{"view.leaveMeasuring",
                  menu,
                  text("Leave measuring"),
                  {QKeySequence("Esc")},
                  [view] { view->setMeasuring(false); },
                  [view] { return view->isMeasuring(); }};
    // Nothing is measured on made motions, where Esc leaves something else.
    leave.workspace = QStringLiteral("segment label graph");
    commands.add(std::move(leave));
    commands.add({"view.copyPicture",
                  group,
                  text("Co&py a picture"),
                  {QKeySequence("Ctrl+Shift+C")},
                  [view] { QApplication::clipboard()->setImage(view->picture()); },
                  open});
    commands.add({"view.savePicture",
                  menu,
                  text("Save a p&icture…"),
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
            text("Click two joints; or %1 and %2 lead to a joint, %3 takes it")
                .arg(key("view.nextJoint"), key("view.previousJoint"), key("view.takeJoint")));
    };
    hint();
    QObject::connect(&commands, &CommandTable::renamed, &stage, hint);
    QObject::connect(&stage, &StageView::switchesChanged, &commands, &CommandTable::refresh);
}

}  // namespace kumite::studio
