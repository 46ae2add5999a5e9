#include "core/demo/body.h"

#include <Eigen/Geometry>

#include "core/motion/body_model.h"

namespace kumite::demo {
namespace {

using Eigen::Vector3d;

/// A landmark's share in the centre of mass; the head's top is number kRoleCount.
struct Share {
    int landmark;
    double weight;
};

std::vector<Share> sharesOf(const BodyModel& model) {
    std::array<double, kRoleCount + 1> weights{};
    double whole = 0;
    for (const BodySegment& segment : model.segments) {
        whole += segment.mass;
        const double toShare = segment.to ? segment.fraction : 0.0;
        for (const Role from : segment.from) {
            weights[static_cast<std::size_t>(from)] +=
                segment.mass * (1 - toShare) / static_cast<double>(segment.from.size());
        }
        if (!segment.to) continue;
        const bool isHeadTop = segment.toEndSite && *segment.to == Role::Head;
        weights[isHeadTop ? kRoleCount : static_cast<std::size_t>(*segment.to)] +=
            segment.mass * toShare;
    }
    std::vector<Share> shares;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] > 0) shares.push_back({static_cast<int>(i), weights[i] / whole});
    }
    return shares;
}

}  // namespace

Role roleOf(Side side, Part part) {
    using enum Role;
    constexpr std::array<Role, kPartsPerSide> left = {
        LeftClavicle, LeftShoulder, LeftElbow, LeftWrist, LeftHip, LeftKnee, LeftAnkle, LeftToe};
    const Role role = left[static_cast<std::size_t>(part)];
    return side == Side::Left ? role : mirrored(role);
}

Eigen::Matrix3d spineTurn(const Pose& pose, int k, int n) {
    if (k == n) return pose.chestTurn;
    const Eigen::Quaterniond from(pose.pelvisTurn);
    return from.slerp(static_cast<double>(k) / n, Eigen::Quaterniond(pose.chestTurn))
        .toRotationMatrix();
}

void placeTrunk(const BodySize& size, const Pose& pose, Landmarks& marks) {
    marks[Role::Pelvis] = pose.pelvis;
    Vector3d point = pose.pelvis;
    Eigen::Matrix3d turn = pose.pelvisTurn;
    const int n = static_cast<int>(size.spine.size());
    for (int k = 1; k <= n; ++k) {
        point += turn * Vector3d(0, size.spine[static_cast<std::size_t>(k) - 1], 0);
        turn = spineTurn(pose, k, n);
        if (k == 1) marks[Role::Spine] = point;
    }
    marks[Role::Chest] = point;
    marks[Role::Neck] = point + turn * Vector3d(0, size.chestToNeck, 0);
    marks[Role::Head] = marks[Role::Neck] + pose.neckTurn * Vector3d(0, size.neck, 0);
    marks.headTop = marks[Role::Head] + pose.headTurn * Vector3d(0, size.head, 0);
    for (const Side side : {Side::Left, Side::Right}) {
        const double x = sign(side);
        const Vector3d clavicle = point + turn * Vector3d(0.02 * x, size.clavicleRise, 0);
        marks[roleOf(side, Part::Clavicle)] = clavicle;
        marks[roleOf(side, Part::UpperArm)] =
            clavicle + pose.turn(side, Part::Clavicle) * Vector3d(size.clavicle * x, 0.02, 0);
        marks[roleOf(side, Part::Thigh)] =
            pose.pelvis + pose.pelvisTurn * Vector3d(size.hipWidth / 2 * x, -size.hipDrop, 0);
    }
}

void placeLimbs(const BodySize& size, const Pose& pose, Landmarks& marks) {
    for (const Side side : {Side::Left, Side::Right}) {
        const double x = sign(side);
        const auto mark = [&](Part part) -> Vector3d& { return marks[roleOf(side, part)]; };
        mark(Part::Forearm) = mark(Part::UpperArm) +
                              pose.turn(side, Part::UpperArm) * Vector3d(size.upperArm * x, 0, 0);
        mark(Part::Hand) =
            mark(Part::Forearm) + pose.turn(side, Part::Forearm) * Vector3d(size.forearm * x, 0, 0);
        mark(Part::Shank) =
            mark(Part::Thigh) + pose.turn(side, Part::Thigh) * Vector3d(0, -size.thigh, 0);
        mark(Part::Foot) =
            mark(Part::Shank) + pose.turn(side, Part::Shank) * Vector3d(0, -size.shank, 0);
        mark(Part::Toe) =
            mark(Part::Foot) +
            pose.turn(side, Part::Foot) * Vector3d(0, size.toeHeight - size.ankleHeight, size.foot);
    }
}

Vector3d centreOfMassOf(const Landmarks& marks) {
    static const std::vector<Share> shares = sharesOf(deLevaMale());
    Vector3d sum = Vector3d::Zero();
    for (const Share& share : shares) {
        const auto i = static_cast<std::size_t>(share.landmark);
        sum += share.weight * (share.landmark == kRoleCount ? marks.headTop : marks.at[i]);
    }
    return sum;
}

}  // namespace kumite::demo
