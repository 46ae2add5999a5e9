#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "studio/view3d/camera_controller.h"
#include "studio/view3d/figure_mesh.h"

namespace kumite::studio {

/// How far along a ray (metres) it comes nearest to a capsule, if it hits it: the segment from
/// `from` to `to`, as thick as the radius between both ends says. `slack` (metres) widens it.
std::optional<double> hitCapsule(const Ray& ray, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to, double fromRadius, double toRadius,
                                 double slack = 0);

/// The nearest hit of a drawn body; `joints` are the positions of all joints, metres.
std::optional<double> hitBody(const Ray& ray, const std::vector<Bone>& bones,
                              const std::vector<Eigen::Vector3f>& joints, double slack = 0);

/// The joint whose picture is nearest to a point of the picture, if within `reach` pixels; of
/// joints behind one another the one in front.
struct PickedJoint {
    int joint = 0;
    double distance = 0;  ///< pixels
    double depth = 0;     ///< metres
};
std::optional<PickedJoint> jointNear(const CameraController& camera, const Viewport& viewport,
                                     const std::vector<Eigen::Vector3f>& joints, double x, double y,
                                     double reach);
/// Whether a is the better answer to a click than b.
bool isNearer(const PickedJoint& a, const PickedJoint& b);

}  // namespace kumite::studio
