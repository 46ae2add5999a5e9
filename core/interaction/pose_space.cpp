#include "core/interaction/pose_space.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/base/parallel.h"

namespace kumite {
namespace {

constexpr int kBlock = 1024;  ///< frames that one piece of work takes

PoseMoments momentsOfBlock(const FighterTrack& track, FrameRange frames) {
    Eigen::MatrixXd poses(kPoseNumbers, frames.size());
    for (int f = frames.begin; f < frames.end; ++f)
        poses.col(f - frames.begin) = track.pose(f);
    PoseMoments moments;
    moments.count = frames.size();
    moments.sum = poses.rowwise().sum();
    moments.squares.noalias() = poses * poses.transpose();
    return moments;
}

}  // namespace

LocalPose FighterTrack::pose(int frame) const {
    const Eigen::Vector3f root = positions->at(frame, pelvis);
    const double turn = heading[static_cast<std::size_t>(frame)];
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    LocalPose pose;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        // The same as withoutYaw, with sine and cosine once a frame.
        const Eigen::Vector3d v = (positions->at(frame, joints[j]) - root).cast<double>();
        pose.segment<3>(3 * static_cast<Eigen::Index>(j)) =
            Eigen::Vector3d(c * v.x() - s * v.z(), v.y(), s * v.x() + c * v.z());
    }
    return pose;
}

Eigen::Vector2d FighterTrack::ground(const Eigen::Vector3d& point) const {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {c * point.x() + s * point.z() + x, c * point.z() - s * point.x() + z};
}

Eigen::Vector2d FighterTrack::root(int frame) const {
    return ground(positions->at(frame, pelvis).cast<double>());
}

Eigen::Vector2d FighterTrack::comOnGround(int frame) const {
    return ground(com[static_cast<std::size_t>(frame)]);
}

int FighterTrack::frameAt(double seconds) const {
    const double frame = std::round((seconds - offset) * rate);
    return static_cast<int>(std::clamp(frame, 0.0, static_cast<double>(frameCount() - 1)));
}

void PoseMoments::add(const PoseMoments& other) {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
}

PoseMoments poseMoments(const FighterTrack& track, FrameRange frames, const Progress& progress) {
    const int blocks = (frames.size() + kBlock - 1) / kBlock;
    std::vector<PoseMoments> parts(static_cast<std::size_t>(blocks));
    forBlocks({0, blocks}, 1, [&](FrameRange block) {
        for (int b = block.begin; b < block.end; ++b) {
            progress.update(static_cast<double>(b) / blocks);
            const int begin = frames.begin + b * kBlock;
            parts[static_cast<std::size_t>(b)] =
                momentsOfBlock(track, {begin, std::min(begin + kBlock, frames.end)});
        }
    });
    PoseMoments all;
    for (const PoseMoments& part : parts)
        all.add(part);
    return all;
}

double PoseSpace::covered(int k) const {
    const double all = variances.sum();
    return all > 0 ? variances.head(k).sum() / all : 0.0;
}

PoseSpace poseSpace(const PoseMoments& moments) {
    PoseSpace space;
    if (moments.count < 1) return space;
    space.mean = moments.sum / moments.count;
    const Eigen::MatrixXd covariance =
        moments.squares / moments.count - space.mean * space.mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(covariance);
    space.variances = solved.eigenvalues().reverse().cwiseMax(0.0);
    space.axes = solved.eigenvectors().rowwise().reverse();
    for (Eigen::Index i = 0; i < kPoseNumbers; ++i) {
        Eigen::Index largest = 0;
        space.axes.col(i).cwiseAbs().maxCoeff(&largest);
        if (space.axes(largest, i) < 0) space.axes.col(i) *= -1;
    }
    return space;
}

}  // namespace kumite
