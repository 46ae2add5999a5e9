#include "core/transition/transition_synthesis.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/transition/playback.h"
#include "core/transition/sequence.h"
#include "tests/support/known_answers.h"
#include "tests/support/made_library.h"

namespace kumite {
namespace {

std::shared_ptr<const FlexibleGraph> graphOf(std::shared_ptr<const MotionLibrary> library,
                                             bool undirected = false) {
    FlexibleGraphSettings settings;
    settings.undirected = undirected;
    settings.secondsPerCluster = 0.3;
    settings.longestPath = 1000;
    return buildFlexibleGraph(std::move(library), settings);
}

/// The largest angle by which a joint turns from one pose to the next, and the root's step, m.
double stepBetween(const Pose& a, const Pose& b) {
    double most = (a.root - b.root).norm();
    for (std::size_t i = 0; i < a.turns.size(); ++i)
        most = std::max(most, a.turns[i].angularDistance(b.turns[i]));
    return most;
}

double largestStep(std::span<const Pose> frames) {
    double most = 0;
    for (std::size_t i = 1; i < frames.size(); ++i)
        most = std::max(most, stepBetween(frames[i - 1], frames[i]));
    return most;
}

double largestStep(const MotionLibrary& library) {
    double most = 0;
    for (const LibraryMotion& motion : library.motions)
        most = std::max(most, largestStep(motion.clip.frames));
    return most;
}

/// Whether two poses are one but for place and heading.
bool samePosture(const Pose& a, const Pose& b) {
    if (std::abs(a.root.y() - b.root.y()) > 1e-9) return false;
    for (std::size_t i = 1; i < a.turns.size(); ++i) {
        if (a.turns[i].angularDistance(b.turns[i]) > 1e-6) return false;
    }
    return true;
}

TEST(PoseMetric, LeavesOutPlaceAndHeading) {
    const auto library = test::madeLibrary();
    const PoseMetric metric(*library->rig);
    const auto& frames = library->motions[0].clip.frames;
    std::vector<Pose> away;
    for (const Pose& pose : frames)
        away.push_back(moved(pose, {2.0, 3.0, -1.0}));
    MetricPoints here{metric.shape(), {}}, there{metric.shape(), {}};
    metric.points(frames, 30, here);
    metric.points(away, 30, there);
    for (int i = 0; i < here.count(); ++i)
        EXPECT_LT(metricDistance(metric.shape(), here.at(i), there.at(i)), 1e-6);
}

TEST(PoseMetric, CountsAnglesHeightAndVelocities) {
    const auto library = test::madeLibrary();
    PoseMetricSettings settings;
    const PoseMetric metric(*library->rig, settings);
    const auto distance = [&](const std::vector<Pose>& a, const std::vector<Pose>& b, int frame) {
        std::vector<double> p(metric.shape().width()), q(p.size());
        metric.point(a, frame, 30, p.data());
        metric.point(b, frame, 30, q.data());
        return metricDistance(metric.shape(), p.data(), q.data());
    };
    const Pose pose = library->motions[0].clip.frames[0];
    const auto turned = [&](Role role, double angle) {
        Pose other = pose;
        Eigen::Quaterniond& turn =
            other.turns[static_cast<std::size_t>(*library->rig->roles[role])];
        turn = turn * Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized());
        return other;
    };
    EXPECT_NEAR(distance({pose}, {turned(Role::LeftElbow, 0.4)}, 0), 0.4, 1e-9);
    EXPECT_NEAR(distance({pose}, {turned(Role::LeftWrist, 0.4)}, 0), 0.12, 1e-9);
    EXPECT_NEAR(distance({pose}, {turned(Role::LeftClavicle, 0.4)}, 0), 0, 1e-9);
    Pose high = pose;
    high.root.y() += 0.25;
    EXPECT_NEAR(distance({pose}, {high}, 0), 0.25, 1e-9);
    // The pelvis leans by 0.3 about x, whichever way it faces.
    Pose lean = pose;
    lean.turns[0] = Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitY()) *
                    Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
    EXPECT_NEAR(distance({pose}, {lean}, 0), 0.3, 1e-9);
    // The elbow turns by 0.2 a frame: 6 rad/s, of which a tenth counts.
    const std::vector<Pose> still(3, pose);
    const std::vector<Pose> moving = {turned(Role::LeftElbow, -0.2), pose,
                                      turned(Role::LeftElbow, 0.2)};
    EXPECT_NEAR(distance(still, moving, 1), 0.6, 1e-9);
    EXPECT_NEAR(distance(still, moving, 0), std::hypot(0.2, 0.6), 1e-9);
}

