#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/project/analysis.h"
#include "core/project/project.h"

namespace kumite {

/// A project after an edit, and the edit's name as the history shows it. An edit that would change
/// nothing returns nothing. Edits are free functions of values: window, command line and tests
/// call the same ones; each throws Error with one sentence where it cannot be done.
struct Edit {
    Project project;
    std::string name;
};
using MaybeEdit = std::optional<Edit>;

// Boundaries. `analysis` must be that of `project`. Frames are frames of the take.

/// Removes the boundary nearest to `frame` within 0.1 s. The first and last frame stay.
MaybeEdit removeBoundary(const Project& project, const Analysis& analysis, FighterAddress fighter,
                         int frame);
/// Brings back the removed minimum (or removed added boundary) nearest to `frame` within 0.1 s.
MaybeEdit restoreBoundary(const Project& project, const Analysis& analysis, FighterAddress fighter,
                          int frame);
/// Adds a boundary at `frame`, strictly inside the take.
MaybeEdit addBoundary(const Project& project, const Analysis& analysis, FighterAddress fighter,
                      int frame);
/// Moves the boundary nearest to `from` within 0.1 s to `to`, which must lie strictly between its
/// neighbours.
MaybeEdit moveBoundary(const Project& project, const Analysis& analysis, FighterAddress fighter,
                       int from, int to);
/// Says that the detected boundary nearest to `frame` within 0.1 s is right: it is no suspect any
/// more and stays whatever the threshold. Nothing to do for one that a hand has set.
MaybeEdit acceptBoundary(const Project& project, const Analysis& analysis, FighterAddress fighter,
                         int frame);
/// Takes that back.
MaybeEdit withdrawAcceptance(const Project& project, const Analysis& analysis,
                             FighterAddress fighter, int frame);
/// Forgets one correction that no longer means any minimum, or all of them.
MaybeEdit forgetCorrection(const Project& project, const Analysis& analysis, FighterAddress fighter,
                           const Correction& correction);
MaybeEdit dropUnmatchedCorrections(const Project& project, const Analysis& analysis,
                                   FighterAddress fighter);

/// Puts a boundary by hand where a correction that no longer means any minimum had one.
MaybeEdit addBoundaryOfCorrection(const Project& project, const Analysis& analysis,
                                  FighterAddress fighter, const Correction& correction);

// Notes.

/// Writes the note of the action that holds `frame`, at its peak; no text removes it. What was
/// noted there before is replaced.
MaybeEdit setNote(const Project& project, const Analysis& analysis, FighterAddress fighter,
                  int frame, const std::string& text);

// Settings.

MaybeEdit setSegmentation(const Project& project, const SegmentationSettings& settings);
MaybeEdit setBodyModel(const Project& project, const BodyModel& model);

/// Brings back a whole earlier state. `when` says which: "10:32".
MaybeEdit restoreVersion(const Project& project, const Project& version, const std::string& when);

// What motions are made from, and what is being made.

/// Adds files or folders to the clips; those that are there already stay once.
MaybeEdit addClips(const Project& project, const std::vector<std::filesystem::path>& clips);
MaybeEdit removeClips(const Project& project, const std::vector<std::filesystem::path>& clips);
/// Replaces the draft of a kind by a JSON text; no text removes it. `edit` is what the history
/// shows. Throws InputError if it is no JSON.
MaybeEdit setDraft(const Project& project, const std::string& kind, const std::string& json,
                   std::string edit);

// Takes.

/// Adds a take; its name must be new and not empty, and it must have one or two fighters.
MaybeEdit addTake(const Project& project, const Take& take);
MaybeEdit removeTake(const Project& project, int take);
MaybeEdit renameTake(const Project& project, int take, const std::string& name);
/// Puts a take to the place `to` of the list; those between close up.
MaybeEdit moveTake(const Project& project, int take, int to);
/// Player 1 becomes player 2 and the reverse.
MaybeEdit swapFighters(const Project& project, int take);
MaybeEdit setOffset(const Project& project, FighterAddress fighter, double seconds);
MaybeEdit setPlacement(const Project& project, FighterAddress fighter, const Placement& placement);
MaybeEdit setFloor(const Project& project, FighterAddress fighter, std::optional<double> metres);
/// Mends a wrong role mapping; `joint` nothing: the skeleton has no such joint.
MaybeEdit setRole(const Project& project, FighterAddress fighter, Role role,
                  std::optional<int> joint);
/// Points a fighter to the file where its recording is now. `sha256` of the new file.
MaybeEdit relinkRecording(const Project& project, FighterAddress fighter,
                          const RecordingRef& recording, std::shared_ptr<const Motion> motion);

}  // namespace kumite
