#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "studio/view3d/figure_mesh.h"

namespace kumite::studio {

/// How much of the light from above a body keeps from the floor: a square patch of the floor,
/// kCells × kCells values row by row (x, then z), 0 = none, 255 = all. Blurred the more the higher
/// the limb, so that what touches the floor casts a dark, sharp patch.
struct FloorShadow {
    static constexpr int kCells = 64;

    Eigen::Vector2f centre = Eigen::Vector2f::Zero();  ///< x, z; metres
    float extent = 1;                                  ///< side of the square, metres
    std::vector<std::uint8_t> darkness;
};

/// `floor` is the height of the drawn floor, metres. The patch's border is empty.
void castShadow(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints,
                float floor, FloorShadow& shadow);

}  // namespace kumite::studio
