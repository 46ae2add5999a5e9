#include "studio/view3d/figure_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kumite::studio {

namespace {

/// How finely a round thing is drawn: corners of a ring, rings of a round end. Thin things take
/// few, for the number of triangles decides how long a body takes without a graphics card.
struct Fineness {
    int sides;
    int capRings;
};

Fineness finenessOf(float radius) {
    if (radius < 0.013F) return {5, 1};
    if (radius < 0.035F) return {8, 2};
    return {12, 3};
}

constexpr int kMostSides = 12;

/// A ring's plane, and the outward directions of its corners.
struct RingFrame {
    Eigen::Vector3f axis;
    int sides;
    std::array<Eigen::Vector3f, kMostSides> around;

    RingFrame(const Eigen::Vector3f& direction, int count) : axis(direction), sides(count) {
        const Eigen::Vector3f across = axis.unitOrthogonal();
        const Eigen::Vector3f over = axis.cross(across);
        for (int side = 0; side < sides; ++side) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(side) /
                                static_cast<float>(sides);
            around[static_cast<std::size_t>(side)] =
                std::cos(angle) * across + std::sin(angle) * over;
        }
    }
};

/// Joins consecutive rings of corners with triangles.
void joinRings(std::vector<int>& triangles, int first, int rings, int sides) {
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const int a = first + ring * sides + side;
            const int b = first + ring * sides + (side + 1) % sides;
            const int c = a + sides;
            const int d = b + sides;
            triangles.insert(triangles.end(), {a, b, c, b, d, c});
        }
    }
}

}  // namespace

void Mesh::clear() {
    points.clear();
    normals.clear();
    triangles.clear();
}

void Mesh::addCapsule(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float fromRadius,
                      float toRadius) {
    const Eigen::Vector3f along = to - from;
    const float length = along.norm();
    const Eigen::Vector3f axis =
        length > 1e-6F ? Eigen::Vector3f(along / length) : Eigen::Vector3f::UnitY();
    const auto [sides, capRings] = finenessOf(std::max(fromRadius, toRadius));
    const RingFrame frame(axis, sides);
    // Where the cone touches both spheres, so that the surface has no crease.
    const float slope =
        length > 1e-6F ? std::clamp((fromRadius - toRadius) / length, -0.95F, 0.95F) : 0.0F;
    const float touch = std::asin(slope);
    const float half = std::numbers::pi_v<float> / 2;
    const int first = static_cast<int>(points.size());
    const auto ring = [&](const Eigen::Vector3f& centre, float radius, float angle) {
        const float outward = std::cos(angle);
        const Eigen::Vector3f onward = std::sin(angle) * axis;
        for (int side = 0; side < frame.sides; ++side) {
            const Eigen::Vector3f normal =
                outward * frame.around[static_cast<std::size_t>(side)] + onward;
            points.push_back(centre + radius * normal);
            normals.push_back(normal);
        }
    };
    for (int i = 0; i <= capRings; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(capRings);
        ring(from, fromRadius, -half + (touch + half) * share);
    }
    for (int i = 0; i <= capRings; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(capRings);
        ring(to, toRadius, touch + (half - touch) * share);
    }
    joinRings(triangles, first, 2 * (capRings + 1), sides);
}

void Mesh::addEllipsoid(const Ellipsoid& ellipsoid) {
    constexpr int kRings = 11;
    const auto& [centre, axis, length, width] = ellipsoid;
    const RingFrame frame(axis, kMostSides);
    const int first = static_cast<int>(points.size());
    for (int i = 0; i < kRings; ++i) {
        const float angle =
            std::numbers::pi_v<float> * (static_cast<float>(i) / (kRings - 1) - 0.5F);
        for (int side = 0; side < frame.sides; ++side) {
            const Eigen::Vector3f& around = frame.around[static_cast<std::size_t>(side)];
            points.push_back(centre + width * std::cos(angle) * around +
                             length * std::sin(angle) * axis);
            normals.push_back(
                (std::cos(angle) / width * around + std::sin(angle) / length * axis).normalized());
        }
    }
    joinRings(triangles, first, kRings, kMostSides);
}

void Mesh::addArrow(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius) {
    const Eigen::Vector3f along = to - from;
    const float length = along.norm();
    const Eigen::Vector3f axis =
        length > 1e-6F ? Eigen::Vector3f(along / length) : Eigen::Vector3f::UnitY();
    const float tip = std::min(length, 6 * radius);
    addCapsule(from, to - tip * axis, radius, radius);
    const RingFrame frame(axis, kMostSides);
    const int first = static_cast<int>(points.size());
    const std::array<float, 3> radii = {0.0F, 2.6F * radius, 0.0F};
    const std::array<float, 3> back = {tip, tip, 0.0F};
    for (std::size_t i = 0; i < radii.size(); ++i) {
        for (int side = 0; side < frame.sides; ++side) {
            const Eigen::Vector3f& around = frame.around[static_cast<std::size_t>(side)];
            points.push_back(to - back[i] * axis + radii[i] * around);
            normals.push_back(i == 0 ? Eigen::Vector3f(-axis)
                                     : Eigen::Vector3f((around + 0.4F * axis).normalized()));
        }
    }
    joinRings(triangles, first, 3, kMostSides);
}

