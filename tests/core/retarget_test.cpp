#include "core/motion/retarget.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/formats/recording.h"
#include "core/motion/feet.h"
#include "core/motion/survey.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Clip randomHuman(int frames, unsigned seed) {
    const auto motion = test::bobbing(frames, 60, [](double t) { return 0.1 * t; });
    const Fighter fighter = test::makeFighter(motion, 60);
    Clip clip = clipOf(*motion, motion->frames(), fighter.space, fighter.roles);
    std::mt19937 random(seed);
    std::normal_distribution<double> angle(0, 0.6);
    for (Pose& pose : clip.frames) {
        for (std::size_t i = 0; i < pose.turns.size(); ++i) {
            if (!clip.rig->joints[i].isEndSite)
                pose.turns[i] = AngleAxisd(angle(random), Vector3d::UnitX()) *
                                AngleAxisd(angle(random), Vector3d::UnitY()) *
                                AngleAxisd(angle(random), Vector3d::UnitZ());
        }
        pose.root += Vector3d(angle(random), 0, angle(random));
    }
    return clip;
}

double worstDistance(const JointPositions& a, const JointPositions& b) {
    EXPECT_EQ(a.xyz.size(), b.xyz.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.xyz.size(); ++i)
        worst = std::max<double>(worst, std::abs(a.xyz[i] - b.xyz[i]));
    return worst;
}

/// The same body whose file rests otherwise: joint i is turned by `rest[i]` in space at rest.
std::shared_ptr<const Rig> restedAnew(const Rig& rig, const std::vector<Quaterniond>& rest) {
    Rig other = rig;
    for (std::size_t i = 1; i < rig.joints.size(); ++i) {
        const auto parent = static_cast<std::size_t>(rig.joints[i].parent);
        other.joints[i].offset = rest[parent].conjugate() * rig.joints[i].offset;
    }
    other.forward = rest[0].conjugate() * rig.forward;
    return std::make_shared<const Rig>(other);
}

TEST(Retarget, OntoItselfChangesNothing) {
    const Clip clip = randomHuman(20, 1);
    Findings losses;
    const Clip same = retargeted(clip, clip.rig, &losses);
    EXPECT_TRUE(losses.empty());
    EXPECT_LT(worstDistance(positionsOf(clip), positionsOf(same)), 1e-5);
}

TEST(Retarget, ALargerBodyMovesInProportion) {
    const Clip clip = randomHuman(20, 2);
    auto large = std::make_shared<Rig>(*clip.rig);
    for (Rig::Joint& joint : large->joints)
        joint.offset *= 1.2;
    const Retargeting retargeting(clip.rig, large);
    EXPECT_NEAR(retargeting.scale(), 1.2, 1e-12);
    ASSERT_EQ(retargeting.losses().size(), 1U);
    const Vector3d origin(0.3, 0, -0.4);
    JointFrames from, to;
    for (const Pose& pose : clip.frames) {
        jointFrames(*clip.rig, pose, from);
        jointFrames(*large, retargeting.apply(pose, origin), to);
        for (std::size_t i = 0; i < from.positions.size(); ++i) {
            EXPECT_LT((to.positions[i] - origin - 1.2 * (from.positions[i] - origin)).norm(), 1e-9);
        }
    }
}

// Files whose rest pose lies and whose bones all point along x, whose arms hang or whose body
// faces elsewhere: one body, so all joints come to the same places.
TEST(Retarget, AnotherRestPoseShowsTheSame) {
    const Clip clip = randomHuman(20, 3);
    const Rig& rig = *clip.rig;
    const auto turned = [](double degrees, const Vector3d& axis) {
        return Quaterniond(AngleAxisd(degrees * M_PI / 180, axis));
    };
    const auto isBelow = [&](int joint, Role role) {
        while (joint > *rig.roles[role])
            joint = rig.joint(joint).parent;
        return joint == *rig.roles[role];
    };
    // Spine along x, hips along z; the legs turned half round the hips' line, so that they lie
    // along x, too.
    const Quaterniond lying = turned(120, Vector3d(1, 1, 1).normalized());
    std::vector<Quaterniond> allAlongX, hangingArms, facingX;
    for (int i = 0; i < rig.jointCount(); ++i) {
        const bool leg = isBelow(i, Role::LeftHip) || isBelow(i, Role::RightHip);
        const bool left = isBelow(i, Role::LeftShoulder), right = isBelow(i, Role::RightShoulder);
        const Quaterniond arm = left    ? turned(-80, Vector3d::UnitZ())
                                : right ? turned(80, Vector3d::UnitZ())
                                        : Quaterniond::Identity();
        allAlongX.push_back((leg ? turned(180, Vector3d::UnitX()) : Quaterniond::Identity()) *
                            lying);
        hangingArms.push_back(arm);
        facingX.push_back(turned(90, Vector3d::UnitY()));
    }
    for (const auto& rest : {allAlongX, hangingArms, facingX}) {
        const auto target = restedAnew(rig, rest);
        JointFrames from, to;
        const Retargeting retargeting(clip.rig, target), back(target, clip.rig);
        for (const Pose& pose : clip.frames) {
            jointFrames(rig, pose, from);
            const Pose there = retargeting.apply(pose);
            jointFrames(*target, there, to);
            for (std::size_t i = 0; i < from.positions.size(); ++i)
                EXPECT_LT((to.positions[i] - from.positions[i]).norm(), 1e-9) << rig.joints[i].name;
            jointFrames(rig, back.apply(there), to);
            for (std::size_t i = 0; i < from.positions.size(); ++i)
                EXPECT_LT((to.positions[i] - from.positions[i]).norm(), 1e-9) << rig.joints[i].name;
        }
    }
}

