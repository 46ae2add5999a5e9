#pragma once

#include <QColor>

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

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

/// A ring by which a hand turns something about an axis.
struct StageRing {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< metres
    Eigen::Vector3d axis = Eigen::Vector3d::UnitY();   ///< unit
    double radius = 0.2;                               ///< metres

    /// A point of it, by radians.
    Eigen::Vector3d at(double angle) const {
        const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
        return centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
    }
};

/// A figure of the live view at another moment, drawn through.
struct StageGhost {
    int player = 0;
    std::vector<Eigen::Vector3f> joints;

    bool operator==(const StageGhost&) const = default;
};

/// What a live view offers to a hand, and what is marked beside it. A handle is dragged over the
/// plane through it that faces the camera.
struct StageHandles {
    std::vector<StageHandle> all;
    std::vector<StageBox> boxes;
    std::vector<Eigen::Vector3d> dots;  ///< small and not to be dragged, metres
    std::vector<StageRing> rings;
};

/// What a hand is drawing at. It ends with the button that began it, or with Esc.
struct StageDrag {
    std::optional<int> handle;
    std::optional<int> ring;
    Eigen::Vector2d begun = Eigen::Vector2d::Zero();  ///< pixels
    Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< of the ring: pixels a radian there
    bool over = false;                                ///< left by Esc while the button is held

    bool isOn() const { return (handle || ring) && !over; }
};

}  // namespace kumite::studio
