#include "studio/workspaces/sequence/sequence_commands.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QLineEdit>
#include <QTableView>

#include <cmath>

#include "studio/app/commands.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/made_motion.h"
#include "studio/workspaces/sequence/sequence_panel.h"
#include "studio/workspaces/sequence/sequence_session.h"
#include "studio/workspaces/sequence/sequence_strip.h"

namespace kumite::studio {

namespace {

constexpr int kLiveKeys = 9;

/// Translations of this file.
struct SequenceCommands {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::SequenceCommands)
};

void addPlayback(CommandTable& commands, SequenceSession* sequence) {
    const QString menu = SequenceCommands::tr("Se&quence");
    const QString group = QLatin1Char('-') + menu;
    const auto shown = [sequence] {
        return sequence->length() > 0 || sequence->showing() == SequenceSession::Showing::Live;
    };
    const auto still = [sequence] { return sequence->length() > 0; };
    commands.add({"sequence.play",
                  menu,
                  SequenceCommands::tr("&Play or pause"),
                  {QKeySequence("Space")},
                  [sequence] { sequence->setPlaying(!sequence->isPlaying()); },
                  shown,
                  {},
                  "play"});
    const auto step = [&](const char* id, const QString& title, const QList<QKeySequence>& keys,
                          std::function<void()> run, const QString& icon, const QString& where) {
        commands.add({id, where, title, keys, std::move(run), still, {}, icon});
    };
    step(
        "sequence.back", SequenceCommands::tr("One frame back"),
        {QKeySequence("Left"), QKeySequence(",")}, [sequence] { sequence->step(-1); }, "step_back",
        group);
    step(
        "sequence.on", SequenceCommands::tr("One frame on"),
        {QKeySequence("Right"), QKeySequence(".")}, [sequence] { sequence->step(1); }, "step_on",
        menu);
    step(
        "sequence.start", SequenceCommands::tr("To the start"), {QKeySequence("Home")},
        [sequence] { sequence->seek(0); }, "to_begin", menu);
    step(
        "sequence.end", SequenceCommands::tr("To the end"), {QKeySequence("End")},
        [sequence] { sequence->seek(sequence->length()); }, "to_end", menu);
    commands.add({"sequence.loop",
                  menu,
                  SequenceCommands::tr("Play it &over and over"),
                  {QKeySequence("L")},
                  [sequence] { sequence->setLooping(!sequence->isLooping()); },
                  still,
                  [sequence] { return sequence->isLooping(); },
                  "loop"});
    commands.add(
        {"sequence.live",
         group,
         SequenceCommands::tr("&Live: keys play blocks at once"),
         {QKeySequence("Ctrl+L")},
         [sequence] { sequence->setLive(sequence->showing() != SequenceSession::Showing::Live); },
         [sequence] { return sequence->library() != nullptr && !sequence->draft().blocks.empty(); },
         [sequence] { return sequence->showing() == SequenceSession::Showing::Live; }});
    for (int key = 1; key <= kLiveKeys; ++key) {
        commands.add({QStringLiteral("sequence.live%1").arg(key),
                      menu,
                      SequenceCommands::tr("Live: block %1").arg(key),
                      {QKeySequence(QString::number(key))},
                      [sequence, key] { sequence->playLive(key - 1); },
                      [sequence, key] {
                          return sequence->showing() == SequenceSession::Showing::Live &&
                                 key <= static_cast<int>(sequence->draft().blocks.size());
                      }});
    }
    commands.add(
        {"sequence.leave",
         menu,
         SequenceCommands::tr("Back to the sequence"),
         {QKeySequence("Esc")},
         [sequence] {
             sequence->setLive(false);
             sequence->preview({});
         },
         [sequence] { return sequence->showing() != SequenceSession::Showing::Sequence; }});
}

/// Cuts the chosen block at the playhead: what is before it (`begin`) or after it goes.
void trimAtPlayhead(SequenceSession& sequence, bool begin) {
    const SequencePiece* piece = sequence.selectedPiece();
    if (piece == nullptr || piece->transition) return;
    const int head =
        static_cast<int>(std::lround(sequence.seconds() * sequence.motion()->clip.rate));
    if (head <= piece->frames.begin || head >= piece->frames.end - 1) {
        Q_EMIT sequence.session().hinted(
            SequenceCommands::tr("The playhead is not inside the chosen block."));
        return;
    }
    const DraftBlock& block = sequence.draft().blocks[static_cast<std::size_t>(piece->block)];
    const SequenceBlock named = blockNamed(*sequence.library(), block.clip);
    const int all = named.made ? named.made->clip.frameCount() : named.action.frames.size();
    FrameRange range = block.trim.value_or(FrameRange{0, all});
    if (begin) {
        range.begin += head - piece->frames.begin;
    } else {
        range.end -= piece->frames.end - head - 1;
    }
    if (range.size() < 3) return;
    sequence.change(piece->block, SequenceCommands::tr("Trim %1").arg(sequence.titleOf(block)),
                    [&](DraftBlock& each) { each.trim = range; });
}

void addBlocks(CommandTable& commands, SequenceSession* sequence, SequencePanel* panel) {
    const QString menu = SequenceCommands::tr("Se&quence");
    const QString group = QLatin1Char('-') + menu;
    const auto action = [panel] { return panel->chosen().has_value(); };
    const auto chosen = [sequence] { return sequence->selectedBlock().has_value(); };
    const auto block = [sequence](const std::function<void(int)>& act) {
        if (const auto index = sequence->selectedBlock()) act(*index);
    };
    commands.add({"sequence.add",
                  group,
                  SequenceCommands::tr("&Add the chosen action"),
                  {QKeySequence("Return"), QKeySequence("Enter")},
                  [sequence, panel] {
                      if (const auto chosenAction = panel->chosen())
                          sequence->insert(*chosenAction,
                                           sequence->selected()
                                               ? std::optional(sequence->selected()->block + 1)
                                               : std::nullopt);
                  },
                  action});
    commands.add({"sequence.swap",
                  menu,
                  SequenceCommands::tr("S&wap the block for the chosen action"),
                  {QKeySequence("Shift+Return")},
                  [sequence, panel, block] {
                      if (const auto chosenAction = panel->chosen())
                          block([&](int index) { sequence->replace(index, *chosenAction); });
                  },
                  [action, chosen] { return action() && chosen(); }});
    const auto add = [&](const char* id, const QString& where, const QString& title,
                         const QList<QKeySequence>& keys, std::function<void(int)> act) {
        commands.add(
            {id, where, title, keys, [block, act = std::move(act)] { block(act); }, chosen});
    };
    add("sequence.remove", menu, SequenceCommands::tr("&Remove the block"),
        {QKeySequence("Del"), QKeySequence("Backspace")},
        [sequence](int index) { sequence->remove(index); });
    const auto choose = [sequence](int direction) {
        const int count = static_cast<int>(sequence->draft().blocks.size());
        const auto now = sequence->selectedBlock();
        const int next = now ? *now + direction : direction > 0 ? 0 : count - 1;
        if (next >= 0 && next < count) sequence->select(SequencePart{next, false});
    };
    const auto any = [sequence] { return !sequence->draft().blocks.empty(); };
    commands.add({"sequence.previous",
                  group,
                  SequenceCommands::tr("Block before"),
                  {QKeySequence("PgUp")},
                  [choose] { choose(-1); },
                  any});
    commands.add({"sequence.next",
                  menu,
                  SequenceCommands::tr("Block after"),
                  {QKeySequence("PgDown")},
                  [choose] { choose(1); },
                  any});
    add("sequence.earlier", menu, SequenceCommands::tr("Move the block &earlier"),
        {QKeySequence("Alt+Left")}, [sequence](int index) { sequence->move(index, index - 1); });
    add("sequence.later", menu, SequenceCommands::tr("Move the &block later"),
        {QKeySequence("Alt+Right")}, [sequence](int index) { sequence->move(index, index + 1); });
    add("sequence.more", menu, SequenceCommands::tr("Once &more"),
        {QKeySequence("+"), QKeySequence("=")}, [sequence](int index) {
            sequence->change(index, SequenceCommands::tr("Repeat the block"), [](DraftBlock& each) {
                each.repeats = std::min(99, each.repeats + 1);
            });
        });
    add("sequence.fewer", menu, SequenceCommands::tr("Once less"), {QKeySequence("-")},
        [sequence](int index) {
            sequence->change(
                index, SequenceCommands::tr("Repeat the block less"),
                [](DraftBlock& each) { each.repeats = std::max(1, each.repeats - 1); });
        });
    add("sequence.beginHere", group, SequenceCommands::tr("Block begins at the playhead"),
        {QKeySequence("I")}, [sequence](int) { trimAtPlayhead(*sequence, true); });
    add("sequence.endHere", menu, SequenceCommands::tr("Block ends at the playhead"),
        {QKeySequence("O")}, [sequence](int) { trimAtPlayhead(*sequence, false); });
    add("sequence.whole", menu, SequenceCommands::tr("The whole action again"),
        {QKeySequence("Shift+O")}, [sequence](int index) {
            sequence->change(index, SequenceCommands::tr("Trim nothing"),
                             [](DraftBlock& each) { each.trim.reset(); });
        });
    add("sequence.draw", group, SequenceCommands::tr("&Draw the transition anew"),
        {QKeySequence("R")}, [sequence](int index) { sequence->drawAnew(index); });
    commands.add({"sequence.drawAll",
                  menu,
                  SequenceCommands::tr("Draw all that are not locked anew"),
                  {QKeySequence("Shift+R")},
                  [sequence] { sequence->drawAnew({}); },
                  any});
    add("sequence.lock", menu, SequenceCommands::tr("Loc&k the transition, or let it go"),
        {QKeySequence("K")}, [sequence](int index) {
            const bool locked = sequence->draft().blocks[static_cast<std::size_t>(index)].locked;
            sequence->change(index,
                             locked ? SequenceCommands::tr("Unlock the transition")
                                    : SequenceCommands::tr("Lock the transition"),
                             [](DraftBlock& each) { each.locked = !each.locked; });
        });
    commands.add({"sequence.clear",
                  menu,
                  SequenceCommands::tr("Clear the sequence"),
                  {},
                  [sequence] { sequence->clear(); },
                  any});
}

}  // namespace

