#include "studio/workspaces/keyframe/key_commands.h"

#include <QApplication>
#include <QCoreApplication>

#include <cmath>

#include "studio/app/commands.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/part_dialog.h"
#include "studio/workspaces/keyframe/pose_dialog.h"

namespace kumite::studio {

namespace {

constexpr double kCloser = 0.9;

/// Translations of this file.
struct KeyCommands {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::KeyCommands)
};

}  // namespace

void addKeyCommands(CommandTable& commands, KeySession& keys, HitSession& hit, StageView& stage) {
    const QString menu = KeyCommands::tr("Ke&yframe");
    const QString group = QLatin1Char('-') + menu;
    KeySession* session = &keys;
    HitSession* tool = &hit;
    StageView* view = &stage;
    // While the hit tool is shown keys rest.
    const auto ready = [session, tool] { return session->library() != nullptr && !tool->isOn(); };
    const auto any = [session, ready] { return ready() && !session->draft().track.keys.empty(); };
    const auto chosen = [session, ready] { return ready() && session->key().has_value(); };
    const auto editable = [session, ready] { return ready() && session->isEditable(); };
    const auto add = [&](const char* id, const QString& where, const QString& title,
                         const QList<QKeySequence>& keysOf, std::function<void()> run,
                         std::function<bool()> enabled, const QString& icon = {}) {
        commands.add({id, where, title, keysOf, std::move(run), std::move(enabled), {}, icon});
    };
    add(
        "keys.play", menu, KeyCommands::tr("&Play or pause"), {QKeySequence("Space")},
        [session, tool] {
            if (tool->isOn()) {
                tool->setPlaying(!tool->isPlaying());
            } else {
                session->setPlaying(!session->isPlaying());
            }
        },
        [tool, any] { return tool->isOn() ? tool->motion().has_value() : any(); }, "play");
    add(
        "keys.back", menu, KeyCommands::tr("One frame back"),
        {QKeySequence("Left"), QKeySequence(",")}, [session] { session->step(-1); }, ready,
        "step_back");
    add(
        "keys.on", menu, KeyCommands::tr("One frame on"),
        {QKeySequence("Right"), QKeySequence(".")}, [session] { session->step(1); }, ready,
        "step_on");
    add(
        "keys.backTen", menu, KeyCommands::tr("Ten frames back"), {QKeySequence("Shift+Left")},
        [session] { session->step(-10); }, ready);
    add(
        "keys.onTen", menu, KeyCommands::tr("Ten frames on"), {QKeySequence("Shift+Right")},
        [session] { session->step(10); }, ready);
    add(
        "keys.start", menu, KeyCommands::tr("To the first key"), {QKeySequence("Home")},
        [session] { session->seek(session->firstFrame()); }, any, "to_begin");
    add(
        "keys.end", menu, KeyCommands::tr("To the last key"), {QKeySequence("End")},
        [session] { session->seek(session->lastFrame()); }, any, "to_end");
    commands.add({"keys.motion",
                  group,
                  KeyCommands::tr("Show the &motion instead of the keys"),
                  {QKeySequence("V")},
                  [session] { session->setShowsMotion(!session->showsMotion()); },
                  [session, ready] { return ready() && session->motion() != nullptr; },
                  [session] { return session->showsMotion(); }});
    commands.add({"keys.direct",
                  menu,
                  KeyCommands::tr("Beside it the motion without a&djustment"),
                  {QKeySequence("C")},
                  [session] { session->setShowsDirect(!session->showsDirect()); },
                  [session, ready] { return ready() && session->motion() != nullptr; },
                  [session] { return session->showsDirect(); }});
    commands.add({"keys.neighbours",
                  menu,
                  KeyCommands::tr("Keys before and after as &ghosts"),
                  {QKeySequence("O")},
                  [session] { session->setShowsNeighbours(!session->showsNeighbours()); },
                  any,
                  [session] { return session->showsNeighbours(); }});
    commands.add({"keys.hit",
                  menu,
                  KeyCommands::tr("&Hit a target"),
                  {QKeySequence("S")},
                  [tool] { tool->setOn(!tool->isOn()); },
                  [session] { return session->library() != nullptr; },
                  [tool] { return tool->isOn(); }});
    add(
        "keys.add", group, KeyCommands::tr("&Add a key here"),
        {QKeySequence("Return"), QKeySequence("Enter")}, [session] { session->addKey(); }, ready);
    add(
        "keys.remove", menu, KeyCommands::tr("&Remove the key"),
        {QKeySequence("Del"), QKeySequence("Backspace")}, [session] { session->removeKey(); },
        chosen);
    add(
        "keys.previous", menu, KeyCommands::tr("Key before"), {QKeySequence("PgUp")},
        [session] { session->chooseNext(-1); }, any);
    add(
        "keys.next", menu, KeyCommands::tr("Key after"), {QKeySequence("PgDown")},
        [session] { session->chooseNext(1); }, any);
    add(
        "keys.earlier", menu, KeyCommands::tr("Move the key earlier"), {QKeySequence("Alt+Left")},
        [session] { session->moveKey(*session->key(), *session->key() - 1); }, chosen);
    add(
        "keys.later", menu, KeyCommands::tr("Move the key later"), {QKeySequence("Alt+Right")},
        [session] { session->moveKey(*session->key(), *session->key() + 1); }, chosen);
    add(
        "keys.earlierAll", menu, KeyCommands::tr("Move the key and later ones earlier"),
        {QKeySequence("Alt+Shift+Left")},
        [session] { session->shiftKeys(*session->key(), *session->key() - 1); }, chosen);
    add(
        "keys.laterAll", menu, KeyCommands::tr("Move the key and later ones later"),
        {QKeySequence("Alt+Shift+Right")},
        [session] { session->shiftKeys(*session->key(), *session->key() + 1); }, chosen);
    add(
        "keys.closer", menu, KeyCommands::tr("Later keys closer together"), {QKeySequence("[")},
        [session] { session->retime(kCloser); }, chosen);
    add(
        "keys.apart", menu, KeyCommands::tr("Later keys farther apart"), {QKeySequence("]")},
        [session] { session->retime(1 / kCloser); }, chosen);
    add(
        "keys.copy", menu, KeyCommands::tr("&Copy the key to the playhead, or behind the last"),
        {QKeySequence("Ctrl+D")}, [session] { session->copyKey(); }, chosen);
    add(
        "keys.mirror", menu, KeyCommands::tr("M&irror the pose"), {QKeySequence("X")},
        [session] { session->mirrorKey(); }, editable);
    add(
        "keys.take", menu, KeyCommands::tr("&Take the pose that the recording shows"),
        {QKeySequence("T")}, [session] { session->takePose(); }, ready);
    add(
        "keys.takeFrom", menu, KeyCommands::tr("Copy the pose from an&y take or clip…"),
        {QKeySequence("Shift+T")},
        [session, view] { (new PoseDialog(*session, view->window()))->open(); }, ready);
    add(
        "keys.pin", group, KeyCommands::tr("The handle &stays where it is, or not"),
        {QKeySequence("P")},
        [session] { session->setPinned(session->handle(), !session->pins()[session->handle()]); },
        editable);
    add(
        "keys.nextHandle", menu, KeyCommands::tr("Next handle"), {QKeySequence("N")},
        [session] {
            session->setHandle(
                static_cast<Handle>((static_cast<int>(session->handle()) + 1) % kHandleCount));
        },
        editable);
    add(
        "keys.nextJoint", menu, KeyCommands::tr("Next &joint to turn"), {QKeySequence("J")},
        [session] { session->stepJoint(1); }, editable);
    add(
        "keys.previousJoint", menu, KeyCommands::tr("Joint before"), {QKeySequence("Shift+J")},
        [session] { session->stepJoint(-1); }, editable);
    const auto move = [&](const char* id, const QString& title, const char* key,
                          const Eigen::Vector3d& way) {
        add(
            id, menu, title, {QKeySequence(QLatin1String(key))},
            [session, way] { session->nudge(way); }, editable);
    };
    move("keys.up", KeyCommands::tr("Handle up"), "Ctrl+Up", {0, 0.02, 0});
    move("keys.down", KeyCommands::tr("Handle down"), "Ctrl+Down", {0, -0.02, 0});
    move("keys.xMinus", KeyCommands::tr("Handle toward −x"), "Ctrl+Left", {-0.02, 0, 0});
    move("keys.xPlus", KeyCommands::tr("Handle toward +x"), "Ctrl+Right", {0.02, 0, 0});
    move("keys.zMinus", KeyCommands::tr("Handle toward −z"), "Ctrl+Shift+Up", {0, 0, -0.02});
    move("keys.zPlus", KeyCommands::tr("Handle toward +z"), "Ctrl+Shift+Down", {0, 0, 0.02});
    add(
        "keys.anywhere", group, KeyCommands::tr("The body from anywhere again"),
        {QKeySequence("B")},
        [session] {
            session->change(KeyCommands::tr("Take the body from anywhere"),
                            [](KeyDraft& draft) { draft.body.clear(); });
        },
        [session, ready] { return ready() && !session->draft().body.empty(); });
    add(
        "keys.clear", menu, KeyCommands::tr("Remove all keys"), {}, [session] { session->clear(); },
        any);
    const auto open = [session] { return session->session().document().isOpen(); };
    add(
        "keys.clips", group, KeyCommands::tr("Add clips of &files…"),
        {QKeySequence("Ctrl+Shift+I")},
        [session, view] { askForClips(session->session(), view->window()); }, open);
    add(
        "keys.folder", menu, KeyCommands::tr("Add cl&ips of a folder…"), {},
        [session, view] { askForClipFolder(session->session(), view->window()); }, open);
    add(
        "keys.part", menu, KeyCommands::tr("R&eplace a part of a take…"), {QKeySequence("R")},
        [session, view] { (new PartDialog(*session, view->window()))->open(); }, ready);
    const auto writable = [session, tool] {
        return (tool->isOn() ? tool->motion().has_value() : session->isCurrent()) &&
               !session->writing().isRunning();
    };
    const auto made = [session, tool] {
        session->setPlaying(false);
        return tool->isOn() ? tool->madeMotion() : session->madeMotion();
    };
    add(
        "keys.keep", group, KeyCommands::tr("&Keep as a take…"), {QKeySequence("Ctrl+T")},
        [session, view, made] {
            keepMotion(session->session(), session->writing(), made(), view->window());
        },
        writable);
    add(
        "keys.export", menu, KeyCommands::tr("E&xport the motion…"), {QKeySequence("Ctrl+Shift+E")},
        [session, view, made] {
            exportMotion(session->session(), session->writing(), made(), view->window());
        },
        writable);
    for (auto signal : {&KeySession::stateChanged, &KeySession::chosen, &KeySession::motionChanged,
                        &KeySession::draftChanged, &KeySession::libraryChanged})
        QObject::connect(session, signal, &commands, &CommandTable::refresh);
    QObject::connect(tool, &HitSession::changed, &commands, &CommandTable::refresh);
}

}  // namespace kumite::studio
