#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/project/edits.h"

namespace kumite {
namespace {

/// The fighter that an edit is about, with all that the edit looks at.
struct Subject {
    const Fighter& fighter;
    const FighterAnalysis& values;
    const Segmentation& segmentation;
    double reach;
    int player;

    Subject(const Project& project, const Analysis& analysis, FighterAddress address)
        : fighter(fighterAt(project, address)),
          values(analysis.at(address)),
          segmentation(require(values)),
          reach(kCorrectionReach * fighter.rate),
          player(address.player + 1) {}

    static const Segmentation& require(const FighterAnalysis& values) {
        if (values.segmentation) return *values.segmentation;
        throw Error(values.input.recording.path.string() +
                    ": the recording is missing; its boundaries cannot be edited.");
    }

    const ForceMinimum& minimum(int index) const {
        return values.force->minima[static_cast<std::size_t>(index)];
    }
    std::string at(int frame) const {
        return fmt::format("at {:.2f} s, fighter {}", frame / fighter.rate, player);
    }
};

/// The boundary that a user means by a frame: the nearest within reach.
const Boundary& boundaryNear(const Subject& subject, int frame) {
    const std::vector<Boundary>& all = subject.segmentation.boundaries;
    const auto nearest =
        std::min_element(all.begin(), all.end(), [&](const Boundary& a, const Boundary& b) {
            return std::abs(a.frame - frame) < std::abs(b.frame - frame);
        });
    if (nearest == all.end() || std::abs(nearest->frame - frame) > subject.reach) {
        throw Error(fmt::format(
            "Fighter {} has no boundary near frame {}{}.", subject.player, frame,
            nearest == all.end() ? std::string()
                                 : fmt::format("; the nearest is at {}", nearest->frame)));
    }
    if (nearest->source == BoundarySource::End) {
        throw Error(fmt::format("The boundary at frame {} is an end of the take, which stays.",
                                nearest->frame));
    }
    return *nearest;
}

/// Whether a boundary other than `own`, not an end, stands within reach of a frame.
bool standsBesideAnother(const Subject& subject, int frame, std::optional<int> own) {
    return std::any_of(subject.segmentation.boundaries.begin(),
                       subject.segmentation.boundaries.end(), [&](const Boundary& boundary) {
                           return boundary.source != BoundarySource::End && boundary.frame != own &&
                                  std::abs(boundary.frame - frame) <= subject.reach;
                       });
}

Edit withCorrections(const Project& project, FighterAddress address,
                     std::vector<Correction> corrections, std::string name) {
    Edit edit{project, std::move(name)};
    fighterAt(edit.project, address).corrections = std::move(corrections);
    return edit;
}

/// The correction (its index) of a kind that means a minimum.
std::optional<std::size_t> correctionOf(const Subject& subject, Correction::Kind kind,
                                        int minimum) {
    const std::vector<Correction>& corrections = subject.fighter.corrections;
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        if (corrections[i].kind == kind && subject.segmentation.meant[i] == minimum) return i;
    }
    return std::nullopt;
}

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

bool standsAt(const Subject& subject, int frame) {
    return std::any_of(subject.segmentation.boundaries.begin(),
                       subject.segmentation.boundaries.end(),
                       [&](const Boundary& boundary) { return boundary.frame == frame; });
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

MaybeEdit dropUnmatchedCorrections(const Project& project, const Analysis& analysis,
                                   FighterAddress address) {
    const Subject subject(project, analysis, address);
    const std::vector<Correction>& unmatched = subject.segmentation.unmatched;
    if (unmatched.empty()) return std::nullopt;
    std::vector<Correction> corrections = subject.fighter.corrections;
    std::erase_if(corrections, [&](const Correction& correction) {
        return std::find(unmatched.begin(), unmatched.end(), correction) != unmatched.end();
    });
    return withCorrections(project, address, std::move(corrections),
                           fmt::format("Forget corrections, fighter {}", subject.player));
}

}  // namespace kumite
