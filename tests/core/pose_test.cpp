#include "core/motion/pose.h"

#include <cmath>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/recording.h"
#include "core/motion/euler.h"
#include "core/motion/feet.h"
#include "core/motion/heading.h"
#include "core/motion/survey.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::makeMotion;
using test::makeSkeleton;

const SpaceConvention kMetres{1.0, UpAxis::Y};

/// Largest distance between joints of two motions' frames, metres; joints may be left out.
double worstDistance(const JointPositions& a, const JointPositions& b) {
    EXPECT_EQ(a.xyz.size(), b.xyz.size());
    double worst = 0;
    for (int frame = 0; frame < a.frameCount; ++frame) {
        for (int joint = 0; joint < a.jointCount; ++joint)
            worst = std::max<double>(worst, (a.at(frame, joint) - b.at(frame, joint)).norm());
    }
    return worst;
}

/// Largest step of an angle between neighbouring frames, degrees.
double worstStep(const Motion& motion) {
    double worst = 0;
    for (const Joint& joint : motion.skeleton->joints) {
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            if (!isRotation(joint.channels[c])) continue;
            for (int frame = 1; frame < motion.frameCount; ++frame) {
                const auto column = static_cast<std::size_t>(joint.firstChannel) + c;
                worst = std::max(
                    worst, std::abs(motion.frame(frame)[column] - motion.frame(frame - 1)[column]));
            }
        }
    }
    return worst;
}

std::vector<std::filesystem::path> recordings() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*test::dataFolder())) {
        if (entry.path().extension() == ".bvh" || entry.path().extension() == ".amc")
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(Clip, EveryRecordingComesBackFromPoses) {
    KUMITE_NEEDS_DATA();
    int checked = 0;
    for (const auto& file : recordings()) {
        SCOPED_TRACE(file.string());
        const bool isAmc = file.extension() == ".amc";
        const Recording recording =
            isAmc ? readRecording(file, {.asf = file.parent_path() / "135-martialArts.asf"})
                  : readRecording(file);
        for (const auto& motion : recording.motions) {
            const Survey survey = surveyMotion(*motion);
            const FrameRange frames{0, std::min(motion->frameCount, 1500)};
            const auto losses = rigLosses(*motion, frames, survey.space, survey.roles.roles);
            const Clip clip = clipOf(*motion, frames, survey.space, survey.roles.roles);
            const auto original = forwardKinematics(*motion, frames, survey.space);
            if (!losses.empty()) continue;
            EXPECT_LT(worstDistance(positionsOf(clip), original), 1e-5);
            const Motion back = motionOf(clip, motion->skeleton, survey.space);
            back.validate();
            EXPECT_LT(worstDistance(forwardKinematics(back, back.frames(), survey.space), original),
                      1e-5);
            ++checked;
        }
    }
    EXPECT_GE(checked, 15);
}

TEST(Clip, KeepsAnglesContinuousOnARecording) {
    KUMITE_NEEDS_DATA();
    const Recording recording =
        readRecording(*test::dataFolder() / "cmu_karate" / "martial_04.bvh");
    const Motion& motion = *recording.motions.front();
    const Survey survey = surveyMotion(motion);
    const Clip clip = clipOf(motion, {1, motion.frameCount}, survey.space, survey.roles.roles);
    const Motion back = motionOf(clip, motion.skeleton, survey.space);
    EXPECT_LT(worstStep(back), 180.0);
}

TEST(Clip, WholeTurnsDoNotJump) {
    const auto skeleton =
        makeSkeleton({{"root", -1, {0, 0, 0}, "XYZzxy"}, {"tip", 0, {0, 1, 0}, ""}});
    const auto motion = makeMotion(
        skeleton, 200, 60, [](int frame, int column) { return column == 5 ? 7.0 * frame : 0.0; });
    const Clip clip = clipOf(*motion, motion->frames(), kMetres, RoleMap());
    const Motion back = motionOf(clip, skeleton, kMetres);
    for (int frame = 0; frame < 200; ++frame)
        EXPECT_NEAR(back.frame(frame)[5], 7.0 * frame, 1e-6);
}

// Random trees with every order of channels, joints of one and two axes, turned rotation frames,
// z up: poses hold exactly what the channels mean, and come back.
TEST(Clip, ComesBackOnRandomSkeletons) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> angle(-170, 170), length(-1, 1);
    const std::vector<std::string> orders = {"xyz", "zxy", "yx", "z", "zyx",
                                             "xzy", "yxz", "xz", "y"};
    for (int round = 0; round < 30; ++round) {
        std::vector<test::JointSpec> specs = {{"0", -1, {0, 0, 0}, "XYZzxy"}};
        for (int j = 1; j < 12; ++j) {
            specs.push_back({std::to_string(j),
                             static_cast<int>(random() % static_cast<unsigned>(j)),
                             {length(random), length(random), length(random)},
                             orders[random() % orders.size()]});
        }
        auto skeleton = std::make_shared<Skeleton>(*makeSkeleton(specs));
        for (Joint& joint : skeleton->joints)
            joint.rotationFrame = axisRotation(0, angle(random)) * axisRotation(1, angle(random));
        const auto motion = makeMotion(skeleton, 5, 30, [&](int, int) { return angle(random); });
        const SpaceConvention space{0.01, round % 2 == 0 ? UpAxis::Z : UpAxis::Y};
        const Clip clip = clipOf(*motion, {1, 5}, space, RoleMap());
        const auto original = forwardKinematics(*motion, {1, 5}, space);
        EXPECT_LT(worstDistance(positionsOf(clip), original), 2e-6);
        const Motion back = motionOf(clip, skeleton, space);
        EXPECT_LT(worstDistance(forwardKinematics(back, back.frames(), space), original), 2e-6);
    }
}

