#pragma once

#include "core/labelling/label_filter.h"

namespace kumite {

/// Words of a filter that speak of a label, and what they ask.
struct LabelPhrase {
    std::size_t length = 0;  ///< in words; 0: they do not
    FilterAtom atom;
};

/// The longest phrase about labels that begins with word `at` (there is one): "right kick", "kick
/// up", "jump none", "react open", "left to right", "strike", "attack", "others".
LabelPhrase longestLabelPhrase(const Vocabulary& vocabulary, const std::vector<std::string>& words,
                               std::size_t at);

}  // namespace kumite