TEST(PoseMetric, AJointOfTwoRolesCountsOnce) {
    const auto library = test::madeLibrary();
    Rig rig = *library->rig;
    const PoseMetric plain(rig);
    rig.roles.set(Role::Spine, *rig.roles[Role::Chest]);
    const PoseMetric doubled(rig);
    const auto distinct = [](const Rig& r) {
        std::set<int> joints;
        for (const Role role : allRoles()) {
            if (PoseMetricSettings::defaultWeights()[static_cast<std::size_t>(role)] > 0 &&
                r.roles[role])
                joints.insert(*r.roles[role]);
        }
        return joints.size();
    };
    EXPECT_EQ(doubled.shape().weights.size(), distinct(rig));
    EXPECT_EQ(plain.shape().weights.size(), distinct(*library->rig));
}

TEST(PoseMetric, APointPlayedBackward) {
    const auto library = test::madeLibrary();
    const PoseMetric metric(*library->rig);
    const auto& frames = library->motions[1].clip.frames;
    const std::vector<Pose> back(frames.rbegin(), frames.rend());
    std::vector<double> p(metric.shape().width()), q(p.size());
    metric.point(frames, 20, 30, p.data());
    metric.reverse(p.data());
    metric.point(back, 39, 30, q.data());
    EXPECT_LT(metricDistance(metric.shape(), p.data(), q.data()), 1e-6);
}

class KnownBezier : public testing::TestWithParam<const char*> {};

TEST_P(KnownBezier, WalkAndCurve) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer(GetParam());
    const auto& input = known["input"];
    const auto& expected = known["expected"];
    PoseTree centres(MetricShape{2, {}});
    for (const auto& medoid : input["medoids"])
        centres.add(medoid.get<std::vector<double>>().data());
    const std::vector<int> walk = medoidWalk(centres, input["source_node"], input["target_node"]);
    EXPECT_EQ(walk, expected["walk"].get<std::vector<int>>());
    const auto poseAt = [](const nlohmann::json& point) {
        Pose pose;
        pose.root = {point[0].get<double>(), point[1].get<double>(), 0};
        return pose;
    };
    std::vector<Pose> visited;
    for (const int node : walk)
        visited.push_back(poseAt(input["medoids"][static_cast<std::size_t>(node)]));
    const PoseCurve curve = curveThrough(poseAt(input["source"]), visited, poseAt(input["target"]));
    for (const auto& [name, point] :
         {std::pair("C1", curve.points[1]), std::pair("C2", curve.points[2])}) {
        EXPECT_NEAR(point.root.x(), expected[name][0], 1e-9);
        EXPECT_NEAR(point.root.y(), expected[name][1], 1e-9);
    }
    for (std::size_t i = 0; i < expected["u"].size(); ++i) {
        const Pose pose = curve.at(expected["u"][i]);
        EXPECT_NEAR(pose.root.x(), expected["curve"][i][0], 1e-9);
        EXPECT_NEAR(pose.root.y(), expected["curve"][i][1], 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, KnownBezier, testing::Values("bezier_even", "bezier_fig7"));

TEST(PoseCurve, EndsAndContinuousSpeed) {
    const auto library = test::madeLibrary();
    const Pose& source = library->motions[0].clip.frames[30];
    const Pose& target = library->motions[1].clip.frames[30];
    const std::vector<Pose> visited = {library->motions[2].clip.frames[30],
                                       library->motions[3].clip.frames[10],
                                       library->motions[3].clip.frames[30]};
    const PoseCurve curve = curveThrough(source, visited, target);
    EXPECT_LT(stepBetween(curve.at(0), source), 1e-9);
    EXPECT_LT(stepBetween(curve.at(1), target), 1e-9);
    // The middle pose counts in both halves.
    EXPECT_LT(stepBetween(curve.points[1], meanPose(std::span(visited).first(2))), 1e-12);
    EXPECT_LT(stepBetween(curve.points[2], meanPose(std::span(visited).last(2))), 1e-12);
    // C¹: the angular velocity to the left and to the right of any moment agree.
    const double h = 1e-5;
    for (double u = 0.1; u < 0.95; u += 0.1) {
        for (std::size_t joint = 0; joint < source.turns.size(); ++joint) {
            const auto at = [&](double v) { return curve.at(v).turns[joint]; };
            const auto rate = [&](double from, double to) {
                return Eigen::AngleAxisd(at(from).conjugate() * at(to));
            };
            const Eigen::AngleAxisd left = rate(u - h, u), right = rate(u, u + h);
            const Eigen::Vector3d change =
                left.angle() * left.axis() - right.angle() * right.axis();
            EXPECT_LT(change.norm() / h, 1e-2);
        }
    }
    // Without poses on the way it goes straight, at even speed.
    const PoseCurve straight = curveThrough(source, {}, target);
    for (const double u : {0.25, 0.5, 0.9})
        EXPECT_LT(stepBetween(straight.at(u), blend(source, target, u)), 1e-9);
}

TEST(MeanPose, AlignsSigns) {
    Pose a;
    a.turns = {Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()))};
    Pose b;
    b.turns = {Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitX()))};
    b.turns[0].coeffs() *= -1;
    const std::vector<Pose> poses = {a, b};
    EXPECT_NEAR(Eigen::AngleAxisd(meanPose(poses).turns[0]).angle(), 0.6, 1e-9);
}