// A skeleton whose hips have the way, below a root that stands still away from the origin.
std::shared_ptr<const Skeleton> withReference(const std::string& channelsOfReference) {
    std::vector<test::JointSpec> specs = {{"Reference", -1, {30, 0, 40}, channelsOfReference}};
    for (const Joint& joint : test::makeHuman()->joints) {
        std::string channels;
        for (const Channel channel : joint.channels)
            channels += "XYZxyz"[static_cast<int>(channel)];
        specs.push_back({joint.name, joint.parent + 1, joint.offset, channels});
    }
    return makeSkeleton(specs);
}

double walking(int frame, int column, int firstOfHips) {
    const int own = column - firstOfHips;
    if (own == 0) return 3.0 * frame;
    if (own == 1) return test::kHumanRootHeight;
    if (own == 2) return -2.0 * frame;
    return own > 2 ? 5.0 * std::sin(0.1 * frame + own) : 0.0;
}

TEST(Clip, TheJointThatMovesNeedNotBeTheFirst) {
    const auto skeleton = withReference("zxy");
    const auto motion = makeMotion(skeleton, 50, 60, [](int frame, int column) {
        return column < 3 ? std::array{10.0, 20.0, 30.0}[static_cast<std::size_t>(column)]
                          : walking(frame, column, 3);
    });
    const SpaceConvention space{0.01, UpAxis::Y};
    const RoleMap roles = mapRoles(*skeleton).roles;
    ASSERT_EQ(roles[Role::Pelvis], 1);
    const Rig rig = rigOf(*motion, motion->frames(), space, roles);
    EXPECT_EQ(rig.traveller, 1);
    EXPECT_TRUE(rigLosses(*motion, motion->frames(), space, roles).empty());

    const Clip clip = clipOf(*motion, motion->frames(), space, roles);
    const auto original = forwardKinematics(*motion, motion->frames(), space);
    for (const int frame : {0, 20, 49}) {
        EXPECT_LT((clip.frames[static_cast<std::size_t>(frame)].root -
                   original.at(frame, 1).cast<double>())
                      .norm(),
                  1e-6);
    }
    // Written back, the first joint stands where it stood, and the body is where it was.
    const Motion back = motionOf(clip, skeleton, space);
    EXPECT_LT(worstDistance(forwardKinematics(back, back.frames(), space), original), 1e-6);
}

TEST(Clip, AWayAboveTheTravellerIsDroppedAndSaid) {
    const auto skeleton = withReference("XYZ");
    const auto motion = makeMotion(skeleton, 50, 60, [](int frame, int column) {
        return column < 3 ? 1.0 * frame : walking(frame, column, 3);
    });
    const SpaceConvention space{0.01, UpAxis::Y};
    const RoleMap roles = mapRoles(*skeleton).roles;
    const Findings losses = rigLosses(*motion, motion->frames(), space, roles);
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_NE(losses[0].text.find("Reference moves"), std::string::npos) << losses[0].text;
    const Clip clip = clipOf(*motion, motion->frames(), space, roles);
    const Motion back = motionOf(clip, skeleton, space);
    const auto original = forwardKinematics(*motion, motion->frames(), space);
    const auto returned = forwardKinematics(back, back.frames(), space);
    for (int joint = 1; joint < skeleton->jointCount(); ++joint)
        EXPECT_LT((original.at(49, joint) - returned.at(49, joint)).norm(), 1e-6);
}

