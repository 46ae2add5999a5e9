#include "core/interaction/cross_validation.h"

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/demo/random.h"

namespace kumite {
namespace {

/// A bout drawn at random, without motions: labels that depend on what was before, numbers that
/// depend on labels.
struct RandomBout {
    CoupledGraph graph;
    BoutNumbers numbers;

    explicit RandomBout(int actions, int takes = 1, std::uint64_t seed = 3) {
        demo::Random random(seed);
        const Vocabulary& v = kickboxing();
        const std::vector<std::string> spellings = {"right_punch:fwd+move:L-R", "move:L-L",
                                                    "left_kick:up+move:R-R",
                                                    "right_punch:bwd+move:R-L"};
        std::vector<LabelledTake> all;
        for (int t = 0; t < takes; ++t) {
            LabelledTake& take = all.emplace_back();
            take.name = std::to_string(t);
            for (int p = 0; p < 2; ++p) {
                LabelledStream stream{60, 0, 0, {}, {}};
                int frame = 0, kind = 0;
                for (int i = 0; i < actions; ++i) {
                    const int end = frame + 20 + static_cast<int>(random.uniform(0, 40));
                    stream.actions.push_back({frame, end, (frame + end) / 2});
                    if (random.chance(0.8)) {
                        kind = (kind + 1) % 4;
                    } else {
                        kind = random.pick(std::vector<double>{1, 1, 1, 1});
                    }
                    stream.labels.push_back(
                        parseLabel(v, spellings[static_cast<std::size_t>(kind)]));
                    frame = end;
                }
                stream.frameCount = frame + 1;
                take.players.push_back(stream);
            }
        }
        graph = coupledGraph(v, all);
        for (const std::size_t player : {0, 1}) {
            for (const BasicAction& action : graph.actions[player]) {
                ActionSummary summary;
                summary.frames = action.frames.end - action.frames.begin;
                summary.rate = 60;
                for (auto* sample : {&summary.mean, &summary.first, &summary.last}) {
                    sample->root = {0.3 * action.node + random.normal(0, 0.2), random.normal(0, 1)};
                    sample->yaw = random.normal(0, 0.5);
                    for (double& value : sample->pose)
                        value = random.normal(0, 0.1);
                }
                numbers.summaries[player].push_back(summary);
            }
            numbers.grounds[player].resize(graph.transitions[player].size());
        }
    }
    /// Moments in which every frame is a pose of its own.
    static PoseMoments poses(int take, int player, FrameRange frames) {
        PoseMoments moments;
        for (int f = frames.begin; f < frames.end; ++f) {
            demo::Random random(static_cast<std::uint64_t>(1000000 * take + 500000 * player + f));
            LocalPose pose;
            for (Eigen::Index i = 0; i < kPoseNumbers; ++i)
                pose[i] = random.normal(0, 1.0 / (1.0 + static_cast<double>(i)));
            moments.count += 1;
            moments.sum += pose;
            moments.squares += pose * pose.transpose();
        }
        return moments;
    }
};

ValidationSettings quick() {
    ValidationSettings settings;
    settings.seeds = 2;
    settings.maxComponents = 4;
    return settings;
}

TEST(BoutSplit, SidesShareNoAction) {
    const RandomBout bout(200);
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const BoutSplit split = splitBout(bout.graph, quick(), seed);
        std::array<std::set<int>, 2> learnt, judged;
        double training = 0, validation = 0;
        for (const std::size_t mover : {0, 1}) {
            const auto& transitions = bout.graph.transitions[mover];
            ASSERT_EQ(split.sides[mover].size(), transitions.size());
            for (std::size_t i = 0; i < transitions.size(); ++i) {
                const HoldoutSide side = split.sides[mover][i];
                training += side == HoldoutSide::Training;
                validation += side == HoldoutSide::Validation;
                if (side == HoldoutSide::LeftOut) continue;
                auto& sets = side == HoldoutSide::Training ? learnt : judged;
                sets[mover].insert({transitions[i].own, transitions[i].next});
                sets[1 - mover].insert(transitions[i].opponent);
            }
        }
        for (const std::size_t player : {0, 1}) {
            for (const int action : judged[player])
                EXPECT_EQ(learnt[player].count(action), 0u);
            for (std::size_t i = 0; i < split.learnt[player].size(); ++i)
                EXPECT_EQ(split.learnt[player][i], learnt[player].count(static_cast<int>(i)) > 0);
        }
        EXPECT_NEAR(training / (training + validation), 0.68, 0.08);
    }
    EXPECT_NE(splitBout(bout.graph, quick(), 1).sides, splitBout(bout.graph, quick(), 2).sides);
}

TEST(BoutSplit, ByTakes) {
    const RandomBout bout(40, 4);
    ValidationSettings settings = quick();
    settings.split = SplitBy::Takes;
    const BoutSplit split = splitBout(bout.graph, settings, 1);
    std::array<std::set<HoldoutSide>, 4> sides;
    for (const std::size_t mover : {0, 1}) {
        for (std::size_t i = 0; i < split.sides[mover].size(); ++i) {
            const int take =
                bout.graph.action(static_cast<int>(mover), bout.graph.transitions[mover][i].next)
                    .take;
            sides[static_cast<std::size_t>(take)].insert(split.sides[mover][i]);
        }
    }
    for (const auto& side : sides)
        EXPECT_EQ(side.size(), 1u) << "a take is on one side as a whole";
    EXPECT_THROW(splitBout(RandomBout(40).graph, settings, 1), Error);
    EXPECT_THROW(splitBout(CoupledGraph{}, quick(), 1), Error);
}

TEST(CrossValidation, NothingOfTheValidationPartReachesTheTraining) {
    const RandomBout bout(150);
    ValidationSettings settings = quick();
    settings.seeds = 1;
    const BoutSplit split = splitBout(bout.graph, settings, settings.seed);
    // Only frames of training actions are looked at.
    const PoseSource watched = [&](int take, int player, FrameRange frames) {
        const auto& actions = bout.graph.actions[static_cast<std::size_t>(player)];
        bool allowed = false;
        for (std::size_t i = 0; i < actions.size(); ++i) {
            allowed =
                allowed ||
                (split.learnt[static_cast<std::size_t>(player)][i] && actions[i].take == take &&
                 actions[i].frames.begin <= frames.begin && frames.end <= actions[i].frames.end);
        }
        EXPECT_TRUE(allowed) << "player " << player << " frames " << frames.begin;
        return RandomBout::poses(take, player, frames);
    };
    const ValidationResult clean = crossValidate(bout.graph, bout.numbers, watched, settings);

    // What only the validation part shows is made absurd: the training figures do not move.
    RandomBout spoilt = bout;
    for (const std::size_t player : {0, 1}) {
        for (std::size_t i = 0; i < split.learnt[player].size(); ++i) {
            if (split.learnt[player][i]) continue;
            spoilt.numbers.summaries[player][i].mean.root.array() += 1000;
        }
        for (std::size_t i = 0; i < split.sides[player].size(); ++i) {
            if (split.sides[player][i] == HoldoutSide::Training) continue;
            Transition& t = spoilt.graph.transitions[player][i];
            t.nextNode = (t.nextNode + 1) % spoilt.graph.nodeCount(static_cast<int>(player));
        }
    }
    const ValidationResult other = crossValidate(spoilt.graph, spoilt.numbers, watched, settings);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(clean.labelTerm[i].train, other.labelTerm[i].train);
        EXPECT_EQ(clean.geometryTerm[i].train, other.geometryTerm[i].train);
        EXPECT_NE(clean.geometryTerm[i].validation, other.geometryTerm[i].validation);
    }
    for (std::size_t i = 0; i < clean.components.size(); ++i) {
        EXPECT_EQ(clean.components[i].density.train, other.components[i].density.train);
        EXPECT_EQ(clean.components[i].covered, other.components[i].covered);
    }
}

