// What belongs to the window as a whole: workspaces, layout, preferences and the pages beside it.

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QMenuBar>
#include <QResizeEvent>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyleOptionMenuItem>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/document_panel.h"
#include "studio/app/fighter_properties.h"
#include "studio/app/keys_page.h"
#include "studio/app/main_window.h"
#include "studio/app/message_strip.h"
#include "studio/app/system_theme.h"
#include "studio/app/words.h"
#include "studio/app/workspaces.h"
#include "studio/jobs/job_bar.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/bout/bout_session.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

void MainWindow::layOutTopBar() {
    auto* bar = new QWidget(menuBar());
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 8, 0);
    row->setSpacing(8);
    tabs_ = new WorkspaceBar(*workspaces_, bar);
    row->addWidget(tabs_);
    auto* run = new QToolButton(bar);
    run->setProperty("role", "small");
    run->setFocusPolicy(Qt::TabFocus);
    QAction* action = commands_->action("app.palette");
    const auto name = [this, run, action] {
        run->setText(commands_->find("app.palette")->keysText());
        run->setAccessibleName(commands_->find("app.palette")->plainText());
    };
    name();
    connect(commands_, &CommandTable::renamed, run, name);
    commands_->tellKey(run, "app.palette");
    connect(run, &QToolButton::clicked, action, &QAction::trigger);
    row->addWidget(run);
    menuBar()->setCornerWidget(bar, Qt::TopRightCorner);
    connect(workspaces_, &Workspaces::changed, this, &MainWindow::fitTopBar);
    fitTopBar();
}

/// No menu is pushed out by the tabs.
void MainWindow::fitTopBar() {
    if (tabs_ == nullptr) return;
    const int rest = withTextSize(90);  // the palette's button and margins
    const QStyle& style = *menuBar()->style();
    QStyleOptionMenuItem item;
    item.initFrom(menuBar());
    int menus = 0;
    for (const QAction* menu : menuBar()->actions()) {
        if (!menu->isVisible()) continue;
        item.text = menu->text();
        const QSize words = menuBar()->fontMetrics().size(Qt::TextShowMnemonic, item.text);
        menus += style.sizeFromContents(QStyle::CT_MenuBarItem, &item, words, menuBar()).width() +
                 style.pixelMetric(QStyle::PM_MenuBarItemSpacing, &item, menuBar());
    }
    tabs_->setCompact(false);
    tabs_->setCompact(menus + tabs_->sizeHint().width() + rest > width());
    // The menu bar gives its corner another place only when it is resized; the tab that is shown
    // may be the only one with a name.
    QResizeEvent again(menuBar()->size(), menuBar()->size());
    QCoreApplication::sendEvent(menuBar(), &again);
}

void MainWindow::setPanelsShown(bool shown) {
    if (shown == panelsShown_) return;
    // A splitter forgets the width of what it does not show.
    if (!shown && isVisible()) widths_ = panelWidths();
    panelsShown_ = shown;
    documentPanel_->setVisible(shown);
    rightPanel_->setVisible(shown);
    if (shown && !widths_.left.isEmpty()) setPanelWidths(widths_);
    commands_->refresh();
}

MainWindow::PanelWidths MainWindow::panelWidths() const {
    return {upper_->saveState(), columns_->saveState()};
}

bool MainWindow::setPanelWidths(const PanelWidths& widths) {
    return upper_->restoreState(widths.left) && columns_->restoreState(widths.right);
}

void MainWindow::restoreLayout() {
    const QSettings settings;
    if (!restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray())) {
        resize(1280, 800);
    }
    const auto state = [&settings](const char* part) {
        return settings.value(QStringLiteral("layout/") + QLatin1String(part)).toByteArray();
    };
    widths_ = {state("left"), state("right")};
    spaceShared_ = rows_->restoreState(state("rows")) && setPanelWidths(widths_);
    content_->restoreState(state("content"));
    for (QSplitter* splitter : {columns_, rows_, upper_, content_}) {
        connect(splitter, &QSplitter::splitterMoved, this, [this] { spaceShared_ = true; });
    }
    workspaces_->show(settings.value(QStringLiteral("workspace")).toString());
    setPanelsShown(settings.value(QStringLiteral("panels"), true).toBool());
}

void MainWindow::saveLayout() const {
    QSettings settings;
    settings.setValue(QStringLiteral("geometry"), saveGeometry());
    if (spaceShared_) {
        const PanelWidths widths = panelsShown_ ? panelWidths() : widths_;
        settings.setValue(QStringLiteral("layout/rows"), rows_->saveState());
        settings.setValue(QStringLiteral("layout/content"), content_->saveState());
        settings.setValue(QStringLiteral("layout/left"), widths.left);
        settings.setValue(QStringLiteral("layout/right"), widths.right);
    }
    settings.setValue(QStringLiteral("workspace"), workspaces_->current());
    settings.setValue(QStringLiteral("panels"), panelsShown_);
}

