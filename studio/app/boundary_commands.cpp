// Commands on boundaries and actions, of the review, and of what the timeline shows.

#include <QSettings>

#include <array>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/main_window.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/segment/compare_box.h"
#include "studio/workspaces/segment/review.h"
#include "studio/workspaces/segment/segment_panel.h"

namespace kumite::studio {

namespace {

/// Under which the timeline's options are kept between starts.
constexpr std::array<std::pair<const char*, bool TimelineOptions::*>, 4> kSwitches = {
    {{"timeline/height", &TimelineOptions::height},
     {"timeline/rawForce", &TimelineOptions::rawForce},
     {"timeline/handSpeed", &TimelineOptions::handSpeed},
     {"timeline/footSpeed", &TimelineOptions::footSpeed}}};
constexpr const char* kRuler = "timeline/ruler";

TimelineOptions storedOptions() {
    const QSettings settings;
    TimelineOptions options;
    for (const auto& [key, member] : kSwitches) {
        options.*member = settings.value(QLatin1String(key), options.*member).toBool();
    }
    const int ruler = settings.value(QLatin1String(kRuler), 0).toInt();
    if (ruler >= 0 && ruler <= 2) options.ruler = static_cast<RulerUnits>(ruler);
    return options;
}

void storeOptions(const TimelineOptions& options) {
    QSettings settings;
    for (const auto& [key, member] : kSwitches)
        settings.setValue(QLatin1String(key), options.*member);
    settings.setValue(QLatin1String(kRuler), static_cast<int>(options.ruler));
}

}  // namespace

void MainWindow::addBoundaryCommand(const char* id, const QString& text,
                                    const QList<QKeySequence>& keys, std::function<void()> run,
                                    bool newGroup, const QList<QWidget*>& scopes) {
    const QString segment = tr("&Segment");
    Command command{id,
                    newGroup ? QLatin1Char('-') + segment : segment,
                    text,
                    keys,
                    std::move(run),
                    [this] { return hasTake(); },
                    {},
                    {},
                    scopes};
    command.leadsOn = true;
    commands_->add(std::move(command));
}

void MainWindow::addBoundaryCommands() {
    const auto add = [this](const char* id, const QString& text, const QList<QKeySequence>& keys,
                            std::function<void()> run, bool newGroup = false,
                            const QList<QWidget*>& scopes = {}) {
        addBoundaryCommand(id, text, keys, std::move(run), newGroup, scopes);
    };
    add("boundary.toggle", tr("&Remove or restore boundary"), {QKeySequence("Del")},
        [this] { session_.toggleCurrentBoundary(); });
    add("boundary.add", tr("Split here: &add a boundary"), {QKeySequence("S")},
        [this] { session_.addBoundaryAtPlayhead(); });
    add("boundary.mergeLeft", tr("Join with the action &before"), {QKeySequence("Ctrl+[")},
        [this] { session_.mergeAction(-1); });
    add("boundary.mergeRight", tr("Join with the action af&ter"), {QKeySequence("Ctrl+]")},
        [this] { session_.mergeAction(1); });
    add(
        "boundary.previous", tr("&Previous boundary"), {QKeySequence("Ctrl+Left")},
        [this] { session_.stepBoundary(-1); }, true);
    add("boundary.next", tr("&Next boundary"), {QKeySequence("Ctrl+Right")},
        [this] { session_.stepBoundary(1); });
    add("boundary.earlier", tr("Move boundary one frame &earlier"), {QKeySequence("Alt+Left")},
        [this] { session_.nudgeBoundary(-1); });
    add("boundary.later", tr("Move boundary one frame &later"), {QKeySequence("Alt+Right")},
        [this] { session_.nudgeBoundary(1); });
    add(
        "action.previous", tr("Select the action before"), {QKeySequence("PgUp")},
        [this] { session_.stepAction(-1); }, true);
    add("action.next", tr("Select the action after"), {QKeySequence("PgDown")},
        [this] { session_.stepAction(1); });
    add("action.loop", tr("Sho&w and loop the action"), {QKeySequence("Ctrl+Shift+L")}, [this] {
        if (const auto action = session_.currentAction()) session_.loopAction(*action);
    });
    add("action.note", tr("N&ote on the action…"), {QKeySequence("Ctrl+N")},
        [this] { timeline_->editNote(); });
}

void MainWindow::addSegmentCommands(SegmentPanel& panel) {
    const auto has = [this] { return hasTake(); };
    const QString segment = tr("&Segment");
    const auto add = [this](const char* id, const QString& text, const QList<QKeySequence>& keys,
                            std::function<void()> run, bool newGroup = false,
                            const QList<QWidget*>& scopes = {}) {
        addBoundaryCommand(id, text, keys, std::move(run), newGroup, scopes);
    };
    connect(&session_, &Session::examined, stage_, [this] {
        const Transport& transport = session_.transport();
        stage_->showBoth(transport.loopIn().value_or(transport.span().begin),
                         transport.loopOut().value_or(transport.span().end));
        if (!isMotionReduced()) session_.transport().setPlaying(true);
    });
    // Return and Backspace are keys of fields and buttons, too.
    const QList<QWidget*> views = {stage_, timelineBox_, panel.list()};
    add(
        "review.next", tr("Ne&xt suspect"), {QKeySequence("N")},
        [this] { stepSuspect(session_, 1); }, true);
    add("review.previous", tr("Pre&vious suspect"), {QKeySequence("Shift+N")},
        [this] { stepSuspect(session_, -1); });
    add(
        "review.accept", tr("&Keep: it is a boundary"),
        {QKeySequence("Return"), QKeySequence("Enter")}, [this] { acceptSuspect(session_); }, false,
        views);
    add(
        "review.reject", tr("Re&move: it is spurious"), {QKeySequence("Backspace")},
        [this] { rejectSuspect(session_); }, false, views);
    add(
        "review.again", tr("De&cide anew"), {QKeySequence("Shift+Return")},
        [this] { reviewAgain(session_); }, false, views);
    commands_->offerMenu(panel.list(), {"review.accept", "review.reject", "review.again", "-",
                                        "review.next", "review.previous", "-", "view.selection"});
    CompareBox& compare = panel.comparison();
    commands_->add({"segment.compare",
                    QLatin1Char('-') + segment,
                    tr("Compare with settings B"),
                    {QKeySequence("C")},
                    [&compare] { compare.setOn(!compare.isOn()); },
                    has,
                    [&compare] { return compare.isOn(); }});
    panel.tellKeys(*commands_);
    connect(&compare, &CompareBox::toggled, commands_, &CommandTable::refresh);
}

void MainWindow::addTimelineCommands() {
    const QString menu = tr("T&imeline");
    timeline_->setOptions(storedOptions());
    const auto change = [this](auto what) {
        TimelineOptions options = timeline_->options();
        what(options);
        timeline_->setOptions(options);
        storeOptions(options);
        if (!spaceShared_) shareSpace();
    };
    const std::array<std::pair<const char*, QString>, 4> switches = {
        {{"timeline.height", tr("&Height of the centre of mass")},
         {"timeline.rawForce", tr("Force without &smoothing")},
         {"timeline.handSpeed", tr("Speeds of the h&ands")},
         {"timeline.footSpeed", tr("Speeds of the &feet")}}};
    for (std::size_t i = 0; i < switches.size(); ++i) {
        const auto member = kSwitches[i].second;
        commands_->add({switches[i].first,
                        menu,
                        switches[i].second,
                        {},
                        [change, member] {
                            change([member](TimelineOptions& o) { o.*member = !(o.*member); });
                        },
                        {},
                        [this, member] { return timeline_->options().*member; }});
    }
    const std::array<std::pair<RulerUnits, QString>, 3> units = {
        {{RulerUnits::Both, tr("Ruler in &time and frames")},
         {RulerUnits::Time, tr("Ruler in time")},
         {RulerUnits::Frames, tr("Ruler in frames")}}};
    const char* const ids[] = {"timeline.rulerBoth", "timeline.rulerTime", "timeline.rulerFrames"};
    for (const auto& [unit, text] : units) {
        commands_->add(
            {ids[static_cast<int>(unit)],
             unit == RulerUnits::Both ? QLatin1Char('-') + menu : menu,
             text,
             {},
             [change, unit = unit] { change([unit](TimelineOptions& o) { o.ruler = unit; }); },
             {},
             [this, unit = unit] { return timeline_->options().ruler == unit; }});
    }
    commands_->add(
        {"timeline.ruler", menu, tr("Next &unit of the ruler"), {QKeySequence("T")}, [change] {
             change([](TimelineOptions& o) {
                 o.ruler = static_cast<RulerUnits>((static_cast<int>(o.ruler) + 1) % 3);
             });
         }});
}

}  // namespace kumite::studio
