#include "studio/timeline/snapping.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace kumite::studio {

QString snapText(SnapKind kind) {
    switch (kind) {
        case SnapKind::Minimum:
            return QCoreApplication::translate("kumite", "minimum");
        case SnapKind::Contact:
            return QCoreApplication::translate("kumite", "foot contact");
        case SnapKind::OtherFighter:
            return QCoreApplication::translate("kumite", "boundary of the other");
        case SnapKind::Playhead:
            return QCoreApplication::translate("kumite", "playhead");
    }
    return {};
}

std::optional<SnapTarget> nearestTarget(std::span<const SnapTarget> targets, double frame,
                                        double reach) {
    std::optional<SnapTarget> best;
    const auto rank = [frame](const SnapTarget& target) {
        return std::tuple(std::abs(target.frame - frame), target.kind, target.frame);
    };
    for (const SnapTarget& target : targets) {
        if (std::abs(target.frame - frame) > reach) continue;
        if (!best || rank(target) < rank(*best)) best = target;
    }
    return best;
}

DragLimits dragLimits(const std::vector<BoundaryMark>& marks, int frame, int frameCount) {
    DragLimits limits{1, std::max(1, frameCount - 2)};
    for (const BoundaryMark& mark : marks) {
        if (!mark.isLive()) continue;
        if (mark.frame < frame) limits.low = mark.frame + 1;
        if (mark.frame > frame) {
            limits.high = mark.frame - 1;
            break;
        }
    }
    return limits;
}

}  // namespace kumite::studio
