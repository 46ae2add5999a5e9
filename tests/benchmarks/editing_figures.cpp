// The figures of partial motion (core/editing):
//   kumite-editing-figures hit          leave one out: full against partial blending, made and real
//   kumite-editing-figures curves DIR   turn of chest and hip of both ways over time, as CSV
//   kumite-editing-figures coverage     volume of the natural against the extended region
//   kumite-editing-figures live         milliseconds per target dragged around
//   kumite-editing-figures retrieval    features and queries over 22 437 and 1 000 000 frames
//   kumite-editing-figures assembly     junctions and quality, direct against adjusted, real motion
//   kumite-editing-figures strips DIR   film strips: strikes at targets, key poses and their
//   motions
// Times are processor time of all threads (getrusage), so that a busy machine does not count.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <sys/resource.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/editing/assembly.h"
#include "core/editing/hit_region.h"
#include "core/formats/recording.h"
#include "core/motion/survey.h"
#include "core/project/film_strip.h"
#include "core/project/library.h"
#include "core/quality/body_quality.h"
#include "core/quality/joint_motion.h"
#include "tests/benchmarks/bench_table.h"
#include "tests/support/fixtures.h"
#include "tests/support/made_strikes.h"

namespace {

using namespace kumite;
using Eigen::Vector3d;
using test::StrikeKind;

double processorSeconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

template <typename Work>
double timed(const Work& work) {
    const double start = processorSeconds();
    work();
    return processorSeconds() - start;
}

/// Strikes of one kind, to be left out one by one.
struct StrikeSet {
    std::string name;
    Striker striker;
    std::vector<Strike> strikes;
};

std::vector<StrikeSet> madeSets() {
    std::vector<StrikeSet> sets;
    for (const StrikeKind kind : test::kStrikeKinds)
        sets.push_back({std::string("made: ") + test::kindName(kind), test::strikerOf(kind),
                        test::asExamples(test::madeStrikes(kind))});
    return sets;
}

/// The strikes that a recording holds, by limb; limbs with fewer than three are left out.
std::vector<StrikeSet> realSets() {
    std::vector<StrikeSet> sets;
    const auto data = test::dataFolder();
    if (!data) return sets;
    for (const char* file :
         {"cmu_karate/martial_03.bvh", "cmu_karate/martial_04.bvh", "cmu_karate/martial_06.bvh",
          "cmu_moves/02_05.bvh", "awkward/Boxing_Toes.bvh"}) {
        const auto motion = readRecording(*data / file).motions.front();
        const Survey survey = surveyMotion(*motion);
        const Clip clip = resampled(clipOf(*motion, {survey.leadingRestFrames, motion->frameCount},
                                           survey.space, survey.roles.roles, survey.rate),
                                    60);
        const double floor = floorUnder(clip);
        for (const Striker striker :
             {Striker::LeftHand, Striker::RightHand, Striker::LeftFoot, Striker::RightFoot}) {
            StrikeSet set{fmt::format("{} {}", std::filesystem::path(file).stem().string(),
                                      strikerName(striker)),
                          striker,
                          {}};
            for (const StrikeMoment& moment : findStrikes(clip, striker))
                set.strikes.push_back(
                    strikeFrom(clip, moment, floor, fmt::format("frame {}", moment.hit)));
            if (set.strikes.size() >= 3) sets.push_back(std::move(set));
        }
    }
    return sets;
}

std::vector<Strike> without(std::vector<Strike> strikes, std::size_t left) {
    strikes.erase(strikes.begin() + static_cast<std::ptrdiff_t>(left));
    return strikes;
}

Vector3d pointOf(const StrikeSet& set, std::size_t e) {
    const Strike& strike = set.strikes[e];
    return positionsOf(strike.clip)
        .at(strike.hit, *strikingJoint(*strike.clip.rig, set.striker))
        .cast<double>();
}

/// Mean and largest of some numbers.
struct Spread {
    double sum = 0, most = 0;
    int count = 0;
    void add(double value) {
        sum += value;
        most = std::max(most, value);
        ++count;
    }
    void add(const Spread& other) {
        sum += other.sum;
        most = std::max(most, other.most);
        count += other.count;
    }
    double mean() const { return sum / count; }
    std::string text(double scale) const {
        return count ? fmt::format("{:6.1f} /{:6.1f}", scale * sum / count, scale * most)
                     : std::string("       -       ");
    }
};

/// Mean distance of the role joints of two clips, each shown over its own length.
double trajectoryDistance(const Clip& a, const Clip& b) {
    constexpr int kSamples = 41;
    double sum = 0;
    int count = 0;
    JointFrames one, other;
    for (int i = 0; i < kSamples; ++i) {
        const double s = i / (kSamples - 1.0);
        jointFrames(*a.rig, poseAt(a, s * a.seconds()), one);
        jointFrames(*b.rig, poseAt(b, s * b.seconds()), other);
        for (const Role role : allRoles()) {
            if (!a.rig->roles[role]) continue;
            const auto j = static_cast<std::size_t>(*a.rig->roles[role]);
            sum += (one.positions[j] - other.positions[j]).norm();
            ++count;
        }
    }
    return sum / count;
}

/// Errors of one kind of strikes together.
struct HitErrors {
    int sets = 0;
    Spread fewer, partial;  ///< without the example asked for: whole blends, by parts
    void addRow(const char* kind) const {
        if (sets == 0) return;
        const auto text = [](const Spread& s) {
            return fmt::format("{:.1f} cm, at most {:.1f} cm", 100 * s.mean(), 100 * s.most);
        };
        bench::addRow({std::string("error of a hit by parts, its example left out: ") + kind,
                       fmt::format("{} examples in {} sets", partial.count, sets), text(partial),
                       "blends of whole examples: " + text(fewer)});
    }
};

void hits() {
    std::cout << "Leave one example out and ask for its hit point: error in cm, mean / largest;\n"
                 "joints: mean distance of all joints from the example's own motion, cm.\n\n";
    std::cout << fmt::format("{:<30}{:>4} {:>16} {:>16} {:>16} {:>8} {:>8} {:>8}\n", "set", "n",
                             "full, all", "full, one fewer", "partial, fewer", "outside",
                             "joints f", "joints p");
    std::vector<StrikeSet> sets = madeSets();
    const std::size_t madeCount = sets.size();
    for (StrikeSet& set : realSets())
        sets.push_back(std::move(set));
    HitErrors made, recorded;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const StrikeSet& set = sets[s];
        const StrikeSpace all = strikeSpace(set.strikes, set.striker);
        Spread full, fewer, partial, fullJoints, partialJoints;
        int outside = 0;
        for (std::size_t e = 0; e < set.strikes.size(); ++e) {
            const Vector3d target = pointOf(set, e);
            const StrikeSpace rest = strikeSpace(without(set.strikes, e), set.striker);
            full.add(hitTarget(all, target, HitMethod::Full).error);
            const HitMotion plain = hitTarget(rest, target, HitMethod::Full);
            const HitMotion parts = hitTarget(rest, target, HitMethod::Partial);
            fewer.add(plain.error);
            partial.add(parts.error);
            outside += !plain.solution.insideNaturalRegion;
            fullJoints.add(trajectoryDistance(plain.clip, set.strikes[e].clip));
            partialJoints.add(trajectoryDistance(parts.clip, set.strikes[e].clip));
        }
        std::cout << fmt::format("{:<30}{:>4} {:>16} {:>16} {:>16} {:>8} {:>8.1f} {:>8.1f}\n",
                                 set.name, set.strikes.size(), full.text(100), fewer.text(100),
                                 partial.text(100), outside,
                                 100 * fullJoints.sum / fullJoints.count,
                                 100 * partialJoints.sum / partialJoints.count)
                  << std::flush;
        HitErrors& together = s < madeCount ? made : recorded;
        ++together.sets;
        together.fewer.add(fewer);
        together.partial.add(partial);
    }
    made.addRow("made strikes");
    recorded.addRow("recorded strikes");
}

