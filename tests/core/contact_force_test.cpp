#include "core/segmentation/contact_force.h"

#include <cmath>
#include <complex>
#include <random>

#include <gtest/gtest.h>

#include "core/motion/role_mapping.h"
#include "core/segmentation/centre_of_mass.h"
#include "core/segmentation/low_pass.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

using Path = std::vector<Eigen::Vector3d>;

Path pathOf(int frames, double rate, const std::function<Eigen::Vector3d(double)>& at) {
    Path path;
    for (int i = 0; i < frames; ++i)
        path.push_back(at(i / rate));
    return path;
}

TEST(LowPass, HalvesASineAtTheCutoff) {
    // Butterworth is −3 dB at its cutoff; both passes together −6 dB: exactly half.
    std::vector<double> sine;
    for (int i = 0; i < 1200; ++i)
        sine.push_back(std::sin(2 * M_PI * 6.0 * i / 120.0));
    const auto smooth = lowPass(sine, 120, 6.0);
    double highest = 0;
    for (std::size_t i = 300; i < 900; ++i)
        highest = std::max(highest, smooth[i]);
    EXPECT_NEAR(highest, 0.5, 1e-3);
}

TEST(LowPass, KeepsConstantsAndLines) {
    std::vector<double> level(50, 3.25), line;
    for (int i = 0; i < 200; ++i)
        line.push_back(0.5 * i - 7);
    for (const double v : lowPass(level, 60, 6))
        EXPECT_NEAR(v, 3.25, 1e-12);
    const auto smooth = lowPass(line, 60, 6);
    for (std::size_t i = 0; i < line.size(); ++i)
        EXPECT_NEAR(smooth[i], line[i], 1e-6);
}

// Independent route: the filter's frequency response, squared, on a sine far from the ends.
TEST(LowPass, FollowsItsFrequencyResponse) {
    const double rate = 100, cutoff = 8;
    for (const double f : {1.0, 4.0, 12.0, 30.0}) {
        std::vector<double> sine;
        for (int i = 0; i < 2000; ++i)
            sine.push_back(std::cos(2 * M_PI * f * i / rate));
        const auto smooth = lowPass(sine, rate, cutoff);
        // Bilinear transform: the analogue frequency of f is tan(πf/rate), of the cutoff
        // tan(πc/rate).
        const double ratio = std::tan(M_PI * f / rate) / std::tan(M_PI * cutoff / rate);
        const double gain = 1.0 / (1.0 + std::pow(ratio, 4));  // |H|² of 2nd order
        for (std::size_t i = 900; i < 1100; ++i)
            EXPECT_NEAR(smooth[i], gain * sine[i], 1e-6);
    }
}

TEST(LowPass, RunsTheSameBothWays) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise;
    std::vector<double> samples;
    for (int i = 0; i < 400; ++i)
        samples.push_back(noise(random));
    const auto forward = lowPass(samples, 60, 6);
    auto backward = lowPass({samples.rbegin(), samples.rend()}, 60, 6);
    std::reverse(backward.begin(), backward.end());
    // Zero phase: only what the ends' padding leaves differs.
    for (std::size_t i = 60; i < 340; ++i)
        EXPECT_NEAR(forward[i], backward[i], 1e-6);
}

TEST(LowPass, ShortSignals) {
    EXPECT_TRUE(lowPass({}, 60, 6).empty());
    EXPECT_NEAR(lowPass({2.0}, 60, 6)[0], 2.0, 1e-12);
    EXPECT_EQ(lowPass({1.0, 2.0}, 60, 6).size(), 2u);
}

TEST(ContactForce, StandingIsOneBodyWeight) {
    const auto force = contactForce(Path(100, {1, 0.9, 2}), 60, 6, ForceCurve::Norm);
    for (const double f : force.curve)
        EXPECT_DOUBLE_EQ(f, 1.0);
}

TEST(ContactForce, FreeFallIsZero) {
    const Path fall = pathOf(120, 120, [](double t) {
        return Eigen::Vector3d(0.3 * t, 1 + 2 * t - 0.5 * kGravity * t * t, -t);
    });
    const auto norm = contactForce(fall, 120, 6, ForceCurve::Norm);
    for (std::size_t i = 40; i < 80; ++i)
        EXPECT_NEAR(norm.curve[i], 0.0, 1e-3);
    const auto vertical = contactForce(fall, 120, 6, ForceCurve::Vertical);
    for (std::size_t i = 40; i < 80; ++i)
        EXPECT_NEAR(vertical.curve[i], 0.0, 1e-3);
}

TEST(ContactForce, SineAgainstItsExactSecondDerivative) {
    const double f = 1.5, amplitude = 0.03, rate = 240;
    const double omega = 2 * M_PI * f;
    const Path path = pathOf(960, rate, [&](double t) {
        return Eigen::Vector3d(0, 1 + amplitude * std::sin(omega * t), 0);
    });
    const auto force = contactForce(path, rate, 30, ForceCurve::Vertical);
    for (std::size_t i = 240; i < 720; ++i) {
        const double exact = 1 - amplitude * omega * omega *
                                     std::sin(omega * static_cast<double>(i) / rate) / kGravity;
        EXPECT_NEAR(force.curve[i], exact, 2e-3);
    }
}