TEST(Clip, BonesInPositionChannelsAreKeptAsTheirMean) {
    // The upper bone is constant (2, not its offset 1), the lower alternates between 3 and 5.
    const auto skeleton = makeSkeleton({{"root", -1, {0, 0, 0}, "XYZ"},
                                        {"upper", 0, {1, 0, 0}, "XYZzxy"},
                                        {"lower", 1, {1, 0, 0}, "XYZ"}});
    const auto motion = makeMotion(skeleton, 10, 60, [](int frame, int column) {
        if (column == 3) return 2.0;
        if (column == 9) return frame % 2 == 0 ? 3.0 : 5.0;
        return column < 3 ? 1.0 * frame : 0.0;
    });
    const Rig rig = rigOf(*motion, motion->frames(), kMetres, RoleMap());
    EXPECT_EQ(rig.joints[1].offset, Eigen::Vector3d(2, 0, 0));
    EXPECT_EQ(rig.joints[2].offset, Eigen::Vector3d(4, 0, 0));
    const Findings losses = rigLosses(*motion, motion->frames(), kMetres, RoleMap());
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_NE(losses[0].text.find("lower changes by up to 100.00 cm"), std::string::npos)
        << losses[0].text;
    const Motion back =
        motionOf(clipOf(*motion, motion->frames(), kMetres, RoleMap()), skeleton, kMetres);
    EXPECT_DOUBLE_EQ(back.frame(3)[3], 2.0);
    EXPECT_DOUBLE_EQ(back.frame(3)[9], 4.0);
}

TEST(Clip, ATurnThatAJointCannotShowIsBroughtNear) {
    const auto skeleton = makeSkeleton({{"root", -1, {0, 0, 0}, "XYZzxy"},
                                        {"knee", 0, {0, -1, 0}, "x"},
                                        {"foot", 1, {0, -1, 0}, ""}});
    const auto motion = makeMotion(skeleton, 1, 60, [](int, int) { return 0.0; });
    Clip clip = clipOf(*motion, motion->frames(), kMetres, RoleMap());
    clip.frames[0].turns[1] = Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()) *
                              Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY());
    const Motion back = motionOf(clip, skeleton, kMetres);
    EXPECT_NEAR(back.frame(0)[6], 0.6 * 180 / M_PI, 0.01);
}

TEST(Clip, AnotherSkeletonIsRefused) {
    const auto motion = test::bobbing(3, 60, [](double) { return 0.0; });
    const Clip clip = clipOf(*motion, motion->frames(), {}, RoleMap());
    EXPECT_THROW(motionOf(clip, makeSkeleton({{"root", -1, {0, 0, 0}, "XYZ"}}), {}), Error);
    EXPECT_EQ(motionOf(clip, motion->skeleton, {}).frameTime, motion->frameTime);
}

TEST(Clip, OnASkeletonMadeOfItsRig) {
    const auto motion = makeMotion(test::makeHuman(), 20, 60,
                                   [](int frame, int column) { return walking(frame, column, 0); });
    const RoleMap roles = mapRoles(*motion->skeleton).roles;
    const Clip clip = clipOf(*motion, motion->frames(), {0.01, UpAxis::Z}, roles, 50.0);
    EXPECT_EQ(clip.rate, 50.0);
    EXPECT_DOUBLE_EQ(clip.seconds(), 19.0 / 50.0);
    const auto skeleton = skeletonOf(*clip.rig);
    const Motion written = motionOf(clip, skeleton, kMetres);
    EXPECT_LT(worstDistance(forwardKinematics(written, written.frames(), kMetres),
                            forwardKinematics(*motion, motion->frames(), {0.01, UpAxis::Z})),
              1e-6);
}

TEST(Rig, KnowsFeetLegsAndFront) {
    const auto motion = test::bobbing(2, 60, [](double) { return 0.0; });
    const Fighter fighter = test::makeFighter(motion, 60);
    const Rig rig = rigOf(*motion, motion->frames(), fighter.space, fighter.roles);
    for (const bool left : {true, false})
        EXPECT_EQ(footPoint(rig, left), footPoint(*motion->skeleton, fighter.roles, left));
    EXPECT_NEAR(legLength(rig), 0.84, 1e-12);
    EXPECT_LT((rig.forward - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(Rig, HeadingIsThatOfTheMotion) {
    KUMITE_NEEDS_DATA();
    for (const char* name : {"cmu_moves/49_06.bvh", "cmu_salsa/60_01.bvh"}) {
        const Recording recording = readRecording(*test::dataFolder() / name);
        const Motion& motion = *recording.motions.front();
        const Survey survey = surveyMotion(motion);
        const RoleMap& roles = survey.roles.roles;
        const FrameRange frames{1, motion.frameCount};
        const Clip clip = clipOf(motion, frames, survey.space, roles);
        const auto expected = headings(motion, frames, survey.space, roles);
        int known = 0;
        for (std::size_t i = 0; i < clip.frames.size(); ++i) {
            const auto yaw = headingOf(*clip.rig, clip.frames[i]);
            if (!yaw) continue;
            ++known;
            ASSERT_NEAR(std::remainder(*yaw - expected[i], 2 * M_PI), 0.0, 1e-9) << "frame " << i;
        }
        EXPECT_GT(known, clip.frameCount() / 2);
    }
}

}  // namespace
}  // namespace kumite
