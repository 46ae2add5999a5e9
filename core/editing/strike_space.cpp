#include "core/editing/strike_space.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "core/base/error.h"
#include "core/editing/time_alignment.h"

namespace kumite {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<int> roleJoints(const Rig& rig) {
    std::set<int> joints;
    for (const Role role : allRoles()) {
        if (rig.roles[role]) joints.insert(*rig.roles[role]);
    }
    return {joints.begin(), joints.end()};
}

/// Joint places of some frames of a clip, for the time alignment.
std::vector<JointPoints> pointsOf(const Clip& clip, FrameRange range,
                                  const std::vector<int>& joints) {
    std::vector<JointPoints> points;
    JointFrames frames;
    for (int f = range.begin; f < range.end; ++f) {
        jointFrames(*clip.rig, clip.frames[static_cast<std::size_t>(f)], frames);
        JointPoints pose(3, static_cast<Eigen::Index>(joints.size()));
        for (std::size_t j = 0; j < joints.size(); ++j)
            pose.col(static_cast<Eigen::Index>(j)) =
                frames.positions[static_cast<std::size_t>(joints[j])];
        points.push_back(std::move(pose));
    }
    return points;
}

/// Moments of `other` that belong to the reference's frames `range`, in frames of other's range.
struct Times {
    std::vector<double> frames;
    double cost = 0;
};

Times alignedTimes(const Clip& reference, FrameRange range, const Clip& other,
                   FrameRange otherRange, const std::vector<int>& joints, int slopeLimit) {
    const AlignmentGrid grid =
        alignmentGrid(pointsOf(reference, range, joints), pointsOf(other, otherRange, joints));
    // As steep as it must be where one side is much longer.
    const int longer = std::max(grid.rows, grid.columns);
    const int shorter = std::max(1, std::min(grid.rows, grid.columns));
    const auto alignment =
        alignInTime(grid, std::max({1, slopeLimit, (longer + shorter - 1) / shorter - 1}));
    if (!alignment) throw Error("Two examples of the strike cannot be aligned in time.");
    const int smoothing = 2 * static_cast<int>(std::lround(0.05 * reference.rate)) + 1;
    return {matchingTimes(*alignment, smoothing), alignment->cost};
}

/// The reference's frames as moments of an example: before and after the hit each for itself, so
/// that the hits fall on each other.
Times timesOf(const Strike& reference, const Strike& example, const std::vector<int>& joints,
              int slopeLimit) {
    const Times before = alignedTimes(reference.clip, {0, reference.hit + 1}, example.clip,
                                      {0, example.hit + 1}, joints, slopeLimit);
    const Times after =
        alignedTimes(reference.clip, {reference.hit, reference.clip.frameCount()}, example.clip,
                     {example.hit, example.clip.frameCount()}, joints, slopeLimit);
    Times all = before;
    all.cost += after.cost;
    for (std::size_t i = 1; i < after.frames.size(); ++i)
        all.frames.push_back(example.hit + after.frames[i]);
    return all;
}

/// All weights of `count` examples that are multiples of 1/steps.
void forWeights(int count, int steps, std::vector<int>& parts, const auto& visit) {
    const int used = std::accumulate(parts.begin(), parts.end(), 0);
    if (static_cast<int>(parts.size()) + 1 == count) {
        parts.push_back(steps - used);
        visit(parts);
        parts.pop_back();
        return;
    }
    for (int part = 0; part <= steps - used; ++part) {
        parts.push_back(part);
        forWeights(count, steps, parts, visit);
        parts.pop_back();
    }
}

/// Every example with the examples that hit nearest to it.
std::set<std::vector<int>> neighbourhoodsOf(const StrikeSpace& space, int neighbours) {
    std::vector<Vector3d> points;
    for (const auto& example : space.examples)
        points.push_back(example.point);
    const PointIndex index(points);
    std::set<std::vector<int>> sets;
    for (const Vector3d& point : points) {
        std::vector<int> some = index.nearest(point, neighbours + 1);
        std::sort(some.begin(), some.end());
        sets.insert(std::move(some));
    }
    return sets;
}

void sampleBlends(StrikeSpace& space, const StrikeSpaceSettings& settings,
                  const Progress& progress) {
    const auto sets = neighbourhoodsOf(space, settings.neighbours);
    space.neighbourhoods.assign(sets.begin(), sets.end());
    std::set<std::vector<std::pair<int, int>>> seen;
    std::vector<Vector3d> points;
    for (std::size_t n = 0; n < space.neighbourhoods.size(); ++n) {
        const std::vector<int>& examples = space.neighbourhoods[n];
        std::vector<int> parts;
        forWeights(static_cast<int>(examples.size()), std::max(1, settings.steps), parts,
                   [&](const std::vector<int>& shares) {
                       std::vector<std::pair<int, int>> key;
                       BlendWeights weights;
                       for (std::size_t i = 0; i < shares.size(); ++i) {
                           if (shares[i] == 0) continue;
                           key.emplace_back(examples[i], shares[i]);
                           weights.push_back(
                               {examples[i], static_cast<double>(shares[i]) / settings.steps});
                       }
                       if (!seen.insert(key).second) return;
                       points.push_back(hitPoint(space, weights));
                       space.samples.push_back({std::move(weights), static_cast<int>(n)});
                   });
        progress.update(static_cast<double>(n + 1) /
                        static_cast<double>(space.neighbourhoods.size()));
    }
    space.natural = {points.front(), points.front()};
    for (const Vector3d& p : points) {
        space.natural.low = space.natural.low.cwiseMin(p);
        space.natural.high = space.natural.high.cwiseMax(p);
    }
    space.points = PointIndex(std::move(points));
}

/// Weights of some examples as one vector, and back.
BlendWeights weightsFrom(const std::vector<int>& examples, const Eigen::VectorXd& shares) {
    BlendWeights weights;
    const double sum = shares.sum();
    for (std::size_t i = 0; i < examples.size(); ++i) {
        const double share = shares[static_cast<Eigen::Index>(i)] / sum;
        if (share > 0) weights.push_back({examples[i], share});
    }
    return weights;
}

/// Moves the weights of a neighbourhood toward the target (damped Gauss–Newton on the simplex).
BlendFit refined(const StrikeSpace& space, const std::vector<int>& examples,
                 const BlendWeights& start, const Vector3d& target, const Matrix3d& measure) {
    const auto n = static_cast<Eigen::Index>(examples.size());
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(n);
    for (const ExampleWeight& w : start) {
        const auto at = std::find(examples.begin(), examples.end(), w.example);
        shares[at - examples.begin()] = w.weight;
    }
    const auto pointOf = [&](const Eigen::VectorXd& s) {
        return hitPoint(space, weightsFrom(examples, s));
    };
    constexpr double kStep = 0.02, kGoodEnough = 2e-4;
    Vector3d point = pointOf(shares);
    double error = (measure * (point - target)).norm();
    for (int round = 0; round < 8 && error > kGoodEnough; ++round) {
        Eigen::MatrixXd slopes(3, n);
        for (Eigen::Index i = 0; i < n; ++i) {
            Eigen::VectorXd moved = shares;
            moved[i] += kStep;
            slopes.col(i) = measure * (pointOf(moved) - point) / kStep;
        }
        Eigen::MatrixXd normal = slopes.transpose() * slopes;
        normal.diagonal().array() += 1e-4 * std::max(normal.trace() / double(n), 1e-9);
        const Eigen::VectorXd step =
            normal.ldlt().solve(-slopes.transpose() * (measure * (point - target)));
        bool better = false;
        for (double scale = 1; scale > 0.1 && !better; scale /= 2) {
            Eigen::VectorXd next = (shares + scale * step).cwiseMax(0.0);
            if (!(next.sum() > 1e-9)) continue;
            next /= next.sum();
            const Vector3d there = pointOf(next);
            const double then = (measure * (there - target)).norm();
            if (then >= error) continue;
            better = error - then > 1e-6;
            shares = next;
            point = there;
            error = then;
        }
        if (!better) break;
    }
    return {weightsFrom(examples, shares), point, (point - target).norm()};
}

}  // namespace

