#include "core/segmentation/centre_of_mass.h"

#include <algorithm>

#include "core/motion/role_topology.h"

namespace kumite {
namespace {

/// A point's share in the sum Σ mᵢ rᵢ: every segment's centre is a weighted mean of joints, so
/// the whole sum is one weight per joint.
void addSegment(const BodySegment& segment, const Skeleton& skeleton, const RoleMap& roles,
                std::vector<double>& weights) {
    std::optional<int> to = segment.to ? roles[*segment.to] : std::nullopt;
    double toShare = to ? segment.fraction : 0.0;
    if (to && segment.toEndSite && !skeleton.joints[static_cast<std::size_t>(*to)].isEndSite) {
        const auto end = endSiteOf(skeleton, *to);
        if (!end) toShare = 1.0;
        to = end ? end : to;
    }
    for (const Role role : segment.from) {
        weights[static_cast<std::size_t>(*roles[role])] +=
            segment.mass * (1.0 - toShare) / static_cast<double>(segment.from.size());
    }
    if (to) weights[static_cast<std::size_t>(*to)] += segment.mass * toShare;
}

bool isComplete(const BodySegment& segment, const RoleMap& roles) {
    const bool hasFrom = std::all_of(segment.from.begin(), segment.from.end(),
                                     [&](Role role) { return roles.has(role); });
    return hasFrom && (!segment.to || segment.toOptional || roles.has(*segment.to));
}

}  // namespace

CentreOfMass centreOfMass(const BodyModel& model, const Skeleton& skeleton, const RoleMap& roles,
                          const JointPositions& positions) {
    CentreOfMass result;
    std::vector<double> weights(skeleton.joints.size(), 0.0);
    double present = 0;
    double whole = 0;
    for (const BodySegment& segment : model.segments) {
        whole += segment.mass;
        if (!isComplete(segment, roles)) {
            result.missingSegments.push_back(segment.name);
            continue;
        }
        addSegment(segment, skeleton, roles, weights);
        present += segment.mass;
    }
    if (present <= 0) return result;
    result.massCoverage = present / whole;

    std::vector<std::pair<int, double>> points;
    for (std::size_t joint = 0; joint < weights.size(); ++joint) {
        if (weights[joint] != 0)
            points.emplace_back(static_cast<int>(joint), weights[joint] / present);
    }
    result.position.assign(static_cast<std::size_t>(positions.frameCount), Eigen::Vector3d::Zero());
    for (int frame = 0; frame < positions.frameCount; ++frame) {
        Eigen::Vector3d& com = result.position[static_cast<std::size_t>(frame)];
        for (const auto& [joint, weight] : points) {
            com += weight * positions.at(frame, joint).cast<double>();
        }
    }
    return result;
}

}  // namespace kumite