TEST(Transition, AlongThePathIsContinuousAndEndsInTheAction) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    ASSERT_GT(graph->clusters.count(), 6);
    const double bar = largestStep(*library);
    for (const char* from : {"kick", "punch", "block"}) {
        for (const char* to : {"turn", "block", "kick"}) {
            MotionStrip strip(graph, {});
            // From the posture itself: the way to the other action leads through the stance.
            const MotionPart before = test::partOf(*library, from).part({0, 31});
            const MotionPart after = test::partOf(*library, to);
            strip.begin(before);
            const MotionStrip::Led led = strip.lead(after, {});
            EXPECT_EQ(led.report.method, TransitionMethod::Graph);
            EXPECT_EQ(led.report.clips.size() + 1, led.report.visited.size());
            EXPECT_EQ(led.report.grids.size(), led.report.visited.size());
            EXPECT_EQ(led.report.visited.front(), led.report.source.id);
            EXPECT_EQ(led.report.visited.back(), led.report.target.id);
            EXPECT_LE(largestStep(strip.frames()), 2 * bar) << from << " " << to;
            EXPECT_TRUE(samePosture(strip.frames().back(), after.poses.back()));
            // What is left of the action is all there.
            EXPECT_EQ(strip.frameCount() - led.actionBegin, after.size() - led.actionEntered);
            EXPECT_LE(led.actionEntered, TransitionSettings{}.actionFrames);
            EXPECT_GE(led.transitionBegin, 31 - TransitionSettings{}.backFrames);
            EXPECT_EQ(strip.standing().size(), strip.frames().size());
        }
    }
}

TEST(Transition, TheJoinIsTheNearestPairOfTheGrid) {
    const auto library = test::madeLibrary();
    MotionStrip strip(graphOf(library), {});
    strip.begin(test::partOf(*library, "kick"));
    const auto led = strip.lead(test::partOf(*library, "punch"), {});
    for (const DistanceGrid& grid : led.report.grids) {
        EXPECT_LE(grid.rows, 10);
        EXPECT_LE(grid.columns, 25);
        EXPECT_EQ(grid.at(grid.row, grid.column),
                  *std::min_element(grid.distances.begin(), grid.distances.end()));
    }
}

