#include "core/motion/heading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/role_mapping.h"
#include "tests/support/builders.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

constexpr double kDegrees = M_PI / 180;

/// makeHuman (root channels XYZzxy) turned by `angle(frame)` degrees in root column 3, 4 or 5.
std::vector<double> headingsOf(int frames, int column, const std::function<double(int)>& angle,
                               UpAxis up = UpAxis::Y) {
    const auto human = test::makeHuman();
    const auto motion = test::makeMotion(
        human, frames, 60, [&](int frame, int c) { return c == column ? angle(frame) : 0.0; });
    return headings(*motion, motion->frames(), {0.01, up}, mapRoles(*human).roles);
}

TEST(Headings, FollowTheTurnAboutYBeyondAWholeCircle) {
    const auto yaw = headingsOf(100, 5, [](int frame) { return 10.0 * frame; });
    for (std::size_t i = 0; i < yaw.size(); ++i) {
        EXPECT_NEAR(yaw[i], 10.0 * kDegrees * static_cast<double>(i), 1e-9);
    }
}

TEST(Headings, ABowDoesNotTurn) {
    const auto yaw = headingsOf(60, 4, [](int frame) { return 1.0 * frame; });
    for (const double each : yaw)
        EXPECT_NEAR(each, 0, 1e-9);
}

TEST(Headings, AreInterpolatedWhileTheBodyFacesTheGround) {
    // Frames 0–9 face +z, 10–19 lie face down, 20–29 face +x (y turned by 90°).
    const auto human = test::makeHuman();
    const auto motion = test::makeMotion(human, 30, 60, [&](int frame, int c) {
        if (c == 4) return frame >= 10 && frame < 20 ? 90.0 : 0.0;
        if (c == 5) return frame >= 20 ? 90.0 : 0.0;
        return 0.0;
    });
    const auto yaw = headings(*motion, {0, 30}, {0.01, UpAxis::Y}, mapRoles(*human).roles);
    EXPECT_NEAR(yaw[9], 0, 1e-9);
    for (std::size_t i = 10; i < 20; ++i) {
        EXPECT_NEAR(yaw[i], M_PI / 2 * static_cast<double>(i - 9) / 11.0, 1e-9);
    }
    EXPECT_NEAR(yaw[20], M_PI / 2, 1e-9);
}

TEST(Headings, ATakeThatFacesTheGroundAllTheTime) {
    for (const double each : headingsOf(5, 4, [](int) { return 90.0; }))
        EXPECT_EQ(each, 0);
}

TEST(Headings, ABodyThatRestsFacingSidewaysOrInAZUpFile) {
    // The rest pose's own facing counts, whatever axis of the file it is along.
    const RoleMap roles = mapRoles(*test::makeHuman()).roles;
    auto turned = std::make_shared<Skeleton>(*test::makeHuman());
    for (Joint& joint : turned->joints)
        joint.offset = Eigen::Vector3d(joint.offset.z(), joint.offset.y(), -joint.offset.x());
    auto motion = test::makeMotion(turned, 1, 60, [](int, int) { return 0.0; });
    EXPECT_NEAR(headings(*motion, {0, 1}, {0.01, UpAxis::Y}, roles)[0], M_PI / 2, 1e-9);
    // z up: world = (x, z, −y), so file = (x, −z, y).
    auto upright = std::make_shared<Skeleton>(*test::makeHuman());
    for (Joint& joint : upright->joints)
        joint.offset = Eigen::Vector3d(joint.offset.x(), -joint.offset.z(), joint.offset.y());
    motion = test::makeMotion(upright, 3, 60, [](int frame, int c) {
        return c == 3 ? 30.0 * frame : 0.0;  // about the file's z, which is up
    });
    const auto yaw = headings(*motion, {0, 3}, {0.01, UpAxis::Z}, roles);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(yaw[i], 30 * kDegrees * static_cast<double>(i), 1e-9);
}

TEST(Headings, ARestPoseThatLiesOnItsBackIsStillABody) {
    // Offsets as exporters write them whose root carries the turn that makes the body stand.
    auto lying = std::make_shared<Skeleton>(*test::makeHuman());
    for (Joint& joint : lying->joints)
        joint.offset = Eigen::Vector3d(joint.offset.x(), -joint.offset.z(), joint.offset.y());
    const auto motion =
        test::makeMotion(lying, 1, 60, [](int, int c) { return c == 4 ? -90.0 : 0.0; });
    const RoleMap roles = mapRoles(*test::makeHuman()).roles;
    EXPECT_NEAR(headings(*motion, {0, 1}, {0.01, UpAxis::Y}, roles)[0], 0, 1e-9);
}

TEST(Headings, KnownAnswersOfARecording) {
    KUMITE_NEEDS_DATA();
    for (const char* name : {"features_martial_04", "features_martial_04_on_frames"}) {
        const auto known = test::knownAnswer(name);
        const test::KnownRecording recording(known["input"]);
        const auto yaw =
            headings(*recording.motion, recording.frames, recording.space, recording.roles);
        for (std::size_t i = 0; i < 10; ++i) {
            const double time = known["expected"]["times"][i].get<double>();
            const auto before = static_cast<std::size_t>(time);
            const double share = time - static_cast<double>(before);
            const double here =
                share > 0 ? (1 - share) * yaw[before] + share * yaw[before + 1] : yaw[before];
            EXPECT_NEAR(std::remainder(here - known["expected"]["yaw_at_samples"][i].get<double>(),
                                       2 * M_PI),
                        0, known["tolerance"]["yaw_rad"].get<double>())
                << name << " " << time;
        }
    }
}

}  // namespace
}  // namespace kumite
