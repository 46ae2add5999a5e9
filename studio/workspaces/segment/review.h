#pragma once

#include <vector>

#include "studio/app/session.h"

namespace kumite::studio {

/// A minimum of the shown take that cuts actions, or did until a hand removed it.
struct Suspect {
    BoundaryRef boundary;
    int minimum = 0;  ///< index
    double seconds = 0;
    double suspicion = 0;
    MarkState state = MarkState::Detected;

    /// Nobody has decided yet.
    bool isOpen() const { return state == MarkState::Detected; }
};

/// The minima of the shown take: those to be decided first, the most suspicious first; then those
/// that were, in the same order.
std::vector<Suspect> suspectsOf(const Session& session);

// What keys do in a review. Each decision goes on to the most suspicious minimum that is left.

/// Goes to the next (+1) or previous (-1) minimum to be decided; round at the ends.
void stepSuspect(Session& session, int direction);
/// The selected minimum is a boundary.
void acceptSuspect(Session& session);
/// The selected minimum is spurious.
void rejectSuspect(Session& session);
/// The selected minimum is to be decided anew.
void reviewAgain(Session& session);
/// After a step of the history: selects the boundary of the shown take that it decided otherwise,
/// if it is one.
void selectChanged(Session& session, const Project& before);

}  // namespace kumite::studio
