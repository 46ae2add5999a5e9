#pragma once

#include <QString>

#include <vector>

#include "core/labelling/label.h"

namespace kumite::studio {

/// A label as people read it: "right kick up, jump up"; "nothing" where every known aspect is at
/// its fallback, "open" where nothing is known. The move is left out beside anything else.
QString labelWords(const Vocabulary& vocabulary, const Label& label);
/// One aspect of it: "right kick up".
QString aspectWords(const Vocabulary& vocabulary, int aspect, int qualifier);
/// "hand", "rule", "machine"
QString sourceWords(LabelSource source);

}  // namespace kumite::studio