TEST(ContactForce, NormIsTheLengthOfTheVector) {
    const Path path = pathOf(200, 100, [](double t) {
        return Eigen::Vector3d(std::sin(5 * t), std::cos(4 * t), std::sin(3 * t));
    });
    const auto force = contactForce(path, 100, 6, ForceCurve::Norm);
    for (std::size_t i = 0; i < force.curve.size(); ++i) {
        EXPECT_DOUBLE_EQ(force.curve[i], force.force[i].norm());
    }
    EXPECT_EQ(force.force[0], force.force[1]);
    EXPECT_EQ(force.force[199], force.force[198]);
}

TEST(ContactForce, ClipsOfOneTwoAndThreeFrames) {
    EXPECT_TRUE(contactForce(Path(), 60, 6, ForceCurve::Norm).curve.empty());
    for (int n = 1; n <= 2; ++n) {
        const auto force =
            contactForce(pathOf(n, 60, [](double t) { return Eigen::Vector3d(t, 0, 0); }), 60, 6,
                         ForceCurve::Norm);
        EXPECT_EQ(force.curve, std::vector<double>(static_cast<std::size_t>(n), 1.0));
    }
    const auto three = contactForce({{{0, 0, 0}, {0, 0.1, 0}, {0, 0, 0}}}, 60, 6, ForceCurve::Norm);
    EXPECT_EQ(three.curve[0], three.curve[1]);
    EXPECT_EQ(three.curve[2], three.curve[1]);
}

TEST(ContactForce, ACutoffAboveHalfTheRateDoesNotSmooth) {
    const Path path =
        pathOf(50, 10, [](double t) { return Eigen::Vector3d(0, std::sin(9 * t), 0); });
    const auto force = contactForce(path, 10, 6, ForceCurve::Norm);
    EXPECT_FALSE(force.smoothed);
    EXPECT_EQ(force.smoothedCom, path);
}

TEST(BodyModel, MassesAddUpToOne) {
    double sum = 0;
    for (const BodySegment& segment : deLevaMale().segments)
        sum += segment.mass;
    EXPECT_NEAR(sum, 1.0, 1e-3);
}

TEST(CentreOfMass, OfTheStandingHumanByHand) {
    const auto motion = test::bobbing(2, 60, [](double) { return 0.0; });
    const auto positions = forwardKinematics(*motion, motion->frames(), {0.01, UpAxis::Y});
    const RoleMap roles = mapRoles(*motion->skeleton).roles;
    const auto com = centreOfMass(deLevaMale(), *motion->skeleton, roles, positions);
    EXPECT_NEAR(com.massCoverage, 1.0, 1e-12);
    EXPECT_TRUE(com.missingSegments.empty());
    // Heights in metres: hips 0.92, neck 1.42, top of the head 1.72, arms 1.38, knees 0.50,
    // ankles 0.08, toes 0.00.
    const double sum = 0.4346 * (0.92 + 0.5514 * 0.50) + 0.0694 * (1.42 + 0.5 * 0.30) +
                       2 * (0.0271 + 0.0162 + 0.0061) * 1.38 + 2 * 0.1416 * (0.92 - 0.4095 * 0.42) +
                       2 * 0.0433 * (0.50 - 0.4395 * 0.42) + 2 * 0.0137 * 0.04;
    const double masses =
        0.4346 + 0.0694 + 2 * (0.0271 + 0.0162 + 0.0061 + 0.1416 + 0.0433 + 0.0137);
    EXPECT_NEAR(com.position[0].y(), sum / masses, 1e-6);
    EXPECT_NEAR(com.position[0].x(), 0.0, 1e-6);
}

TEST(CentreOfMass, MissingPartsAreLeftOutAndReported) {
    const auto motion = test::bobbing(1, 60, [](double) { return 0.0; });
    const auto positions = forwardKinematics(*motion, motion->frames(), {0.01, UpAxis::Y});
    RoleMap roles = mapRoles(*motion->skeleton).roles;
    roles.clear(Role::LeftElbow);
    roles.clear(Role::RightToe);
    const auto com = centreOfMass(deLevaMale(), *motion->skeleton, roles, positions);
    EXPECT_EQ(com.missingSegments, (std::vector<std::string>{"left upper arm", "left forearm"}))
        << "a foot without a toe counts at the ankle";
    EXPECT_NEAR(com.massCoverage, (1.0002 - 0.0433) / 1.0002, 1e-3);
    EXPECT_LT(com.position[0].x(), 0) << "without the left arm the centre lies to the right";
    EXPECT_EQ(centreOfMass(deLevaMale(), *motion->skeleton, RoleMap(), positions).massCoverage, 0);
}

TEST(CentreOfMass, AHeadWithoutEndSiteCountsAtItsJoint) {
    auto skeleton = std::make_shared<Skeleton>(*test::makeHuman());
    skeleton->joints[4].parent = 2;  // the head's End Site hangs on the neck now
    const auto motion = test::makeMotion(skeleton, 1, 60, [](int, int) { return 0.0; });
    const auto positions = forwardKinematics(*motion, {0, 1}, {0.01, UpAxis::Y});
    BodyModel headOnly{"head", {{"head", 1.0, {Role::Neck}, Role::Head, true, false, 0.5}}};
    const auto com = centreOfMass(headOnly, *skeleton, mapRoles(*skeleton).roles, positions);
    EXPECT_NEAR(com.position[0].y(), 0.60, 1e-6);
}

}  // namespace
}  // namespace kumite
