#include "studio/view3d/picking.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

std::optional<double> hitCapsule(const Ray& ray, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to, double fromRadius, double toRadius,
                                 double slack) {
    const Eigen::Vector3d along = to - from;
    const Eigen::Vector3d offset = ray.origin - from;
    const double length2 = along.squaredNorm();
    const double slant = ray.direction.dot(along);
    const double offsetAlong = offset.dot(along);
    const double offsetRay = offset.dot(ray.direction);
    // Nearest points of a line and a segment; a parallel or pointlike segment takes its begin.
    const double denominator = length2 - slant * slant;
    double share = denominator > 1e-12 * std::max(1.0, length2)
                       ? (offsetAlong - offsetRay * slant) / denominator
                       : 0.0;
    share = std::clamp(share, 0.0, 1.0);
    const Eigen::Vector3d nearest = from + share * along;
    const double depth = (nearest - ray.origin).dot(ray.direction);
    if (depth <= 0) return std::nullopt;
    const double distance = (ray.origin + depth * ray.direction - nearest).norm();
    const double radius = fromRadius + share * (toRadius - fromRadius) + slack;
    if (distance > radius) return std::nullopt;
    return depth - std::sqrt(radius * radius - distance * distance);
}

std::optional<double> hitBody(const Ray& ray, const std::vector<Bone>& bones,
                              const std::vector<Eigen::Vector3f>& joints, double slack) {
    std::optional<double> nearest;
    for (const Bone& bone : bones) {
        Eigen::Vector3d from = joints[static_cast<std::size_t>(bone.from)].cast<double>();
        Eigen::Vector3d to = joints[static_cast<std::size_t>(bone.to)].cast<double>();
        double fromRadius = bone.fromRadius;
        double toRadius = bone.toRadius;
        if (bone.isHead) {
            const Ellipsoid head = headOf(bone, from.cast<float>(), to.cast<float>());
            const Eigen::Vector3d half = ((head.length - head.width) * head.axis).cast<double>();
            from = head.centre.cast<double>() - half;
            to = head.centre.cast<double>() + half;
            fromRadius = toRadius = head.width;
        }
        const auto hit = hitCapsule(ray, from, to, fromRadius, toRadius, slack);
        if (hit && (!nearest || *hit < *nearest)) nearest = hit;
    }
    return nearest;
}

bool isNearer(const PickedJoint& a, const PickedJoint& b) {
    constexpr double kSamePlace = 3;  // pixels
    if (std::abs(a.distance - b.distance) > kSamePlace) return a.distance < b.distance;
    return a.depth < b.depth;
}

std::optional<PickedJoint> jointNear(const CameraController& camera, const Viewport& viewport,
                                     const std::vector<Eigen::Vector3f>& joints, double x, double y,
                                     double reach) {
    std::optional<PickedJoint> best;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
        const Eigen::Vector3d at = camera.project(joints[joint].cast<double>(), viewport);
        const PickedJoint here{static_cast<int>(joint), std::hypot(at.x() - x, at.y() - y), at.z()};
        if (here.depth <= 0 || here.distance > reach) continue;
        if (!best || isNearer(here, *best)) best = here;
    }
    return best;
}

}  // namespace kumite::studio