/// Angles of a joint over a clip: turn about y and about x against its parent, degrees.
void curves(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    constexpr double kDegrees = 180 / std::numbers::pi;
    for (const StrikeKind kind : {StrikeKind::Hook, StrikeKind::StraightKick}) {
        const auto made = test::asExamples(test::madeStrikes(kind));
        const Striker striker = test::strikerOf(kind);
        const StrikeSpace all = strikeSpace(made, striker);
        // The example whose point lies farthest from what the others can reach.
        std::size_t left = 0;
        double worst = -1;
        for (std::size_t e = 0; e < made.size(); ++e) {
            const StrikeSpace rest = strikeSpace(without(made, e), striker);
            const double error = solveHit(rest, all.examples[e].point, HitMethod::Full).error;
            if (error > worst) {
                worst = error;
                left = e;
            }
        }
        const StrikeSpace rest = strikeSpace(without(made, left), striker);
        const Vector3d target = all.examples[left].point;
        const HitMotion full = hitTarget(all, target, HitMethod::Full);
        const HitMotion partial = hitTarget(rest, target, HitMethod::Partial);
        std::string csv =
            "time,full_chest_y,partial_chest_y,full_right_hip_x,partial_right_hip_x\n";
        constexpr int kSamples = 61;
        for (int i = 0; i < kSamples; ++i) {
            const double s = i / (kSamples - 1.0);
            csv += fixed(s, 4);
            std::array<std::array<double, 2>, 2> values{};
            for (const std::size_t way : {0, 1}) {
                const Clip& clip = way == 0 ? full.clip : partial.clip;
                const Pose pose = poseAt(clip, s * clip.seconds());
                const RoleMap& roles = clip.rig->roles;
                const auto angles = [&](Role role) {
                    const std::vector<Eigen::Quaterniond> one{
                        pose.turns[static_cast<std::size_t>(*roles[role])]};
                    return anglesOf(one, {1, 0, 2}).front();
                };
                values[0][way] = kDegrees * angles(Role::Chest)[0];
                values[1][way] = kDegrees * angles(Role::RightHip)[1];
            }
            for (const auto& joint : values)
                csv += "," + fixed(joint[0], 2) + "," + fixed(joint[1], 2);
            csv += "\n";
        }
        const std::string name = kind == StrikeKind::Hook ? "hook.csv" : "straight_kick.csv";
        writeFileAtomically(folder / name, csv);
        std::cout << fmt::format(
            "{}: example {} left out (others {:.1f} cm away); full {:.2f} cm, "
            "partial {:.2f} cm\n",
            name, left + 1, 100 * worst, 100 * full.error, 100 * partial.error);
    }
}

