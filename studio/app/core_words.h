#pragma once

#include <QString>

#include <string>

#include "core/labelling/vocabulary.h"
#include "core/motion/roles.h"

namespace kumite::studio {

/// What the core says of its own accord, in the window's language: names of edits ("Remove boundary
/// at 0:12.30, fighter 1"), errors, findings, reasons of rules. What is not known here stays as it
/// is.
QString coreWords(const std::string& text);

/// Names of the built-in vocabulary ("Left punch", "forward"); those of another vocabulary are its
/// author's and stay.
QString vocabularyWords(const std::string& name);
/// The same within a sentence: "left punch"; where nouns keep their capital, as they stand.
QString vocabularyInText(const std::string& name);
/// As short as can be, for cells, nodes and blocks: "fwd". Again only of the built-in vocabulary.
QString shortWords(const Qualifier& qualifier);

/// "left wrist".
QString roleWords(Role role);

}  // namespace kumite::studio
