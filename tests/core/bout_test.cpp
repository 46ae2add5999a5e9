// Bouts: the stream, its modes, its tape, and how it becomes a take.
#include "core/synthesis/bout_tape.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/project/bout.h"
#include "core/project/kept_bout.h"
#include "core/project/labels.h"
#include "core/synthesis/moments.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"
#include "tests/support/labelled_bout.h"

namespace kumite {
namespace {

/// One made bout for all tests: making it costs most of the time.
class BoutTest : public testing::Test {
protected:
    static inline test::TemporaryFolder* folder = nullptr;
    static inline test::LabelledBout* made = nullptr;
    static inline std::shared_ptr<const BoutLibrary> library;

    static void SetUpTestSuite() {
        folder = new test::TemporaryFolder;
        made = new test::LabelledBout(folder->path(), 60, 5);
        library = boutLibrary(made->project, made->analysis, made->interaction);
    }
    static void TearDownTestSuite() {
        library.reset();
        delete made;
        delete folder;
    }
    static BoutSettings seeded(std::uint64_t seed) {
        BoutSettings settings;
        settings.seed = seed;
        return settings;
    }
    static BoutTape shown(const BoutSettings& settings, int frames,
                          std::shared_ptr<const BoutLibrary> from = library) {
        BoutTape tape(std::move(from), settings);
        tape.advance(frames);
        return tape;
    }
};

void expectSame(const Bout& a, const Bout& b) {
    ASSERT_EQ(a.frame(), b.frame());
    for (const int player : {0, 1}) {
        const Pose& p = a.shown(player).pose;
        const Pose& q = b.shown(player).pose;
        ASSERT_EQ(p.root, q.root) << "frame " << a.frame();
        for (std::size_t j = 0; j < p.turns.size(); ++j)
            ASSERT_EQ(p.turns[j].coeffs(), q.turns[j].coeffs()) << "joint " << j;
        ASSERT_EQ(a.shown(player).action, b.shown(player).action);
    }
}

TEST_F(BoutTest, StartsAsSomethingThatWasRecorded) {
    const Bout bout(library, seeded(3));
    std::array<Eigen::Vector2d, 2> recorded;
    int take = -1, seconds = -1;
    for (const int player : {0, 1}) {
        const FighterShown& shown = bout.shown(player);
        const BoutAction& action = library->fighter(player).action(shown.action);
        const LibraryClip& clip = library->fighter(player).clipOf(action);
        const int frame = action.begin - shown.actionBegin;
        recorded[static_cast<std::size_t>(player)] = clip.stationAt(frame).root;
        const int now = static_cast<int>(std::lround(60 * clip.secondsAt(frame)));
        if (player == 1) {
            EXPECT_EQ(action.clip, take);
            EXPECT_NEAR(now, seconds, 1) << "one moment of the recording";
        }
        take = action.clip;
        seconds = now;
    }
    const Eigen::Vector3d apart = bout.shown(0).pose.root - bout.shown(1).pose.root;
    EXPECT_NEAR(std::hypot(apart.x(), apart.z()), (recorded[0] - recorded[1]).norm(), 0.02);
}

TEST_F(BoutTest, TheSameSeedGivesTheSameBytes) {
    const BoutTape one = shown(seeded(7), 600);
    const BoutTape two = shown(seeded(7), 600);
    EXPECT_EQ(boutLog(one), boutLog(two));
    expectSame(one.now(), two.now());
    EXPECT_NE(boutLog(one), boutLog(shown(seeded(8), 600)));
}

TEST_F(BoutTest, ASnapshotThatGoesOnShowsWhatTheOriginalShows) {
    Bout bout(library, seeded(2));
    for (int i = 0; i < 200; ++i)
        bout.step();
    Bout copy = bout;
    for (int i = 0; i < 200; ++i) {
        bout.step();
        copy.step();
    }
    expectSame(bout, copy);
}

TEST_F(BoutTest, RewindingAndResumingEqualsNeverHavingStopped) {
    BoutTape tape = shown(seeded(4), 700);
    const std::string log = boutLog(tape);
    for (const int frame : {333, 240, 239, 0, 699, 1}) {
        tape.seek(frame);
        expectSame(tape.now(), shown(seeded(4), frame).now());
    }
    tape.seek(100);
    tape.advance(600);
    expectSame(tape.now(), shown(seeded(4), 700).now());
    EXPECT_EQ(boutLog(tape), log);
    tape.seek(250);
    tape.cut();
    EXPECT_EQ(tape.end(), 250);
    tape.advance(450);
    EXPECT_EQ(boutLog(tape), log) << "nothing else was asked for";
}

TEST_F(BoutTest, ResumesWithAnotherSeedFromTheMomentOn) {
    BoutTape tape = shown(seeded(4), 600);
    tape.seek(200);
    BoutCommand command;
    command.kind = BoutCommand::Kind::Seed;
    command.seed = 99;
    tape.command(command);
    tape.advance(400);
    const BoutTape plain = shown(seeded(4), 600);
    BoutTape replayed(library, seeded(4), tape.commands());
    replayed.advance(600);
    EXPECT_EQ(boutLog(tape), boutLog(replayed)) << "log and commands tell the whole bout";
    EXPECT_NE(boutLog(tape), boutLog(plain));
    tape.seek(200);
    BoutTape before = shown(seeded(4), 200);
    expectSame(tape.now(), before.now());
}

TEST_F(BoutTest, AnotherChoiceIsTakenWhereItWasMade) {
    BoutTape tape = shown(seeded(6), 600);
    const auto choice = tape.choices()[5];
    const auto other = std::find_if(
        choice->options.options.begin(), choice->options.options.end(), [&](const Option& each) {
            return each.candidate.transition >= 0 && each.candidate.node != choice->node;
        });
    ASSERT_NE(other, choice->options.options.end());
    tape.chooseInstead(*choice, other->candidate.node);
    EXPECT_EQ(tape.frame(), choice->frame);
    EXPECT_LE(tape.choices().size(), 5u);
    tape.advance(200);
    const auto again =
        std::find_if(tape.choices().begin(), tape.choices().end(), [&](const auto& each) {
            return each->frame == choice->frame && each->player == choice->player;
        });
    ASSERT_NE(again, tape.choices().end());
    EXPECT_EQ((*again)->node, other->candidate.node);
    EXPECT_TRUE((*again)->forced);
    EXPECT_EQ((*again)->own, choice->own);
    EXPECT_EQ((*again)->transition, other->candidate.transition);
}

TEST_F(BoutTest, ActionsChainByStanceWhereOneIsThere) {
    const BoutTape tape = shown(seeded(1), 1800);
    std::array<int, 2> stance = {-1, -1};
    int followed = 0;
    for (const auto& choice : tape.choices()) {
        const BoutAction& action = library->fighter(choice->player).action(choice->action);
        int& now = stance[static_cast<std::size_t>(choice->player)];
        if (now >= 0 && !choice->options.stanceGaveWay) {
            EXPECT_EQ(action.firstStance, now);
            ++followed;
        }
        now = action.lastStance;
    }
    EXPECT_GT(followed, 50);
}

TEST_F(BoutTest, MomentsOfStrikeAndReactionMeetWithTheRecordedLag) {
    const BoutTape tape = shown(seeded(1), 3600);
    int coupled = 0, met = 0;
    BoutTape looking = tape;
    for (const auto& choice : tape.choices()) {
        if (!choice->coupling) continue;
        ++coupled;
        const Coupling& coupling = *choice->coupling;
        EXPECT_GE(coupling.meeting.own, kLeastWarp);
        EXPECT_LE(coupling.meeting.own, kMostWarp);
        if (std::abs(coupling.meeting.error) > 1e-6) continue;
        ++met;
        looking.seek(choice->frame + 1);
        // Where both changed at once, the other shows something else by now.
        if (looking.now().newChoices().size() > 1) continue;
        const Bout& bout = looking.now();
        const double lag =
            bout.shown(choice->player).momentFrame - bout.shown(1 - choice->player).momentFrame;
        EXPECT_NEAR(lag / library->rate, coupling.lag, 1 / library->rate + 1e-6)
            << "frame " << choice->frame;
    }
    EXPECT_GT(coupled, 5);
    EXPECT_GT(met, coupled / 3);
}

TEST_F(BoutTest, BannedLabelsStayAway) {
    BoutCommand ban;
    ban.kind = BoutCommand::Kind::Weigh;
    ban.number = 0;
    const int node = shown(seeded(1), 600).choices()[3]->node;
    const int player = shown(seeded(1), 600).choices()[3]->player;
    ban.player = player;
    ban.words = library->graph->node(player, node).text;
    BoutTape tape(library, seeded(1), {ban});
    tape.advance(1200);
    for (const auto& choice : tape.choices()) {
        if (choice->player == player && !choice->options.banGaveWay) {
            EXPECT_NE(choice->node, node);
        }
    }
}

// ---- avatar ------------------------------------------------------------------------------------

TEST_F(BoutTest, TheAvatarServesItsCommandAndForgetsIt) {
    const auto with = withAvatar(library, 0);
    BoutSettings settings = seeded(1);
    settings.mode = BoutMode::Avatar;
    settings.reactFirst = false;
    for (const std::string words : {"kick", "left_punch", "punch"}) {
        BoutTape tape = shown(settings, 90, with);
        BoutCommand command;
        command.words = words;
        tape.command(command);
        EXPECT_EQ(tape.now().wish(), words);
        const auto nodes = commandedNodes(*with, 0, words);
        for (int i = 0; i < 200 && !tape.now().wish().empty(); ++i)
            tape.advance(1);
        EXPECT_TRUE(tape.now().wish().empty()) << words;
        const auto choice = tape.now().choice(0);
        EXPECT_TRUE(choice->commanded);
        EXPECT_TRUE(std::find(nodes.begin(), nodes.end(), choice->node) != nodes.end());
        EXPECT_GE(choice->frame, 90);
    }
    Bout bout(with, settings);
    BoutCommand unknown;
    unknown.words = "headbutt";
    EXPECT_THROW(bout.apply(unknown), Error);
    EXPECT_THROW(Bout(library, seeded(1)).apply(BoutCommand{}), Error) << "nobody is steered";
}

TEST_F(BoutTest, UnderAttackTheAvatarMayAnswerFirst) {
    const auto with = withAvatar(library, 0);
    BoutSettings settings = seeded(1);
    settings.mode = BoutMode::Avatar;
    settings.reactFirst = false;
    BoutTape obeying = shown(settings, 1, with);
    settings.reactFirst = true;
    BoutTape answering = shown(settings, 1, with);
    const auto firstChoice = [](BoutTape tape) {
        BoutCommand command;
        command.words = "kick";
        tape.command(command);
        const std::size_t before = tape.choices().size();
        while (true) {
            tape.advance(1);
            for (std::size_t i = before; i < tape.choices().size(); ++i) {
                if (tape.choices()[i]->player == 0) return tape.choices()[i];
            }
        }
    };
    int answered = 0;
    for (int moment = 0; moment < 100 && (moment < 10 || answered == 0); ++moment) {
        EXPECT_TRUE(firstChoice(obeying)->commanded);
        answered += !firstChoice(answering)->commanded;
        obeying.advance(20);
        answering.advance(20);
    }
    EXPECT_GT(answered, 0);
}

TEST_F(BoutTest, TheAvatarReachesATargetInReach) {
    const auto with = withAvatar(library, 0);
    double sum = 0;
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        BoutSettings settings = seeded(seed);
        settings.mode = BoutMode::Avatar;
        BoutTape tape = shown(settings, 60, with);
        const Eigen::Vector3d from = tape.now().shown(0).pose.root;
        const Eigen::Vector3d ahead = tape.now().shown(1).pose.root - from;
        BoutCommand command;
        command.kind = BoutCommand::Kind::Target;
        // Three quarters of a metre to the side.
        command.target = Eigen::Vector2d(from.x(), from.z()) +
                         0.75 * Eigen::Vector2d(ahead.z(), -ahead.x()).normalized();
        tape.command(command);
        tape.advance(300);
        const Eigen::Vector3d at = tape.now().shown(0).pose.root;
        const double error = (Eigen::Vector2d(at.x(), at.z()) - command.target).norm();
        EXPECT_LT(error, 0.5) << "seed " << seed;
        sum += error;
    }
    EXPECT_LT(sum / 4, 0.35);
}

// ---- passive -----------------------------------------------------------------------------------

TEST_F(BoutTest, PassiveLeavesTheAttackUnusedAndTheOtherDoesNotAttack) {
    const CapturedAttack attack = busiestAttack(made->interaction, 1);
    EXPECT_GT(attack.actions.size(), 5u);
    const Interaction rest = interactionWithout(made->analysis, made->interaction, attack);
    const auto out = leftOutWith(*made->interaction.graph, attack);
    EXPECT_LT(rest.graph->transitions[0].size(), made->interaction.graph->transitions[0].size());
    BoutSettings settings = seeded(3);
    settings.mode = BoutMode::Passive;
    settings.attacker = 1;
    settings.attack = attack.actions;
    const BoutTape tape = shown(settings, 1500, boutLibrary(made->project, made->analysis, rest));
    EXPECT_FALSE(out[0][static_cast<std::size_t>(tape.first().shown(0).action)]);
    std::size_t replayed = 1;
    for (const auto& choice : tape.choices()) {
        if (choice->player == 1) {
            EXPECT_EQ(choice->action, attack.actions[replayed++ % attack.actions.size()]);
            continue;
        }
        EXPECT_FALSE(out[0][static_cast<std::size_t>(choice->action)]);
        EXPECT_FALSE(
            strikes(library->vocabulary(), made->interaction.graph->node(0, choice->node).label));
        for (const Option& option : choice->options.options) {
            if (option.candidate.transition < 0) continue;
            const Transition& t =
                rest.graph->transitions[0][static_cast<std::size_t>(option.candidate.transition)];
            EXPECT_FALSE(out[0][static_cast<std::size_t>(t.own)]);
            EXPECT_FALSE(out[0][static_cast<std::size_t>(t.next)]);
            EXPECT_FALSE(out[1][static_cast<std::size_t>(t.opponent)]);
        }
    }
    EXPECT_GT(replayed, 10u);
    EXPECT_THROW(attackIn(made->interaction, 1, 0, {100000, 100001}), Error);
}

// ---- long runs and poor models -----------------------------------------------------------------

/// Both stand upright somewhere near each other and move as bodies can.
void expectSane(const Bout& bout, const Bout* before) {
    const Eigen::Vector3d apart = bout.shown(0).pose.root - bout.shown(1).pose.root;
    ASSERT_LT(apart.norm(), 6) << "frame " << bout.frame();
    for (const int player : {0, 1}) {
        const JointFrames& joints = bout.shown(player).joints;
        for (std::size_t j = 0; j < joints.positions.size(); ++j) {
            ASSERT_TRUE(joints.positions[j].allFinite()) << "frame " << bout.frame();
            ASSERT_GT(joints.positions[j].y(), -0.2) << "frame " << bout.frame();
            ASSERT_LT(joints.positions[j].y(), 3.2) << "frame " << bout.frame();
            if (!before) continue;
            const double way =
                (joints.positions[j] - before->shown(player).joints.positions[j]).norm();
            ASSERT_LT(way * bout.library().rate, 30) << "joint " << j << ", frame " << bout.frame();
        }
    }
}

TEST_F(BoutTest, ALongBoutStaysSane) {
    Bout bout(library, seeded(11));
    std::set<std::pair<int, int>> actions;
    for (int i = 0; i < 60 * 80; ++i) {
        const Bout before = bout;
        bout.step();
        expectSane(bout, &before);
        if (HasFatalFailure()) return;
        for (const auto& choice : bout.newChoices())
            actions.insert({choice->player, choice->action});
    }
    EXPECT_GT(actions.size(), 30u) << "it does not go round in a small circle";
}

/// The bobbing bout with labels by action; "" leaves one open.
struct PoorBout {
    Project project = test::makeBout();
    Analysis analysis = analyse(project);
    Interaction interaction;