void coverage() {
    constexpr double kCell = 0.06;
    std::cout << fmt::format("{:<30} {:>10} {:>12} {:>12} {:>7} {:>9}\n", "set", "box l",
                             "natural l", "extended l", "factor", "seconds");
    for (const StrikeSet& set : madeSets()) {
        const StrikeSpace space = strikeSpace(set.strikes, set.striker);
        Box box;
        Coverage c;
        const double seconds = timed([&] {
            box = extendedBox(space);
            c = coverageOf(space, box, kCell);
        });
        std::cout << fmt::format("{:<30} {:>10.1f} {:>12.1f} {:>12.1f} {:>7.1f} {:>9.1f}\n",
                                 set.name, 1000 * box.volume(), 1000 * c.naturalVolume(),
                                 1000 * c.extendedVolume(),
                                 c.extendedVolume() / std::max(c.naturalVolume(), 1e-9), seconds)
                  << std::flush;
        bench::addRow({set.name + ", region hit within 3 cm",
                       fmt::format("{} examples", set.strikes.size()),
                       fmt::format("{:.0f} l", 1000 * c.extendedVolume()),
                       fmt::format("blends of whole examples: {:.0f} l", 1000 * c.naturalVolume()),
                       bench::timesText(c.extendedVolume() / c.naturalVolume())});
    }
}

