#include "core/motion/kinematics.h"

#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/motion/euler.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

using test::makeMotion;
using test::makeSkeleton;

void expectNear(const Eigen::Vector3f& actual, const Eigen::Vector3d& expected) {
    EXPECT_LT((actual.cast<double>() - expected).norm(), 1e-5)
        << actual.transpose() << " instead of " << expected.transpose();
}

// Worked out by hand: a two-bone arm along x, the root turned 90° about z, the elbow 90° about y.
TEST(ForwardKinematics, ArmByHand) {
    const auto arm = makeSkeleton({{"root", -1, {0, 0, 0}, "XYZzxy"},
                                   {"elbow", 0, {2, 0, 0}, "y"},
                                   {"hand", 1, {1, 0, 0}, ""}});
    const auto motion = makeMotion(arm, 1, 30, [](int, int column) {
        return std::vector<double>{10, 20, 30, 90, 0, 0, 90}[static_cast<std::size_t>(column)];
    });
    const JointPositions positions = forwardKinematics(*motion, motion->frames(), {1.0, UpAxis::Y});
    expectNear(positions.at(0, 0), {10, 20, 30});
    expectNear(positions.at(0, 1), {10, 22, 30});  // x turned into y
    expectNear(positions.at(0, 2), {10, 22, 29});  // the elbow's y-turn takes its x into −z
}

TEST(ForwardKinematics, ChannelOrderIsMatrixOrder) {
    // Zrotation then Xrotation means R = Rz · Rx: Rx takes y to z, Rz leaves z alone.
    const auto zx = makeSkeleton({{"root", -1, {0, 0, 0}, "zx"}, {"tip", 0, {0, 1, 0}, ""}});
    const auto xz = makeSkeleton({{"root", -1, {0, 0, 0}, "xz"}, {"tip", 0, {0, 1, 0}, ""}});
    const auto quarter = [](int, int) { return 90.0; };
    const SpaceConvention metres{1.0, UpAxis::Y};
    expectNear(forwardKinematics(*makeMotion(zx, 1, 30, quarter), {0, 1}, metres).at(0, 1),
               {0, 0, 1});
    // R = Rx · Rz: Rz takes y to −x, Rx leaves x alone.
    expectNear(forwardKinematics(*makeMotion(xz, 1, 30, quarter), {0, 1}, metres).at(0, 1),
               {-1, 0, 0});
}

TEST(ForwardKinematics, PositionChannelsReplaceTheOffset) {
    const auto skeleton = makeSkeleton({{"root", -1, {5, 6, 7}, "Y"}, {"tip", 0, {1, 2, 3}, "Xz"}});
    const auto motion = makeMotion(skeleton, 1, 30, [](int, int column) {
        return std::vector<double>{60, 10, 0}[static_cast<std::size_t>(column)];
    });
    const auto positions = forwardKinematics(*motion, {0, 1}, {1.0, UpAxis::Y});
    expectNear(positions.at(0, 0), {5, 60, 7});
    expectNear(positions.at(0, 1), {15, 62, 10});
}

TEST(ForwardKinematics, UnitsAndUpAxis) {
    const auto point = makeSkeleton({{"root", -1, {0, 0, 0}, "XYZ"}});
    const auto motion =
        makeMotion(point, 1, 30, [](int, int column) { return 100.0 * (column + 1); });
    expectNear(forwardKinematics(*motion, {0, 1}, {0.01, UpAxis::Y}).at(0, 0), {1, 2, 3});
    expectNear(forwardKinematics(*motion, {0, 1}, {0.01, UpAxis::Z}).at(0, 0), {1, 3, -2});
}

TEST(ForwardKinematics, RotationFrame) {
    // In a frame turned 90° about z, the channel's x axis is the world's y axis.
    auto skeleton = std::make_shared<Skeleton>(
        *makeSkeleton({{"root", -1, {0, 0, 0}, "x"}, {"tip", 0, {1, 0, 0}, ""}}));
    skeleton->joints[0].rotationFrame = axisRotation(2, 90);
    const auto motion = makeMotion(skeleton, 1, 30, [](int, int) { return 90.0; });
    expectNear(forwardKinematics(*motion, {0, 1}, {1.0, UpAxis::Y}).at(0, 1), {0, 0, -1});
    EXPECT_LT((localRotation(skeleton->joints[0], motion->frame(0)) - axisRotation(1, 90)).norm(),
              1e-12);
}

