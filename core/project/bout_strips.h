#pragma once

#include <string>

#include "core/project/film_strip.h"
#include "core/synthesis/bout_tape.h"

namespace kumite {

/// What strips of a bout show.
struct BoutStripSettings {
    int pictures = 7;  ///< of each action, from its begin to its end
    int most = 12;     ///< actions at most
    FilmView view = FilmView::Side;
};

/// Synthesised actions beside the recorded ones that they were made from (paper A, Fig. 14), as an
/// SVG picture: of each technique, and then of other labels that say more than steps, the first
/// time a bout shows it, a row of the bout and a row of the sample with its recorded opponent, at
/// the same shares of the action. Cancellable.
std::string boutStripsSvg(const BoutTape& tape, const BoutStripSettings& settings = {},
                          const Progress& progress = {});

}  // namespace kumite