void live() {
    Spread eachSolve, eachWhole;
    std::cout << fmt::format("{:<30} {:>9} {:>12} {:>12} {:>14}\n", "set", "samples", "space ms",
                             "solve ms", "whole clip ms");
    for (const StrikeSet& set : madeSets()) {
        StrikeSpace space;
        const double building = timed([&] { space = strikeSpace(set.strikes, set.striker); });
        constexpr int kTargets = 60;
        const auto target = [&](int i) -> Vector3d {
            const double a = 2 * std::numbers::pi * i / kTargets;
            const Vector3d middle = 0.5 * (space.natural.low + space.natural.high);
            return middle + 0.6 * Vector3d(std::cos(a), std::sin(a), 0)
                                      .cwiseProduct(space.natural.high - space.natural.low);
        };
        double sum = 0;
        const double solving = timed([&] {
            for (int i = 0; i < kTargets; ++i)
                sum += solveHit(space, target(i), HitMethod::Best).error;
        });
        const double whole = timed([&] {
            for (int i = 0; i < kTargets; ++i)
                sum += hitTarget(space, target(i), HitMethod::Best).error;
        });
        std::cout << fmt::format("{:<30} {:>9} {:>12.1f} {:>12.2f} {:>14.2f}\n", set.name,
                                 space.samples.size(), 1000 * building, 1000 * solving / kTargets,
                                 1000 * whole / kTargets);
        eachSolve.add(solving / kTargets);
        eachWhole.add(whole / kTargets);
        if (!(sum >= 0)) std::cout << "unexpected\n";  // keeps the work from being left out
    }
    bench::addRow({"a strike to a dragged target, processor",
                   fmt::format("{} made techniques, the slowest", eachSolve.count),
                   fmt::format("{}, with the whole clip {}", bench::timeText(eachSolve.most),
                               bench::timeText(eachWhole.most))});
}

/// Joint places of a body that moves somehow, without a rig: what features are made of.
JointPositions madePositions(int frames, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::array<float, 4>> waves;
    for (int i = 0; i < 3 * kRoleCount; ++i) {
        const auto draw = [&] { return static_cast<float>(random()) / 4294967296.0f; };
        waves.push_back({0.25f * draw(), 0.02f + 0.12f * draw(), 6.3f * draw(), 0});
    }
    const auto rest = restPositions(*test::madeRig());
    JointPositions positions;
    positions.frameCount = frames;
    positions.jointCount = test::madeRig()->jointCount();
    positions.xyz.reserve(3 * static_cast<std::size_t>(frames) * rest.size());
    for (int f = 0; f < frames; ++f) {
        for (std::size_t j = 0; j < rest.size(); ++j) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto& wave = waves[(3 * j + axis) % waves.size()];
                positions.xyz.push_back(
                    static_cast<float>(rest[j][static_cast<Eigen::Index>(axis)]) +
                    wave[0] * std::sin(wave[1] * static_cast<float>(f) + wave[2]));
            }
        }
    }
    return positions;
}

void retrieval() {
    std::cout << fmt::format("{:>10} {:>7} {:>12} {:>14} {:>14} {:>12}\n", "frames", "clips",
                             "features s", "whole body ms", "one part ms", "wall ms");
    for (const auto& [frames, clips] :
         {std::pair(22437, 226), std::pair(1000000, 10000), std::pair(1000000, 1)}) {
        FeatureLibrary library;
        double features = 0;
        const int each = frames / clips;
        for (int c = 0; c < clips; ++c) {
            const int count = c + 1 == clips ? frames - each * c : each;
            const JointPositions positions = madePositions(count, static_cast<unsigned>(c + 1));
            std::vector<PoseBits> bits;
            features += timed([&] { bits = poseBits(positions, test::madeRig()->roles); });
            library.add(fmt::format("clip {}", c), bits);
        }
        KeySequence keys;
        const auto query = poseBits(madePositions(80, 99999), test::madeRig()->roles);
        for (const int f : {0, 15, 30, 50, 70}) {
            keys.bits.push_back(query[static_cast<std::size_t>(f)]);
            keys.frames.push_back(f);
        }
        constexpr int kQueries = 20;
        std::size_t found = 0;
        double wall = 0;
        const double whole = timed([&] {
            const auto start = std::chrono::steady_clock::now();
            for (int i = 0; i < kQueries; ++i)
                found += findSimilar(library, keys).size();
            wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        });
        RetrievalSettings part;
        part.mask = maskOf(BodyPart::RightArm);
        const double one = timed([&] {
            for (int i = 0; i < kQueries; ++i)
                found += findSimilar(library, keys, part).size();
        });
        std::cout << fmt::format("{:>10} {:>7} {:>12.3f} {:>14.2f} {:>14.2f} {:>12.2f}\n", frames,
                                 clips, features, 1000 * whole / kQueries, 1000 * one / kQueries,
                                 1000 * wall / kQueries)
                  << std::flush;
        if (found == 0) std::cout << "unexpected\n";
        if (clips > 1)
            bench::addRow({"key poses looked up, processor",
                           fmt::format("{} frames in {} clips", frames, clips),
                           bench::timeText(whole / kQueries)});
    }
}

