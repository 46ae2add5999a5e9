// Reference frame, numbers n and principal components.
#include "core/interaction/action_parameters.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/known_answers.h"

namespace kumite {
namespace {

Eigen::Vector2d onFloor(const nlohmann::json& point) {
    return {point[0].get<double>(), point[2].get<double>()};
}

/// Three pose coordinates of a file's frame as a pose whose first three numbers they are.
LocalPose poseOf(const nlohmann::json& d) {
    LocalPose pose = LocalPose::Zero();
    for (int i = 0; i < 3; ++i)
        pose[i] = d[static_cast<std::size_t>(i)];
    return pose;
}

/// An action of the file: all of its frames, 1 Hz, so that differences are those per frame.
ActionSummary actionOf(const nlohmann::json& root, const nlohmann::json& yaw,
                       const nlohmann::json& d) {
    ActionSummary action;
    action.frames = static_cast<int>(root.size());
    action.rate = 1;
    double last = yaw[0];
    const auto sample = [&](std::size_t i) -> ActionSummary::Sample {
        last += std::remainder(yaw[i].get<double>() - last, 2 * std::numbers::pi);
        return {onFloor(root[i]), last, poseOf(d[i])};
    };
    for (std::size_t i = 0; i < root.size(); ++i) {
        const auto now = sample(i);
        if (i == 0) action.first = now;
        action.last = now;
        action.mean.root += now.root / action.frames;
        action.mean.yaw += now.yaw / action.frames;
        action.mean.pose += now.pose / action.frames;
    }
    return action;
}

class KnownReferenceFrame : public testing::TestWithParam<const char*> {};

TEST_P(KnownReferenceFrame, FrameAndNumbers) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer(GetParam());
    const auto& input = known["input"];
    const auto& expected = known["expected"];
    const GroundFrame frame =
        groundFrame(onFloor(input["com_mover"]), onFloor(input["com_opponent"]), input["yaw"][0]);
    EXPECT_NEAR((frame.origin - onFloor(expected["origin"])).norm(), 0, 1e-9);
    EXPECT_NEAR(std::sin(frame.yaw), expected["z"][0], 1e-9);
    EXPECT_NEAR(std::cos(frame.yaw), expected["z"][2], 1e-9);
    const PoseSpace space;
    const auto check = [&](const ActionSummary& action, double facing, const char* name) {
        const Eigen::VectorXd n = actionNumbers(action, frame, facing, space, 3);
        ASSERT_EQ(n.size(), 12);
        for (Eigen::Index i = 0; i < 12; ++i)
            EXPECT_NEAR(n[i], expected[name][static_cast<std::size_t>(i)], 1e-9) << name << i;
    };
    check(actionOf(input["root"], input["yaw"], input["d"]), frame.yaw, "n");
    check(actionOf(input["opponent_root"], input["opponent_yaw"], input["opponent_d"]),
          frame.yaw + std::numbers::pi, "opponent_n_q_from_own_direction");
}

INSTANTIATE_TEST_SUITE_P(Files, KnownReferenceFrame,
                         testing::Values("reference_frame_plain", "reference_frame_oblique"));

TEST(GroundFrame, OfTwoWhoStandInEachOther) {
    const GroundFrame frame = groundFrame({1, 2}, {1.01, 2}, 0.7);
    EXPECT_DOUBLE_EQ(frame.yaw, 0.7) << "the mover's heading";
    EXPECT_NEAR(groundFrame({1, 2}, {1.06, 2}, 0.7).yaw, std::numbers::pi / 2, 1e-12);
}

/// A fighter whose joints wander, at 30 Hz.
struct Wanderer {
    JointPositions positions;
    std::vector<double> heading;
    std::vector<Eigen::Vector3d> com;