TEST(Retarget, SaysWhatIsLost) {
    const Clip clip = randomHuman(3, 4);
    auto target = std::make_shared<Rig>(*clip.rig);
    target->roles.clear(Role::LeftClavicle);
    target->roles.clear(Role::LeftToe);
    for (const Role role : {Role::LeftElbow, Role::LeftWrist})
        target->joints[static_cast<std::size_t>(*target->roles[role])].offset *= 1.5;
    Findings losses;
    retargeted(clip, target, &losses);
    ASSERT_EQ(losses.size(), 2U);
    EXPECT_NE(losses[0].text.find("left_clavicle, left_toe"), std::string::npos) << losses[0].text;
    EXPECT_NE(losses[1].text.find("50 % longer"), std::string::npos) << losses[1].text;
    const Retargeting back(target, clip.rig);
    EXPECT_NE(back.losses()[0].text.find("The source has no left_clavicle"), std::string::npos);
}

/// Largest angle between the limbs of two rigs' poses, radians.
double worstLimbAngle(const Clip& a, const Clip& b) {
    using enum Role;
    const JointPositions first = positionsOf(a), second = positionsOf(b);
    double worst = 0;
    for (const auto& [from, to] :
         {std::pair{LeftShoulder, LeftElbow}, std::pair{LeftElbow, LeftWrist},
          std::pair{RightShoulder, RightElbow}, std::pair{RightElbow, RightWrist},
          std::pair{LeftHip, LeftKnee}, std::pair{LeftKnee, LeftAnkle},
          std::pair{RightHip, RightKnee}, std::pair{RightKnee, RightAnkle}}) {
        for (int frame = 0; frame < a.frameCount(); ++frame) {
            const auto bone = [&, from = from, to = to](
                                  const Clip& clip, const JointPositions& positions) -> Vector3d {
                return (positions.at(frame, *clip.rig->roles[to]) -
                        positions.at(frame, *clip.rig->roles[from]))
                    .cast<double>()
                    .normalized();
            };
            worst = std::max(worst, std::acos(std::min(1.0, bone(a, first).dot(bone(b, second)))));
        }
    }
    return worst;
}

TEST(Retarget, RecordingsOfOtherFamiliesKeepTheirLimbsAndFloor) {
    KUMITE_NEEDS_DATA();
    const auto clipFrom = [](const char* name, int begin, int end) {
        const Recording recording = readRecording(*test::dataFolder() / name);
        const Motion& motion = *recording.motions.front();
        const Survey survey = surveyMotion(motion);
        return clipOf(motion, {begin, std::min(end, motion.frameCount)}, survey.space,
                      survey.roles.roles);
    };
    const Clip target = clipFrom("cmu_karate/martial_04.bvh", 1, 3);
    for (const char* name : {"awkward/Boxing_Toes.bvh", "cmu_moves/02_05.bvh",
                             "cmu_salsa/60_01.bvh", "awkward/kick_37_joints.bvh"}) {
        SCOPED_TRACE(name);
        const Clip clip = clipFrom(name, 1, 800);
        const Clip there = retargeted(clip, target.rig);
        ASSERT_EQ(there.frameCount(), clip.frameCount());
        EXPECT_LT(worstLimbAngle(clip, there), 1e-3);
        const auto floorOf = [](const Clip& c) {
            return *floorHeight(*skeletonOf(*c.rig), c.rig->roles, positionsOf(c));
        };
        EXPECT_NEAR(floorOf(there), floorOf(clip), 1e-4);
    }
}

}  // namespace
}  // namespace kumite