StrikeSpace strikeSpace(const std::vector<Strike>& examples, Striker striker,
                        const StrikeSpaceSettings& settings, const Progress& progress) {
    if (examples.empty()) throw Error("There is no example of the strike to blend.");
    StrikeSpace space;
    space.striker = striker;
    space.rig = examples.front().clip.rig;
    const auto joint = strikingJoint(*space.rig, striker);
    if (!joint) {
        throw Error(fmt::format("The skeleton has no {}: its roles tell nothing that could hit.",
                                strikerName(striker)));
    }
    std::vector<Strike> strikes = examples;
    for (const Strike& strike : strikes)
        space.rate = std::max(space.rate, strike.clip.rate);
    for (Strike& strike : strikes) {
        if (strike.clip.rig->jointCount() != space.rig->jointCount())
            throw Error(fmt::format("Strike \"{}\" is of another skeleton.", strike.name));
        if (strike.clip.rate == space.rate) continue;
        strike.hit = static_cast<int>(std::lround(strike.hit * space.rate / strike.clip.rate));
        strike.clip = resampled(strike.clip, space.rate);
        strike.hit = std::min(strike.hit, strike.clip.frameCount() - 1);
    }
    // The reference has the median length, so that no example is warped more than it must be.
    std::vector<int> order(strikes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return strikes[static_cast<std::size_t>(a)].clip.frameCount() <
               strikes[static_cast<std::size_t>(b)].clip.frameCount();
    });
    space.reference = order[(order.size() - 1) / 2];
    const Strike& reference = strikes[static_cast<std::size_t>(space.reference)];
    space.frames = reference.clip.frameCount();
    space.hit = reference.hit;
    const std::vector<int> joints = roleJoints(*space.rig);
    for (std::size_t e = 0; e < strikes.size(); ++e) {
        const Strike& strike = strikes[e];
        const Times times = timesOf(reference, strike, joints, settings.slopeLimit);
        StrikeSpace::Example example;
        example.name = strike.name;
        example.alignmentCost = times.cost;
        for (const double frame : times.frames) {
            example.seconds.push_back(frame / strike.clip.rate);
            example.poses.push_back(poseAt(strike.clip, example.seconds.back()));
        }
        space.fastest = std::max(space.fastest, fastestOf(strike.clip, *joint));
        space.examples.push_back(std::move(example));
        progress.update(0.7 * static_cast<double>(e + 1) / static_cast<double>(strikes.size()));
    }
    for (std::size_t e = 0; e < space.examples.size(); ++e)
        space.examples[e].point = hitPoint(space, {{static_cast<int>(e), 1.0}});
    sampleBlends(space, settings, progress.part(0.7, 1));
    return space;
}