TEST(CrossValidation, FindsWhatThereIsToFind) {
    const RandomBout bout(300);
    const ValidationResult result =
        crossValidate(bout.graph, bout.numbers, RandomBout::poses, quick());
    EXPECT_EQ(result.seeds, 2);
    const auto label = [&](LabelEstimator e) {
        return result.labelTerm[static_cast<std::size_t>(e)];
    };
    EXPECT_NEAR(label(LabelEstimator::Uniform).validation, -std::log(4.0), 1e-12);
    EXPECT_GT(label(LabelEstimator::Equ7).validation, -1.0) << "the law is 80 % sure";
    EXPECT_GT(result.geometryTerm[static_cast<std::size_t>(CovarianceKind::SemiTied)].train,
              result.pooled.train)
        << "places depend on labels";
    for (const Averages& averages : result.geometryTerm)
        EXPECT_TRUE(std::isfinite(averages.train) && std::isfinite(averages.validation));
    ASSERT_EQ(result.components.size(), 4u);
    EXPECT_LT(result.components[0].covered, result.components[3].covered);
    const ValidationResult again =
        crossValidate(bout.graph, bout.numbers, RandomBout::poses, quick());
    EXPECT_EQ(again.geometryTerm[3].validation, result.geometryTerm[3].validation)
        << "whatever the threads do";
}

TEST(CrossValidation, CanBeCancelled) {
    const RandomBout bout(60);
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(crossValidate(bout.graph, bout.numbers, RandomBout::poses, quick(),
                               {{}, source.get_token()}),
                 Cancelled);
}

}  // namespace
}  // namespace kumite
