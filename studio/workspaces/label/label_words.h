#pragma once

#include <QString>

#include "core/labelling/label.h"
#include "studio/workspaces/label/shown_action.h"

namespace kumite::studio {

class LabelSession;

/// How labels read in the window.

/// "right punch forward, jump up"; "nothing" where all that is known is at its fallback; "open"
/// where nothing is known. `withRules`: aspects that rules decide, too.
QString labelWords(const Vocabulary& vocabulary, const Label& label, bool withRules = false);
/// "right punch forward"; "no right punch" for the fallback.
QString aspectWords(const Vocabulary& vocabulary, int aspect, int qualifier);
/// "hand", "rule", "machine"
QString sourceWords(LabelSource source);
/// "by hand", "accepted from the machine, p 0.93", "proposed by a rule".
QString standingWords(const ShownAspect& aspect);
/// "p 0.83"; "…" while it is not known.
QString probabilityWords(double confidence);
/// Why an aspect has the value that it has, as far as rules say; else empty.
QString reasonWords(const LabelSession& labels, const ShownAction& action, int aspect);

}  // namespace kumite::studio
