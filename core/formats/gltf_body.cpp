#include "core/formats/gltf_body.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/motion/overlap.h"

namespace kumite {
namespace {

using Eigen::Vector3d;

constexpr int kSides = 10;
constexpr int kRings = 3;  // of each half ball, its pole left out
constexpr double kThinBone = 0.012;

/// Adds a capsule of which the ball round `a` hangs on one joint and that round `b` on another.
void addCapsule(BodyMesh& mesh, const Vector3d& a, const Vector3d& b, double radius, int jointOfA,
                int jointOfB) {
    const Vector3d way = b - a;
    const Vector3d along = way.norm() > 1e-9 ? Vector3d(way.normalized()) : Vector3d::UnitY();
    const Vector3d side = along.unitOrthogonal(), other = along.cross(side);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto add = [&](const Vector3d& centre, const Vector3d& normal, int joint) {
        mesh.positions.push_back((centre + radius * normal).cast<float>());
        mesh.normals.push_back(normal.cast<float>());
        mesh.joints.push_back(static_cast<std::uint16_t>(joint));
    };
    // From the pole at a over rings to the pole at b.
    add(a, -along, jointOfA);
    for (int ring = 0; ring < 2 * kRings; ++ring) {
        const bool ofA = ring < kRings;
        const int step = ofA ? ring + 1 : ring - kRings;  // a: 1 … kRings, b: 0 … kRings − 1
        const double angle = 0.5 * std::numbers::pi * step / kRings;
        const double height = ofA ? -std::cos(angle) : std::sin(angle);
        const double width = ofA ? std::sin(angle) : std::cos(angle);
        for (int k = 0; k < kSides; ++k) {
            const double turn = 2 * std::numbers::pi * k / kSides;
            const Vector3d normal =
                height * along + width * (std::cos(turn) * side + std::sin(turn) * other);
            add(ofA ? a : b, normal, ofA ? jointOfA : jointOfB);
        }
    }
    add(b, along, jointOfB);

    const auto triangle = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        mesh.triangles.insert(mesh.triangles.end(), {first + i, first + j, first + k});
    };
    const auto at = [](int ring, int k) {
        return static_cast<std::uint32_t>(1 + ring * kSides + k % kSides);
    };
    const auto lastPole = static_cast<std::uint32_t>(1 + 2 * kRings * kSides);
    for (int k = 0; k < kSides; ++k) {
        triangle(0, at(0, k + 1), at(0, k));
        for (int ring = 0; ring + 1 < 2 * kRings; ++ring) {
            triangle(at(ring, k), at(ring, k + 1), at(ring + 1, k + 1));
            triangle(at(ring, k), at(ring + 1, k + 1), at(ring + 1, k));
        }
        triangle(lastPole, at(2 * kRings - 1, k), at(2 * kRings - 1, k + 1));
    }
}

}  // namespace

BodyMesh bodyMesh(const Rig& rig) {
    BodyMesh mesh;
    const std::vector<Vector3d> rest = restPositions(rig);
    const auto at = [&](int joint) { return rest[static_cast<std::size_t>(joint)]; };
    // A joint's place follows its parent's turn.
    const auto carrier = [&](int joint) { return std::max(0, rig.joint(joint).parent); };
    std::vector<bool> covered(rig.joints.size(), false);
    for (const BodySolid& solid : bodySolids()) {
        const auto from = rig.roles[solid.from], to = rig.roles[solid.to];
        if (!from || !to || *from == *to) continue;
        addCapsule(mesh, at(*from), at(*to), solid.radius, *from, carrier(*to));
        for (int joint = *to; joint > *from; joint = rig.joint(joint).parent)
            covered[static_cast<std::size_t>(joint)] = true;
    }
    const auto neck = rig.roles[Role::Neck], head = rig.roles[Role::Head];
    if (neck && head) {
        addCapsule(mesh, at(*head), 2 * at(*head) - at(*neck), kSkullRadius, *head, *head);
        if (const auto top = endSiteOf(rig, *head)) covered[static_cast<std::size_t>(*top)] = true;
    }
    for (int joint = 1; joint < rig.jointCount(); ++joint) {
        if (covered[static_cast<std::size_t>(joint)]) continue;
        const int parent = rig.joint(joint).parent;
        addCapsule(mesh, at(parent), at(joint), kThinBone, parent, parent);
    }
    return mesh;
}

}  // namespace kumite