void MainWindow::setTheme(ThemeChoice choice) {
    preferences_.setTheme(choice);
}

void MainWindow::applyPreferences() {
    const PreferenceValues& values = preferences_.values();
    stage_->setMouseSpeed(values.mouseSpeed);
    commands_->setText("transport.backTen", tr("%1 frames back").arg(values.leapFrames));
    commands_->setText("transport.onTen", tr("%1 frames on").arg(values.leapFrames));
    // The window is made for text of 100 %, whatever other windows have by now.
    const double ratio = values.textSize / shownTextSize_;
    const bool larger = values.textSize != textSize() || ratio != 1;
    shownTextSize_ = values.textSize;
    setTextSize(values.textSize);
    setMotionReduced(values.reduceMotion);
    if (values.theme != shownTheme_ || larger) applyTheme(values.theme);
    if (ratio != 1) rescale(*this, ratio);
    if (larger && !spaceShared_) shareSpace();
    shownTheme_ = values.theme;
    commands_->refresh();
}

void MainWindow::applyPlaybackPreferences() {
    Transport& transport = session_.transport();
    transport.setSpeed(preferences_.values().playbackSpeed);
    transport.setLooping(preferences_.values().looping);
}

void MainWindow::followSystemTheme() {
    setSystemDark(systemTheme_->isDark());
    if (preferences_.values().theme == ThemeChoice::System) applyTheme(ThemeChoice::System);
}

QStringList MainWindow::keysHint() const {
    struct Entry {
        QStringList commands;
        QString text;
        bool holds = true;
    };
    const bool playing = session_.transport().isPlaying();
    const bool measuring = stage_->isMeasuring();
    const bool boundary = session_.selection().has_value();
    const bool action = session_.selectedAction().has_value();
    const QList<Entry> entries = {
        {{"view.previousJoint", "view.nextJoint"}, tr("joint"), measuring},
        {{"view.takeJoint"}, tr("measure from or to it"), measuring},
        {{"fighter.other"}, tr("other fighter"), measuring},
        {{"view.leaveMeasuring"}, tr("leave measuring"), measuring},
        {{"transport.play"}, playing ? tr("pause") : tr("play")},
        {{"review.next"}, tr("next suspect"), !measuring},
        {{"review.accept"}, tr("keep"), boundary && !measuring},
        {{"review.reject"}, tr("remove"), boundary && !measuring},
        {{"action.previous", "action.next"}, tr("action"), action && !measuring},
        {{"action.note"}, tr("note"), action && !measuring},
        {{"label.next"}, tr("next question"), !measuring},
        {{"label.accept"}, tr("accept"), !measuring},
        {{"label.reject"}, tr("second best"), !measuring},
        {{"label.laneUp", "label.laneDown"}, tr("lane"), !measuring},
        {{"label.class1"}, tr("… its classes"), !measuring},
        {{"bout.play"}, bout_->isPlaying() ? tr("pause") : tr("fight")},
        {{"bout.act1"}, tr("… lead the avatar"), bout_->steers()},
        {{"bout.reseed"}, tr("go on otherwise")},
        {{"sequence.play"}, sequence_->isPlaying() ? tr("pause") : tr("play")},
        {{"sequence.live1"},
         tr("… play a block at once"),
         sequence_->showing() == SequenceSession::Showing::Live},
        {{"sequence.leave"},
         tr("back to the sequence"),
         sequence_->showing() != SequenceSession::Showing::Sequence},
        {{"sequence.find"}, tr("find an action")},
        {{"sequence.add"}, tr("add it")},
        {{"sequence.previous", "sequence.next"}, tr("block")},
        {{"sequence.earlier", "sequence.later"}, tr("move it")},
        {{"sequence.draw"}, tr("draw its transition anew")},
        {{"sequence.map"}, tr("map of poses")},
        {{"sequence.live"}, tr("live")},
        {{"keys.play"}, keys_->isPlaying() || hit_->isPlaying() ? tr("pause") : tr("play")},
        {{"keys.add"}, tr("add a key here"), !hit_->isOn()},
        {{"keys.previous", "keys.next"}, tr("key"), !hit_->isOn()},
        {{"keys.take"}, tr("take the recording's pose"), keys_->isEditable() && !hit_->isOn()},
        {{"keys.nextHandle"}, tr("handle"), keys_->isEditable() && !hit_->isOn()},
        {{"keys.nextJoint"}, tr("joint"), keys_->isEditable() && !hit_->isOn()},
        {{"keys.pin"}, tr("pin it"), keys_->isEditable() && !hit_->isOn()},
        {{"keys.mirror"}, tr("mirror"), keys_->isEditable() && !hit_->isOn()},
        {{"keys.hit"}, hit_->isOn() ? tr("back to the keys") : tr("hit a target")},
        {{"keys.motion"},
         keys_->showsMotion() ? tr("keys") : tr("motion"),
         keys_->motion() != nullptr && !hit_->isOn()},
        {{"bout.keep"}, tr("keep as a take")},
        {{"graph.nextSurprise"}, tr("next surprise"), !measuring},
        {{"graph.play"}, tr("play what is behind"), !measuring},
        {{"graph.view"}, tr("matrix or graph"), !measuring},
        {{"transport.back", "transport.on"}, tr("frame")},
        {{"boundary.previous", "boundary.next"}, tr("boundary"), !measuring},
        {{"boundary.add"}, tr("add"), !measuring && !boundary},
        {{"app.palette"}, tr("any command"), !measuring},
        {{"help.open"}, tr("help"), !measuring},
    };
    QStringList parts;
    const QWidget* focused = QApplication::focusWidget();
    const auto isElsewhere = [focused](const Command& command) {
        return focused != nullptr && !command.scopes.isEmpty() &&
               std::none_of(command.scopes.begin(), command.scopes.end(), [&](QWidget* scope) {
                   return scope == focused || scope->isAncestorOf(focused);
               });
    };
    if (isInControl())
        parts.append(keyText(QKeySequence(Qt::Key_Escape)) + QLatin1Char(' ') +
                     tr("leave the field or button"));
    for (const Entry& entry : entries) {
        if (!entry.holds) continue;
        QStringList keys;
        for (const QString& id : entry.commands) {
            const Command* command = commands_->find(id);
            if (command == nullptr || command->keys.isEmpty()) continue;
            if (!commands_->action(id)->isVisible() || isElsewhere(*command)) continue;
            QString key = keyText(command->keys.front());
            // "Ctrl+← →": what two keys have in common is said once.
            if (!keys.isEmpty()) key = key.mid(key.lastIndexOf(QLatin1Char('+'), -2) + 1);
            keys.append(key);
        }
        if (!keys.isEmpty())
            parts.append(keys.join(QLatin1Char(' ')) + QLatin1Char(' ') + entry.text);
    }
    return parts;
}

