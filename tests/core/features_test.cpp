#include "core/labelling/features.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/labelling/distances.h"
#include "core/motion/heading.h"
#include "core/motion/role_mapping.h"
#include "tests/support/builders.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

Eigen::Vector3d point(const nlohmann::json& row) {
    return {row[0].get<double>(), row[1].get<double>(), row[2].get<double>()};
}

TEST(Features, KnownAnswersOfToyFigures) {
    KUMITE_NEEDS_DATA();
    for (const char* name : {"features_toy_on_frames", "features_toy_between_frames"}) {
        const auto known = test::knownAnswer(name);
        const auto& input = known["input"];
        // The file's yaw is wrapped; ours comes unwrapped.
        std::vector<double> yaw = input["yaw"].get<std::vector<double>>();
        for (std::size_t i = 1; i < yaw.size(); ++i)
            yaw[i] = yaw[i - 1] + std::remainder(yaw[i] - yaw[i - 1], 2 * M_PI);
        PoseStream stream;
        stream.yaw = yaw;
        stream.jointCount = static_cast<int>(input["joints"][0].size());
        stream.root = [&](int frame) { return point(input["root"][static_cast<size_t>(frame)]); };
        stream.joint = [&](int frame, int joint) {
            return point(input["joints"][static_cast<size_t>(frame)][static_cast<size_t>(joint)]);
        };
        const auto numbers =
            sampleAction(stream, input["begin"].get<int>(), input["end"].get<int>());
        const std::size_t width = 3 + 3 * static_cast<std::size_t>(stream.jointCount);
        ASSERT_EQ(numbers.size(), 10 * width);
        for (std::size_t pose = 0; pose < 10; ++pose) {
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR(numbers[pose * width + i],
                            known["expected"]["delta_x_z_yaw"][pose][i].get<double>(), 1e-9);
                for (std::size_t j = 0; 3 + 3 * j < width; ++j) {
                    EXPECT_NEAR(numbers[pose * width + 3 + 3 * j + i],
                                known["expected"]["local"][pose][j][i].get<double>(), 1e-9);
                }
            }
        }
    }
}

TEST(Features, KnownAnswersOfARecording) {
    KUMITE_NEEDS_DATA();
    for (const char* name : {"features_martial_04", "features_martial_04_on_frames"}) {
        const auto known = test::knownAnswer(name);
        const auto& input = known["input"];
        const test::KnownRecording recording(input);
        const auto& [motion, frames, space, roles] = recording;
        const Action action{input["begin"].get<int>(), input["end"].get<int>(), 0};
        const FeatureMatrix row =
            actionFeatures(*motion->skeleton, roles, forwardKinematics(*motion, frames, space),
                           headings(*motion, frames, space, roles), {&action, 1});
        ASSERT_EQ(row.cols(), 540);
        const auto& tolerance = known["tolerance"];
        for (std::size_t pose = 0; pose < 10; ++pose) {
            const float* numbers = row.data() + pose * kNumbersPerPose;
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR(numbers[i], known["expected"]["delta_x_z_yaw"][pose][i].get<double>(),
                            tolerance["delta_m"].get<double>());
                for (std::size_t j = 0; j < 17; ++j) {
                    EXPECT_NEAR(numbers[3 + 3 * j + i],
                                known["expected"]["local"][pose][j][i].get<double>(),
                                tolerance["local_m"].get<double>() * 1.01)
                        << name << " pose " << pose << " joint " << j;
                }
            }
        }
    }
}

/// A human who walks, turns and waves; placed and turned as asked, or seen in a mirror.
FeatureMatrix wavingFeatures(double x, double z, double turn, bool mirror,
                             std::vector<Action> actions = {{0, 20, 10},
                                                            {20, 41, 30},
                                                            {41, 41, 41}},
                             std::optional<Role> without = {}, Findings* findings = nullptr) {
    const auto human = test::makeHuman();
    const auto column = [&](const char* joint, int channel) {
        return human->joints[static_cast<std::size_t>(human->find(joint))].firstChannel + channel;
    };
    const double side = mirror ? -1 : 1;
    const auto motion = test::makeMotion(human, 60, 60, [&](int frame, int c) -> double {
        const double t = frame / 60.0;
        const double own = side * 40 * t;  // degrees of turning
        // Walks where it looks, in the turned and shifted frame.
        const double forward = 100 * t;
        const double sideways = side * 20 * t * t;
        const double angle = turn * M_PI / 180;
        if (c == 0) return x + std::cos(angle) * sideways + std::sin(angle) * forward;
        if (c == 1) return 92 + 3 * t;
        if (c == 2) return z + std::cos(angle) * forward - std::sin(angle) * sideways;
        if (c == 5) return turn + own;
        // Rotations about z and y change sign in a mirror, about x they do not.
        if (c == column(mirror ? "RightElbow" : "LeftElbow", 0)) return side * 70 * t;
        if (c == column(mirror ? "RightHip" : "LeftHip", 1)) return -50 * t;
        if (c == column(mirror ? "LeftShoulder" : "RightShoulder", 2)) return side * 30 * t;
        return 0.0;
    });
    const SpaceConvention space{0.01, UpAxis::Y};
    RoleMap roles = mapRoles(*human).roles;
    if (without) roles.clear(*without);
    return actionFeatures(*human, roles, forwardKinematics(*motion, motion->frames(), space),
                          headings(*motion, motion->frames(), space, roles), actions, findings);
}