TEST(Transition, PathsAreDrawnInInverseProportionToCost) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library, true);
    const MotionPart from = test::partOf(*library, "kick").part({0, 31});
    const MotionPart to = test::partOf(*library, "punch").part({30, 60});
    const TransitionReport located = locate(*graph, from.poses, to.poses);
    ASSERT_GT(located.candidates.size(), 1u);
    double weights = 0;
    for (const CandidatePath& path : located.candidates)
        weights += 1 / path.cost;
    std::vector<int> counts(located.candidates.size(), 0);
    constexpr int kDraws = 600;
    for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
        MotionStrip strip(graph, {});
        strip.begin(from);
        const auto led = strip.lead(to, {{}, seed, {}});
        EXPECT_EQ(led.report.candidates, located.candidates);
        ++counts[static_cast<std::size_t>(led.report.chosen)];
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double p = 1 / located.candidates[i].cost / weights;
        EXPECT_NEAR(counts[i], kDraws * p, 4.5 * std::sqrt(kDraws * p * (1 - p))) << i;
    }
    // A path can be asked for; one that is not there is refused and changes nothing.
    MotionStrip strip(graph, {});
    strip.begin(from);
    EXPECT_THROW(strip.lead(to, {{}, 1, 99}), Error);
    EXPECT_THROW(strip.lead({}, {}), Error);
    EXPECT_EQ(strip.frameCount(), 31);
    EXPECT_EQ(strip.lead(to, {{}, 1, 1}).report.chosen, 1);
}

TEST(Transition, ACurveWhereThereIsNoPath) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    const MotionPart from = test::partOf(*library, "kick");
    const MotionPart to = test::partOf(*library, "lonely");
    EXPECT_TRUE(locate(*graph, from.poses, to.poses).candidates.empty());
    MotionStrip strip(graph, {});
    strip.begin(from);
    EXPECT_THROW(strip.lead(to, {TransitionMethod::Graph, 1, {}}), Error);
    EXPECT_EQ(strip.frameCount(), 60);
    const auto led = strip.lead(to, {});
    EXPECT_EQ(led.report.method, TransitionMethod::Bezier);
    EXPECT_EQ(led.report.visited.back(), led.report.target.id);
    EXPECT_EQ(led.transitionBegin, 60);
    // Duration = distance / σ.
    std::vector<double> p(graph->metric.shape().width()), q(p.size());
    graph->metric.point(from.poses, 59, 30, p.data());
    graph->metric.point(to.poses, 0, 30, q.data());
    const double distance = metricDistance(graph->metric.shape(), p.data(), q.data());
    EXPECT_EQ(led.actionBegin + 1 - led.transitionBegin,
              std::lround(distance / TransitionSettings{}.speed * 30));
    EXPECT_TRUE(
        samePosture(strip.frames()[static_cast<std::size_t>(led.actionBegin)], to.poses.front()));
    EXPECT_TRUE(samePosture(strip.frames().back(), to.poses.back()));
}

TEST(Transition, LinearIsStraight) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    const MotionPart from = test::partOf(*library, "kick").part({0, 31});
    const MotionPart to = test::partOf(*library, "punch").part({30, 60});
    MotionStrip strip(graph, {});
    strip.begin(from);
    const auto led = strip.lead(to, {TransitionMethod::Linear, 1, {}});
    const int count = led.actionBegin - 30;
    for (int i = 0; i <= count; ++i) {
        const Pose& shown = strip.frames()[static_cast<std::size_t>(30 + i)];
        const Pose straight =
            blend(from.poses.back(), to.poses.front(), static_cast<double>(i) / count);
        for (std::size_t joint = 1; joint < shown.turns.size(); ++joint)
            EXPECT_LT(shown.turns[joint].angularDistance(straight.turns[joint]), 1e-6);
    }
}