    explicit PoorBout(const std::function<std::string(int player, int action)>& label) {
        std::vector<ActionAnswer> answers;
        for (const int player : {0, 1}) {
            const auto& actions = analysis.at({0, player}).segmentation->actions;
            for (int i = 0; i < static_cast<int>(actions.size()); ++i) {
                const std::string text = label(player, i);
                if (text.empty()) continue;
                answers.push_back({{0, player}, i, parseLabel(kickboxing(), text)});
            }
        }
        if (const auto edit = setLabels(project, analysis, answers)) project = edit->project;
        interaction = deriveInteraction(project, analysis);
    }
    std::shared_ptr<const BoutLibrary> library() const {
        return boutLibrary(project, analysis, interaction);
    }
};

TEST(PoorBouts, OneLabelGoesOnForEver) {
    const PoorBout poor([](int, int) { return "move:L-L"; });
    ASSERT_EQ(poor.interaction.graph->nodeCount(0), 1);
    Bout bout(poor.library(), {});
    for (int i = 0; i < 2000; ++i) {
        bout.step();
        expectSane(bout, nullptr);
    }
}

TEST(PoorBouts, ASingleSampleIsShownOverAndOver) {
    // Player 1 knows one transition; player 2 a few.
    const PoorBout poor([](int player, int action) -> std::string {
        if (player == 0 && action != 4 && action != 5) return "";
        return action % 2 ? "right_punch:fwd+move:L-R" : "move:R-L";
    });
    ASSERT_EQ(poor.interaction.graph->transitions[0].size(), 1u);
    Bout bout(poor.library(), {});
    int choices = 0;
    for (int i = 0; i < 1500; ++i) {
        bout.step();
        expectSane(bout, nullptr);
        for (const auto& choice : bout.newChoices()) {
            choices += choice->player == 0;
            if (choice->player == 0) {
                EXPECT_EQ(choice->action, 5);
            }
        }
    }
    EXPECT_GT(choices, 10);
}

TEST(PoorBouts, WithoutLabelsOrWithOneFighterAloneASentenceSaysSo) {
    const PoorBout none([](int, int) { return ""; });
    EXPECT_THROW(none.library(), Error);
    const PoorBout half([](int player, int action) -> std::string {
        if (player == 1) return action == 3 ? "move:L-L" : "";
        return "move:R-L";
    });
    ASSERT_EQ(half.interaction.graph->transitions[1].size(), 0u);
    try {
        const Bout bout(half.library(), {});
        FAIL() << "player 2 has nothing to choose";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("Player 2"), std::string::npos) << error.what();
    }
}

