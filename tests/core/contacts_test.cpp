#include "core/motion/contacts.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/motion/role_mapping.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

using Contact = std::vector<std::uint8_t>;

Contact contactAt100Hz(std::vector<float> height, std::vector<float> speed,
                       const ContactSettings& settings = {}) {
    if (height.empty()) height.resize(speed.size(), 0.0f);
    if (speed.empty()) speed.resize(height.size(), 0.0f);
    return footContact(height, speed, 100, settings);
}

TEST(FootContact, BeginsBelowFiveCentimetresAndEndsAboveEight) {
    EXPECT_EQ(contactAt100Hz({.09f, .06f, .05f, .04f, .06f, .07f, .08f, .06f, .081f, .06f}, {}),
              Contact({0, 0, 0, 1, 1, 1, 1, 1, 0, 0}));
}

TEST(FootContact, BeginsBelowHalfAMetreASecondAndEndsAboveEightTenths) {
    EXPECT_EQ(contactAt100Hz({}, {1.f, .6f, .5f, .4f, .7f, .79f, .1f, .3f, .9f, .6f, .6f}),
              Contact({0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0}));
}

TEST(FootContact, ShorterThanATwentiethOfASecondDoesNotCount) {
    // 4 frames at 100 Hz are 0.04 s, 5 are 0.05 s.
    const std::vector<float> height = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    EXPECT_EQ(contactAt100Hz(height, {}), Contact({0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0}));
    ContactSettings settings;
    settings.shortest = 0;
    EXPECT_EQ(contactAt100Hz(height, {}, settings), Contact({0, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 0}));
    settings.height = 2;
    settings.releaseHeight = 2;
    EXPECT_EQ(contactAt100Hz(height, {}, settings), Contact(12, 1));
}

/// A human who lifts the left leg (hip bent by `degrees` forward) between two frames, in 4 frames.
FootContacts contactsOfALift(double up, UpAxis axis) {
    const auto human = test::makeHuman();
    const int hip = human->find("LeftHip");
    const int column = human->joints[static_cast<std::size_t>(hip)].firstChannel + 1;
    const auto motion = test::makeMotion(human, 120, 60, [&](int frame, int c) {
        if (c == 1) return test::kHumanRootHeight;
        const double lift = std::clamp(std::min(frame - 38, 82 - frame) / 4.0, 0.0, 1.0);
        return c == column ? -up * lift : 0.0;
    });
    const auto positions = forwardKinematics(*motion, motion->frames(), {0.01, axis});
    return footContacts(*human, mapRoles(*human).roles, positions, 60);
}

TEST(FootContacts, ALiftedFootIsInTheAir) {
    const FootContacts contacts = contactsOfALift(60, UpAxis::Y);
    EXPECT_EQ(contacts.right, Contact(120, 1));
    ASSERT_EQ(contacts.left.size(), 120u);
    for (int frame = 0; frame < 120; ++frame) {
        if (frame < 37 || frame > 83) {
            EXPECT_EQ(contacts.left[static_cast<std::size_t>(frame)], 1) << frame;
        } else if (frame > 39 && frame < 81) {
            EXPECT_EQ(contacts.left[static_cast<std::size_t>(frame)], 0) << frame;
        }
    }
}

TEST(FootContacts, EachFootAgainstItsOwnRestHeight) {
    // One leg 20 cm shorter: that foot hangs 20 cm above the other and still counts as standing.
    auto human = std::make_shared<Skeleton>(*test::makeHuman());
    human->joints[static_cast<std::size_t>(human->find("LeftKnee"))].offset.y() += 20;
    const auto motion = test::makeMotion(human, 60, 60, [](int, int) { return 0.0; });
    const auto positions = forwardKinematics(*motion, motion->frames(), {0.01, UpAxis::Y});
    const auto contacts = footContacts(*human, mapRoles(*human).roles, positions, 60);
    EXPECT_EQ(contacts.left, Contact(60, 1));
    EXPECT_EQ(contacts.right, Contact(60, 1));
}

TEST(FootContacts, WithoutALegThereIsNoContact) {
    const auto human = test::makeHuman();
    RoleMap roles = mapRoles(*human).roles;
    for (const Role role : {Role::LeftAnkle, Role::LeftToe})
        roles.clear(role);
    const auto motion = test::makeMotion(human, 3, 60, [](int, int) { return 0.0; });
    const auto positions = forwardKinematics(*motion, motion->frames(), {0.01, UpAxis::Y});
    const auto contacts = footContacts(*human, roles, positions, 60);
    EXPECT_TRUE(contacts.left.empty());
    EXPECT_EQ(contacts.right, Contact({1, 1, 1})) << "three frames at 60 Hz last 0.05 s";
}

}  // namespace
}  // namespace kumite
