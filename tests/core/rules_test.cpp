#include "core/labelling/rules.h"

#include <gtest/gtest.h>

#include "tests/support/known_answers.h"

namespace kumite {
namespace {

TEST(MoveRule, KnownAnswers) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer("move_rule");
    for (const auto& take : known["takes"]) {
        const FootContacts contacts{take["left"].get<std::vector<std::uint8_t>>(),
                                    take["right"].get<std::vector<std::uint8_t>>()};
        const std::vector<Stance> stand = stances(contacts);
        std::string letters;
        for (const Stance stance : stand)
            letters += stanceLetter(stance);
        EXPECT_EQ(letters, take["expected_stance"]) << take["what"];
        const auto cuts = take["boundaries"].get<std::vector<int>>();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            EXPECT_EQ(moveOf({cuts[i], cuts[i + 1], cuts[i]}, stand).symbol(),
                      take["expected_move"][i])
                << take["what"];
        }
    }
}

TEST(MoveRule, OneLegOrNone) {
    EXPECT_TRUE(stances({}).empty());
    const auto stand = stances({{1, 0, 1}, {}});
    EXPECT_EQ(moveOf({0, 1, 0}, stand).symbol(), "L-F");
    EXPECT_EQ(moveText(moveOf({0, 1, 0}, stand)),
              "stands left at the beginning, in the air at the end");
}

/// Two fighters 2 m apart on the z axis; fighter 1 stands still at z = 0, fighter 2 at z = 2 with
/// limbs that go toward fighter 1 with given speeds (m/s) from 0.5 s on. 60 Hz, 2 s.
struct Scene {
    std::vector<Action> own = {{0, 30, 15}, {30, 60, 45}, {60, 120, 90}};
    std::vector<Action> theirs = {{0, 30, 15}, {30, 60, 45}, {60, 120, 90}};
    std::map<Role, double> speed;
    double offset = 0;  ///< of fighter 2 on the clock
    double theirRate = 60;

    FighterView player() const {
        FighterView view{own, 60, 0, 121, {}, {}};
        view.limbEnd = [](int, Role) { return Eigen::Vector3d(0, 1, 0); };
        view.body = [](int) -> std::array<Eigen::Vector3d, 3> {
            return {Eigen::Vector3d(0, 0.9, 0), Eigen::Vector3d(0, 1.4, 0),
                    Eigen::Vector3d(0, 1.6, 0)};
        };
        return view;
    }
    FighterView opponent() const {
        FighterView view{theirs, theirRate, offset, 121, {}, {}};
        view.limbEnd = [this](int frame, Role limb) -> std::optional<Eigen::Vector3d> {
            const double t = std::clamp(frame / theirRate - 0.5, 0.0, 0.5);
            const auto found = speed.find(limb);
            if (found == speed.end()) return Eigen::Vector3d(0, 1.2, 2);
            return Eigen::Vector3d(0, 1.2, 2 - found->second * t);
        };
        view.body = player().body;
        return view;
    }
    Reaction react(int action, const std::string& label, const RuleSettings& settings = {}) const {
        const Vocabulary& v = kickboxing();
        const std::vector<Label> labels(theirs.size(), parseLabel(v, label));
        return reactionOf(v, v[*v.find("react")], player(), action, opponent(), labels, settings);
    }
};

TEST(ReactRule, ToAKickThatComesNearer) {
    const Scene scene{.speed = {{Role::RightToe, 3.0}}};
    const Reaction reaction = scene.react(1, "right_kick:up");
    EXPECT_EQ(reaction.qualifier, "kick");
    EXPECT_EQ(reaction.opponentAction, 1);
    EXPECT_NEAR(reaction.closing, 3.0, 1e-9);
    EXPECT_EQ(reactionText(kickboxing(), reaction), "opponent's right kick up, closing 3.0 m/s");
    EXPECT_EQ(scene.react(1, "right_kick:downup").qualifier, "kick");
    EXPECT_EQ(scene.react(1, "right_kick:down").qualifier, "");
    EXPECT_EQ(scene.react(1, "left_kick:up").qualifier, "") << "the other foot stays where it is";
}

