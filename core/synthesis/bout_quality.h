#pragma once

#include "core/quality/quality.h"
#include "core/synthesis/bout_tape.h"

namespace kumite {

/// The longest take of both fighters that a library holds: what its bouts are held against. Joins
/// are the boundaries of actions, so that their ratio says how boundaries differ from what lies
/// between; hits are held against the median lag, because each is its own target. Null values
/// where no take shows both.
struct RecordingQuality {
    Quality quality;
    JointMotionBar bar;  ///< joint motion inside its actions
};
RecordingQuality recordingQuality(const BoutLibrary& library, const Progress& progress = {});

/// Frames [0, end()] of a tape by the same measures (core/quality). Joins are where actions were
/// chosen; hits are the strikes and reactions that were brought together, as they were shown in
/// the end, and their wanted lag. Cancellable.
Quality boutQuality(const BoutTape& tape, const JointMotionBar& bar, const Progress& progress = {});

}  // namespace kumite