void Mesh::addThread(const std::vector<Eigen::Vector3f>& path, const std::vector<float>& radii) {
    if (path.size() < 2) return;
    constexpr int kStrands = 5;
    const int first = static_cast<int>(points.size());
    Eigen::Vector3f across = (path[1] - path[0]).unitOrthogonal();
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Eigen::Vector3f way =
            path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0];
        // Carried along from point to point, so that the thread is not wrung.
        if (way.norm() > 1e-6F) {
            const Eigen::Vector3f axis = way.normalized();
            across -= across.dot(axis) * axis;
            across = across.norm() > 1e-4F ? Eigen::Vector3f(across.normalized())
                                           : Eigen::Vector3f(axis.unitOrthogonal());
            const Eigen::Vector3f over = axis.cross(across);
            for (int strand = 0; strand < kStrands; ++strand) {
                const float angle =
                    2 * std::numbers::pi_v<float> * static_cast<float>(strand) / kStrands;
                normals.push_back(std::cos(angle) * across + std::sin(angle) * over);
                points.push_back(path[i] + radii[i] * normals.back());
            }
        } else {
            // A foot at rest: the same ring again.
            for (int strand = 0; strand < kStrands; ++strand) {
                normals.push_back(i > 0 ? normals[normals.size() - kStrands] : across);
                points.push_back(path[i] + radii[i] * normals.back());
            }
        }
        if (i == 0) continue;
        const int ring = first + static_cast<int>(i - 1) * kStrands;
        for (int strand = 0; strand < kStrands; ++strand) {
            const int a = ring + strand;
            const int b = ring + (strand + 1) % kStrands;
            triangles.insert(triangles.end(), {a, b, a + kStrands, b, b + kStrands, a + kStrands});
        }
    }
}

void Mesh::addFloorBand(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius,
                        float width, float height) {
    constexpr int kHalf = 12;
    Eigen::Vector2f along(to.x() - from.x(), to.z() - from.z());
    along = along.norm() > 1e-5F ? Eigen::Vector2f(along.normalized()) : Eigen::Vector2f::UnitX();
    const Eigen::Vector2f across(-along.y(), along.x());
    const int first = static_cast<int>(points.size());
    constexpr int kCorners = 2 * (kHalf + 1);
    for (int i = 0; i < kCorners; ++i) {
        // Half a turn about the one end, then half a turn about the other.
        const bool atTo = i <= kHalf;
        const float angle =
            std::numbers::pi_v<float> * (static_cast<float>(atTo ? i : i - 1) / kHalf - 0.5F);
        const Eigen::Vector2f out = std::cos(angle) * along + std::sin(angle) * across;
        const Eigen::Vector3f& end = atTo ? to : from;
        for (const float reach : {radius, radius + width}) {
            points.emplace_back(end.x() + reach * out.x(), height, end.z() + reach * out.y());
            normals.push_back(Eigen::Vector3f::UnitY());
        }
        const int a = first + 2 * i;
        const int b = first + 2 * ((i + 1) % kCorners);
        triangles.insert(triangles.end(), {a, a + 1, b, a + 1, b + 1, b});
    }
}

Ellipsoid headOf(const Bone& bone, const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
    const Eigen::Vector3f along = to - from;
    const float length = along.norm();
    const auto radius = static_cast<float>(bone.fromRadius);
    const Eigen::Vector3f axis =
        length > 1e-4F ? Eigen::Vector3f(along / length) : Eigen::Vector3f::UnitY();
    const float half = std::clamp(0.62F * length, 2.6F * radius, 3.4F * radius);
    return {from + 0.85F * half * axis, axis, half, 0.76F * half};
}

void buildBody(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints,
               Mesh& mesh, BodyPart part) {
    mesh.clear();
    for (const Bone& bone : bones) {
        if (part != BodyPart::Whole && bone.isLeft != (part == BodyPart::LeftLimbs)) continue;
        const Eigen::Vector3f& from = joints[static_cast<std::size_t>(bone.from)];
        const Eigen::Vector3f& to = joints[static_cast<std::size_t>(bone.to)];
        if (bone.isHead) {
            mesh.addEllipsoid(headOf(bone, from, to));
        } else {
            mesh.addCapsule(from, to, static_cast<float>(bone.fromRadius),
                            static_cast<float>(bone.toRadius));
        }
    }
}

}  // namespace kumite::studio
