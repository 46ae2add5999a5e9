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
    std::span<const ForceMinimum> minima() const {
        return values.force ? std::span<const ForceMinimum>(values.force->minima)
                            : std::span<const ForceMinimum>();
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

/// Whether a correction other than an addition means this minimum.
bool means(const Project& project, const Subject& subject, const Correction& correction,
           int minimum) {
    return correction.kind != Correction::Kind::Add &&
           meantMinimum(subject.minima(), project.segmentation.prominence, correction.frame,
                        subject.reach) == minimum;
}

}  // namespace

MaybeEdit removeBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                         int frame) {
    const Subject subject(project, analysis, address);
    const Boundary& boundary = boundaryNear(subject, frame);
    const bool added = boundary.source == BoundarySource::Added;
    std::vector<Correction> corrections = subject.fighter.corrections;
    corrections.push_back({Correction::Kind::Remove,
                           added ? boundary.frame : subject.minimum(*boundary.minimum).frame, 0,
                           false});
    return withCorrections(project, address, std::move(corrections),
                           "Remove boundary " + subject.at(boundary.frame));
}

MaybeEdit restoreBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                          int frame) {
    const Subject subject(project, analysis, address);
    const Segmentation& segmentation = subject.segmentation;
    // Where removed boundaries stood; the nearest is meant.
    std::optional<int> place, minimum;
    const auto offer = [&](int candidate, std::optional<int> index) {
        const int distance = std::abs(candidate - frame);
        if (distance > subject.reach || (place && distance >= std::abs(*place - frame))) return;
        place = candidate;
        minimum = index;
    };
    for (const int removed : segmentation.removedAdded)
        offer(removed, {});
    for (const int index : segmentation.removedMinima) {
        offer(subject.minimum(index).frame, index);
        for (const Correction& correction : subject.fighter.corrections) {
            const bool moved = correction.kind == Correction::Kind::Move &&
                               means(project, subject, correction, index);
            if (moved) offer(correction.to, index);
        }
    }
    if (!place) {
        throw Error(fmt::format("Fighter {} has no removed boundary near frame {}.", subject.player,
                                frame));
    }
    std::vector<Correction> corrections = subject.fighter.corrections;
    std::erase_if(corrections, [&](const Correction& correction) {
        if (correction.kind != Correction::Kind::Remove) return false;
        return minimum ? means(project, subject, correction, *minimum) : correction.frame == *place;
    });
    return withCorrections(project, address, std::move(corrections),
                           "Restore boundary " + subject.at(*place));
}

MaybeEdit addBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                      int frame) {
    const Subject subject(project, analysis, address);
    const Segmentation& segmentation = subject.segmentation;
    const int last = subject.values.frameCount() - 1;
    if (frame <= 0 || frame >= last) {
        throw Error(
            fmt::format("Frame {} is not inside the take: a boundary can stand from frame 1 to {}.",
                        frame, last - 1));
    }
    const bool exists =
        std::any_of(segmentation.boundaries.begin(), segmentation.boundaries.end(),
                    [&](const Boundary& boundary) { return boundary.frame == frame; });
    if (exists) return std::nullopt;
    const bool wasRemoved =
        std::count(segmentation.removedAdded.begin(), segmentation.removedAdded.end(), frame) > 0 ||
        std::any_of(segmentation.removedMinima.begin(), segmentation.removedMinima.end(),
                    [&](int index) { return subject.minimum(index).frame == frame; });
    if (wasRemoved) return restoreBoundary(project, analysis, address, frame);

    std::vector<Correction> corrections = subject.fighter.corrections;
    corrections.push_back(
        {Correction::Kind::Add, frame, 0, standsBesideAnother(subject, frame, std::nullopt)});
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
        for (Correction& correction : corrections) {
            if (correction.kind != Correction::Kind::Add || correction.frame != boundary.frame) {
                continue;
            }
            correction.frame = to;
            correction.beside = standsBesideAnother(subject, to, boundary.frame);
        }
    } else {
        std::erase_if(corrections, [&](const Correction& correction) {
            return correction.kind == Correction::Kind::Move &&
                   means(project, subject, correction, *boundary.minimum);
        });
        const int home = subject.minimum(*boundary.minimum).frame;
        if (to != home) corrections.push_back({Correction::Kind::Move, home, to, false});
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