// ---- assembly ------------------------------------------------------------------------------

std::shared_ptr<const MotionLibrary> realLibrary() {
    const auto data = test::dataFolder();
    if (!data)
        throw Error("There are no recordings: set KUMITE_DATA to the folder that holds them.");
    return std::make_shared<const MotionLibrary>(
        loadLibrary({*data / "cmu_karate/martial_03.bvh", *data / "cmu_karate/martial_04.bvh",
                     *data / "cmu_karate/martial_06.bvh", *data / "cmu_moves",
                     *data / "awkward/Boxing_Toes.bvh", *data / "cmu_salsa/60_01.bvh",
                     *data / "awkward/walk_left_45_UPPERCASE_channels.bvh"},
                    {60})
            .library);
}

/// The library without one of its motions, so that keys from it must be answered by others.
KeyLibrary withoutMotion(const MotionLibrary& all, std::size_t motion) {
    auto rest = std::make_shared<MotionLibrary>(all);
    rest->motions.erase(rest->motions.begin() + static_cast<std::ptrdiff_t>(motion));
    rest->actions.clear();
    return keyLibrary(rest);
}

KeyTrack keysOf(const LibraryMotion& motion, int begin, int apart, int count = 5) {
    KeyTrack track;
    track.rig = motion.clip.rig;
    track.rate = motion.clip.rate;
    for (int k = 0; k < count; ++k) {
        const Pose& pose = motion.clip.frames[static_cast<std::size_t>(begin + k * apart)];
        track = withKey(std::move(track), {k * apart, pose, Easing::Smooth});
    }
    return track;
}

struct Judgement {
    Spread mean, deviation, skate, acceleration;
};

void judge(const Assembly& made, bool adjusted, Judgement& sum) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    for (const AdjustedJunction& junction : made.junctions) {
        const AngleStatistics& got =
            adjusted ? junction.values.assembled : junction.values.retrieved;
        sum.mean.add(kDegrees * (got.mean - junction.values.query.mean).norm());
        sum.deviation.add(kDegrees * (got.deviation - junction.values.query.deviation).norm());
    }
    sum.skate.add(footSkateOf(measuredBody(made.clip, 0)).value_or(0));
    sum.acceleration.add(barOf(measureJoins(made.clip, {}).inside).acceleration);
}