// ---- scripts and takes -------------------------------------------------------------------------

TEST(BoutScript, ReadsWhatItWrites) {
    const std::string text = R"({"kumite_script": 1, "commands": [
        {"at": 2, "target": [0.5, -1]}, {"at": 0.5, "act": "right_kick:up"},
        {"at": 3, "target": []}, {"at": 1, "release": true},
        {"at": 4, "player": 2, "choose": "jump:up"}, {"at": 4, "player": 1, "weigh": "jump:up",
        "factor": 0.5}, {"at": 5, "seed": 12}, {"at": 6, "temperature": 0.5}]})";
    const auto commands = parseScript(text, "s.json", 60);
    ASSERT_EQ(commands.size(), 8u);
    EXPECT_EQ(commands[0].frame, 30) << "in order of time";
    EXPECT_EQ(commands[0].words, "right_kick:up");
    EXPECT_EQ(commands[2].target, Eigen::Vector2d(0.5, -1));
    EXPECT_EQ(commands[3].kind, BoutCommand::Kind::NoTarget);
    EXPECT_EQ(commands[4].player, 1);
    EXPECT_EQ(commands[6].seed, 12u);
    EXPECT_EQ(parseScript(scriptText(commands, 60), "again", 60), commands);
}

TEST(BoutScript, NamesWhatIsWrong) {
    const auto message = [](const std::string& commands) -> std::string {
        try {
            parseScript(R"({"kumite_script": 1, "commands": [)" + commands + "]}", "s.json", 60);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
             {R"({"act": "kick"})", "at"},
             {R"({"at": -1, "act": "kick"})", "at"},
             {R"({"at": 1})", "expected one of"},
             {R"({"at": 1, "target": [1]})", "target"},
             {R"({"at": 1, "target": [1, "x"]})", "target"},
             {R"({"at": 1, "act": "kick", "speed": 3})", "speed"},
             {R"({"at": 1, "choose": "jump:up", "player": 3})", "player"},
             {R"({"at": 1, "seed": 1.5})", "seed"},
             {R"({"at": 1, "seed": -1})", "seed"}}) {
        const std::string found = message(text);
        EXPECT_NE(found.find("commands[0]"), std::string::npos) << text << ": " << found;
        EXPECT_NE(found.find(word), std::string::npos) << text << ": " << found;
    }
    EXPECT_THROW(parseScript("{}", "s.json", 60), InputError);
    EXPECT_THROW(parseScript(R"({"kumite_script": 2, "commands": []})", "s", 60), InputError);
}

