#include "studio/app/main_window.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QPointer>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QSurfaceFormat>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/command_palette.h"
#include "studio/app/command_words.h"
#include "studio/app/commands.h"
#include "studio/app/control_keys.h"
#include "studio/app/document_panel.h"
#include "studio/app/file_actions.h"
#include "studio/app/focus_frame.h"
#include "studio/app/icons.h"
#include "studio/app/key_bindings.h"
#include "studio/app/message_strip.h"
#include "studio/app/recent_files.h"
#include "studio/app/status_line.h"
#include "studio/app/system_theme.h"
#include "studio/app/welcome_page.h"
#include "studio/app/workspaces.h"
#include "studio/help/help.h"
#include "studio/jobs/job_bar.h"
#include "studio/timeline/timeline_view.h"
#include "studio/timeline/transport_bar.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/bout/bout_session.h"
#include "studio/workspaces/graph/graph_session.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

namespace {

QStringList droppedFiles(const QMimeData* data) {
    QStringList files;
    for (const QUrl& url : data->urls()) {
        if (url.isLocalFile()) files.append(url.toLocalFile());
    }
    return files;
}

}  // namespace

void MainWindow::prepareGraphics() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      systemTheme_(new SystemTheme(QDBusConnection::sessionBus(), this)),
      shownTheme_(preferences_.values().theme) {
    setWindowIcon(applicationIcon());
    setAcceptDrops(true);
    setMinimumSize(900, 560);
    commands_ = new CommandTable(this);
    help_ = new Help(*this);
    layOut();
    addFileCommands();
    addEditCommands();
    addTakeCommands();
    addWorkspaces();
    // The Bout workspace has a clock of its own.
    commands_->addFor(QStringLiteral("segment label graph"), [this] {
        addPlaybackCommands();
        addTimelineCommands();
    });
    addViewCommands();
    addCommandWords(*commands_);
    loadKeys(*commands_);
    refreshIcons();
    commands_->fillMenus(menuBar());
    layOutTopBar();
    documentPanel_->addCommands(*commands_);
    addContextMenus();
    auto* box = static_cast<QVBoxLayout*>(timelineBox_->layout());
    box->insertWidget(0, new TransportBar(session_, *commands_, timelineBox_));
    welcome_ = new WelcomePage(*commands_, pages_);
    pages_->insertWidget(0, welcome_);
    pages_->setCurrentWidget(welcome_);
    listen();
    applyPreferences();
    showFindingsCount();
    commands_->refresh();
    refreshTitle();
    restoreLayout();
    showKeysHint();
    qApp->installEventFilter(this);
}

MainWindow::~MainWindow() {
    qApp->removeEventFilter(this);
    // The focus moves while what it moves through is destroyed.
    disconnect(qApp, nullptr, this, nullptr);
    // The views listen to the session, which is destroyed before them.
    delete takeCentralWidget();
}

/// Nothing is shown any more that has the focus: Qt hands it to whatever control comes next, which
/// then takes the keys that are meant for commands.
void MainWindow::focusMoved(QWidget* from, QWidget* to) {
    showKeysHint();
    if (from == nullptr || to == nullptr || from->isVisible() || !isAncestorOf(from) ||
        !isAncestorOf(to) || to->window() != this || !stage_->isVisible())
        return;
    QMetaObject::invokeMethod(
        this,
        [this, handed = QPointer<QWidget>(to)] {
            if (handed && handed == QApplication::focusWidget()) stage_->setFocus();
        },
        Qt::QueuedConnection);
}

void MainWindow::layOut() {
    pages_ = new QStackedWidget(this);
    columns_ = new QSplitter(Qt::Horizontal, pages_);
    rows_ = new QSplitter(Qt::Vertical, columns_);
    upper_ = new QSplitter(Qt::Horizontal, rows_);
    documentPanel_ = new DocumentPanel(session_, upper_);
    content_ = new QSplitter(Qt::Horizontal, upper_);
    stage_ = new StageView(session_, content_);
    centres_ = new QStackedWidget(content_);
    content_->addWidget(stage_);
    content_->addWidget(centres_);
    content_->setStretchFactor(0, 2);
    content_->setStretchFactor(1, 3);
    rightPanel_ = new QStackedWidget(columns_);
    workspaces_ = new Workspaces(*commands_, rightPanel_, centres_, this);
    upper_->addWidget(documentPanel_);
    upper_->addWidget(content_);
    timelineBox_ = new QWidget(rows_);
    auto* box = new QVBoxLayout(timelineBox_);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(0);
    timeline_ = new TimelineView(session_, timelineBox_);
    box->addWidget(timeline_, 1);
    new FocusFrame(stage_);
    new FocusFrame(timeline_);
    rows_->addWidget(upper_);
    rows_->addWidget(timelineBox_);
    columns_->addWidget(rows_);
    columns_->addWidget(rightPanel_);
    for (QSplitter* splitter : {columns_, rows_, upper_, content_}) {
        splitter->setHandleWidth(1);
        splitter->setChildrenCollapsible(false);
    }
    rows_->setStretchFactor(0, 1);
    rows_->setStretchFactor(1, 0);
    upper_->setStretchFactor(0, 0);
    upper_->setStretchFactor(1, 1);
    columns_->setStretchFactor(0, 1);
    columns_->setStretchFactor(1, 0);
    pages_->addWidget(columns_);
    setCentralWidget(pages_);
    strip_ = new MessageStrip(pages_);
    palette_ = new CommandPalette(*commands_, pages_);
    files_ = new FileActions(session_, *strip_, this);

    status_ = new StatusLine(this);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(status_, 1);
    findingsButton_ = new QToolButton(this);
    findingsButton_->setProperty("role", "small");
    statusBar()->addPermanentWidget(findingsButton_);
    auto* jobs = new JobBar(this);
    jobs->watch(files_->jobs());
    jobs->watch(files_->writing());
    jobs->watch(files_->exporting());
    jobs->watch(session_.document().jobs());
    statusBar()->addPermanentWidget(jobs);
}