void assemblies() {
    const auto library = realLibrary();
    Judgement own, direct, adjusted;
    Spread mismatches, distance, planning, assembling;
    int replaced = 0, cases = 0;
    for (std::size_t m = 0; m < library->motions.size(); ++m) {
        const LibraryMotion& motion = library->motions[m];
        const KeyLibrary rest = withoutMotion(*library, m);
        for (const int apart : {10, 20}) {
            for (int part = 0; part < 4; ++part) {
                const int begin = (motion.clip.frameCount() - 4 * apart - 1) * part / 4;
                if (begin < 0) continue;
                const KeyTrack track = keysOf(motion, begin, apart);
                AssemblyPlan plan;
                planning.add(timed([&] { plan = planAssembly(rest, track); }));
                AssemblySettings settings;
                settings.adjusted = false;
                Assembly made;
                assembling.add(timed([&] { made = assemble(rest, track, plan, settings); }));
                judge(made, false, direct);
                judge(assemble(rest, track, plan), true, adjusted);
                Clip source = motion.clip;
                source.frames.assign(motion.clip.frames.begin() + begin,
                                     motion.clip.frames.begin() + begin + 4 * apart + 1);
                own.skate.add(footSkateOf(measuredBody(source, 0)).value_or(0));
                own.acceleration.add(barOf(measureJoins(source, {}).inside).acceleration);
                mismatches.add(plan.body.match.mismatches);
                distance.add(plan.body.distance);
                for (const auto& each : plan.parts)
                    replaced += each.has_value();
                ++cases;
            }
        }
    }
    std::cout << fmt::format(
        "{} sets of five keys out of {} recordings, answered by the other recordings\n"
        "whole body: {:.1f} of 90 features differ, poses {:.1f} cm apart; {:.1f} of 5 parts come "
        "from elsewhere\n"
        "planning {:.1f} ms, assembling {:.1f} ms\n\n",
        cases, library->motions.size(), mismatches.sum / cases, 100 * distance.sum / cases,
        double(replaced) / cases, 1000 * planning.sum / cases, 1000 * assembling.sum / cases);
    std::cout << fmt::format("{:<12} {:>18} {:>18} {:>14} {:>22}\n", "", "junction mean °",
                             "deviation °", "foot skate", "acceleration p99 rad/s²");
    const auto line = [](const char* name, const Judgement& j) {
        std::cout << fmt::format("{:<12} {:>18} {:>18} {:>14.3f} {:>22.0f}\n", name, j.mean.text(1),
                                 j.deviation.text(1), j.skate.sum / j.skate.count,
                                 j.acceleration.sum / j.acceleration.count);
    };
    line("recording", own);
    line("direct", direct);
    line("adjusted", adjusted);
    const auto text = [](const Judgement& j) {
        return fmt::format("{:.0f}°, skate {:.2f}", j.mean.mean(), j.skate.mean());
    };
    bench::addRow({"junctions of motions of five keys, off the keys' means",
                   fmt::format("{} sets of keys", cases), text(adjusted),
                   fmt::format("as retrieved: {}; recordings: skate {:.2f}", text(direct),
                               own.skate.mean())});
}

// ---- film strips ---------------------------------------------------------------------------

void write(const std::filesystem::path& file, const std::string& title,
           const std::vector<FilmRow>& rows) {
    FilmSettings settings;
    settings.view = FilmView::ThreeQuarter;
    writeFileAtomically(file, filmStripSvg(title, rows, settings));
}

FilmRow rowOf(const Clip& clip, std::string title, int pictures,
              const std::optional<Vector3d>& mark = {}, std::optional<int> hit = {}) {
    FilmRow row{std::move(title), {}};
    std::vector<int> frames = evenFrames({0, clip.frameCount()}, pictures);
    if (hit) frames[frames.size() / 2] = *hit;
    for (const int f : frames) {
        FilmPicture picture{fmt::format("{}{}", f, hit == f ? " hit" : ""), {}, {}};
        picture.figures.push_back({&clip, f});
        if (mark) picture.marks.push_back({*mark});
        row.pictures.push_back(std::move(picture));
    }
    return row;
}

/// The library without the stretch of a motion that the keys come from: what is before and after it
/// stays, as motions of their own.
KeyLibrary withoutStretch(const MotionLibrary& all, std::size_t motion, FrameRange stretch) {
    auto rest = std::make_shared<MotionLibrary>(all);
    rest->actions.clear();
    const LibraryMotion whole = rest->motions[motion];
    rest->motions.erase(rest->motions.begin() + static_cast<std::ptrdiff_t>(motion));
    for (const FrameRange& range :
         {FrameRange{0, stretch.begin}, FrameRange{stretch.end, whole.clip.frameCount()}}) {
        if (range.size() < 2) continue;
        LibraryMotion piece = whole;
        piece.name += fmt::format("@{}:{}", range.begin, range.end);
        piece.clip.frames.assign(whole.clip.frames.begin() + range.begin,
                                 whole.clip.frames.begin() + range.end);
        piece.standing.assign(whole.standing.begin() + range.begin,
                              whole.standing.begin() + range.end);
        rest->motions.push_back(std::move(piece));
    }
    return keyLibrary(rest);
}

