#pragma once

#include "core/labelling/label.h"

namespace kumite {

// What a hand means by few words: one key labels a whole action.

/// How a hand names a qualifier of an action that is labelled already or proposed a label.
enum class Naming {
    Instead,  ///< a strike takes the place of every other strike
    Besides,  ///< it comes beside other strikes: a composite
};

/// The whole label that a hand means by naming one qualifier: what it `said` before stays, the
/// other learnt aspects are as `proposed`, or at their fallback. What the named aspect excludes is
/// at its fallback. Aspects of rules stay as they were said; to name one says nothing else.
Label answeredLabel(const Vocabulary& vocabulary, const Label& said, const Label& proposed,
                    int aspect, int qualifier, Naming naming = Naming::Instead);

/// The whole label that a hand means by agreeing: learnt aspects as said, else as proposed, else
/// at their fallback. Aspects of rules stay as they were said.
Label agreedLabel(const Vocabulary& vocabulary, const Label& said, const Label& proposed);

/// A whole label that one key says, "right punch forward"; unknown where rules decide.
struct QuickLabel {
    Label label;
    std::string key;  ///< default key: "Shift+Q"; may be empty

    bool operator==(const QuickLabel&) const = default;
};

/// The labels of one learnt aspect each, in the order of the vocabulary, an aspect's beside those
/// of its mirror, and nothing of anything at the end. Aspects in pairs have a row of the keyboard
/// (Q W E R, Z X C, …), with Shift for the second of the pair; single ones share a row; B: nothing.
std::vector<QuickLabel> quickLabels(const Vocabulary& vocabulary);

}  // namespace kumite
