#pragma once

#include <QDateTime>
#include <QKeySequence>
#include <QString>

#include "core/project/review.h"
#include "studio/app/boundary_marks.h"

namespace kumite::studio {

struct LockHolder;

/// How numbers and names read everywhere in the window, in its language. Moments and frames have
/// the same form in all of them.

/// 0.5 with two decimals → "0.50", "0,50".
QString numberText(double number, int decimals);
/// With as many decimals as it has, six digits at most: "0.5", "0,5".
QString numberText(double number);
/// 64.25 s → "1:04.250"; minutes, seconds, milliseconds.
QString timeText(double seconds);
/// With as many decimals as `step` seconds between two texts need: "1:04", "1:04.2".
QString timeText(double seconds, double step);
/// 0.7249 → "0.72 BW".
QString bodyWeightsText(double bodyWeights);
/// 0.123 → "12 %".
QString percentText(double share);
/// 0 → "fighter 1".
QString fighterText(int player);
/// "today 10:32", "yesterday 18:04", "2008-01-31 17:45"; with seconds where they tell moments
/// apart.
QString momentText(const QDateTime& moment, bool seconds = false);
/// "Computer dojo, process 4711, since today 10:32."
QString holderText(const LockHolder& holder);
/// 1 → "1 edit", 3 → "3 edits".
QString editsText(int edits);

/// A key as the window's language names it, arrows as signs: "Ctrl+←", "Return", "Entf".
QString keyText(const QKeySequence& key);
/// As short as can be, for narrow places: "⇧Q", "⌫", "⏎".
QString keySigns(const QKeySequence& key);

/// Why a minimum is suspected: "slow left kick, prominence 0.07 BW".
QString reasonText(const SuspectReason& reason);
/// The same in a word or two: "left kick".
QString shortReasonText(const SuspectReason& reason);
/// What is known about the minimum of a mark: reason and suspicion.
QString suspicionText(const FighterAnalysis& fighter, const BoundaryMark& mark);
/// A correction that no longer means a minimum: "removal at 0:02.350".
QString correctionWords(const Correction& correction, const Fighter& fighter);

}  // namespace kumite::studio