TEST(ReactRule, OnlyAttacksThatCloseByMoreThanOneMetreASecond) {
    const Scene slow{.speed = {{Role::LeftWrist, 0.9}}};
    const Reaction reaction = slow.react(1, "left_punch:fwd");
    EXPECT_EQ(reaction.qualifier, "");
    EXPECT_EQ(reactionText(kickboxing(), reaction),
              "opponent's left punch forward, closing only 0.9 m/s");
    RuleSettings settings;
    settings.closingSpeed = 0.5;
    EXPECT_EQ(slow.react(1, "left_punch:fwd", settings).qualifier, "punch");
    const Scene retreating{.speed = {{Role::LeftWrist, -4.0}}};
    EXPECT_EQ(retreating.react(1, "left_punch:fwd").closing, 0);
}

TEST(ReactRule, AKickGoesBeforeAPunchIfItCounts) {
    Scene both{.speed = {{Role::LeftWrist, 5.0}, {Role::RightToe, 2.0}}};
    const char* label = "left_punch:fwdbwd+right_kick:up";
    EXPECT_EQ(both.react(1, label).qualifier, "kick");
    both.speed[Role::RightToe] = 0.2;
    const Reaction reaction = both.react(1, label);
    EXPECT_EQ(reaction.qualifier, "punch") << "the kick does not come nearer";
    EXPECT_NEAR(reaction.closing, 5.0, 1e-9);
}

TEST(ReactRule, TheActionThatOverlapsLongestTheEarlierOfTwo) {
    Scene scene;
    scene.theirs = {{0, 40, 20}, {40, 60, 50}, {60, 120, 90}};
    EXPECT_EQ(correspondingAction(scene.player(), 1, scene.opponent()), 1) << "20 of 30 frames";
    scene.theirs = {{0, 45, 20}, {45, 60, 50}, {60, 120, 90}};
    EXPECT_EQ(correspondingAction(scene.player(), 1, scene.opponent()), 0) << "15 and 15";
    scene.offset = 10.0;
    EXPECT_EQ(correspondingAction(scene.player(), 1, scene.opponent()), std::nullopt);
    EXPECT_EQ(reactionText(kickboxing(), scene.react(1, "left_punch:fwd")),
              "no action of the opponent at that time");
}

TEST(ReactRule, OnTheTakesClockWhateverTheRates) {
    // Fighter 2 recorded at 30 Hz and started 0.25 s later: its frame 15 is at 0.75 s.
    Scene scene{.speed = {{Role::RightWrist, 3.0}}, .offset = 0.25, .theirRate = 30};
    scene.theirs = {{0, 12, 6}, {12, 30, 20}};
    // Action 1 of fighter 1 lasts from 0.5 to 1 s; theirs change at 0.65 s.
    EXPECT_EQ(correspondingAction(scene.player(), 1, scene.opponent()), 1);
    const Reaction reaction = scene.react(1, "right_punch:fwd");
    EXPECT_EQ(reaction.qualifier, "punch");
    EXPECT_NEAR(reaction.closing, 3.0, 1e-9);
}

TEST(ReactRule, UnknownLabelsAndMissingLimbsAreNoAttack) {
    const Scene scene{.speed = {{Role::RightWrist, 3.0}}};
    const Vocabulary& v = kickboxing();
    const std::vector<Label> unknown(3, Label(v.aspects.size(), kUnknown));
    const Aspect& react = v[*v.find("react")];
    EXPECT_EQ(reactionOf(v, react, scene.player(), 1, scene.opponent(), unknown, {}).qualifier, "");
    FighterView armless = scene.opponent();
    armless.limbEnd = [](int, Role) { return std::nullopt; };
    const std::vector<Label> punch(3, parseLabel(v, "right_punch:fwd"));
    EXPECT_EQ(reactionOf(v, react, scene.player(), 1, armless, punch, {}).qualifier, "");
}

}  // namespace
}  // namespace kumite
