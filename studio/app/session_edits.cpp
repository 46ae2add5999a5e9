// The edits that a session makes on behalf of all views.

#include "studio/app/session.h"
#include "studio/app/words.h"

namespace kumite::studio {

void Session::whenCurrent(const std::function<void()>& act) {
    if (document_.isCurrent()) {
        act();
        return;
    }
    document_.whenCurrent([this, act, take = takeName_] {
        if (takeName_ == take) {
            Q_EMIT hinted({});
            act();
        } else {
            Q_EMIT hinted(tr("The edit that waited was dropped: another take is shown."));
        }
    });
    Q_EMIT hinted(tr("The edit waits until the force curves are computed."));
}

void Session::setBoundaryLive(const BoundaryRef& boundary, bool live) {
    whenCurrent([this, boundary, live] {
        document_.apply([&](const Project& project, const Analysis& analysis) {
            const FighterAddress at = address(boundary.player);
            return live ? restoreBoundary(project, analysis, at, boundary.frame)
                        : removeBoundary(project, analysis, at, boundary.frame);
        });
    });
}

void Session::toggleBoundary(const BoundaryRef& boundary) {
    const BoundaryMark* mark = nearestMark(marks(boundary.player), boundary.frame, 0.5);
    if (mark == nullptr) return;
    const bool live = mark->isLive();
    select(boundary);
    setBoundaryLive(boundary, !live);
}

std::optional<BoundaryRef> Session::currentBoundary() {
    if (selection_) return selection_;
    const FighterAnalysis* found = fighter(activePlayer_);
    if (found == nullptr) return std::nullopt;
    const BoundaryMark* mark = nearestMark(marks(activePlayer_), shownFrame(activePlayer_),
                                           kCorrectionReach * found->input.rate);
    if (mark == nullptr) {
        Q_EMIT hinted(tr("No boundary of %1 lies within 0.1 s of the playhead.")
                          .arg(fighterText(activePlayer_)));
        return std::nullopt;
    }
    return BoundaryRef{activePlayer_, mark->frame};
}

void Session::toggleCurrentBoundary() {
    if (const auto boundary = currentBoundary()) toggleBoundary(*boundary);
}

void Session::addBoundaryAtPlayhead() {
    if (fighter(activePlayer_) == nullptr) return;
    const BoundaryRef boundary{activePlayer_, shownFrame(activePlayer_)};
    whenCurrent([this, boundary] {
        const bool added = document_.apply([&](const Project& project, const Analysis& analysis) {
            return addBoundary(project, analysis, address(boundary.player), boundary.frame);
        });
        if (added) select(boundary);
    });
}

void Session::moveBoundary(const BoundaryRef& boundary, int toFrame) {
    whenCurrent([this, boundary, toFrame] {
        const bool moved = document_.apply([&](const Project& project, const Analysis& analysis) {
            return kumite::moveBoundary(project, analysis, address(boundary.player), boundary.frame,
                                        toFrame);
        });
        if (moved) goTo({boundary.player, toFrame});
    });
}

void Session::mergeAction(int direction) {
    const auto current = currentAction();
    const Action* action = current ? actionOf(*current) : nullptr;
    if (action == nullptr) return;
    const BoundaryRef border{current->player, direction < 0 ? action->begin : action->end};
    const BoundaryMark* mark = nearestMark(marks(border.player), border.frame, 0.5);
    if (mark == nullptr) {
        Q_EMIT hinted(direction < 0 ? tr("This is the first action: nothing comes before it.")
                                    : tr("This is the last action: nothing comes after it."));
        return;
    }
    // The joined action stays the chosen one, so that the key can be pressed again.
    const bool chosen = selectedAction_.has_value();
    const int frame = action->begin + (action->end - action->begin) / 2;
    if (!chosen) select(border);
    whenCurrent([this, border, chosen, frame] {
        setBoundaryLive(border, false);
        if (chosen) selectAction(actionAt(border.player, frame));
    });
}

void Session::nudgeBoundary(int frames) {
    const auto boundary = currentBoundary();
    if (!boundary) return;
    const BoundaryMark* mark = nearestMark(marks(boundary->player), boundary->frame, 0.5);
    if (mark == nullptr || !mark->isLive()) {
        Q_EMIT hinted(tr("A removed boundary does not move. Del restores it."));
        return;
    }
    moveBoundary(*boundary, boundary->frame + frames);
}

void Session::acceptBoundary(const BoundaryRef& boundary) {
    whenCurrent([this, boundary] {
        document_.apply([&](const Project& project, const Analysis& analysis) {
            return kumite::acceptBoundary(project, analysis, address(boundary.player),
                                          boundary.frame);
        });
    });
}

void Session::withdrawAcceptance(const BoundaryRef& boundary) {
    whenCurrent([this, boundary] {
        document_.apply([&](const Project& project, const Analysis& analysis) {
            return kumite::withdrawAcceptance(project, analysis, address(boundary.player),
                                              boundary.frame);
        });
    });
}

void Session::setNote(const ActionRef& action, const QString& text) {
    whenCurrent([this, action, text = text.trimmed().toStdString()] {
        document_.apply([&](const Project& project, const Analysis& analysis) {
            return kumite::setNote(project, analysis, address(action.player), action.peak, text);
        });
    });
}

}  // namespace kumite::studio
