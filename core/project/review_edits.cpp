// Decisions on what detection found, and what was written about actions.

#include <algorithm>

#include "core/project/boundary_subject.h"
#include "core/project/notes.h"

namespace kumite {

using namespace detail;

namespace {

/// The index of a correction that is without effect. Throws where there is none such.
std::size_t unmatchedIndex(const Subject& subject, const Correction& correction) {
    const std::vector<Correction>& unmatched = subject.segmentation.unmatched;
    const std::vector<Correction>& all = subject.fighter.corrections;
    const auto found = std::find(all.begin(), all.end(), correction);
    if (found == all.end() ||
        std::find(unmatched.begin(), unmatched.end(), correction) == unmatched.end()) {
        throw Error(fmt::format("\"{}\" of fighter {} is no correction without a minimum.",
                                correctionText(correction), subject.player));
    }
    return static_cast<std::size_t>(found - all.begin());
}

}  // namespace

MaybeEdit acceptBoundary(const Project& project, const Analysis& analysis, FighterAddress address,
                         int frame) {
    const Subject subject(project, analysis, address);
    const Boundary& boundary = boundaryNear(subject, frame);
    if (boundary.source != BoundarySource::Detected) return std::nullopt;
    std::vector<Correction> corrections = subject.fighter.corrections;
    const int home = subject.minimum(*boundary.minimum).frame;
    corrections.push_back({Correction::Kind::Keep, home, 0, false, false});
    return withCorrections(project, address, std::move(corrections),
                           "Accept boundary " + subject.at(boundary.frame));
}

MaybeEdit withdrawAcceptance(const Project& project, const Analysis& analysis,
                             FighterAddress address, int frame) {
    const Subject subject(project, analysis, address);
    const Boundary& boundary = boundaryNear(subject, frame);
    if (boundary.source != BoundarySource::Accepted) return std::nullopt;
    std::vector<Correction> corrections = subject.fighter.corrections;
    const auto keep = correctionOf(subject, Correction::Kind::Keep, *boundary.minimum);
    corrections.erase(corrections.begin() + static_cast<std::ptrdiff_t>(*keep));
    return withCorrections(project, address, std::move(corrections),
                           "Review again boundary " + subject.at(boundary.frame));
}

MaybeEdit forgetCorrection(const Project& project, const Analysis& analysis, FighterAddress address,
                           const Correction& correction) {
    const Subject subject(project, analysis, address);
    std::vector<Correction> corrections = subject.fighter.corrections;
    const std::size_t index = unmatchedIndex(subject, correction);
    corrections.erase(corrections.begin() + static_cast<std::ptrdiff_t>(index));
    return withCorrections(project, address, std::move(corrections),
                           "Forget correction " + subject.at(correction.frame));
}

MaybeEdit addBoundaryOfCorrection(const Project& project, const Analysis& analysis,
                                  FighterAddress address, const Correction& correction) {
    const Subject subject(project, analysis, address);
    const std::size_t index = unmatchedIndex(subject, correction);
    const auto place = boundaryOf(correction);
    if (!place) {
        throw Error(fmt::format("\"{}\" leaves no boundary that could be added.",
                                correctionText(correction)));
    }
    if (*place <= 0 || *place >= subject.values.frameCount() - 1) {
        throw Error(
            fmt::format("Frame {} is not inside the take: a boundary cannot stand there.", *place));
    }
    if (standsAt(subject, *place)) {
        throw Error(fmt::format("Fighter {} has another boundary at frame {}; forget this one.",
                                subject.player, *place));
    }
    std::vector<Correction> corrections = subject.fighter.corrections;
    corrections[index] = {Correction::Kind::Add, *place, 0,
                          standsBesideAnother(subject, *place, std::nullopt), false};
    return withCorrections(project, address, std::move(corrections),
                           "Add boundary " + subject.at(*place));
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

MaybeEdit setNote(const Project& project, const Analysis& analysis, FighterAddress address,
                  int frame, const std::string& text) {
    const Subject subject(project, analysis, address);
    const Action* action = actionAt(subject.segmentation, frame);
    if (action == nullptr) {
        throw Error(fmt::format("Fighter {} has no action at frame {}.", subject.player, frame));
    }
    if (noteOf(subject.fighter.notes, subject.segmentation, *action) == text) return std::nullopt;
    Edit edit{project, (text.empty() ? "Remove note " : "Note ") + subject.at(action->peak)};
    std::vector<ActionNote>& notes = fighterAt(edit.project, address).notes;
    std::erase_if(notes, [&](const ActionNote& note) {
        return actionAt(subject.segmentation, note.frame) == action;
    });
    if (!text.empty()) {
        const auto after = std::find_if(notes.begin(), notes.end(), [&](const ActionNote& note) {
            return note.frame > action->peak;
        });
        notes.insert(after, {action->peak, text});
    }
    return edit;
}

}  // namespace kumite
