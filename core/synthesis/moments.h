#pragma once

#include "core/synthesis/bout_library.h"

namespace kumite {

/// Whether a label strikes: one of its aspects has a qualifier that brings its limb toward the
/// opponent.
bool strikes(const Vocabulary& vocabulary, const Label& label);
/// Whether a label answers something: an aspect found by the react rule is not at its fallback.
bool reacts(const Vocabulary& vocabulary, const Label& label);
/// Numbers of the stance letters at begin and end of a label's move; -1 where it says nothing.
struct StancePair {
    int first = -1;
    int last = -1;
};
StancePair stancesOf(const Vocabulary& vocabulary, const Label& label);

/// Finds the role, the moment and the lag of every action (method A9): of a strike the greatest
/// extension of its limb toward the opponent, of a reaction its force peak. A reaction belongs to
/// the strike that overlaps it longest, a strike to such a reaction. `actions` need their place.
void findMoments(BoutLibrary& library);

}  // namespace kumite
