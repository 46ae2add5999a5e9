#pragma once

#include <vector>

#include <Eigen/Core>

#include "studio/view3d/bones.h"

namespace kumite::studio {

/// A body that turns about `axis` (a unit vector): half `length` along it, half `width` across.
struct Ellipsoid {
    Eigen::Vector3f centre;
    Eigen::Vector3f axis;
    float length = 0;
    float width = 0;
};

/// What is drawn for a bone that is a head, metres.
Ellipsoid headOf(const Bone& bone, const Eigen::Vector3f& from, const Eigen::Vector3f& to);

/// A triangle mesh whose corners have normals; points are metres.
struct Mesh {
    std::vector<Eigen::Vector3f> points;
    std::vector<Eigen::Vector3f> normals;
    std::vector<int> triangles;  ///< three corners each

    void clear();
    /// A cone with round ends.
    void addCapsule(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float fromRadius,
                    float toRadius);
    void addEllipsoid(const Ellipsoid& ellipsoid);
    /// A straight arrow with a pointed head.
    void addArrow(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius);
    /// A thread along a path, of two points or more, as thick at each as `radii` says.
    void addThread(const std::vector<Eigen::Vector3f>& path, const std::vector<float>& radii);
    /// A flat band on the floor, `width` wide, around all that is within `radius` of the line
    /// between the places of `from` and `to` on the floor; `height` is the floor's.
    void addFloorBand(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius,
                      float width, float height);
};

/// What is built of a body.
enum class BodyPart { Whole, LeftLimbs, AllButLeftLimbs };

/// A body's mesh at one pose: `joints` are the positions of all joints, metres. The number and
/// order of corners depend on `bones` and `part` only.
void buildBody(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints,
               Mesh& mesh, BodyPart part = BodyPart::Whole);

}  // namespace kumite::studio