void MainWindow::listen() {
    connect(qApp, &QApplication::focusChanged, this, &MainWindow::focusMoved);
    Document& document = session_.document();
    connect(&document, &Document::failed, strip_, &MessageStrip::showError);
    connect(&document, &Document::changed, this, [this] {
        refreshTitle();
        commands_->refresh();
    });
    connect(&document, &Document::opened, this, [this] {
        findings_.clear();
        applyPlaybackPreferences();
        pages_->setCurrentWidget(columns_);
        timeline_->setFocus();
        showKeysHint();
        // The view has its size only after it was laid out.
        QTimer::singleShot(0, stage_, &StageView::frameAll);
    });
    connect(&session_.transport(), &Transport::stateChanged, this, [this] {
        commands_->refresh();
        refreshIcons();
        showKeysHint();
    });
    connect(&session_, &Session::selectionChanged, this, [this] {
        commands_->refresh();
        showKeysHint();
    });
    connect(&session_, &Session::hovered, status_, &StatusLine::setPointer);
    connect(&session_, &Session::hinted, status_, &StatusLine::say);
    connect(files_, &FileActions::reported, status_, &StatusLine::say);
    // What was said before belongs to what was done before.
    connect(commands_, &CommandTable::running, status_, [this](const QString& id) {
        status_->say({});
        if (!commands_->find(id)->leadsOn) return;
        // Menus hand the focus back only after the command.
        QTimer::singleShot(0, this, &MainWindow::leaveControl);
    });
    connect(&session_, &Session::takeChanged, status_, [this] { status_->say({}); });
    connect(stage_, &StageView::switchesChanged, this, &MainWindow::showKeysHint);
    connect(files_, &FileActions::opened, this, [this](const QStringList& files) {
        rememberFiles(files);
        welcome_->refresh();
    });
    connect(welcome_, &WelcomePage::chosen, files_, &FileActions::open);
    connect(strip_, &MessageStrip::found, &findings_, &FindingsLog::add);
    connect(&findings_, &FindingsLog::changed, this, &MainWindow::showFindingsCount);
    connect(findingsButton_, &QToolButton::clicked, this, &MainWindow::showFindings);
    connect(systemTheme_, &SystemTheme::changed, this, &MainWindow::followSystemTheme);
    connect(&preferences_, &Preferences::changed, this, &MainWindow::applyPreferences);
    connect(workspaces_, &Workspaces::changed, this, &MainWindow::showKeysHint);
    connect(commands_, &CommandTable::renamed, this, &MainWindow::showKeysHint);
}

bool MainWindow::isBusy() const {
    return files_->isBusy() || session_.document().isComputing() || timeline_->isPreparing() ||
           (labels_->isActive() && labels_->isLearning()) || graph_->isLearning() ||
           bout_->isPreparing() || sequence_->isPreparing() || sequence_->making().isRunning() ||
           keys_->isPreparing() || keys_->making().isRunning() || hit_->jobs().isRunning();
}

void MainWindow::shareSpace() {
    // Half of the window and more for the 3D view; the timeline grows with the window, and with
    // what is to be seen in it.
    const int height = pages_->height();
    const int wished = std::min(timelineBox_->sizeHint().height(), 2 * height / 5);
    const int least = std::min(withTextSize(170), 2 * height / 5);
    const int timeline = std::max(std::clamp(height / 4 - 12, least, std::max(least, 300)), wished);
    // The timeline, and what takes its place in the workspaces of made motions.
    rows_->setSizes({height - timeline - 1, timeline, timeline, timeline, timeline});
    const int left = withTextSize(width() < 1600 ? 136 : 176);
    // Some languages need more words than others.
    int right = withTextSize(width() < 1600 ? 240 : 320);
    for (const auto* page : rightPanel_->findChildren<QScrollArea*>(Qt::FindDirectChildrenOnly)) {
        if (page->widget() == nullptr) continue;
        right = std::max(right, std::min(page->widget()->minimumSizeHint().width(), width() / 3));
    }
    const int middle = width() - left - right - 2;
    columns_->setSizes({left + middle + 1, right});
    upper_->setSizes({left, middle});
    // Tables need their names, a view needs none.
    const int view = middle * (textSize() > 125 ? 3 : 4) / 10;
    content_->setSizes({view, middle - view});
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    fitTopBar();
    if (spaceShared_) return;
    QTimer::singleShot(0, this, [this] {
        if (!spaceShared_) shareSpace();
    });
}