    explicit Wanderer(int frames, double phase) {
        positions.frameCount = frames;
        positions.jointCount = 18;
        for (int f = 0; f < frames; ++f) {
            const double t = f / 30.0 + phase;
            heading.push_back(0.8 * t + phase);
            const Eigen::Vector3d root(std::sin(t) + phase, 0.9, std::cos(0.7 * t) + 2 * phase);
            com.push_back(root + Eigen::Vector3d(0.01, 0.1, 0.02));
            for (int j = 0; j < 18; ++j) {
                // Joint j swings with its own amplitude: three directions carry most of it.
                const double swing = (j % 3 == 0 ? 0.3 : 0.02) * std::sin((1 + j % 4) * t + j);
                const Eigen::Vector3d local(0.1 * j, 0.05 * j + swing, 0.3 * (j % 2) - swing);
                const Eigen::Vector3d p =
                    j == 0 ? root : Eigen::Vector3d(root + turned(local, heading.back()));
                for (int axis = 0; axis < 3; ++axis)
                    positions.xyz.push_back(static_cast<float>(p[axis]));
            }
        }
    }
    static Eigen::Vector3d turned(const Eigen::Vector3d& v, double yaw) {
        return withoutYaw(v, -yaw);
    }
    FighterTrack track() const {
        FighterTrack track;
        track.positions = &positions;
        for (std::size_t j = 0; j < track.joints.size(); ++j)
            track.joints[j] = static_cast<int>(j) + 1;
        track.heading = heading;
        track.com = com;
        track.rate = 30;
        return track;
    }
};

TEST(ActionNumbers, DoNotChangeWhenBothAreMovedAndTurnedTogether) {
    const Wanderer a(90, 0.3), b(90, 1.1);
    PoseMoments moments = poseMoments(a.track(), {0, 90});
    moments.add(poseMoments(b.track(), {0, 90}));
    const PoseSpace space = poseSpace(moments);
    const auto numbers = [&](double x, double z, double yaw) {
        FighterTrack mover = a.track(), opponent = b.track();
        for (FighterTrack* track : {&mover, &opponent}) {
            track->x = x;
            track->z = z;
            track->yaw = yaw;
        }
        const TransitionGround ground = transitionGround(mover, opponent, 40);
        const ActionSummary own = summarise(mover, {20, 40, 30});
        const ActionSummary other = summarise(opponent, {10, 50, 30});
        const ActionSummary next = summarise(mover, {40, 70, 55});
        Eigen::VectorXd all(38);
        all << transitionNumbers(ground.frame, own, other, &next, space, 3), *ground.target;
        return all;
    };
    const Eigen::VectorXd here = numbers(0, 0, 0);
    EXPECT_NEAR((here - numbers(3.5, -1.25, 2.4)).norm(), 0, 1e-9);
    EXPECT_NEAR((here - numbers(-7, 2, -3.0)).norm(), 0, 1e-9);
    EXPECT_GT(here.norm(), 1);
}

TEST(ActionNumbers, OfOneFrameHaveNoDifferences) {
    const Wanderer a(10, 0.3);
    const ActionSummary one = summarise(a.track(), {9, 9, 9});
    EXPECT_EQ(one.frames, 1);
    const Eigen::VectorXd n = actionNumbers(one, {}, 0, {}, 3);
    EXPECT_EQ(n.tail(6).norm(), 0);
    EXPECT_NEAR(n[0], a.track().root(9).x(), 1e-9);
    EXPECT_EQ(transitionGround(a.track(), a.track(), 9).target, std::nullopt)
        << "the take ends before the target";
}

TEST(PoseSpace, FindsTheDirectionsThatVary) {
    const Wanderer a(400, 0.2), b(300, 0.9);
    PoseMoments sum = poseMoments(a.track(), {0, 150});
    sum.add(poseMoments(a.track(), {150, 400}));
    const PoseMoments whole = poseMoments(a.track(), {0, 400});
    EXPECT_NEAR((sum.squares - whole.squares).norm(), 0, 1e-9) << "parts add up";
    sum.add(poseMoments(b.track(), {0, 300}));
    const PoseSpace space = poseSpace(sum);
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(kPoseNumbers, kPoseNumbers);
    EXPECT_NEAR((space.axes.transpose() * space.axes - identity).norm(), 0, 1e-9);
    for (int k = 1; k < kPoseNumbers; ++k)
        EXPECT_GE(space.variances[k - 1], space.variances[k]);
    EXPECT_GT(space.covered(6), 0.95);
    EXPECT_NEAR(space.covered(kPoseNumbers), 1, 1e-12);
    // The coordinates have the variances that the space says.
    double squares = 0;
    for (int f = 0; f < 400; ++f)
        squares += std::pow(space.axes.col(0).dot(a.track().pose(f) - space.mean), 2);
    for (int f = 0; f < 300; ++f)
        squares += std::pow(space.axes.col(0).dot(b.track().pose(f) - space.mean), 2);
    EXPECT_NEAR(squares / 700, space.variances[0], 1e-9);
    EXPECT_EQ(poseSpace({}).covered(3), 0);
}

}  // namespace
}  // namespace kumite