void MainWindow::showFindingsCount() {
    const int count = findings_.count();
    findingsButton_->setVisible(count > 0);
    findingsButton_->setText(count == 1 ? tr("1 finding") : tr("%1 findings").arg(count));
    findingsButton_->setAccessibleName(findingsButton_->text());
    findingsButton_->setToolTip(tr("What was found in the recordings"));
}

void MainWindow::showKeys() {
    if (keysPage_.isNull()) {
        auto* page = new KeysPage(*commands_, this);
        page->setAttribute(Qt::WA_DeleteOnClose);
        connect(page, &KeysPage::remapWanted, this,
                [this] { showPreferences(PreferencesDialog::KeysPage); });
        keysPage_ = page;
    }
    keysPage_->show();
    keysPage_->raise();
    keysPage_->activateWindow();
}

void MainWindow::showPreferences(PreferencesDialog::Page page) {
    if (preferencesDialog_.isNull()) {
        preferencesDialog_ = new PreferencesDialog(preferences_, *commands_, this);
        preferencesDialog_->setAttribute(Qt::WA_DeleteOnClose);
    }
    preferencesDialog_->showPage(page);
    preferencesDialog_->show();
    preferencesDialog_->raise();
    preferencesDialog_->activateWindow();
}

void MainWindow::showFighterProperties() {
    if (fighterProperties_.isNull()) {
        fighterProperties_ = new FighterProperties(session_, *commands_, this);
        fighterProperties_->setAttribute(Qt::WA_DeleteOnClose);
    }
    fighterProperties_->show();
    fighterProperties_->raise();
    fighterProperties_->activateWindow();
}

void MainWindow::showFindings() {
    if (findingsPage_.isNull()) {
        findingsPage_ = new FindingsPage(findings_, this);
        findingsPage_->setAttribute(Qt::WA_DeleteOnClose);
    }
    findingsPage_->show();
    findingsPage_->raise();
    findingsPage_->activateWindow();
}

}  // namespace kumite::studio