TEST(Transition, BackwardClipsLeadWhereNobodyWent) {
    const auto library = test::oneWayLibrary();
    const MotionPart all = test::partOf(*library, "one");
    const MotionPart start = all.part({0, 10}), end = all.part({50, 60});
    MotionStrip directed(graphOf(library), {});
    directed.begin(end);
    EXPECT_EQ(directed.lead(start, {}).report.method, TransitionMethod::Bezier);
    MotionStrip undirected(graphOf(library, true), {});
    undirected.begin(end);
    const auto led = undirected.lead(start, {});
    EXPECT_EQ(led.report.method, TransitionMethod::Graph);
    ASSERT_FALSE(led.report.clips.empty());
    for (const EdgeClip& clip : led.report.clips)
        EXPECT_TRUE(clip.backward);
    EXPECT_LE(largestStep(undirected.frames()), 2 * largestStep(*library));
}

TEST(Transition, OneClipAndOneFrameLibraries) {
    const auto library = test::oneWayLibrary();
    const auto graph = graphOf(library);
    MotionStrip strip(graph, {});
    strip.begin(test::partOf(*library, "one"));
    strip.lead(test::partOf(*library, "one"), {});
    EXPECT_TRUE(samePosture(strip.frames().back(), library->motions[0].clip.frames.back()));
    MotionLibrary single = *library;
    single.motions[0].clip.frames.resize(1);
    single.motions[0].standing.resize(1);
    single.actions[0].frames = {0, 1};
    const auto one = buildFlexibleGraph(std::make_shared<const MotionLibrary>(single));
    EXPECT_EQ(one->clusters.count(), 1);
    MotionStrip frame(one, {});
    frame.begin(single.part(single.actions[0]));
    const auto led = frame.lead(single.part(single.actions[0]), {});
    EXPECT_EQ(led.report.method, TransitionMethod::Graph);
    EXPECT_EQ(frame.frameCount(), 1);
    MotionLibrary nothing = single;
    nothing.motions.clear();
    nothing.actions.clear();
    EXPECT_EQ(buildFlexibleGraph(std::make_shared<const MotionLibrary>(nothing))->clusters.count(),
              0);
}

TEST(Playback, AnInterruptionAtEveryFrameOfATransition) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    const MotionPart kick = test::partOf(*library, "kick").part({0, 31});
    const MotionPart punch = test::partOf(*library, "punch");
    const MotionPart dodge = test::partOf(*library, "block");
    const double bar = 2 * largestStep(*library);
    PlaybackBuffer whole(graph);
    whole.play(kick);
    whole.append(punch);
    const int planned = whole.planned();
    ASSERT_GT(planned, 40);
    for (int at = 0; at <= planned; ++at) {
        PlaybackBuffer buffer(graph);
        buffer.play(kick);
        buffer.append(punch);
        std::vector<Pose> shown;
        for (int i = 0; i < at; ++i)
            shown.push_back(buffer.next());
        buffer.play(dodge);
        while (buffer.planned() > 0)
            shown.push_back(buffer.next());
        EXPECT_LE(largestStep(shown), bar) << at;
        EXPECT_TRUE(samePosture(shown.back(), dodge.poses.back())) << at;
        EXPECT_EQ(buffer.shownFrames(), static_cast<long long>(shown.size()));
        EXPECT_TRUE(samePosture(buffer.next(), shown.back()));  // held
    }
}

TEST(Playback, ForgetsWhatIsLongPastAndRefusesWithoutHarm) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    PlaybackBuffer buffer(graph);
    EXPECT_THROW(buffer.play({}), Error);
    EXPECT_TRUE(buffer.empty());
    long long frames = 0;
    std::vector<Pose> window;
    for (int i = 0; i < 80; ++i) {
        buffer.append(test::partOf(*library, i % 2 ? "kick" : "punch"));
        while (buffer.planned() > 5) {
            window.push_back(buffer.next());
            ++frames;
        }
        const int before = buffer.planned();
        EXPECT_THROW(
            buffer.play(test::partOf(*library, "lonely"), {TransitionMethod::Graph, 1, {}}), Error);
        EXPECT_EQ(buffer.planned(), before);
    }
    EXPECT_EQ(buffer.shownFrames(), frames);
    EXPECT_LT(buffer.frames().size(), 2000u);
    EXPECT_GT(frames, 3000);
    EXPECT_LE(largestStep(window), 2 * largestStep(*library));
}

