#pragma once

#include <Eigen/Core>

namespace kumite::studio {

/// An axis-aligned box in the bout's space, metres.
struct Box {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e30);
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e30);

    bool empty() const { return low.x() > high.x(); }
    void add(const Eigen::Vector3d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    Eigen::Vector3d centre() const { return 0.5 * (low + high); }
};

/// Size of the picture in logical pixels, and a point in it: x to the right, y down.
struct Viewport {
    double width = 1;
    double height = 1;
};

/// A half line: `direction` has length 1.
struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
};

/// A camera that turns about a point: what the mouse and the view keys change. y is up, angles in
/// radians, distances in metres. Knows nothing of the drawing.
class CameraController {
public:
    static constexpr double kFieldOfView = 0.52;  ///< vertical

    /// A drag of dx, dy pixels turns the camera about its target.
    void orbit(double dx, double dy, const Viewport& viewport);
    /// A drag of dx, dy pixels moves what lies at the target by just as much on the screen.
    void pan(double dx, double dy, const Viewport& viewport);
    /// Comes nearer by `factor` > 1; the point under (x, y) at the target's depth stays there.
    void zoomAbout(double x, double y, double factor, const Viewport& viewport);
    /// Keeps the direction and moves so that the box fills the picture.
    void frame(const Box& box, const Viewport& viewport);
    /// Looks along a direction; yaw 0 looks from +z toward -z, pitch is downward.
    void lookFrom(double yaw, double pitch);
    /// Stands at a point and looks at another.
    void standAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target);
    /// Moves without turning.
    void move(const Eigen::Vector3d& way) { target_ += way; }

    Eigen::Vector3d target() const { return target_; }
    Eigen::Vector3d position() const { return target_ - distance_ * forward(); }
    Eigen::Vector3d forward() const;
    Eigen::Vector3d right() const;
    Eigen::Vector3d up() const;
    double distance() const { return distance_; }

    /// Where a point appears in the picture, pixels; z is the depth in metres, negative behind.
    Eigen::Vector3d project(const Eigen::Vector3d& point, const Viewport& viewport) const;
    /// All that appears at a point of the picture, seen from the camera.
    Ray rayThrough(double x, double y, const Viewport& viewport) const;
    /// How long a pixel is at a depth, metres.
    static double metresPerPixel(double depth, const Viewport& viewport);

private:
    Eigen::Vector3d target_ = {0.0, 0.9, 0.0};
    double distance_ = 6.0;
    double yaw_ = 0.6;
    double pitch_ = 0.22;
};

}  // namespace kumite::studio
