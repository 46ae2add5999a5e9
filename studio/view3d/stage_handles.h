#pragma once

#include <QColor>

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace kumite::studio {

/// A point of a made figure that a hand can drag in the 3D view.
struct StageHandle {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< metres
    bool chosen = false;
    bool pinned = false;  ///< drawn as a square: it stays where it is
};

/// A box drawn by its edges, metres.
struct StageBox {
    Eigen::Vector3d low = Eigen::Vector3d::Zero();
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
    bool strong = false;
};

/// The handles of a 3D view, and which one is dragged: over the plane through it that faces the
/// camera.
struct StageHandles {
    std::vector<StageHandle> all;
    std::vector<StageBox> boxes;
    std::optional<int> dragged;
};

}  // namespace kumite::studio