namespace {

/// The blend of some joints: the root, and `joints` (all if empty); the others are as in the first
/// example.
Pose rawBlend(const StrikeSpace& space, const BlendWeights& weights, int frame,
              std::span<const int> joints = {}) {
    const auto poseOf = [&](const ExampleWeight& w) -> const Pose& {
        return space.examples[static_cast<std::size_t>(w.example)]
            .poses[static_cast<std::size_t>(frame)];
    };
    Pose pose = poseOf(weights.front());
    double sum = weights.front().weight;
    for (std::size_t i = 1; i < weights.size(); ++i) {
        sum += weights[i].weight;
        const Pose& next = poseOf(weights[i]);
        const double share = weights[i].weight / sum;
        if (joints.empty()) {
            pose = blend(pose, next, share);
            continue;
        }
        pose.root += share * (next.root - pose.root);
        for (const int j : joints) {
            Eigen::Quaterniond& turn = pose.turns[static_cast<std::size_t>(j)];
            turn = turn.slerp(share, next.turns[static_cast<std::size_t>(j)]);
        }
    }
    return pose;
}

/// The joints above one, with itself.
std::vector<int> chainOf(const Rig& rig, int joint) {
    std::vector<int> chain;
    for (; joint >= 0; joint = rig.joint(joint).parent)
        chain.push_back(joint);
    return chain;
}

/// What brings a blend into the striker's frame.
GroundTransform originOf(const StrikeSpace& space, const BlendWeights& weights) {
    const std::vector<int> chain = chainOf(*space.rig, space.rig->roles[Role::Pelvis].value_or(0));
    return toOrigin(*space.rig, rawBlend(space, weights, 0, chain));
}

}  // namespace

Pose blendedPose(const StrikeSpace& space, const BlendWeights& weights, int frame) {
    return moved(rawBlend(space, weights, frame), originOf(space, weights));
}

std::vector<double> blendedTimes(const StrikeSpace& space, const BlendWeights& weights) {
    std::vector<double> times(static_cast<std::size_t>(space.frames), 0.0);
    for (const ExampleWeight& w : weights) {
        const auto& seconds = space.examples[static_cast<std::size_t>(w.example)].seconds;
        for (std::size_t i = 0; i < times.size(); ++i)
            times[i] += w.weight * seconds[i];
    }
    return times;
}

Vector3d hitPoint(const StrikeSpace& space, const BlendWeights& weights) {
    const int joint = *strikingJoint(*space.rig, space.striker);
    JointFrames frames;
    jointFrames(*space.rig, rawBlend(space, weights, space.hit, chainOf(*space.rig, joint)),
                frames);
    return originOf(space, weights) * frames.positions[static_cast<std::size_t>(joint)];
}

BlendFit fitBlend(const StrikeSpace& space, const Vector3d& target, const Matrix3d& measure) {
    constexpr std::size_t kSamples = 24, kNeighbourhoods = 3;
    std::vector<int> nearest;
    if (measure.isIdentity(0)) {
        nearest = space.points.nearest(target, kSamples);
    } else {
        // Scaled distances: the index knows only plain ones.
        const auto points = space.points.points();
        std::vector<std::pair<double, int>> all;
        for (std::size_t i = 0; i < points.size(); ++i)
            all.emplace_back((measure * (points[i] - target)).squaredNorm(), static_cast<int>(i));
        const std::size_t count = std::min(kSamples, all.size());
        std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), all.end());
        for (std::size_t i = 0; i < count; ++i)
            nearest.push_back(all[i].second);
    }
    std::set<int> tried;
    BlendFit best;
    double least = 0;
    for (const int start : nearest) {
        const StrikeSpace::Sample& sample = space.samples[static_cast<std::size_t>(start)];
        if (tried.size() >= kNeighbourhoods || !tried.insert(sample.neighbourhood).second) continue;
        BlendFit fit =
            refined(space, space.neighbourhoods[static_cast<std::size_t>(sample.neighbourhood)],
                    sample.weights, target, measure);
        const double distance = (measure * (fit.point - target)).norm();
        if (tried.size() == 1 || distance < least - 1e-9) {
            least = distance;
            best = std::move(fit);
        }
    }
    return best;
}

}  // namespace kumite