TEST(Features, DoNotDependOnPlaceAndFacing) {
    const FeatureMatrix here = wavingFeatures(0, 0, 0, false);
    for (const double turn : {90.0, 179.0, -120.0}) {
        EXPECT_LT((wavingFeatures(320, -150, turn, false) - here).cwiseAbs().maxCoeff(), 2e-5);
    }
}

TEST(Features, OfAMirroredMotionAreTheMirroredFeatures) {
    const FeatureMatrix rows = wavingFeatures(0, 0, 0, false);
    const FeatureMatrix seen = wavingFeatures(0, 0, 0, true);
    EXPECT_GT((rows - seen).cwiseAbs().maxCoeff(), 0.1f);
    FeatureMatrix mirrored(rows.rows(), rows.cols());
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        mirrorFeatures({rows.row(i).data(), 540}, {mirrored.row(i).data(), 540});
    }
    EXPECT_LT((mirrored - seen).cwiseAbs().maxCoeff(), 2e-5);
}

TEST(Features, AStandingBodyWorkedOutOnPaper) {
    // One frame: every sample is the pose itself, nothing moves. makeHuman: left toe 9 cm to the
    // left, 92 cm below and 15 cm ahead of the hips.
    const FeatureMatrix row = wavingFeatures(0, 0, 0, false, {{0, 0, 0}});
    for (int pose = 0; pose < 10; ++pose) {
        const float* numbers = row.data() + pose * kNumbersPerPose;
        EXPECT_EQ(numbers[0], 0);
        EXPECT_EQ(numbers[1], 0);
        EXPECT_EQ(numbers[2], 0);
        EXPECT_NEAR(numbers[3 + 3 * 15], 0.09, 1e-6);
        EXPECT_NEAR(numbers[3 + 3 * 15 + 1], -0.92, 1e-6);
        EXPECT_NEAR(numbers[3 + 3 * 15 + 2], 0.15, 1e-6);
        EXPECT_NEAR(numbers[3 + 3 * 16], -0.09, 1e-6);
    }
}

TEST(Features, AMissingJointTakesItsParentsPlaceAndIsReported) {
    Findings findings;
    const FeatureMatrix row =
        wavingFeatures(0, 0, 0, false, {{0, 30, 0}}, Role::LeftWrist, &findings);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_NE(findings[0].text.find("left_wrist"), std::string::npos);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(row(0, 3 + 3 * 7 + i), row(0, 3 + 3 * 5 + i)) << "wrist where the elbow is";
    }
    EXPECT_THROW(wavingFeatures(0, 0, 0, false, {{0, 1, 0}}, Role::Pelvis), Error);
}

TEST(Standardiser, MeanZeroAndSpreadOneButWithoutVarianceZero) {
    FeatureMatrix rows(3, 3);
    rows << 1, 5, 0, 2, 5, 0, 3, 5, 9;
    const FeatureMatrix out = Standardiser(rows).apply(rows);
    EXPECT_NEAR(out(0, 0), -std::sqrt(1.5), 1e-6);
    EXPECT_NEAR(out(1, 0), 0, 1e-6);
    EXPECT_EQ(out(0, 1), 0);
    EXPECT_EQ(out(2, 1), 0);
    EXPECT_NEAR(out(2, 2), std::sqrt(2.0), 1e-6);
    const FeatureMatrix distances = squaredDistances(rows, rows);
    EXPECT_NEAR(distances(0, 2), 4 + 81, 1e-4);
    EXPECT_EQ(distances(1, 1), 0);
}

}  // namespace
}  // namespace kumite
