#include "studio/app/boundary_marks.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace kumite::studio {

namespace {

MarkState stateOf(BoundarySource source) {
    switch (source) {
        case BoundarySource::End:
            return MarkState::End;
        case BoundarySource::Detected:
            return MarkState::Detected;
        case BoundarySource::Accepted:
            return MarkState::Accepted;
        case BoundarySource::Moved:
            return MarkState::Moved;
        case BoundarySource::Added:
            return MarkState::Added;
    }
    return MarkState::Detected;
}

}  // namespace

std::vector<BoundaryMark> boundaryMarks(const FighterAnalysis& fighter) {
    std::vector<BoundaryMark> marks;
    if (!fighter.segmentation) return marks;
    const Segmentation& segmentation = *fighter.segmentation;
    const auto suspicionOf = [&](int minimum) {
        const auto index = static_cast<std::size_t>(minimum);
        return fighter.suspicion && index < fighter.suspicion->size() ? (*fighter.suspicion)[index]
                                                                      : 0.0;
    };
    for (const Boundary& boundary : segmentation.boundaries) {
        const double suspicion = boundary.minimum ? suspicionOf(*boundary.minimum) : 0.0;
        marks.push_back({boundary.frame, stateOf(boundary.source), boundary.minimum, suspicion});
    }
    for (const RemovedBoundary& removed : segmentation.removed) {
        const double suspicion = removed.minimum ? suspicionOf(*removed.minimum) : 0.0;
        marks.push_back({removed.frame, MarkState::Removed, removed.minimum, suspicion});
    }
    std::stable_sort(marks.begin(), marks.end(), [](const auto& a, const auto& b) {
        return std::tuple(a.frame, !a.isLive()) < std::tuple(b.frame, !b.isLive());
    });
    return marks;
}

const BoundaryMark* nearestMark(const std::vector<BoundaryMark>& marks, double frame, double reach,
                                bool ends) {
    const BoundaryMark* best = nullptr;
    double bestDistance = reach;
    for (const BoundaryMark& mark : marks) {
        if (!ends && !mark.isEditable()) continue;
        const double distance = std::abs(mark.frame - frame);
        const bool nearer = best == nullptr ? distance <= reach : distance < bestDistance;
        const bool livelier =
            best != nullptr && distance == bestDistance && mark.isLive() && !best->isLive();
        if (nearer || livelier) {
            best = &mark;
            bestDistance = distance;
        }
    }
    return best;
}

}  // namespace kumite::studio
