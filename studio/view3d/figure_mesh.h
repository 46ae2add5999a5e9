#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/motion/roles.h"
#include "core/motion/skeleton.h"

namespace kumite::studio {

/// A part of a drawn body: a rounded cone from one joint to another, or the head's ellipsoid
/// around both. Radii in metres.
struct Bone {
    int from = 0;
    int to = 0;
    double fromRadius = 0;
    double toRadius = 0;
    bool isHead = false;
};

/// A bone from every joint to each of its children, End Sites included; as thick as its role in
/// the body says, or by its length where the skeleton has no roles. `metresPerUnit` scales the
/// skeleton's offsets.
std::vector<Bone> bonesOf(const Skeleton& skeleton, const RoleMap& roles, double metresPerUnit);

/// A triangle mesh whose corners have normals; points are metres.
struct Mesh {
    std::vector<Eigen::Vector3f> points;
    std::vector<Eigen::Vector3f> normals;
    std::vector<int> triangles;  ///< three corners each

    void clear();
    /// A cone with round ends.
    void addCapsule(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float fromRadius,
                    float toRadius);
    /// An ellipsoid that turns about `axis` (a unit vector).
    void addEllipsoid(const Eigen::Vector3f& centre, const Eigen::Vector3f& axis, float length,
                      float width);
    /// A straight arrow with a pointed head.
    void addArrow(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius);
};

/// A body's mesh at one pose: `joints` are the positions of all joints, metres. The number and
/// order of corners depend on `bones` only.
void buildBody(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints,
               Mesh& mesh);

}  // namespace kumite::studio
