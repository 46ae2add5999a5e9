#include "core/motion/survey.h"

#include <gtest/gtest.h>

#include "tests/support/builders.h"

namespace kumite {
namespace {

using test::makeHuman;
using test::makeMotion;

/// The human scaled to another unit and, on request, standing along z.
std::shared_ptr<const Skeleton> humanIn(double unitsPerCentimetre, bool zUp = false) {
    auto skeleton = std::make_shared<Skeleton>(*makeHuman());
    for (Joint& joint : skeleton->joints) {
        joint.offset *= unitsPerCentimetre;
        if (zUp)
            joint.offset = Eigen::Vector3d(joint.offset.x(), -joint.offset.z(), joint.offset.y());
    }
    return skeleton;
}

std::shared_ptr<const Motion> standing(std::shared_ptr<const Skeleton> skeleton, int frames = 30) {
    return makeMotion(std::move(skeleton), frames, 60, [](int, int) { return 0.0; });
}

TEST(Survey, FindsTheUnitByTheLegs) {
    const std::vector<std::pair<std::string, double>> units = {
        {"m", 1.0},       {"dm", 0.1},      {"cm", 0.01},          {"mm", 0.001},
        {"inch", 0.0254}, {"foot", 0.3048}, {"cmu", 0.0254 / 0.45}};
    for (const auto& [name, metres] : units) {
        const Survey survey = surveyMotion(*standing(humanIn(0.01 / metres)));
        EXPECT_EQ(survey.unitName, name);
        EXPECT_NEAR(survey.legLength, 0.84, 1e-6);
        EXPECT_TRUE(survey.findings.empty()) << survey.findings.front().text;
        EXPECT_EQ(metresPerUnitFromName(name), metres);
    }
}

TEST(Survey, ADoubtfulUnitIsReportedAndCanBeOverridden) {
    SurveyOverrides overrides;
    overrides.metresPerUnit = 0.0127;
    const Survey survey = surveyMotion(*standing(humanIn(1.0)), overrides);
    EXPECT_EQ(survey.space.metresPerUnit, 0.0127);
    EXPECT_EQ(survey.unitName, "0.0127 m");
    EXPECT_TRUE(survey.findings.empty()) << "1.07 m is long, but may be";
    overrides.metresPerUnit = 0.1;
    EXPECT_EQ(surveyMotion(*standing(humanIn(1.0)), overrides).findings.size(), 1u);
    EXPECT_EQ(metresPerUnitFromName("-1"), std::nullopt);
    EXPECT_EQ(metresPerUnitFromName("yard"), std::nullopt);
    EXPECT_EQ(metresPerUnitFromName("0.0127"), 0.0127);
}

TEST(Survey, FindsTheUpAxis) {
    EXPECT_EQ(surveyMotion(*standing(humanIn(1.0))).space.up, UpAxis::Y);
    EXPECT_EQ(surveyMotion(*standing(humanIn(1.0, true))).space.up, UpAxis::Z);
    SurveyOverrides overrides;
    overrides.up = UpAxis::Z;
    EXPECT_EQ(surveyMotion(*standing(humanIn(1.0)), overrides).space.up, UpAxis::Z);
}

TEST(Survey, RateOfTheHeaderOrAsSaid) {
    EXPECT_EQ(surveyMotion(*standing(humanIn(1.0))).rate, 60.0);
    SurveyOverrides overrides;
    overrides.rate = 50.0;
    EXPECT_EQ(surveyMotion(*standing(humanIn(1.0)), overrides).rate, 50.0);
}

/// `rest` frames at rest, then arms and legs bent and moving gently.
std::shared_ptr<const Motion> restThenMotion(int rest) {
    return makeMotion(makeHuman(), 200, 60, [rest](int frame, int column) {
        if (column < 3 || frame < rest) return 0.0;
        return 25.0 * std::sin(column) + 5.0 * std::sin(0.05 * frame + column);
    });
}

TEST(Survey, FindsALeadingRestPose) {
    EXPECT_EQ(surveyMotion(*restThenMotion(1)).leadingRestFrames, 1);
    EXPECT_EQ(surveyMotion(*restThenMotion(40)).leadingRestFrames, 40);
}

TEST(Survey, FindsARestPoseThatLastsLong) {
    const auto longRest = makeMotion(makeHuman(), 900, 60, [](int frame, int column) {
        if (column < 3 || frame < 700) return 0.0;
        return 25.0 * std::sin(column) + 5.0 * std::sin(0.05 * frame + column);
    });
    EXPECT_EQ(surveyMotion(*longRest).leadingRestFrames, 700);
}

/// The human below a helper joint that turns everything: z up, facing sideways. The jump is
/// smeared over some frames, as filtered data has it, so only the pose tells.
TEST(Survey, FindsARestPoseBelowATurnedHelperJoint) {
    Skeleton skeleton = *makeHuman();
    for (Joint& joint : skeleton.joints) {
        joint.parent += 1;
        joint.firstChannel += 2;
    }
    Joint helper;
    helper.name = "Armature";
    helper.channels = {Channel::Xrotation, Channel::Yrotation};
    skeleton.joints.insert(skeleton.joints.begin(), helper);
    skeleton.channelCount += 2;
    const auto motion =
        makeMotion(std::make_shared<Skeleton>(skeleton), 200, 60, [](int frame, int column) {
            if (column < 2) return column == 0 ? 90.0 : 40.0;
            if (column < 5) return 0.0;
            const double ramp = 1 - std::exp(-0.5 * frame);
            return ramp * 45.0 * std::sin(column + 0.01 * frame);
        });
    const Survey survey = surveyMotion(*motion);
    EXPECT_EQ(survey.leadingRestFrames, 1);
    EXPECT_EQ(survey.space.up, UpAxis::Z);
}

TEST(Survey, BonesMayStandInPositionChannels) {
    // Every offset is a position channel; the OFFSET lines are zero.
    Skeleton skeleton = *makeHuman();
    std::vector<double> row;
    skeleton.channelCount = 0;
    for (Joint& joint : skeleton.joints) {
        joint.firstChannel = skeleton.channelCount;
        if (joint.isEndSite) continue;
        joint.channels = {Channel::Xposition, Channel::Yposition, Channel::Zposition,
                          Channel::Zrotation, Channel::Xrotation, Channel::Yrotation};
        for (int axis = 0; axis < 3; ++axis)
            row.push_back(0.01 * joint.offset[axis]);
        row.insert(row.end(), 3, 0.0);
        joint.offset.setZero();
        skeleton.channelCount += 6;
    }
    const auto motion =
        makeMotion(std::make_shared<Skeleton>(skeleton), 10, 60,
                   [&](int, int column) { return row[static_cast<std::size_t>(column)]; });
    EXPECT_EQ(surveyMotion(*motion).unitName, "m");
}

TEST(Survey, MotionFromTheFirstFrameIsNotTakenForARestPose) {
    EXPECT_EQ(surveyMotion(*restThenMotion(0)).leadingRestFrames, 0);
    EXPECT_EQ(surveyMotion(*standing(makeHuman())).leadingRestFrames, 0);
    for (int frames = 1; frames < 6; ++frames) {
        EXPECT_EQ(surveyMotion(*standing(makeHuman(), frames)).leadingRestFrames, 0);
    }
    // A quick start that slows down, as filtered data begins: no jump from a rest pose.
    const auto decaying = makeMotion(makeHuman(), 200, 60, [](int frame, int column) {
        return column < 3 ? 0.0 : 60.0 * std::sin(column) * std::exp(-0.4 * frame) + 20.0;
    });
    EXPECT_EQ(surveyMotion(*decaying).leadingRestFrames, 0);
}

TEST(Survey, WithoutABodyCentimetresAreAssumedAndSaid) {
    const auto chain = test::makeSkeleton({{"a", -1, {0, 0, 0}, "XYZ"}, {"b", 0, {0, 5, 0}, "z"}});
    const Survey survey = surveyMotion(*standing(chain, 1));
    EXPECT_EQ(survey.space.metresPerUnit, 0.01);
    EXPECT_EQ(survey.findings.size(), 2u);
}

}  // namespace
}  // namespace kumite
