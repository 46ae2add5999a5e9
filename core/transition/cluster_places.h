#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/transition/pose_clusters.h"

namespace kumite {

/// A place in the plane for each cluster, so that like poses lie near each other: classical
/// multidimensional scaling of the distances of their centres (the two directions in which these
/// vary most). Centred on the origin, the farthest at 1; one place for clusters that do not differ.
/// Deterministic. Of more than `most` clusters the others are put beside the nearest of these.
std::vector<Eigen::Vector2d> clusterPlaces(const PoseClusters& clusters, int most = 1500,
                                           const Progress& progress = {});

}  // namespace kumite
