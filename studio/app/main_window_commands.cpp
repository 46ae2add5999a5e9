// The commands of the window: what menus, shortcuts and buttons offer.

#include <QAction>
#include <QApplication>
#include <QMenu>

#include <algorithm>
#include <array>
#include <cmath>

#include "studio/app/command_palette.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/main_window.h"
#include "studio/app/recent_files.h"
#include "studio/app/view_commands.h"
#include "studio/help/help.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"

namespace kumite::studio {

namespace {

QString grouped(const QString& menu) {
    return QLatin1Char('-') + menu;
}

}  // namespace

void MainWindow::addFileCommands() {
    const auto open = [this] { return session_.document().isOpen(); };
    const QString menu = tr("&File");
    commands_->add(
        {"file.openDemo", menu, tr("Open the &demo bout"), {QKeySequence("Ctrl+Alt+D")}, [this] {
             files_->openDemo();
         }});
    commands_->add({"file.openRecordings",
                    menu,
                    tr("Open &recordings…"),
                    {QKeySequence("Ctrl+Shift+O")},
                    [this] { files_->askForRecordings(); }});
    commands_->add(
        {"file.openProject", menu, tr("&Open project…"), {QKeySequence("Ctrl+O")}, [this] {
             files_->askForProject();
         }});
    commands_->add({"file.recent", menu, tr("Opened &lately"), {}, [] {}});
    auto* recent = new QMenu(this);
    commands_->action("file.recent")->setMenu(recent);
    connect(recent, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    fillRecentMenu();
    commands_->add({"file.save",
                    grouped(menu),
                    tr("&Save"),
                    {QKeySequence("Ctrl+S")},
                    [this] { files_->save(); },
                    open});
    commands_->add({"file.saveAs",
                    menu,
                    tr("Save &as…"),
                    {QKeySequence("Ctrl+Shift+S")},
                    [this] { files_->saveAs(); },
                    open});
    commands_->add({"file.versions",
                    menu,
                    tr("&Versions…"),
                    {},
                    [this] { files_->showVersions(); },
                    [this] { return !session_.document().path().isEmpty(); }});
    commands_->add({"file.export",
                    grouped(menu),
                    tr("&Export actions…"),
                    {QKeySequence("Ctrl+E")},
                    [this] { files_->askForExport(); },
                    [this] { return hasTake(); }});
    commands_->add({"file.exportMotion",
                    menu,
                    tr("Export &motion…"),
                    {},
                    [this] { files_->askForMotionExport(); },
                    [this] { return hasTake(); }});
    const auto missing = [this] {
        for (int player = 0; player < session_.playerCount(); ++player) {
            if (session_.fighter(player) == nullptr) return session_.document().isCurrent();
        }
        return false;
    };
    commands_->add({"file.findRecording",
                    menu,
                    tr("&Find recording…"),
                    {},
                    [this] { files_->askForMissingRecording(); },
                    missing});
    commands_->add(
        {"file.quit", grouped(menu), tr("&Quit"), {QKeySequence("Ctrl+Q")}, [this] { close(); }});
}

void MainWindow::fillRecentMenu() {
    QMenu* recent = commands_->action("file.recent")->menu();
    recent->clear();
    for (const QStringList& files : recentFiles()) {
        recent->addAction(recentText(files), this, [this, files] { files_->open(files); });
    }
    if (recent->isEmpty()) recent->addAction(tr("Nothing yet"))->setEnabled(false);
}

void MainWindow::addEditCommands() {
    const QString edit = tr("&Edit");
    commands_->add({"edit.undo",
                    edit,
                    tr("&Undo"),
                    {QKeySequence("Ctrl+Z")},
                    [this] { session_.document().undo(); },
                    [this] { return session_.document().canUndo(); }});
    commands_->add({"edit.redo",
                    edit,
                    tr("&Redo"),
                    {QKeySequence("Ctrl+Y"), QKeySequence("Ctrl+Shift+Z")},
                    [this] { session_.document().redo(); },
                    [this] { return session_.document().canRedo(); }});
    commands_->add({"app.palette",
                    grouped(edit),
                    tr("Run a &command by name…"),
                    {QKeySequence("Ctrl+K")},
                    [this] { palette_->open(); }});
    commands_->add({"app.preferences", edit, tr("&Preferences…"), {QKeySequence("Ctrl+,")}, [this] {
                        showPreferences(PreferencesDialog::GeneralPage);
                    }});
}

void MainWindow::addPlaybackCommands() {
    const auto open = [this] { return hasTake(); };
    Transport* transport = &session_.transport();
    const QString menu = tr("&Playback");
    commands_->add({"transport.play",
                    menu,
                    tr("&Play or pause"),
                    {QKeySequence("Space")},
                    [transport] { transport->toggle(); },
                    open,
                    [transport] { return transport->isPlaying(); },
                    "play"});
    commands_->add({"transport.reverse",
                    menu,
                    tr("Play &backward, faster"),
                    {QKeySequence("J")},
                    [transport] { transport->shuttle(-1); },
                    open});
    commands_->add({"transport.stop",
                    menu,
                    tr("S&top"),
                    {QKeySequence("K")},
                    [transport] {
                        transport->setPlaying(false);
                        transport->setSpeed(1);
                    },
                    open});
    commands_->add({"transport.forward",
                    menu,
                    tr("Play &forward, faster"),
                    {QKeySequence("L")},
                    [transport] { transport->shuttle(1); },
                    open});
    const auto step = [&](const char* id, const QString& text, const QList<QKeySequence>& keys,
                          int frames, const QString& icon, bool first) {
        commands_->add({id,
                        first ? grouped(menu) : menu,
                        text,
                        keys,
                        [this, frames] { session_.stepFrames(frames); },
                        open,
                        {},
                        icon});
    };
    step("transport.back", tr("One frame back"), {QKeySequence("Left"), QKeySequence(",")}, -1,
         "step_back", true);
    step("transport.on", tr("One frame on"), {QKeySequence("Right"), QKeySequence(".")}, 1,
         "step_on", false);
    // How far they go is a preference, and so are their names.
    const auto leap = [&](const char* id, const QKeySequence& key, int direction) {
        commands_->add({id,
                        menu,
                        tr("Leap"),
                        {key},
                        [this, direction] {
                            session_.stepFrames(direction * preferences_.values().leapFrames);
                        },
                        open});
    };
    leap("transport.backTen", QKeySequence("Shift+Left"), -1);
    leap("transport.onTen", QKeySequence("Shift+Right"), 1);
    const auto jump = [this, transport](double seconds) {
        transport->setPlayhead(seconds);
        session_.reveal(transport->playhead());
    };
    commands_->add({"transport.begin",
                    menu,
                    tr("To the start"),
                    {QKeySequence("Home")},
                    [jump, transport] { jump(transport->span().begin); },
                    open,
                    {},
                    "to_begin"});
    commands_->add({"transport.end",
                    menu,
                    tr("To the end"),
                    {QKeySequence("End")},
                    [jump, transport] { jump(transport->span().end); },
                    open,
                    {},
                    "to_end"});
    commands_->add({"transport.slower",
                    grouped(menu),
                    tr("Slower"),
                    {QKeySequence("-")},
                    [this] { changeSpeed(-1); },
                    open});
    commands_->add({"transport.faster",
                    menu,
                    tr("Faster"),
                    {QKeySequence("+"), QKeySequence("=")},
                    [this] { changeSpeed(1); },
                    open});
    commands_->add(
        {"loop.in",
         grouped(menu),
         tr("Loop begins here"),
         {QKeySequence("I")},
         [transport] { transport->setLoop(transport->playhead(), transport->loopOut()); },
         open});
    commands_->add({"loop.out",
                    menu,
                    tr("Loop ends here"),
                    {QKeySequence("O")},
                    [transport] { transport->setLoop(transport->loopIn(), transport->playhead()); },
                    open});
    commands_->add({"transport.loop",
                    menu,
                    tr("&Loop"),
                    {QKeySequence("Ctrl+L")},
                    [transport] { transport->setLooping(!transport->isLooping()); },
                    open,
                    [transport] { return transport->isLooping(); },
                    "loop"});
}

void MainWindow::addViewCommands() {
    const auto open = [this] { return hasTake(); };
    const QString menu = tr("&View");
    commands_->add({"view.all",
                    menu,
                    tr("Show &all"),
                    {QKeySequence("A")},
                    [this] {
                        stage_->frameAll();
                        session_.showAll();
                    },
                    open});
    commands_->add({"view.selection",
                    menu,
                    tr("Show the &fighter and what is selected"),
                    {QKeySequence("F")},
                    [this] {
                        stage_->frameActiveFighter();
                        session_.frameSelection();
                    },
                    open});
    commands_->add({"view.panels",
                    grouped(menu),
                    tr("Hide &panels"),
                    {QKeySequence("H")},
                    [this] { setPanelsShown(!panelsShown()); },
                    [this] { return session_.document().isOpen(); },
                    [this] { return !panelsShown(); }});
    commands_->add({"view.fullScreen",
                    menu,
                    tr("F&ull screen"),
                    {QKeySequence("F11")},
                    [this] { isFullScreen() ? showNormal() : showFullScreen(); },
                    {},
                    [this] { return isFullScreen(); }});
    const std::array<std::pair<ThemeChoice, QString>, 3> themes = {
        {{ThemeChoice::System, tr("Theme as the system")},
         {ThemeChoice::Light, tr("Light theme")},
         {ThemeChoice::Dark, tr("Dark theme")}}};
    for (const auto& [choice, text] : themes) {
        const QString id = QStringLiteral("view.theme%1").arg(static_cast<int>(choice));
        commands_->add({id,
                        choice == ThemeChoice::System ? grouped(menu) : menu,
                        text,
                        {},
                        [this, choice = choice] { setTheme(choice); },
                        {},
                        [this, choice = choice] { return preferences_.values().theme == choice; }});
    }
    const auto resize = [&](const char* id, const QString& text, const QList<QKeySequence>& keys,
                            int step) {
        commands_->add({id, step > 0 ? grouped(menu) : menu, text, keys,
                        [this, step] {
                            PreferenceValues values = preferences_.values();
                            values.textSize += step;
                            preferences_.set(values);
                        },
                        [this, step] {
                            return step > 0 ? preferences_.values().textSize < 200
                                            : preferences_.values().textSize > 100;
                        }});
    };
    resize("view.textLarger", tr("Larger text"),
           {QKeySequence("Ctrl+Alt++"), QKeySequence("Ctrl+Alt+=")}, 25);
    resize("view.textSmaller", tr("Smaller text"), {QKeySequence("Ctrl+Alt+-")}, -25);
    addStageCommands(*commands_, *stage_, session_);
    help_->addCommands(*commands_, tr("&Help"));
}

void MainWindow::changeSpeed(int direction) {
    constexpr std::array<double, 9> kSpeeds = {0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4};
    Transport& transport = session_.transport();
    const double now = std::abs(transport.speed());
    double next = now;
    for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
        const double speed = kSpeeds[i];
        if (direction < 0 && speed < now - 1e-6) next = speed;
        if (direction > 0 && speed > now + 1e-6) {
            next = speed;
            break;
        }
    }
    transport.setSpeed(transport.speed() < 0 ? -next : next);
}

}  // namespace kumite::studio
