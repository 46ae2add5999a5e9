#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/project/boundary_subject.h"

namespace kumite {

using namespace detail;

namespace {

/// The addition at a frame that is there, or that was removed.
std::optional<std::size_t> additionAt(const Subject& subject, int frame, bool removed) {
    const std::vector<Correction>& corrections = subject.fighter.corrections;
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        const Correction& correction = corrections[i];
        const bool fits = correction.kind == Correction::Kind::Add && correction.frame == frame &&
                          correction.removed == removed;
        if (fits) return i;
    }
    return std::nullopt;
}

/// Before a minimum is given back to detection: additions near it that stand for no minimum must
/// not be taken for it from now on, or one of the two boundaries would vanish.
void keepAdditionsApart(const Subject& subject, int minimumFrame,
                        std::vector<Correction>& corrections) {
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        const bool near = std::abs(corrections[i].frame - minimumFrame) <= subject.reach;
        if (corrections[i].kind == Correction::Kind::Add && near &&
            !subject.segmentation.meant[i]) {
            corrections[i].beside = true;
        }
    }
}

}  // namespace

MaybeEdit removeBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                         int frame) {
    const Subject subject(project, analysis, address);
    const Boundary& boundary = boundaryNear(subject, frame);
    std::vector<Correction> corrections = subject.fighter.corrections;
    if (boundary.source == BoundarySource::Added) {
        corrections[*additionAt(subject, boundary.frame, false)].removed = true;
    } else {
        Correction removal;
        removal.frame = subject.minimum(*boundary.minimum).frame;
        corrections.push_back(removal);
    }
    return withCorrections(project, address, std::move(corrections),
                           "Remove boundary " + subject.at(boundary.frame));
}

MaybeEdit restoreBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                          int frame) {
    const Subject subject(project, analysis, address);
    const std::vector<RemovedBoundary>& removed = subject.segmentation.removed;
    const auto nearest = std::min_element(
        removed.begin(), removed.end(), [&](const RemovedBoundary& a, const RemovedBoundary& b) {
            return std::abs(a.frame - frame) < std::abs(b.frame - frame);
        });
    if (nearest == removed.end() || std::abs(nearest->frame - frame) > subject.reach) {
        throw Error(fmt::format("Fighter {} has no removed boundary near frame {}.", subject.player,
                                frame));
    }
    if (standsAt(subject, nearest->frame)) {
        throw Error(fmt::format("Fighter {} has another boundary at frame {}; move that one first.",
                                subject.player, nearest->frame));
    }
    std::vector<Correction> corrections = subject.fighter.corrections;
    if (nearest->minimum) {
        keepAdditionsApart(subject, subject.minimum(*nearest->minimum).frame, corrections);
        const auto removal = correctionOf(subject, Correction::Kind::Remove, *nearest->minimum);
        corrections.erase(corrections.begin() + static_cast<std::ptrdiff_t>(*removal));
    } else {
        corrections[*additionAt(subject, nearest->frame, true)].removed = false;
    }
    return withCorrections(project, address, std::move(corrections),
                           "Restore boundary " + subject.at(nearest->frame));
}

MaybeEdit addBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                      int frame) {
    const Subject subject(project, analysis, address);
    const int last = subject.values.frameCount() - 1;
    if (frame <= 0 || frame >= last) {
        throw Error(
            fmt::format("Frame {} is not inside the take, whose last frame is {}: a boundary "
                        "cannot stand there.",
                        frame, last));
    }
    if (standsAt(subject, frame)) return std::nullopt;
    const std::vector<RemovedBoundary>& removed = subject.segmentation.removed;
    const bool wasRemoved =
        std::any_of(removed.begin(), removed.end(),
                    [&](const RemovedBoundary& boundary) { return boundary.frame == frame; });
    if (wasRemoved) return restoreBoundary(project, analysis, address, frame);

    std::vector<Correction> corrections = subject.fighter.corrections;
    corrections.push_back({Correction::Kind::Add, frame, 0,
                           standsBesideAnother(subject, frame, std::nullopt), false});
    return withCorrections(project, address, std::move(corrections),
                           "Add boundary " + subject.at(frame));
}

MaybeEdit moveBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                       int from, int to) {
    const Subject subject(project, analysis, address);
    const Boundary& boundary = boundaryNear(subject, from);
    if (boundary.frame == to) return std::nullopt;
    const Boundary* neighbours = &boundary;  // boundaries are in order; ends are never `boundary`
    if (to <= neighbours[-1].frame || to >= neighbours[1].frame) {
        throw Error(
            fmt::format("The boundary can move between its neighbours only: frames {} to {}.",
                        neighbours[-1].frame + 1, neighbours[1].frame - 1));
    }
    std::vector<Correction> corrections = subject.fighter.corrections;
    if (boundary.source == BoundarySource::Added) {
        Correction& addition = corrections[*additionAt(subject, boundary.frame, false)];
        addition.frame = to;
        addition.beside = standsBesideAnother(subject, to, boundary.frame);
        // What was taken away at the new place is replaced.
        if (const auto old = additionAt(subject, to, true)) {
            corrections.erase(corrections.begin() + static_cast<std::ptrdiff_t>(*old));
        }
    } else {
        const int home = subject.minimum(*boundary.minimum).frame;
        keepAdditionsApart(subject, home, corrections);
        if (const auto old = correctionOf(subject, Correction::Kind::Move, *boundary.minimum)) {
            corrections.erase(corrections.begin() + static_cast<std::ptrdiff_t>(*old));
        }
        if (to != home) corrections.push_back({Correction::Kind::Move, home, to, false, false});
    }
    return withCorrections(project, address, std::move(corrections),
                           "Move boundary " + subject.at(to));
}

}  // namespace kumite
