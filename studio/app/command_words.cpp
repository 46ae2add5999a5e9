#include "studio/app/command_words.h"

#include <QCoreApplication>

#include "studio/app/commands.h"

namespace kumite::studio {

namespace {

struct Words {
    const char* command;
    const char* words;  ///< separated by commas; translated as one text
};

constexpr const char* kContext = "kumite::studio";

constexpr Words kWords[] = {
    {"file.openDemo", QT_TR_NOOP("example, sample, tutorial, try")},
    {"file.openRecordings",
     QT_TR_NOOP("import, load, bvh, amc, asf, mocap, motion capture, new project")},
    {"file.openProject", QT_TR_NOOP("load, kumite file")},
    {"file.save", QT_TR_NOOP("store, write")},
    {"file.saveAs", QT_TR_NOOP("copy, rename project, duplicate")},
    {"file.versions", QT_TR_NOOP("backup, restore, earlier, revert, snapshot")},
    {"file.export", QT_TR_NOOP("csv, json, bvh, table, spreadsheet, results")},
    {"file.findRecording", QT_TR_NOOP("missing, relink, locate, moved")},
    {"file.quit", QT_TR_NOOP("exit, close, leave")},
    {"edit.undo", QT_TR_NOOP("back, revert, oops")},
    {"edit.redo", QT_TR_NOOP("again, repeat")},
    {"app.preferences", QT_TR_NOOP("settings, options, configuration, shortcuts, autosave")},
    {"take.add", QT_TR_NOOP("import, new, load, clip, session")},
    {"take.rename", QT_TR_NOOP("name, title")},
    {"take.remove", QT_TR_NOOP("delete, close, clip")},
    {"take.previous", QT_TR_NOOP("previous clip, switch")},
    {"take.next", QT_TR_NOOP("next clip, switch")},
    {"fighter.other", QT_TR_NOOP("switch, opponent, toggle, player")},
    {"fighter.properties",
     QT_TR_NOOP("joints, roles, skeleton, rate, offset, sync, floor, body model, mass")},
    {"fighter.swap", QT_TR_NOOP("exchange, colours, player")},
    {"project.findings", QT_TR_NOOP("warnings, problems, errors, log, report")},
    {"boundary.toggle", QT_TR_NOOP("delete, erase, clear, undelete, merge, cut")},
    {"boundary.add", QT_TR_NOOP("split, cut, insert, new, razor, slice, mark, here")},
    {"boundary.mergeLeft", QT_TR_NOOP("merge left, combine, previous")},
    {"boundary.mergeRight", QT_TR_NOOP("merge right, combine, next")},
    {"boundary.earlier", QT_TR_NOOP("nudge left, shift")},
    {"boundary.later", QT_TR_NOOP("nudge right, shift")},
    {"action.loop", QT_TR_NOOP("repeat, zoom to action, segment")},
    {"action.note", QT_TR_NOOP("comment, annotate, remark, text, label")},
    {"review.next", QT_TR_NOOP("review, suspicious, error, uncertain, queue")},
    {"review.previous", QT_TR_NOOP("review, suspicious")},
    {"review.accept", QT_TR_NOOP("accept, approve, confirm, ok, yes, good")},
    {"review.reject", QT_TR_NOOP("reject, delete, dismiss, discard, no, false, wrong")},
    {"review.again", QT_TR_NOOP("reset, reopen, undecided, withdraw")},
    {"segment.compare", QT_TR_NOOP("difference, a/b, versus, parameters")},
    {"timeline.rawForce", QT_TR_NOOP("raw, unfiltered, noise")},
    {"timeline.height", QT_TR_NOOP("com, cog, gravity")},
    {"timeline.handSpeed", QT_TR_NOOP("velocity, wrist, punch")},
    {"timeline.footSpeed", QT_TR_NOOP("velocity, ankle, kick")},
    {"timeline.ruler", QT_TR_NOOP("seconds, frames, timecode")},
    {"transport.play", QT_TR_NOOP("start, stop, run")},
    {"transport.stop", QT_TR_NOOP("pause, halt")},
    {"transport.reverse", QT_TR_NOOP("rewind, shuttle")},
    {"transport.forward", QT_TR_NOOP("fast forward, shuttle")},
    {"transport.back", QT_TR_NOOP("previous frame, step")},
    {"transport.on", QT_TR_NOOP("next frame, step")},
    {"transport.begin", QT_TR_NOOP("beginning, first frame, rewind")},
    {"transport.end", QT_TR_NOOP("last frame")},
    {"transport.slower", QT_TR_NOOP("slow motion, speed, rate")},
    {"transport.faster", QT_TR_NOOP("speed up, rate")},
    {"transport.loop", QT_TR_NOOP("repeat, cycle")},
    {"loop.in", QT_TR_NOOP("in point, mark in, start, range")},
    {"loop.out", QT_TR_NOOP("out point, mark out, end, range")},
    {"view.all", QT_TR_NOOP("fit, frame all, zoom out, home, reset view")},
    {"view.selection", QT_TR_NOOP("frame selected, zoom in, focus, centre")},
    {"view.panels", QT_TR_NOOP("sidebar, show panels, focus mode")},
    {"view.fullScreen", QT_TR_NOOP("maximise, maximize")},
    {"view.textLarger", QT_TR_NOOP("font size, zoom, bigger, accessibility, scale")},
    {"view.textSmaller", QT_TR_NOOP("font size, zoom, scale")},
    {"view.theme0", QT_TR_NOOP("dark mode, light mode, colours, auto")},
    {"view.theme1", QT_TR_NOOP("light mode, bright, white, day, colours")},
    {"view.theme2", QT_TR_NOOP("dark mode, black, night, colours")},
    {"view.front", QT_TR_NOOP("camera, front view")},
    {"view.side", QT_TR_NOOP("camera, side view, left, right, profile")},
    {"view.top", QT_TR_NOOP("camera, top view, bird")},
    {"view.shoulder1", QT_TR_NOOP("camera, behind, third person")},
    {"view.shoulder2", QT_TR_NOOP("camera, behind, third person")},
    {"view.follow", QT_TR_NOOP("camera, track")},
    {"view.contacts", QT_TR_NOOP("footsteps, feet, ground")},
    {"view.trails", QT_TR_NOOP("trajectory, path, motion trail")},
    {"view.centreOfMass", QT_TR_NOOP("com, cog, center, gravity")},
    {"view.force", QT_TR_NOOP("arrow, vector, ground reaction")},
    {"view.ghosts", QT_TR_NOOP("onion skin")},
    {"view.addGhost", QT_TR_NOOP("onion skin, pose, stamp")},
    {"view.clearGhosts", QT_TR_NOOP("delete ghosts, onion skin")},
    {"view.measure", QT_TR_NOOP("distance, ruler, speed, tape")},
    {"view.copyPicture", QT_TR_NOOP("screenshot, clipboard, image")},
    {"view.savePicture", QT_TR_NOOP("screenshot, render, image, png, export picture, capture")},
    {"help.open", QT_TR_NOOP("manual, documentation, guide")},
    {"help.first", QT_TR_NOOP("tutorial, introduction, start, guide")},
    {"help.method", QT_TR_NOOP("formula, explain, statistics, papers, sources")},
    {"help.tour", QT_TR_NOOP("tutorial, introduction, walkthrough, wizard, guide")},
    {"help.whatsThis", QT_TR_NOOP("explain, context help")},
    {"help.describe", QT_TR_NOOP("explain, accessibility")},
    {"help.keys", QT_TR_NOOP("shortcuts, hotkeys, cheat sheet, help, manual, print")},
    {"help.changes", QT_TR_NOOP("release notes, changelog, news, version")},
    {"help.about", QT_TR_NOOP("version, licence, license")},
};

}  // namespace

void addCommandWords(CommandTable& commands) {
    for (const Words& each : kWords)
        commands.setWords(QLatin1String(each.command),
                          QCoreApplication::translate(kContext, each.words));
}

}  // namespace kumite::studio
