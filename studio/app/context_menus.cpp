// What the context menus of views and lists hold: commands of the table, by where they were asked
// for. Commands of a workspace that is not shown are left out by themselves.

#include "studio/app/commands.h"
#include "studio/app/main_window.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"

namespace kumite::studio {

namespace {

QStringList onTimeline(TimelineSpot spot) {
    switch (spot) {
        case TimelineSpot::Boundary:
            return {"boundary.toggle",
                    "review.accept",
                    "review.again",
                    "-",
                    "boundary.earlier",
                    "boundary.later",
                    "-",
                    "boundary.mergeLeft",
                    "boundary.mergeRight",
                    "-",
                    "boundary.previous",
                    "boundary.next"};
        case TimelineSpot::Action:
            return {"action.loop",
                    "action.note",
                    "-",
                    "boundary.add",
                    "boundary.mergeLeft",
                    "boundary.mergeRight",
                    "-",
                    "action.previous",
                    "action.next",
                    "-",
                    "view.selection"};
        case TimelineSpot::Ruler:
            break;
    }
    return {"loop.in",
            "loop.out",
            "transport.loop",
            "-",
            "view.all",
            "view.selection",
            "-",
            "timeline.rulerBoth",
            "timeline.rulerTime",
            "timeline.rulerFrames"};
}

/// `player` is the fighter under the pointer.
QStringList inStage(std::optional<int> player) {
    if (player) {
        return {"view.selection",
                *player == 0 ? "view.shoulder1" : "view.shoulder2",
                "view.follow",
                "-",
                "view.addGhost",
                "view.measure",
                "-",
                "fighter.properties",
                "fighter.swap"};
    }
    return {"view.all",          "view.front",
            "view.side",         "view.top",
            "view.shoulder1",    "view.shoulder2",
            "view.follow",       "-",
            "view.contacts",     "view.trails",
            "view.centreOfMass", "view.force",
            "view.ghosts",       "-",
            "view.addGhost",     "view.clearGhosts",
            "view.measure",      "-",
            "view.copyPicture",  "view.savePicture"};
}

}  // namespace

void MainWindow::addContextMenus() {
    connect(
        timeline_, &TimelineView::menuWanted, this,
        [this](TimelineSpot spot, const QPoint& at) { commands_->popUp(onTimeline(spot), at); });
    connect(stage_, &StageView::menuWanted, this,
            [this](std::optional<int> player, const QPoint& at) {
                commands_->popUp(inStage(player), at);
            });
}

}  // namespace kumite::studio
