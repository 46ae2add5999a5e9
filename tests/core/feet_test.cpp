#include "core/motion/feet.h"

#include <gtest/gtest.h>

#include "core/formats/recording.h"
#include "core/motion/role_mapping.h"
#include "tests/support/builders.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

using Track = std::vector<Eigen::Vector3f>;

Track trackOf(const nlohmann::json& rows) {
    Track track;
    for (const auto& row : rows) {
        track.emplace_back(row[0].get<float>(), row[1].get<float>(), row[2].get<float>());
    }
    return track;
}

TEST(FootSkate, KnownAnswerOfAMadeTrack) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer("skating_track");
    const auto& input = known["input"];
    const FootSkate skate =
        measureFootSkate(trackOf(input["left_toe"]), trackOf(input["right_toe"]),
                         input["rate_hz"].get<double>(), input["floor_m"].get<double>());
    EXPECT_EQ(skate.intervals, known["expected"]["intervals"]);
    EXPECT_EQ(skate.left, known["expected"]["skating_left"]);
    EXPECT_EQ(skate.right, known["expected"]["skating_right"]);
    EXPECT_EQ(skate.either, known["expected"]["skating_any"]);
    EXPECT_NEAR(skate.ratio(), known["expected"]["ratio"].get<double>(), 1e-9);
}

TEST(FootSkate, KnownAnswersOfRecordings) {
    KUMITE_NEEDS_DATA();
    for (const char* name : {"skating_martial_04", "skating_salsa_61_01"}) {
        const auto known = test::knownAnswer(name);
        const auto& input = known["input"];
        const Recording recording =
            readRecording(*test::dataFolder() / input["file"].get<std::string>());
        const Motion& motion = *recording.motions.front();
        const SpaceConvention space{input["metres_per_unit"].get<double>(), UpAxis::Y};
        const JointPositions positions =
            forwardKinematics(motion, {input["trim"].get<int>(), motion.frameCount}, space);
        const RoleMap roles = mapRoles(*motion.skeleton).roles;
        std::array<Track, 2> toes;
        for (int frame = 0; frame < positions.frameCount; ++frame) {
            toes[0].push_back(positions.at(frame, *footPoint(*motion.skeleton, roles, true)));
            toes[1].push_back(positions.at(frame, *footPoint(*motion.skeleton, roles, false)));
        }
        EXPECT_NEAR(*floorHeight(*motion.skeleton, roles, positions),
                    input["floor_m"].get<double>(), 5e-4);
        const FootSkate skate = measureFootSkate(toes[0], toes[1], input["rate_hz"].get<double>(),
                                                 input["floor_m"].get<double>());
        EXPECT_EQ(skate.intervals, known["expected"]["intervals"]);
        EXPECT_NEAR(skate.ratio(), known["expected"]["ratio"].get<double>(),
                    known["tolerance"]["ratio"].get<double>());
    }
}

TEST(FootSkate, NothingToMeasureInOneFrame) {
    const Track one(1, Eigen::Vector3f::Zero());
    EXPECT_EQ(measureFootSkate(one, one, 60, 0).intervals, 0);
    EXPECT_EQ(measureFootSkate({}, {}, 60, 0).ratio(), 0.0);
}

TEST(Floor, IsTheFifthPercentileOfTheLowerToe) {
    // The root rises by 1 mm a frame over 101 frames: the 5th percentile is 5 mm up.
    const auto motion = test::bobbing(101, 60, [](double t) { return 0.001 * std::round(60 * t); });
    const RoleMap roles = mapRoles(*motion->skeleton).roles;
    const auto positions = forwardKinematics(*motion, motion->frames(), {0.01, UpAxis::Y});
    EXPECT_NEAR(*floorHeight(*motion->skeleton, roles, positions), 0.005, 1e-6);
    EXPECT_EQ(floorHeight(*motion->skeleton, RoleMap(), positions), std::nullopt);
}

}  // namespace
}  // namespace kumite
