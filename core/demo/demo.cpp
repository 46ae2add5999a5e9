#include "core/demo/demo.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/parallel.h"
#include "core/demo/plan_truth.h"
#include "core/demo/suit.h"
#include "core/motion/euler.h"
#include "core/motion/two_bone.h"

namespace kumite::demo {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kBlock = 512;  ///< frames

/// What cameras and solvers leave behind: slow tremor of every joint, less of the root.
void addSensorNoise(SuitFrame& frame, const Suit& suit, std::uint64_t seed, double time) {
    constexpr double kJoint = 0.0022;  // radians
    constexpr double kRoot = 0.0008;   // radians
    constexpr double kPlace = 0.0004;  // metres
    constexpr double kFrequency = 11;  // Hz
    const auto noise = [&](int channel) { return smoothNoise(seed, channel, time, kFrequency); };
    for (int axis = 0; axis < 3; ++axis) {
        frame.root[axis] += suit.unitsPerMetre * kPlace * noise(axis);
    }
    for (std::size_t i = 0; i < frame.local.size(); ++i) {
        if (suit.skeleton->joints[i].isEndSite || suit.sources[i].kind == Suit::Source::Kind::Fixed)
            continue;
        const int channel = 10 + 3 * static_cast<int>(i);
        const double size = i == 0 ? kRoot : kJoint;
        frame.local[i] = frame.local[i] * aboutX(size * noise(channel)) *
                         aboutY(size * noise(channel + 1)) * aboutZ(size * noise(channel + 2));
    }
}

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

/// Writes one frame's channels; angles stay near those of the frame before.
void writeFrame(const Suit& suit, const SuitFrame& frame, const double* before, double* row) {
    const auto& joints = suit.skeleton->joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Joint& joint = joints[i];
        if (joint.channels.empty()) continue;
        auto at = static_cast<std::size_t>(joint.firstChannel);
        std::array<int, 3> order{};
        std::size_t rotations = 0;
        for (const Channel channel : joint.channels) {
            if (isRotation(channel)) {
                order[rotations++] = axisOf(channel);
            } else {
                row[at++] = rounded(frame.root[axisOf(channel)]);
            }
        }
        const std::array<double, 3> old =
            before ? std::array{before[at], before[at + 1], before[at + 2]}
                   : std::array{0.0, 0.0, 0.0};
        const auto angles = eulerAngles(frame.local[i], order, old);
        for (const double angle : angles)
            row[at++] = rounded(angle);
    }
}

Motion makeMotion(const FighterPlan& plan, const FighterPlan& opponent, const Suit& suit,
                  double rate, int frameCount, const Progress& progress) {
    Motion motion;
    motion.skeleton = suit.skeleton;
    motion.frameTime = 1.0 / rate;
    motion.frameCount = frameCount;
    const auto width = static_cast<std::size_t>(suit.skeleton->channelCount);
    motion.channels.resize(width * static_cast<std::size_t>(frameCount));
    constexpr int kBatch = 8 * kBlock;
    std::vector<SuitFrame> frames(static_cast<std::size_t>(std::min(kBatch, frameCount)));
    for (int begin = 0; begin < frameCount; begin += kBatch) {
        progress.update(static_cast<double>(begin) / frameCount);
        const FrameRange batch = {begin, std::min(begin + kBatch, frameCount)};
        forBlocks(batch, kBlock, [&](FrameRange block) {
            for (int f = block.begin; f < block.end; ++f) {
                const double time = f / rate;
                SuitFrame& frame = frames[static_cast<std::size_t>(f - begin)];
                dress(suit, figureAt(plan, opponent.centreOfMass, time).pose, frame);
                addSensorNoise(frame, suit, plan.seed, time);
            }
        });
        for (int f = batch.begin; f < batch.end; ++f) {
            double* row = motion.channels.data() + width * static_cast<std::size_t>(f);
            writeFrame(suit, frames[static_cast<std::size_t>(f - begin)],
                       f > 0 ? row - width : nullptr, row);
        }
    }
    return motion;
}

}  // namespace

DemoBout makeDemoBout(const DemoSettings& settings, const Progress& progress) {
    constexpr double kLongest = 24 * 3600;
    if (!(settings.seconds >= 1 && settings.seconds <= kLongest)) {
        throw Error(
            fmt::format("A demo bout lasts from 1 second to 24 hours; {} seconds were asked for.",
                        settings.seconds));
    }
    if (!(settings.rate >= 24 && settings.rate <= 240)) {
        throw Error(fmt::format("A demo bout has 24 to 240 frames a second; {} were asked for.",
                                settings.rate));
    }
    const int frameCount = static_cast<int>(std::lround(settings.seconds * settings.rate));
    const double end = (frameCount - 1) / settings.rate;
    const std::array<Suit, 2> suits = {makeHumanIkSuit(), makePoserSuit()};
    const auto plans = planFight(settings.seed, end, {suits[0].size, suits[1].size});
    progress.update(0.1);
    DemoBout bout;
    for (std::size_t i = 0; i < 2; ++i) {
        const double from = 0.1 + 0.45 * static_cast<double>(i);
        bout.motions[i] = makeMotion(plans[i], plans[1 - i], suits[i], settings.rate, frameCount,
                                     progress.part(from, from + 0.45));
    }
    bout.truth = truthOf(plans, settings.rate, frameCount, settings.seed);
    progress.update(1);
    return bout;
}

}  // namespace kumite::demo
