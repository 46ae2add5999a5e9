#include "studio/workspaces/segment/review.h"

#include <QCoreApplication>

#include <algorithm>
#include <tuple>

namespace kumite::studio {

namespace {

/// Translations of this file.
struct Review {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::Review)
};

std::vector<Suspect> openSuspects(const Session& session) {
    std::vector<Suspect> open = suspectsOf(session);
    std::erase_if(open, [](const Suspect& suspect) { return !suspect.isOpen(); });
    return open;
}

std::ptrdiff_t countSuspects(const std::vector<Suspect>& open) {
    return std::count_if(open.begin(), open.end(),
                         [](const Suspect& suspect) { return suspect.suspicion >= kSuspect; });
}

/// After a decision: the most suspicious that is left, if it is worth a look. `before`: how many
/// were suspected until then.
void goOn(Session& session, std::ptrdiff_t before) {
    const std::vector<Suspect> open = openSuspects(session);
    const auto left = static_cast<int>(countSuspects(open));
    if (left > 0) {
        session.examine(open.front().boundary);
        const auto others = static_cast<int>(before - left) - 1;
        if (others > 0) {
            Q_EMIT session.hinted(Review::tr("What you decided clears %n more.", nullptr, others) +
                                  QLatin1Char(' ') +
                                  Review::tr("%n suspect(s) left.", nullptr, left));
        }
        return;
    }
    // The same key or button again must not undo what was just decided.
    session.select(std::nullopt);
    Q_EMIT session.hinted(
        open.empty() ? Review::tr("Every minimum of this take is decided.")
                     : Review::tr("No suspect is left. N leads through the other minima."));
}

/// The mark of the selected boundary; without one, says how to get it.
const BoundaryMark* selectedMark(Session& session) {
    const auto& selected = session.selection();
    const BoundaryMark* mark =
        selected ? nearestMark(session.marks(selected->player), selected->frame, 0.5) : nullptr;
    if (mark == nullptr) {
        Q_EMIT session.hinted(
            Review::tr("No boundary is selected. N leads to the most suspicious minimum."));
    }
    return mark;
}

void goToSuspect(Session& session, int direction) {
    const std::vector<Suspect> open = openSuspects(session);
    if (open.empty()) {
        Q_EMIT session.hinted(Review::tr("No minimum is left to decide."));
        return;
    }
    const auto count = static_cast<std::ptrdiff_t>(open.size());
    const auto selected = std::find_if(open.begin(), open.end(), [&](const Suspect& suspect) {
        return session.selection() == suspect.boundary;
    });
    const auto now = selected - open.begin();
    // From elsewhere the first step leads to the most suspicious; so it does from what is none
    // while there are any.
    const auto suspects = countSuspects(open);  // they stand first
    const auto ring = suspects > 0 ? suspects : count;
    const auto next = now < ring ? (now + direction + ring) % ring : 0;
    session.examine(open[static_cast<std::size_t>(next)].boundary);
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
    // A suspect of settings that are just being left would be gone in a moment.
    session.whenCurrent([&session, direction] { goToSuspect(session, direction); });
}

void acceptSuspect(Session& session) {
    const BoundaryMark* mark = selectedMark(session);
    if (mark == nullptr) return;
    const BoundaryRef boundary = *session.selection();
    session.whenCurrent([&session, boundary, live = mark->isLive()] {
        const auto before = countSuspects(openSuspects(session));
        if (!live) session.setBoundaryLive(boundary, true);
        session.acceptBoundary(boundary);
        goOn(session, before);
    });
}

void rejectSuspect(Session& session) {
    const BoundaryMark* mark = selectedMark(session);
    if (mark == nullptr) return;
    session.whenCurrent([&session, boundary = *session.selection(), live = mark->isLive()] {
        const auto before = countSuspects(openSuspects(session));
        if (live) session.setBoundaryLive(boundary, false);
        goOn(session, before);
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

void selectChanged(Session& session, const Project& before) {
    const Project& now = session.document().project();
    const auto take = static_cast<std::size_t>(session.take());
    if (take >= before.takes.size() || take >= now.takes.size()) return;
    std::optional<BoundaryRef> changed;
    for (int player = 0; player < session.playerCount(); ++player) {
        const auto index = static_cast<std::size_t>(player);
        if (index >= before.takes[take].fighters.size()) return;
        const auto& was = before.takes[take].fighters[index].corrections;
        const auto& is = now.takes[take].fighters[index].corrections;
        const auto lookFor = [&](const auto& some, const auto& others) {
            for (const Correction& each : some) {
                if (std::find(others.begin(), others.end(), each) != others.end()) continue;
                const bool moved = each.kind == Correction::Kind::Move;
                const BoundaryRef place{player, moved && &some == &is ? each.to : each.frame};
                if (!changed) changed = place;
                if (changed->player != player) return false;
            }
            return true;
        };
        // What holds now says best where the boundary is.
        if (!lookFor(is, was) || !lookFor(was, is)) return;
    }
    if (!changed || nearestMark(session.marks(changed->player), changed->frame, 0.5) == nullptr)
        return;
    session.select(changed);
    session.reveal(session.timeOf(*changed));
}

}  // namespace kumite::studio
