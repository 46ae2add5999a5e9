// Real recordings against the figures of an independent program.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/project/edits.h"
#include "core/project/import.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

class Reference : public testing::TestWithParam<std::string> {
protected:
    std::filesystem::path file(const std::string& suffix) const {
        return *test::dataFolder() / "reference" / (GetParam() + suffix);
    }
    nlohmann::json facts() const { return nlohmann::json::parse(test::readText(file(".json"))); }

    static std::vector<std::vector<std::string>> rows(const std::filesystem::path& path) {
        std::vector<std::vector<std::string>> rows;
        const std::string text = test::readText(path);
        for (const std::string_view line : split(text, '\n')) {
            if (line.empty()) continue;
            auto& row = rows.emplace_back();
            for (const std::string_view field : split(trimmed(line), ','))
                row.emplace_back(field);
        }
        rows.erase(rows.begin());
        return rows;
    }
};

TEST_P(Reference, RolesUnitRateAndTrimAreFound) {
    KUMITE_NEEDS_DATA();
    const auto known = facts();
    TakeRequest request;
    request.fighters.emplace_back().path = *test::dataFolder() / known["file"].get<std::string>();
    const Fighter fighter = importTake(request).take.fighters[0];
    for (const auto& [role, name] : known["roles"].items()) {
        const auto joint = fighter.roles[*roleFromName(role)];
        ASSERT_TRUE(joint) << role;
        EXPECT_EQ(fighter.motion->skeleton->joints[static_cast<std::size_t>(*joint)].name, name);
    }
    EXPECT_NEAR(fighter.space.metresPerUnit, known["scale"].get<double>(), 1e-6);
    EXPECT_EQ(fighter.frames.begin, known["trim"]);
    EXPECT_EQ(fighter.motion->frameCount, known["frames_in_file"]);
    EXPECT_EQ(fighter.motion->skeleton->channelCount, known["channels"]);
}

TEST_P(Reference, JointsForceAndMinimaAgree) {
    KUMITE_NEEDS_DATA();
    const auto known = facts();
    TakeRequest request;
    request.rate = known["rate_hz"].get<double>();
    request.trim = FrameRange{known["trim"].get<int>(), -1};
    request.fighters.emplace_back().path = *test::dataFolder() / known["file"].get<std::string>();
    const Project project = addTake({}, importTake(request).take)->project;
    const Fighter& fighter = project.takes[0].fighters[0];

    const Skeleton& skeleton = *fighter.motion->skeleton;
    const auto positions =
        forwardKinematics(*fighter.motion, fighter.motion->frames(), fighter.space);
    for (const auto& row : rows(file(".joints.csv"))) {
        const Eigen::Vector3f p = positions.at(*parseInteger(row[0]), skeleton.find(row[1]));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(p[axis], *parseNumber(row[static_cast<std::size_t>(2 + axis)]), 1e-3);
        }
    }

    const Analysis analysis = analyse(project);
    const FighterForce& force = *analysis.at({0, 0}).force;
    const auto expected = rows(file(".force.csv"));
    ASSERT_EQ(force.force.curve.size(), expected.size());
    double difference = 0, size = 0;
    for (std::size_t i = 30; i + 30 < expected.size(); ++i) {
        const double norm = *parseNumber(expected[i][8]);
        difference += std::pow(force.force.curve[i] - norm, 2);
        size += norm * norm;
    }
    EXPECT_LT(std::sqrt(difference / size), 1e-4);

    std::vector<int> minima;
    for (const ForceMinimum& minimum : force.minima) {
        if (minimum.prominence >= 0.05) minima.push_back(minimum.frame);
    }
    EXPECT_EQ(minima, known["minima"].get<std::vector<int>>());
}

INSTANTIATE_TEST_SUITE_P(Recordings, Reference,
                         testing::Values("02_05", "49_02", "60_01", "61_01", "Boxing_Toes",
                                         "martial_04", "martial_06"));

// The same capture in two formats and two skeletons: the frames correspond, the BVH has a T-pose
// in front.
TEST(SameMotion, AsAmcAndAsBvh) {
    KUMITE_NEEDS_DATA();
    const auto folder = *test::dataFolder() / "cmu_karate";
    TakeRequest request;
    request.fighters.emplace_back().path = folder / "135_06-martialArts.amc";
    request.fighters.emplace_back().path = folder / "martial_06.bvh";
    Project project = addTake({}, importTake(request).take)->project;
    EXPECT_EQ(project.takes[0].fighters[0].frames, (FrameRange{0, 3261}));
    EXPECT_EQ(project.takes[0].fighters[1].frames, (FrameRange{1, 3262}));
    const Analysis analysis = analyse(project);
    const FighterAnalysis& amc = analysis.at({0, 0});
    const FighterAnalysis& bvh = analysis.at({0, 1});
    // The BVH was retargeted to other proportions and rest angles, so a joint's flexion may differ
    // by a constant, but by nothing else; its filtered first frames are left out.
    using enum Role;
    const std::vector<std::array<Role, 3>> limbs = {{LeftHip, LeftKnee, LeftAnkle},
                                                    {RightHip, RightKnee, RightAnkle},
                                                    {LeftShoulder, LeftElbow, LeftWrist},
                                                    {RightShoulder, RightElbow, RightWrist}};
    for (const auto& [top, middle, end] : limbs) {
        std::vector<double> differences;
        for (int frame = 20; frame < 3261; frame += 10) {
            const auto flexion = [&, top = top, middle = middle,
                                  end = end](const FighterAnalysis& f) {
                const auto at = [&](Role role) {
                    return f.motion->positions.at(frame, *f.input.roles[role]);
                };
                const Eigen::Vector3f upper = (at(middle) - at(top)).normalized();
                const Eigen::Vector3f lower = (at(end) - at(middle)).normalized();
                return std::acos(std::clamp(upper.dot(lower), -1.0f, 1.0f)) * 180 / M_PI;
            };
            differences.push_back(flexion(amc) - flexion(bvh));
        }
        double mean = 0, spread = 0;
        for (const double d : differences)
            mean += d / static_cast<double>(differences.size());
        for (const double d : differences)
            spread = std::max(spread, std::abs(d - mean));
        EXPECT_LT(std::abs(mean), 20) << roleName(middle);
        EXPECT_LT(spread, 8) << roleName(middle) << ", degrees";
    }
    double dot = 0, a2 = 0, b2 = 0;
    for (std::size_t i = 60; i < 3200; ++i) {
        const double a = amc.force->force.curve[i] - 1, b = bvh.force->force.curve[i] - 1;
        dot += a * b;
        a2 += a * a;
        b2 += b * b;
    }
    EXPECT_GT(dot / std::sqrt(a2 * b2), 0.95) << "correlation of the two force curves";
}

}  // namespace
}  // namespace kumite
