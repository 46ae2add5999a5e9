#include "studio/workspaces/keyframe/key_commands.h"

#include <QApplication>

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

QString text(const char* source) {
    return QApplication::translate("kumite::studio::KeyCommands", source);
}

}  // namespace

void addKeyCommands(CommandTable& commands, KeySession& keys, HitSession& hit, StageView& stage) {
    const QString menu = text("Ke&yframe");
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
        "keys.play", menu, text("&Play or pause"), {QKeySequence("Space")},
        [session, tool] {
            if (tool->isOn()) {
                tool->setPlaying(!tool->isPlaying());
            } else {
                session->setPlaying(!session->isPlaying());
            }
        },
        [tool, any] { return tool->isOn() ? tool->motion().has_value() : any(); }, "play");
    add(
        "keys.back", menu, text("One frame back"), {QKeySequence("Left"), QKeySequence(",")},
        [session] { session->step(-1); }, ready, "step_back");
    add(
        "keys.on", menu, text("One frame on"), {QKeySequence("Right"), QKeySequence(".")},
        [session] { session->step(1); }, ready, "step_on");
    add(
        "keys.backTen", menu, text("Ten frames back"), {QKeySequence("Shift+Left")},
        [session] { session->step(-10); }, ready);
    add(
        "keys.onTen", menu, text("Ten frames on"), {QKeySequence("Shift+Right")},
        [session] { session->step(10); }, ready);
    add(
        "keys.start", menu, text("To the first key"), {QKeySequence("Home")},
        [session] { session->seek(session->firstFrame()); }, any, "to_begin");
    add(
        "keys.end", menu, text("To the last key"), {QKeySequence("End")},
        [session] { session->seek(session->lastFrame()); }, any, "to_end");
    commands.add({"keys.motion",
                  group,
                  text("Show the &motion instead of the keys"),
                  {QKeySequence("V")},
                  [session] { session->setShowsMotion(!session->showsMotion()); },
                  [session, ready] { return ready() && session->motion() != nullptr; },
                  [session] { return session->showsMotion(); }});
    commands.add({"keys.direct",
                  menu,
                  text("Beside it the motion without a&djustment"),
                  {QKeySequence("C")},
                  [session] { session->setShowsDirect(!session->showsDirect()); },
                  [session, ready] { return ready() && session->motion() != nullptr; },
                  [session] { return session->showsDirect(); }});
    commands.add({"keys.neighbours",
                  menu,
                  text("Keys before and after as &ghosts"),
                  {QKeySequence("O")},
                  [session] { session->setShowsNeighbours(!session->showsNeighbours()); },
                  any,
                  [session] { return session->showsNeighbours(); }});
    commands.add({"keys.hit",
                  menu,
                  text("&Hit a target"),
                  {QKeySequence("S")},
                  [tool] { tool->setOn(!tool->isOn()); },
                  [session] { return session->library() != nullptr; },
                  [tool] { return tool->isOn(); }});
    add(
        "keys.add", group, text("&Add a key here"), {QKeySequence("Return"), QKeySequence("Enter")},
        [session] { session->addKey(); }, ready);
    add(
        "keys.remove", menu, text("&Remove the key"),
        {QKeySequence("Del"), QKeySequence("Backspace")}, [session] { session->removeKey(); },
        chosen);
    add(
        "keys.previous", menu, text("Key before"), {QKeySequence("PgUp")},
        [session] { session->chooseNext(-1); }, any);
    add(
        "keys.next", menu, text("Key after"), {QKeySequence("PgDown")},
        [session] { session->chooseNext(1); }, any);
    add(
        "keys.earlier", menu, text("Move the key earlier"), {QKeySequence("Alt+Left")},
        [session] { session->moveKey(*session->key(), *session->key() - 1); }, chosen);
    add(
        "keys.later", menu, text("Move the key later"), {QKeySequence("Alt+Right")},
        [session] { session->moveKey(*session->key(), *session->key() + 1); }, chosen);
    add(
        "keys.earlierAll", menu, text("Move the key and later ones earlier"),
        {QKeySequence("Alt+Shift+Left")},
        [session] { session->shiftKeys(*session->key(), *session->key() - 1); }, chosen);
    add(
        "keys.laterAll", menu, text("Move the key and later ones later"),
        {QKeySequence("Alt+Shift+Right")},
        [session] { session->shiftKeys(*session->key(), *session->key() + 1); }, chosen);
    add(
        "keys.closer", menu, text("Later keys closer together"), {QKeySequence("[")},
        [session] { session->retime(kCloser); }, chosen);
    add(
        "keys.apart", menu, text("Later keys farther apart"), {QKeySequence("]")},
        [session] { session->retime(1 / kCloser); }, chosen);
    add(
        "keys.copy", menu, text("&Copy the key to the playhead, or behind the last"),
        {QKeySequence("Ctrl+D")}, [session] { session->copyKey(); }, chosen);
    add(
        "keys.mirror", menu, text("M&irror the pose"), {QKeySequence("X")},
        [session] { session->mirrorKey(); }, editable);
    add(
        "keys.take", menu, text("&Take the pose that the recording shows"), {QKeySequence("T")},
        [session] { session->takePose(); }, ready);
    add(
        "keys.takeFrom", menu, text("Copy the pose from an&y take or clip…"),
        {QKeySequence("Shift+T")},
        [session, view] { (new PoseDialog(*session, view->window()))->open(); }, ready);
    add(
        "keys.pin", group, text("The handle &stays where it is, or not"), {QKeySequence("P")},
        [session] { session->setPinned(session->handle(), !session->pins()[session->handle()]); },
        editable);
    add(
        "keys.nextHandle", menu, text("Next handle"), {QKeySequence("N")},
        [session] {
            session->setHandle(
                static_cast<Handle>((static_cast<int>(session->handle()) + 1) % kHandleCount));
        },
        editable);
    add(
        "keys.nextJoint", menu, text("Next &joint to turn"), {QKeySequence("J")},
        [session] { session->stepJoint(1); }, editable);
    add(
        "keys.previousJoint", menu, text("Joint before"), {QKeySequence("Shift+J")},
        [session] { session->stepJoint(-1); }, editable);
    const auto move = [&](const char* id, const QString& title, const char* key,
                          const Eigen::Vector3d& way) {
        add(
            id, menu, title, {QKeySequence(QLatin1String(key))},
            [session, way] { session->nudge(way); }, editable);
    };
    move("keys.up", text("Handle up"), "Ctrl+Up", {0, 0.02, 0});
    move("keys.down", text("Handle down"), "Ctrl+Down", {0, -0.02, 0});
    move("keys.xMinus", text("Handle toward −x"), "Ctrl+Left", {-0.02, 0, 0});
    move("keys.xPlus", text("Handle toward +x"), "Ctrl+Right", {0.02, 0, 0});
    move("keys.zMinus", text("Handle toward −z"), "Ctrl+Shift+Up", {0, 0, -0.02});
    move("keys.zPlus", text("Handle toward +z"), "Ctrl+Shift+Down", {0, 0, 0.02});
    add(
        "keys.anywhere", group, text("The body from anywhere again"), {QKeySequence("B")},
        [session] {
            session->change(text("Take the body from anywhere"),
                            [](KeyDraft& draft) { draft.body.clear(); });
        },
        [session, ready] { return ready() && !session->draft().body.empty(); });
    add(
        "keys.clear", menu, text("Remove all keys"), {}, [session] { session->clear(); }, any);
    const auto open = [session] { return session->session().document().isOpen(); };
    add(
        "keys.clips", group, text("Add clips of &files…"), {QKeySequence("Ctrl+Shift+I")},
        [session, view] { askForClips(session->session(), view->window()); }, open);
    add(
        "keys.folder", menu, text("Add clips of a f&older…"), {},
        [session, view] { askForClipFolder(session->session(), view->window()); }, open);
    add(
        "keys.part", menu, text("&Replace a part of a take…"), {QKeySequence("R")},
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
        "keys.keep", group, text("&Keep as a take…"), {QKeySequence("Ctrl+T")},
        [session, view, made] {
            keepMotion(session->session(), session->writing(), made(), view->window());
        },
        writable);
    add(
        "keys.export", menu, text("E&xport the motion…"), {QKeySequence("Ctrl+Shift+E")},
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
