#include "core/project/boundary_subject.h"

#include <algorithm>
#include <cstdlib>

namespace kumite::detail {

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

bool standsAt(const Subject& subject, int frame) {
    return std::any_of(subject.segmentation.boundaries.begin(),
                       subject.segmentation.boundaries.end(),
                       [&](const Boundary& boundary) { return boundary.frame == frame; });
}

bool standsBesideAnother(const Subject& subject, int frame, std::optional<int> own) {
    return std::any_of(subject.segmentation.boundaries.begin(),
                       subject.segmentation.boundaries.end(), [&](const Boundary& boundary) {
                           return boundary.source != BoundarySource::End && boundary.frame != own &&
                                  std::abs(boundary.frame - frame) <= subject.reach;
                       });
}

std::optional<std::size_t> correctionOf(const Subject& subject, Correction::Kind kind,
                                        int minimum) {
    const std::vector<Correction>& corrections = subject.fighter.corrections;
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        if (corrections[i].kind == kind && subject.segmentation.meant[i] == minimum) return i;
    }
    return std::nullopt;
}

Edit withCorrections(const Project& project, FighterAddress address,
                     std::vector<Correction> corrections, std::string name) {
    Edit edit{project, std::move(name)};
    fighterAt(edit.project, address).corrections = std::move(corrections);
    return edit;
}

}  // namespace kumite::detail
