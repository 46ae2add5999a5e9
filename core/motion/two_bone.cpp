#include "core/motion/two_bone.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace kumite {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

bool hangsBelow(const Rig& rig, int joint, int ancestor) {
    while (joint > ancestor)
        joint = rig.joint(joint).parent;
    return joint == ancestor;
}

/// Height of the middle over the line from root to end.
double heightOf(double reach, double upper, double lower) {
    const double a = (upper * upper - lower * lower + reach * reach) / (2 * reach);
    return std::sqrt(std::max(0.0, upper * upper - a * a));
}

Vector3d across(const Vector3d& vector, const Vector3d& along) {
    return vector - vector.dot(along) * along;
}

/// The turn that takes a bone in its plane to another bone in another plane; both normals are
/// square to their bones.
Quaterniond turnBetween(const Vector3d& bone, const Vector3d& normal, const Vector3d& toBone,
                        const Vector3d& toNormal) {
    const Matrix3d turn = turnWithX(toBone, toNormal) * turnWithX(bone, normal).transpose();
    return Quaterniond(turn).normalized();
}

}  // namespace

TwoBone bend(const Vector3d& root, const Vector3d& target, const Vector3d& pole, double upper,
             double lower, const Stretch& stretch) {
    const Vector3d way = target - root;
    const double wanted = std::max(1e-6, way.norm());
    const double reach =
        std::clamp(wanted, stretch.least * (upper + lower), stretch.most * (upper + lower));
    const Vector3d along = way / wanted;
    Vector3d side = pole - pole.dot(along) * along;
    if (side.norm() < 1e-6) side = along.unitOrthogonal();
    side.normalize();
    const double a = (upper * upper - lower * lower + reach * reach) / (2 * reach);
    const double height = std::sqrt(std::max(0.0, upper * upper - a * a));
    return {root + a * along + height * side, root + reach * along};
}

Matrix3d turnWithY(const Vector3d& along, const Vector3d& ahead) {
    Matrix3d turn;
    const Vector3d y = along.normalized();
    const Vector3d z = (ahead - ahead.dot(y) * y).normalized();
    turn << y.cross(z), y, z;
    return turn;
}

Matrix3d turnWithX(const Vector3d& along, const Vector3d& above) {
    Matrix3d turn;
    const Vector3d x = along.normalized();
    const Vector3d y = (above - above.dot(x) * x).normalized();
    turn << x, y, x.cross(y);
    return turn;
}

Matrix3d aboutX(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d::UnitX()).toRotationMatrix();
}
Matrix3d aboutY(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
}
Matrix3d aboutZ(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

std::optional<Limb> limbOf(const Rig& rig, Role end) {
    const auto limb = [&](Role root, Role middle) -> std::optional<Limb> {
        const auto r = rig.roles[root];
        const auto m = rig.roles[middle];
        const auto e = rig.roles[end];
        if (!r || !m || !e || *r == *m || *m == *e) return std::nullopt;
        if (!hangsBelow(rig, *e, *m) || !hangsBelow(rig, *m, *r)) return std::nullopt;
        return Limb{*r, *m, *e, end == Role::LeftAnkle || end == Role::RightAnkle};
    };
    switch (end) {
        case Role::LeftWrist:
            return limb(Role::LeftShoulder, Role::LeftElbow);
        case Role::RightWrist:
            return limb(Role::RightShoulder, Role::RightElbow);
        case Role::LeftAnkle:
            return limb(Role::LeftHip, Role::LeftKnee);
        case Role::RightAnkle:
            return limb(Role::RightHip, Role::RightKnee);
        default:
            return std::nullopt;
    }
}

Vector3d reach(const Rig& rig, Pose& pose, const JointFrames& frames, const Limb& limb,
               const Vector3d& target, EndTurn endTurn, const Stretch& stretch) {
    const auto at = [](int joint) { return static_cast<std::size_t>(joint); };
    const Vector3d root = frames.positions[at(limb.root)];
    const Vector3d middle = frames.positions[at(limb.middle)];
    const Vector3d end = frames.positions[at(limb.end)];
    const double upper = (middle - root).norm();
    const double lower = (end - middle).norm();
    const double was = (end - root).norm();
    const double wanted = (target - root).norm();
    if (upper < 1e-6 || lower < 1e-6 || was < 1e-6 || wanted < 1e-6) return end - target;
    const double length = upper + lower;
    const Stretch limits{std::min(stretch.least, was / length),
                         std::max(stretch.most, was / length)};

    const Vector3d along = (end - root) / was;
    const Vector3d toAlong = (target - root) / wanted;
    // Where a straight limb would bend to.
    const Vector3d forward = frames.turns[at(limb.root)] * rig.forward;
    Vector3d natural = across(limb.isLeg ? forward : Vector3d(-forward), along);
    if (natural.norm() < 1e-6) natural = along.unitOrthogonal();
    natural.normalize();

    const Vector3d offLine = across(middle - root, along);
    const double height = offLine.norm();
    const Vector3d pole = height > 1e-9 ? Vector3d(offLine / height) : natural;
    // A knee that the recording shows slightly overstretched must not bend that way: the more it
    // is bent beyond what is shown, the more its natural side counts. A bent limb keeps its plane.
    const double reached = std::clamp(wanted, limits.least * length, limits.most * length);
    const double straight = std::max(0.0, 1.0 - height / (0.06 * length));
    const double pull = 2.0 * std::abs(heightOf(reached, upper, lower) - height) * straight;
    Vector3d bendTo = height * pole + pull * natural;
    if (bendTo.norm() < 1e-9) bendTo = pole;
    const Vector3d toPole =
        across(Quaterniond::FromTwoVectors(along, toAlong) * bendTo, toAlong).normalized();

    const TwoBone bent = bend(root, target, toPole, upper, lower, limits);
    const Vector3d normal = along.cross(pole);
    const Vector3d toNormal = toAlong.cross(toPole);
    const Quaterniond upperTurn = turnBetween(middle - root, normal, bent.middle - root, toNormal);
    const Quaterniond lowerTurn =
        turnBetween(end - middle, normal, bent.end - bent.middle, toNormal);

    const auto turnOfParent = [&](int joint) -> Quaterniond {
        const int parent = rig.joint(joint).parent;
        return parent >= 0 ? frames.turns[at(parent)] : Quaterniond::Identity();
    };
    const auto& world = frames.turns;
    pose.turns[at(limb.root)] =
        (turnOfParent(limb.root).conjugate() * upperTurn * world[at(limb.root)]).normalized();
    pose.turns[at(limb.middle)] =
        ((upperTurn * turnOfParent(limb.middle)).conjugate() * lowerTurn * world[at(limb.middle)])
            .normalized();
    if (endTurn == EndTurn::KeepsWorld) {
        pose.turns[at(limb.end)] =
            ((lowerTurn * turnOfParent(limb.end)).conjugate() * world[at(limb.end)]).normalized();
    }
    return bent.end - target;
}

}  // namespace kumite
