#include "core/motion/overlap.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/builders.h"

namespace kumite {
namespace {

Capsule along(double x, double y, double z, double length, double radius) {
    return {{x, y, z}, {x + length, y, z}, radius};
}

TEST(Overlap, OfParallelCrossedAndDistantCapsules) {
    const Capsule one = along(0, 0, 0, 1, 0.1);
    EXPECT_NEAR(overlap({one}, {along(0, 0.15, 0, 1, 0.1)}), 0.05, 1e-12);  // side by side
    EXPECT_NEAR(overlap({one}, {along(1.5, 0, 0, 1, 0.1)}), -0.3, 1e-12);   // end to end
    const Capsule across{{0.5, 0.12, -1}, {0.5, 0.12, 1}, 0.05};
    EXPECT_NEAR(overlap({one}, {across}), 0.03, 1e-12);
    const Capsule point{{0.3, 0.2, 0}, {0.3, 0.2, 0}, 0.05};
    EXPECT_NEAR(overlap({one}, {point}), -0.05, 1e-12);
    EXPECT_NEAR(overlap({along(3, 0, 0, 1, 0.1), one}, {across, point}), 0.03, 1e-12);
    EXPECT_LT(overlap({}, {one}), -1e9);
}

TEST(Overlap, IsTheSameEitherWay) {
    const Capsule a{{0.1, 0.2, 0.3}, {0.9, -0.4, 0.2}, 0.2};
    const Capsule b{{0.5, 0.6, -0.3}, {-0.2, 0.1, 0.8}, 0.15};
    EXPECT_NEAR(overlap({a}, {b}), overlap({b}, {a}), 1e-12);
    // Against brute force over both lines.
    double nearest = 1e9;
    for (int i = 0; i <= 400; ++i) {
        for (int k = 0; k <= 400; ++k) {
            const Eigen::Vector3d p = a.a + i / 400.0 * (a.b - a.a);
            const Eigen::Vector3d q = b.a + k / 400.0 * (b.b - b.a);
            nearest = std::min(nearest, (p - q).norm());
        }
    }
    EXPECT_NEAR(overlap({a}, {b}), a.radius + b.radius - nearest, 1e-4);
}

TEST(Overlap, ABodyOverlapsItselfButNotOneTwoMetresAway) {
    const auto motion = test::bobbing(2, 60, [](double) { return 0.92; });
    const Fighter fighter = test::makeFighter(motion, 60);
    const auto positions = forwardKinematics(*motion, motion->frames(), fighter.space);
    const auto here = bodyCapsules(fighter.roles, positions, 0);
    auto there = here;
    for (Capsule& capsule : there) {
        capsule.a.x() += 2.5;
        capsule.b.x() += 2.5;
    }
    EXPECT_GT(here.size(), 10u);
    EXPECT_GT(overlap(here, here), 0.1);
    EXPECT_LT(overlap(here, there), 0);
}

}  // namespace
}  // namespace kumite
