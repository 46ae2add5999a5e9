#include "studio/view3d/camera_controller.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kumite::studio {

namespace {
constexpr double kSteepest = std::numbers::pi / 2 - 0.001;
constexpr double kNearest = 0.2;
constexpr double kFarthest = 200.0;
}  // namespace

Eigen::Vector3d CameraController::forward() const {
    return {-std::sin(yaw_) * std::cos(pitch_), -std::sin(pitch_),
            -std::cos(yaw_) * std::cos(pitch_)};
}

Eigen::Vector3d CameraController::right() const {
    return {std::cos(yaw_), 0.0, -std::sin(yaw_)};
}

Eigen::Vector3d CameraController::up() const {
    return right().cross(forward());
}

double CameraController::metresPerPixel(double depth, const Viewport& viewport) {
    return 2 * depth * std::tan(kFieldOfView / 2) / std::max(1.0, viewport.height);
}

void CameraController::orbit(double dx, double dy, const Viewport& viewport) {
    const double radiansPerPixel = std::numbers::pi / std::max(200.0, viewport.height);
    yaw_ -= dx * radiansPerPixel;
    pitch_ = std::clamp(pitch_ + dy * radiansPerPixel, -kSteepest, kSteepest);
}

void CameraController::pan(double dx, double dy, const Viewport& viewport) {
    target_ += (-dx * right() + dy * up()) * metresPerPixel(distance_, viewport);
}

void CameraController::zoomAbout(double x, double y, double factor, const Viewport& viewport) {
    const double before = distance_;
    distance_ = std::clamp(distance_ / factor, kNearest, kFarthest);
    const double share = 1 - distance_ / before;
    const double scale = metresPerPixel(before, viewport);
    const Eigen::Vector3d offset =
        ((x - viewport.width / 2) * right() - (y - viewport.height / 2) * up()) * scale;
    target_ += share * offset;
}

void CameraController::frame(const Box& box, const Viewport& viewport) {
    if (box.empty()) return;
    target_ = box.centre();
    const double slope = std::tan(kFieldOfView / 2);
    const double aspect = viewport.width / std::max(1.0, viewport.height);
    double needed = kNearest;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d point((corner & 1) ? box.high.x() : box.low.x(),
                                    (corner & 2) ? box.high.y() : box.low.y(),
                                    (corner & 4) ? box.high.z() : box.low.z());
        const Eigen::Vector3d offset = point - target_;
        const double across = std::abs(offset.dot(right())) / (slope * aspect);
        const double along = std::abs(offset.dot(up())) / slope;
        needed = std::max(needed, std::max(across, along) - offset.dot(forward()));
    }
    distance_ = std::clamp(needed * 1.08, kNearest, kFarthest);
}

void CameraController::lookFrom(double yaw, double pitch) {
    yaw_ = yaw;
    pitch_ = std::clamp(pitch, -kSteepest, kSteepest);
}

void CameraController::standAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
    const Eigen::Vector3d way = target - position;
    distance_ = std::clamp(way.norm(), kNearest, kFarthest);
    target_ = target;
    if (way.norm() < 1e-9) return;
    const Eigen::Vector3d ahead = way.normalized();
    lookFrom(std::atan2(-ahead.x(), -ahead.z()), std::asin(std::clamp(-ahead.y(), -1.0, 1.0)));
}

Ray CameraController::rayThrough(double x, double y, const Viewport& viewport) const {
    const double scale = metresPerPixel(1.0, viewport);
    const Eigen::Vector3d way = forward() + (x - viewport.width / 2) * scale * right() -
                                (y - viewport.height / 2) * scale * up();
    return {position(), way.normalized()};
}

Eigen::Vector3d CameraController::project(const Eigen::Vector3d& point,
                                          const Viewport& viewport) const {
    const Eigen::Vector3d offset = point - position();
    const double depth = offset.dot(forward());
    const double scale = viewport.height / (2 * std::tan(kFieldOfView / 2) * std::max(1e-6, depth));
    return {viewport.width / 2 + offset.dot(right()) * scale,
            viewport.height / 2 - offset.dot(up()) * scale, depth};
}

}  // namespace kumite::studio