Sequence sequenceOf(const MotionLibrary& library, const std::vector<std::string>& names) {
    Sequence sequence;
    for (const std::string& name : names) {
        SequenceBlock& block = sequence.blocks.emplace_back();
        block.name = name;
        block.action = test::actionOf(library, name);
        block.transition.seed = sequence.blocks.size();
    }
    return sequence;
}

TEST(Sequence, PiecesFollowWithoutGap) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    Sequence sequence = sequenceOf(*library, {"kick", "lonely", "punch", "block"});
    sequence.blocks[2].repeats = 3;
    sequence.blocks[3].trim = FrameRange{10, 40};
    const SequenceMotion motion = makeSequence(graph, sequence);
    ASSERT_EQ(motion.pieces.size(), 11u);
    int at = 0;
    for (std::size_t i = 0; i < motion.pieces.size(); ++i) {
        const SequencePiece& piece = motion.pieces[i];
        EXPECT_EQ(piece.frames.begin, at);
        EXPECT_GE(piece.frames.end, piece.frames.begin);
        EXPECT_EQ(piece.transition.has_value(), i % 2 == 1);
        at = piece.frames.end;
    }
    EXPECT_EQ(at, motion.clip.frameCount());
    EXPECT_LE(largestStep(motion.clip.frames), 3 * largestStep(*library));  // σ sets the pace
    EXPECT_EQ(makeSequence(graph, sequence).clip.frames.back().root,
              motion.clip.frames.back().root);
}

TEST(Sequence, ALaterChangeLeavesWhatComesBeforeAsItIs) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library, true);
    const SequenceMotion first =
        makeSequence(graph, sequenceOf(*library, {"kick", "punch", "turn"}));
    Sequence other = sequenceOf(*library, {"kick", "punch", "block"});
    other.blocks[2].transition.seed = 77;
    const SequenceMotion second = makeSequence(graph, other);
    ASSERT_EQ(first.pieces[1].transition->chosen, second.pieces[1].transition->chosen);
    const int shared = std::min(first.pieces[2].frames.end, second.pieces[2].frames.end) - 10;
    ASSERT_GT(shared, 60);
    for (int i = 0; i < shared; ++i) {
        EXPECT_EQ(stepBetween(first.clip.frames[static_cast<std::size_t>(i)],
                              second.clip.frames[static_cast<std::size_t>(i)]),
                  0)
            << i;
    }
}

TEST(Sequence, MadeMotionIsABlockLikeAnyOther) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    Sequence sequence = sequenceOf(*library, {"kick", "punch"});
    SequenceBlock& block = sequence.blocks.emplace_back();
    block.name = "strike at a target";
    block.made = std::make_shared<const LibraryMotion>(library->motions[3]);
    const SequenceMotion motion = makeSequence(graph, sequence);
    EXPECT_TRUE(samePosture(motion.clip.frames.back(), library->motions[3].clip.frames.back()));
}

TEST(Sequence, WhatIsNotThereIsAnError) {
    const auto library = test::madeLibrary();
    const auto graph = graphOf(library);
    EXPECT_THROW(makeSequence(graph, {}), Error);
    Sequence sequence = sequenceOf(*library, {"kick", "punch"});
    for (const FrameRange trim :
         {FrameRange{-1, 5}, FrameRange{5, 5}, FrameRange{0, 61}, FrameRange{70, 80}}) {
        sequence.blocks[1].trim = trim;
        EXPECT_THROW(makeSequence(graph, sequence), Error);
    }
    sequence.blocks[1].trim.reset();
    sequence.blocks[1].action.motion = 9;
    EXPECT_THROW(makeSequence(graph, sequence), Error);
}

}  // namespace
}  // namespace kumite
