#include "studio/workspaces/segment/review.h"

#include <QCoreApplication>

#include <algorithm>
#include <tuple>

namespace kumite::studio {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("kumite::studio::Review", text);
}

std::vector<Suspect> openSuspects(const Session& session) {
    std::vector<Suspect> open = suspectsOf(session);
    std::erase_if(open, [](const Suspect& suspect) { return !suspect.isOpen(); });
    return open;
}

/// After a decision: the most suspicious that is left, if it is worth a look.
void goOn(Session& session) {
    const std::vector<Suspect> open = openSuspects(session);
    if (!open.empty() && open.front().suspicion >= kSuspect) {
        session.examine(open.front().boundary);
        return;
    }
    Q_EMIT session.hinted(open.empty()
                              ? words("Every minimum of this take is decided.")
                              : words("No suspect is left. N leads through the other minima."));
}

/// The mark of the selected boundary; without one, says how to get it.
const BoundaryMark* selectedMark(Session& session) {
    const auto& selected = session.selection();
    const BoundaryMark* mark =
        selected ? nearestMark(session.marks(selected->player), selected->frame, 0.5) : nullptr;
    if (mark == nullptr) {
        Q_EMIT session.hinted(
            words("Nothing is selected. N leads to the most suspicious minimum."));
    }
    return mark;
}

}  // namespace

std::vector<Suspect> suspectsOf(const Session& session) {
    std::vector<Suspect> suspects;
    for (int player = 0; player < session.playerCount(); ++player) {
        if (session.fighter(player) == nullptr) continue;
        for (const BoundaryMark& mark : session.marks(player)) {
            if (!mark.minimum) continue;
            const BoundaryRef boundary{player, mark.frame};
            suspects.push_back(
                {boundary, *mark.minimum, session.timeOf(boundary), mark.suspicion, mark.state});
        }
    }
    std::stable_sort(suspects.begin(), suspects.end(), [](const Suspect& a, const Suspect& b) {
        return std::tuple(!a.isOpen(), -a.suspicion, a.seconds) <
               std::tuple(!b.isOpen(), -b.suspicion, b.seconds);
    });
    return suspects;
}

void stepSuspect(Session& session, int direction) {
    const std::vector<Suspect> open = openSuspects(session);
    if (open.empty()) {
        Q_EMIT session.hinted(words("No minimum is left to decide."));
        return;
    }
    const auto count = static_cast<std::ptrdiff_t>(open.size());
    const auto selected = std::find_if(open.begin(), open.end(), [&](const Suspect& suspect) {
        return session.selection() == suspect.boundary;
    });
    const auto now = selected - open.begin();
    // From elsewhere the first step leads to the most suspicious.
    const auto next = selected == open.end() ? 0 : (now + direction + count) % count;
    session.examine(open[static_cast<std::size_t>(next)].boundary);
}

void acceptSuspect(Session& session) {
    const BoundaryMark* mark = selectedMark(session);
    if (mark == nullptr) return;
    const BoundaryRef boundary = *session.selection();
    session.whenCurrent([&session, boundary, live = mark->isLive()] {
        if (!live) session.setBoundaryLive(boundary, true);
        session.acceptBoundary(boundary);
        goOn(session);
    });
}

void rejectSuspect(Session& session) {
    const BoundaryMark* mark = selectedMark(session);
    if (mark == nullptr) return;
    session.whenCurrent([&session, boundary = *session.selection(), live = mark->isLive()] {
        if (live) session.setBoundaryLive(boundary, false);
        goOn(session);
    });
}

void reviewAgain(Session& session) {
    const BoundaryMark* mark = selectedMark(session);
    if (mark == nullptr) return;
    const BoundaryRef boundary = *session.selection();
    session.whenCurrent([&session, boundary, live = mark->isLive()] {
        if (!live) session.setBoundaryLive(boundary, true);
        session.withdrawAcceptance(boundary);
    });
}

}  // namespace kumite::studio