TEST_F(BoutTest, KeptAsATakeItHasTheActionsAndLabelsThatWereChosen) {
    const BoutTape tape = shown(seeded(2), 900);
    test::TemporaryFolder out;
    const KeptBout kept = keepBout(made->project, made->analysis, tape, "made bout", out.path());
    ASSERT_EQ(kept.edit.project.takes.size(), 2u);
    EXPECT_EQ(made->project.takes.size(), 1u);
    for (const auto& file : kept.files)
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
    const Analysis analysis = analyse(kept.edit.project);
    for (const int player : {0, 1}) {
        const FighterAnalysis& fighter = analysis.at({1, player});
        EXPECT_EQ(fighter.frameCount(), 901);
        std::vector<int> chosen = {0}, cut;
        std::vector<int> nodes = {tape.first().shown(player).node};
        for (const auto& choice : tape.choices()) {
            if (choice->player != player || choice->frame >= 900) continue;
            if (choice->frame == 0) {
                chosen.pop_back();
                nodes.pop_back();
            }
            chosen.push_back(choice->frame);
            nodes.push_back(choice->node);
        }
        for (const Action& action : fighter.segmentation->actions)
            cut.push_back(action.begin);
        EXPECT_EQ(cut, chosen);
        EXPECT_TRUE(fighter.segmentation->unmatched.empty());
        const auto labels =
            actionLabels(kept.edit.project.takes[1].fighters[static_cast<std::size_t>(player)],
                         fighter, kickboxing().size());
        ASSERT_EQ(labels.size(), nodes.size());
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            // Of the last one too little may have been shown.
            if (i + 1 == nodes.size() && !labels[i].anyByHand()) continue;
            EXPECT_EQ(labels[i].label(), library->graph->node(player, nodes[i]).label) << i;
            EXPECT_TRUE(labels[i].anyByHand());
        }
        // What was written is what was shown.
        const Bout end = tape.now();
        for (const auto role : {Role::Head, Role::LeftWrist, Role::RightAnkle}) {
            const int joint = *fighter.input.roles[role];
            const Eigen::Vector3d placedPoint =
                placed(fighter.input, fighter.body->floor,
                       fighter.motion->positions.at(900, joint).cast<double>());
            EXPECT_LT(
                (placedPoint - end.shown(player).joints.positions[static_cast<std::size_t>(joint)])
                    .norm(),
                0.001);
        }
    }
    EXPECT_THROW(keepBout(made->project, made->analysis, tape, "made bout", out.path()), Error);
    EXPECT_THROW(keepBout(made->project, made->analysis, tape, "demo", out.path()), Error);
}

}  // namespace
}  // namespace kumite