/// Five keys of a stretch of a motion, answered by the rest of the library (paper C, Figs. 12, 13).
void keyStrip(const std::filesystem::path& file, const MotionLibrary& library, std::size_t m,
              int begin, int apart) {
    const LibraryMotion& motion = library.motions[m];
    const KeyLibrary rest = withoutStretch(library, m, {begin, begin + 4 * apart + 1});
    const KeyTrack track = keysOf(motion, begin, apart);
    const AssemblyPlan plan = planAssembly(rest, track);
    AssemblyPlan whole = plan;
    for (auto& part : whole.parts)
        part.reset();
    AssemblySettings settings;
    const Clip query = clipOf(track);
    const Clip retrieved = assemble(rest, track, whole, settings).clip;
    const Clip adjusted = assemble(rest, track, plan, settings).clip;
    settings.meetKeys = 1;
    const Clip met = assemble(rest, track, plan, settings).clip;
    settings.meetKeys = 0;
    settings.adjusted = false;
    const Clip direct = assemble(rest, track, plan, settings).clip;
    std::string from =
        fmt::format("{} ({} of 90 features differ)", rest.motion(plan.body.match.clip).name,
                    plan.body.match.mismatches);
    for (const BodyPart part : allParts()) {
        const auto& own = plan.parts[static_cast<std::size_t>(part)];
        if (own)
            from += fmt::format(", {} {} ({})", partName(part), rest.motion(own->match.clip).name,
                                own->match.mismatches);
    }
    write(file, fmt::format("{} {}: {}", motion.name, begin, from),
          {rowOf(query, "query", 9), rowOf(retrieved, "retrieved", 9),
           rowOf(direct, "assembled, direct", 9), rowOf(adjusted, "assembled, adjusted", 9),
           rowOf(met, "adjusted, drawn to the keys", 9)});
}

/// A punch of the boxer, one of the karateka, and two steps of the walk.
void keyStrips(const std::filesystem::path& folder) {
    const auto library = realLibrary();
    for (std::size_t m = 0; m < library->motions.size(); ++m) {
        const LibraryMotion& motion = library->motions[m];
        if (motion.name.starts_with("walk")) {
            keyStrip(folder / "keys_walk.svg", *library, m, 110, 20);
        } else if (motion.name == "Boxing_Toes" || motion.name == "02_05") {
            const auto strikes = findStrikes(motion.clip, Striker::RightHand);
            if (strikes.size() < 3) continue;
            const FrameRange frames = strikes[2].frames;
            keyStrip(folder / fmt::format("keys_punch_{}.svg", motion.name), *library, m,
                     frames.begin, std::max(1, (frames.size() - 1) / 4));
        }
    }
}

void strips(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::vector<StrikeSet> sets = madeSets();
    for (StrikeSet& set : realSets())
        sets.push_back(std::move(set));
    for (const StrikeSet& set : sets) {
        const StrikeSpace space = strikeSpace(set.strikes, set.striker);
        const Box& box = space.natural;
        const Vector3d middle = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
        std::vector<HitMotion> motions;
        std::vector<std::string> titles;
        for (const Vector3d& way : {Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(-1, 1, 1),
                                    Vector3d(1, -1, 1), Vector3d(-1, -1, 1)}) {
            const Vector3d target = middle + 0.9 * half.cwiseProduct(way);
            motions.push_back(hitTarget(space, target));
            const HitMotion& m = motions.back();
            titles.push_back(fmt::format("({:.2f}, {:.2f}, {:.2f}) {}, {:.1f} cm", target.x(),
                                         target.y(), target.z(), methodName(m.solution.method),
                                         100 * m.error));
        }
        std::vector<FilmRow> rows;
        for (std::size_t i = 0; i < motions.size(); ++i)
            rows.push_back(
                rowOf(motions[i].clip, titles[i], 9, motions[i].solution.target, motions[i].hit));
        std::string name = set.name;
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == ' ' || c == ':'; }, '_');
        write(folder / ("hit_" + name + ".svg"), set.name, rows);
    }
    keyStrips(folder);
}

}  // namespace

int main(int count, char** words) {
    const std::string what = count > 1 ? words[1] : "";
    try {
        if (what == "hit") {
            hits();
        } else if (what == "curves" && count > 2) {
            curves(words[2]);
        } else if (what == "coverage") {
            coverage();
        } else if (what == "live") {
            live();
        } else if (what == "retrieval") {
            retrieval();
        } else if (what == "assembly") {
            assemblies();
        } else if (what == "strips" && count > 2) {
            strips(words[2]);
        } else {
            std::cerr << "kumite-editing-figures hit | curves DIR | coverage | live | retrieval | "
                         "assembly | strips DIR\n";
            return 2;
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