void MainWindow::refreshTitle() {
    const Document& document = session_.document();
    setWindowTitle(document.isOpen() ? tr("%1[*] — Kumite").arg(document.name()) : tr("Kumite"));
    setWindowModified(document.isModified());
}

void MainWindow::refreshIcons() {
    commands_->refreshIcons();
    const auto showPause = [this](const char* command) {
        commands_->action(QLatin1String(command))
            ->setIcon(lineIcon(QStringLiteral("pause"), coloursFor(palette()).text));
    };
    if (session_.transport().isPlaying()) showPause("transport.play");
    if (bout_ != nullptr && bout_->isPlaying()) showPause("bout.play");
    if (sequence_ != nullptr && sequence_->isPlaying()) showPause("sequence.play");
    if (hit_ != nullptr && (keys_->isPlaying() || hit_->isPlaying())) showPause("keys.play");
}

void MainWindow::showKeysHint() {
    status_->setKeys(session_.document().isOpen() ? keysHint() : QStringList());
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && commands_ != nullptr) refreshIcons();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        if (isInControl()) return leaveControl();
        const Command* tour = commands_->find(QStringLiteral("help.tour.leave"));
        if (tour != nullptr && commands_->isEnabled(*tour)) return commands_->run(tour->id);
    }
    QMainWindow::keyPressEvent(event);
}

/// Whether keys that are meant for the views are taken by a control of this window.
bool MainWindow::isInControl() const {
    const QWidget* focused = QApplication::focusWidget();
    return focused != nullptr && focused->window() == this && columns_->isVisible() &&
           isControl(*focused);
}

void MainWindow::leaveControl() {
    if (!isInControl()) return;
    (timeline_->isVisible() ? static_cast<QWidget*>(timeline_) : stage_)->setFocus();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_->mayLeave()) {
        event->ignore();
        return;
    }
    saveLayout();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFiles(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList files = droppedFiles(event->mimeData());
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    // Questions may follow: not while the other program still waits for the drop to end.
    QTimer::singleShot(0, this, [this, files] { files_->openDropped(files); });
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && QApplication::activePopupWidget() != nullptr) {
        event->accept();  // keys are the open list's or menu's alone
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (const auto* widget = qobject_cast<QWidget*>(watched);
            widget != nullptr && (worksControl(*widget, *key) || isOfTheViews(*widget, *key))) {
            event->accept();
            return true;
        }
        // Undo in a field of a number takes back what the number did, not its digits.
        auto* number = qobject_cast<QAbstractSpinBox*>(watched);
        if (number == nullptr) number = qobject_cast<QAbstractSpinBox*>(watched->parent());
        if (number != nullptr &&
            (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
            event->ignore();
            return true;
        }
        if (number != nullptr && goesToCommands(*number, *key)) {
            // The number is done: the keys that follow belong to the command, too.
            timeline_->setFocus();
            event->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
        qobject_cast<QWidget*>(watched) != nullptr &&
        menuBar()->isAncestorOf(static_cast<QWidget*>(watched)) && isInControl()) {
        leaveControl();  // the bar in whose corner it stands would keep the key
        return true;
    }
    if (event->type() == QEvent::KeyPress &&
        pressesButton(watched, *static_cast<QKeyEvent*>(event)))
        return true;
    return QMainWindow::eventFilter(watched, event);
}

bool MainWindow::isOfTheViews(const QWidget& focused, const QKeyEvent& key) const {
    if (!menuBar()->isAncestorOf(&focused)) return false;
    const QKeySequence pressed(key.keyCombination());
    const auto& all = commands_->commands();
    return std::any_of(all.begin(), all.end(), [&](const Command& command) {
        return !command.scopes.isEmpty() && command.keys.contains(pressed);
    });
}

bool MainWindow::goesToCommands(const QWidget& field, const QKeyEvent& key) const {
    // A number has no letters.
    const bool letter =
        key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z && !(key.modifiers() & ~Qt::ShiftModifier);
    if (!letter || field.window() != this) return false;
    const QKeySequence pressed(key.keyCombination());
    const auto& all = commands_->commands();
    return std::any_of(all.begin(), all.end(), [&](const Command& command) {
        return command.keys.contains(pressed) && commands_->isEnabled(command);
    });
}

}  // namespace kumite::studio