// Independent route: quaternions up the chain from each joint, on random skeletons.
TEST(ForwardKinematics, AgreesWithQuaternionsUpTheChain) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-400, 400), length(-1, 1);
    const std::vector<std::string> orders = {"xyz", "zxy", "yx", "z", "zyx", "xzy", "yxz"};
    for (int round = 0; round < 20; ++round) {
        std::vector<test::JointSpec> specs = {{"0", -1, {0, 0, 0}, "XYZzxy"}};
        for (int j = 1; j < 12; ++j) {
            specs.push_back({std::to_string(j),
                             static_cast<int>(random() % static_cast<unsigned>(j)),
                             {length(random), length(random), length(random)},
                             orders[random() % orders.size()]});
        }
        const auto skeleton = makeSkeleton(specs);
        const auto motion = makeMotion(skeleton, 5, 30, [&](int, int) { return angle(random); });
        const auto positions = forwardKinematics(*motion, {1, 4}, {1.0, UpAxis::Y});
        ASSERT_EQ(positions.frameCount, 3);
        for (int frame = 1; frame < 4; ++frame) {
            const auto row = motion->frame(frame);
            for (int j = 0; j < skeleton->jointCount(); ++j) {
                Eigen::Vector3d point = Eigen::Vector3d::Zero();
                for (int up = j; up >= 0;
                     up = skeleton->joints[static_cast<std::size_t>(up)].parent) {
                    const Joint& joint = skeleton->joints[static_cast<std::size_t>(up)];
                    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
                    Eigen::Vector3d offset = joint.offset;
                    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
                        const double value = row[static_cast<std::size_t>(joint.firstChannel) + c];
                        const int axis = axisOf(joint.channels[c]);
                        if (isRotation(joint.channels[c])) {
                            turn = turn * Eigen::AngleAxisd(value * M_PI / 180,
                                                            Eigen::Vector3d::Unit(axis));
                        } else {
                            offset[axis] = value;
                        }
                    }
                    if (up != j) point = turn * point;
                    point += offset;
                }
                EXPECT_LT((positions.at(frame - 1, j).cast<double>() - point).norm(), 1e-4);
            }
        }
    }
}

TEST(ForwardKinematics, CanBeCancelled) {
    const auto motion = makeMotion(makeSkeleton({{"root", -1, {0, 0, 0}, "XYZ"}}), 5000, 60,
                                   [](int, int) { return 0.0; });
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(forwardKinematics(*motion, motion->frames(), {}, {{}, stop.get_token()}),
                 Cancelled);
}

TEST(EulerAngles, EveryOrderComesBack) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-180, 180);
    const std::vector<std::array<int, 3>> orders = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const auto& order : orders) {
        for (int i = 0; i < 200; ++i) {
            std::array<double, 3> was = {angle(random), angle(random), angle(random)};
            if (i % 10 == 0) was[1] = i % 20 == 0 ? 90 : -90;  // gimbal lock
            const Eigen::Matrix3d rotation = axisRotation(order[0], was[0]) *
                                             axisRotation(order[1], was[1]) *
                                             axisRotation(order[2], was[2]);
            const auto found = eulerAngles(rotation, order, was);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(found[k], was[k], 1e-4) << "the triple nearest to what was";
            }
        }
    }
}

TEST(EulerAngles, StaysContinuousOverFullTurns) {
    std::array<double, 3> before{};
    for (int degrees = 0; degrees <= 1000; degrees += 5) {
        before = eulerAngles(axisRotation(1, degrees), {2, 0, 1}, before);
        EXPECT_NEAR(before[2], degrees, 1e-6);
    }
}

TEST(Motion, ValidationNamesWhatIsWrong) {
    Motion motion = *makeMotion(makeSkeleton({{"root", -1, {0, 0, 0}, "XYZ"}}), 2, 60,
                                [](int, int) { return 0.0; });
    motion.channels.pop_back();
    EXPECT_THROW(motion.validate(), Error);
    motion.channels.push_back(std::nan(""));
    EXPECT_THROW(motion.validate(), Error);
    motion.channels.back() = 0;
    motion.frameTime = 0;
    EXPECT_THROW(motion.validate(), Error);
}

TEST(RateOf, BringsRoundedHeadersToTheRateTheyMean) {
    EXPECT_EQ(rateOf(.0083333), 120.0);
    EXPECT_EQ(rateOf(0.008333), 120.0);
    EXPECT_EQ(rateOf(0.033333), 30.0);
    EXPECT_EQ(rateOf(0.0416667), 24.0);
    EXPECT_EQ(rateOf(0.033366), 30.0 / 1.001);
    EXPECT_EQ(rateOf(0.001), 1000.0);
    EXPECT_DOUBLE_EQ(rateOf(1.0 / 47.3), 47.3);
}

}  // namespace
}  // namespace kumite
