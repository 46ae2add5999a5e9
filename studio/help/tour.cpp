#include "studio/help/tour.h"

#include <QFrame>
#include <QPushButton>

#include <algorithm>

#include "core/base/error.h"
#include "core/project/demo_bout.h"
#include "core/project/label_files.h"
#include "core/project/labels.h"
#include "studio/app/commands.h"
#include "studio/app/core_words.h"
#include "studio/app/file_actions.h"
#include "studio/app/main_window.h"
#include "studio/app/message_strip.h"
#include "studio/app/workspaces.h"
#include "studio/help/tour_box.h"
#include "studio/workspaces/bout/bout_bar.h"
#include "studio/workspaces/bout/bout_session.h"
#include "studio/workspaces/graph/graph_centre.h"
#include "studio/workspaces/graph/graph_session.h"
#include "studio/workspaces/label/label_panel.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/progress_box.h"
#include "studio/workspaces/segment/segment_panel.h"

namespace kumite::studio {

namespace {

constexpr int kGap = 10;    ///< between the box and what it points at
constexpr int kBelow = 44;  ///< room for the buttons of a view beside which it stands

/// Where a box of that size stands best beside a target, inside `room`.
QPoint placeBeside(const QRect& target, const QSize& size, const QRect& room) {
    const int x = std::clamp(target.left(), room.left(), room.right() - size.width());
    const int y = std::clamp(target.top() + kBelow, room.top(), room.bottom() - size.height());
    const QPoint places[] = {{target.left() - kGap - size.width(), y},
                             {target.right() + kGap, y},
                             {x, target.top() - kGap - size.height()},
                             {x, target.bottom() + kGap}};
    for (const QPoint& place : places) {
        if (room.contains(QRect(place, size))) return place;
    }
    return {room.right() - size.width(), room.bottom() - size.height()};
}

}  // namespace

Tour::Tour(MainWindow& window) : QObject(&window), window_(window) {
    addSteps();
    done_.assign(steps_.size(), false);
    placing_.setInterval(150);
    connect(&placing_, &QTimer::timeout, this, &Tour::place);
}

void Tour::addCommands(CommandTable& commands, const QString& menu) {
    const auto runs = [this] { return isRunning(); };
    commands.add({"help.tour", menu, tr("&Tour on the demo bout"), {}, [this] { start(); }});
    commands.add({"help.tour.next",
                  menu,
                  tr("Tour: next step"),
                  {QKeySequence("Ctrl+Alt+N")},
                  [this] { go(1); },
                  runs});
    commands.add({"help.tour.back",
                  menu,
                  tr("Tour: step before"),
                  {QKeySequence("Ctrl+Alt+B")},
                  [this] { go(-1); },
                  [this] { return at_ > 0; }});
    commands.add({"help.tour.leave",
                  menu,
                  tr("Leave the tour"),
                  {QKeySequence("Ctrl+Alt+E")},
                  [this] { leave(); },
                  runs});
    listen();
}

QString Tour::key(const char* command) const {
    const Command* found = window_.commands().find(QLatin1String(command));
    if (found == nullptr || found->keys.isEmpty()) return {};
    const QString name = found->keys.front().toString(QKeySequence::NativeText);
    return QStringLiteral("<b>%1</b>").arg(name.toHtmlEscaped());
}

std::vector<Correction> Tour::corrections() const {
    std::vector<Correction> all;
    for (const Take& take : window_.session().document().project().takes) {
        for (const Fighter& fighter : take.fighters)
            all.insert(all.end(), fighter.corrections.begin(), fighter.corrections.end());
    }
    return all;
}

void Tour::addSteps() {
    steps_.push_back(
        {tr("Correct a suspect"),
         [this] {
             return tr("The minima of the force cut the bout into actions; a few are wrong. %1 "
                       "leads "
                       "to the likeliest, plays it and says why; %2 stops. %3 keeps it, %4 "
                       "removes it.")
                 .arg(key("review.next"), key("transport.play"), key("review.accept"),
                      key("review.reject"));
         },
         QStringLiteral("segment"), [this] { return window_.findChild<SegmentPanel*>(); },
         [this] { corrected_ = corrections(); }, [this] { return corrections() != corrected_; }});
    steps_.push_back(
        {tr("Label an action"),
         [this] {
             return tr("%1 leads to the action that says most; it loops. Say what it is: %2 is a "
                       "left punch forward, %3 a right one; the palette shows the other keys.")
                 .arg(key("label.next"), key("label.quick1"), key("label.quick2"));
         },
         QStringLiteral("label"), [this] { return window_.findChild<LabelPanel*>(); },
         [this] { byHand_ = window_.labels().progress().byHand; },
         [this] { return window_.labels().progress().byHand > byHand_; }});
    steps_.push_back(
        {tr("Let the machine say the rest"),
         [this] {
             return tr("A machine learns from your labels. One is few: here a third of the bout "
                       "can "
                       "be labelled for you. Then %1 accepts all that the machine is sure of; %2 "
                       "takes it back.")
                 .arg(key("label.acceptSure"), key("edit.undo"));
         },
         QStringLiteral("label"), [this] { return window_.findChild<ProgressBox*>(); },
         [this] { accepted_ = window_.labels().progress().accepted; },
         [this] { return window_.labels().progress().accepted > accepted_; },
         tr("Label a third for me"), [this] { labelSome(); }});
    steps_.push_back(
        {tr("See what follows what"),
         [this] {
             return tr("A row is what goes on, a column what comes next. Click a cell: the moments "
                       "behind it are listed, a click plays one. %1 leads to the most surprising "
                       "moment.")
                 .arg(key("graph.nextSurprise"));
         },
         QStringLiteral("graph"), [this] { return &window_.graphCentre(); },
         [this] { looked_ = false; }, [this] { return looked_; }});
    steps_.push_back(
        {tr("Let them fight on"),
         [this] {
             return tr("%1 starts a bout that was never fought, made from what was learnt. Every "
                       "choice stands at the right; a click takes another one. Back with %2, on "
                       "otherwise with %3.")
                 .arg(key("bout.play"), key("bout.back"), key("bout.reseed"));
         },
         QStringLiteral("bout"), [this] { return window_.findChild<BoutBar*>(); }, [] {},
         [this] { return window_.bout().isPlaying(); }});
}

void Tour::listen() {
    Document& document = window_.session().document();
    connect(&document, &Document::changed, this, &Tour::check);
    connect(&document, &Document::opened, this, [this] {
        const bool now = showsDemo() && wanted_;
        wanted_ = false;
        if (isRunning()) leave();
        if (now) QTimer::singleShot(0, this, &Tour::begin);
    });
    connect(&window_.labels(), &LabelSession::changed, this, &Tour::check);
    connect(&window_.bout(), &BoutSession::stateChanged, this, &Tour::check);
    const auto looked = [this] {
        looked_ = looked_ || window_.graph().selection() || window_.graph().current();
        check();
    };
    connect(&window_.graph(), &GraphSession::selectionChanged, this, looked);
    connect(&window_.graph(), &GraphSession::currentChanged, this, looked);
    connect(&window_.commands(), &CommandTable::renamed, this, [this] {
        if (isRunning()) show(at_);
    });
}

bool Tour::showsDemo() const {
    const Document& document = window_.session().document();
    if (!document.isOpen() || document.project().takes.empty()) return false;
    const auto& fighters = document.project().takes.front().fighters;
    return !fighters.empty() && fighters.front().recording.path.parent_path() == demoFolder();
}

void Tour::start() {
    if (showsDemo()) return begin();
    wanted_ = true;
    window_.files().openDemo();
}

void Tour::begin() {
    done_.assign(steps_.size(), false);
    if (box_ == nullptr) {
        mark_ = new QFrame(&window_);
        mark_->setProperty("role", "tourMark");
        mark_->setAttribute(Qt::WA_TransparentForMouseEvents);
        box_ = new TourBox(window_.commands(), &window_);
        connect(box_, &TourBox::helpWanted, this, [this] {
            if (isRunning()) steps_[static_cast<std::size_t>(at_)].help();
        });
    }
    window_.setPanelsShown(true);
    placing_.start();
    at_ = 0;
    steps_.front().begin();
    show(0);
}

void Tour::leave() {
    at_ = -1;
    placing_.stop();
    if (box_ != nullptr) {
        box_->hide();
        mark_->hide();
    }
    window_.commands().refresh();
}

void Tour::go(int direction) {
    const int to = at_ + direction;
    if (to >= static_cast<int>(steps_.size())) return leave();
    if (to < 0) return;
    at_ = to;
    steps_[static_cast<std::size_t>(to)].begin();
    show(to);
}

void Tour::show(int step) {
    const TourStep& shown = steps_[static_cast<std::size_t>(step)];
    window_.workspaces().show(shown.workspace);
    mark_->raise();
    box_->show(shown, step + 1, static_cast<int>(steps_.size()));
    box_->setDone(isDone(step));
    window_.commands().refresh();
    place();
    check();
}

void Tour::check() {
    if (!isRunning()) return;
    const auto step = static_cast<std::size_t>(at_);
    if (done_[step] || !steps_[step].isDone()) return;
    done_[step] = true;
    box_->setDone(true);
}

void Tour::place() {
    if (!isRunning()) return;
    QWidget* target = steps_[static_cast<std::size_t>(at_)].target();
    const bool seen = target != nullptr && target->isVisible();
    mark_->setVisible(seen);
    const QRect room = window_.rect().adjusted(kGap, kGap + 30, -kGap, -kGap - 20);
    QRect at(room.bottomRight(), QSize());
    if (seen) {
        at = QRect(target->mapTo(&window_, QPoint()), target->size());
        mark_->setGeometry(at);
    }
    box_->move(placeBeside(at, box_->size(), room));
}

/// Every third label of the demo bout's truth; what a hand said stays.
void Tour::labelSome() {
    box_->helpButton()->setEnabled(false);
    try {
        const auto truth = demoFolder() / "truth.json";
        const Document& document = window_.session().document();
        const auto labels = readLabels(truth, *document.project().labelling.vocabulary);
        std::vector<TimedLabel> some;
        for (std::size_t i = 0; i < labels.size(); i += 3)
            some.push_back(labels[i]);
        window_.session().document().apply(
            Document::BoundaryEdit([&](const Project& project, const Analysis& analysis) {
                const auto matched = matchLabels(project, analysis, some, 0);
                MaybeEdit edit = mergeLabels(project, analysis, matched.fighters);
                if (edit) edit->name = "Label a third of the demo bout";
                return edit;
            }));
    } catch (const std::exception& error) {
        window_.messages().showError(coreWords(error.what()));
    }
}

}  // namespace kumite::studio