void addSequenceCommands(CommandTable& commands, SequenceSession& sequence, SequencePanel& panel,
                         SequenceStrip& strip, StageView& stage) {
    const QString menu = SequenceCommands::tr("Se&quence");
    const QString group = QLatin1Char('-') + menu;
    SequenceSession* session = &sequence;
    StageView* view = &stage;
    addPlayback(commands, session);
    addBlocks(commands, session, &panel);
    commands.add({"sequence.find",
                  group,
                  SequenceCommands::tr("&Find an action"),
                  {QKeySequence("Ctrl+F")},
                  [&panel] {
                      panel.search().setFocus();
                      panel.search().selectAll();
                  },
                  [session] { return session->library() != nullptr; }});
    commands.add({"sequence.all",
                  menu,
                  SequenceCommands::tr("Show all of it"),
                  {QKeySequence("Shift+A")},
                  [&strip] { strip.showAll(); },
                  [session] { return session->motion() != nullptr; }});
    commands.add({"sequence.map",
                  menu,
                  SequenceCommands::tr("Map of po&ses"),
                  {QKeySequence("V")},
                  [session] { session->setMap(!session->showsMap()); },
                  [session] { return session->library() != nullptr; },
                  [session] { return session->showsMap(); }});
    commands.add({"sequence.clips",
                  group,
                  SequenceCommands::tr("Add &clips of files…"),
                  {QKeySequence("Ctrl+Shift+I")},
                  [session, view] { askForClips(session->session(), view->window()); },
                  [session] { return session->session().document().isOpen(); }});
    commands.add({"sequence.folder",
                  menu,
                  SequenceCommands::tr("Add cl&ips of a folder…"),
                  {},
                  [session, view] { askForClipFolder(session->session(), view->window()); },
                  [session] { return session->session().document().isOpen(); }});
    const auto writable = [session] {
        return session->isCurrent() && !session->writing().isRunning() &&
               session->motion() != nullptr;
    };
    commands.add({"sequence.keep",
                  group,
                  SequenceCommands::tr("Keep as a &take…"),
                  {QKeySequence("Ctrl+T")},
                  [session, view] {
                      keepMotion(session->session(), session->writing(), session->madeMotion(),
                                 view->window());
                  },
                  writable});
    commands.add({"sequence.export",
                  menu,
                  SequenceCommands::tr("E&xport the sequence…"),
                  {QKeySequence("Ctrl+Shift+E")},
                  [session, view] {
                      exportMotion(session->session(), session->writing(), session->madeMotion(),
                                   view->window());
                  },
                  writable});
    for (auto signal : {&SequenceSession::stateChanged, &SequenceSession::selectionChanged,
                        &SequenceSession::motionChanged, &SequenceSession::draftChanged,
                        &SequenceSession::libraryChanged})
        QObject::connect(session, signal, &commands, &CommandTable::refresh);
    QObject::connect(panel.table().selectionModel(), &QItemSelectionModel::currentRowChanged,
                     &commands, &CommandTable::refresh);
}

}  // namespace kumite::studio
