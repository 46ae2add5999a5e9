#include "tests/benchmarks/transition_corpus.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <sys/resource.h>

#include <fmt/format.h>

#include "core/demo/demo.h"
#include "core/motion/feet.h"
#include "core/motion/retarget.h"
#include "core/motion/survey.h"
#include "core/project/library.h"

namespace kumite::bench {

double processorSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double timed(const std::function<void()>& work, double least) {
    const double start = processorSeconds();
    int times = 0;
    do {
        work();
        ++times;
    } while (processorSeconds() - start < least);
    return (processorSeconds() - start) / times;
}

namespace {

void settle(Clip& clip) {
    const JointPositions positions = positionsOf(clip);
    const double floor = std::min(restHeight(positions, *footPoint(*clip.rig, true)),
                                  restHeight(positions, *footPoint(*clip.rig, false)));
    for (Pose& pose : clip.frames)
        pose.root.y() -= floor;
}

}  // namespace

void addBout(MotionLibrary& library, double seconds, std::uint64_t seed) {
    const demo::DemoBout bout = demo::makeDemoBout({seconds, kRate, seed});
    for (const Motion& motion : bout.motions) {
        const Survey survey = surveyMotion(motion);
        Clip clip = clipOf(motion, motion.frames(), survey.space, survey.roles.roles, kRate);
        settle(clip);
        if (!library.rig) {
            library.rig = clip.rig;
            library.skeleton = motion.skeleton;
            library.space = survey.space;
            library.rate = kRate;
        } else {
            clip = retargeted(clip, library.rig);
        }
        LibraryMotion& added = library.motions.emplace_back();
        added.name = fmt::format("made{}", library.motions.size());
        added.sourceRate = kRate;
        added.standing = standingOf(clip);
        added.clip = std::move(clip);
    }
}

namespace {

std::filesystem::path dataFolder() {
    const char* set = std::getenv("KUMITE_DATA");
    return set ? set : "../shared/data";
}

}  // namespace

std::optional<MotionLibrary> recordings() {
    const auto data = dataFolder();
    if (!std::filesystem::exists(data / "MANIFEST.md")) return std::nullopt;
    return loadLibrary({data / "cmu_karate/martial_03.bvh", data / "cmu_karate/martial_04.bvh",
                        data / "cmu_karate/martial_06.bvh", data / "cmu_moves/02_05.bvh",
                        data / "cmu_moves/49_02.bvh", data / "awkward/Boxing_Toes.bvh",
                        data / "cmu_salsa/60_01.bvh", data / "cmu_salsa/61_03.bvh"})
        .library;
}

namespace {

/// `clips` stretches of about equal length, together `frames` frames, spread over a library; each
/// is a motion and an action of its own.
std::shared_ptr<const MotionLibrary> cutUp(const MotionLibrary& whole, int clips, int frames) {
    auto library = std::make_shared<MotionLibrary>(whole);
    library->motions.clear();
    library->actions.clear();
    const int longest = frames / clips + 1;
    std::vector<LibraryAction> stretches;
    for (std::size_t m = 0; m < whole.motions.size(); ++m) {
        for (int at = 0; at + longest <= whole.motions[m].clip.frameCount(); at += longest)
            stretches.push_back({"", "", static_cast<int>(m), {at, at + longest}});
    }
    int left = frames;
    for (int i = 0; i < clips; ++i) {
        const std::size_t chosen =
            static_cast<std::size_t>(i) * stretches.size() / static_cast<std::size_t>(clips);
        LibraryAction action = stretches[chosen];
        action.frames.end = action.frames.begin + left / (clips - i);
        left -= action.frames.size();
        const MotionPart part = whole.part(action);
        LibraryMotion& motion = library->motions.emplace_back();
        motion.name =
            fmt::format("{}@{}", whole.motions[static_cast<std::size_t>(action.motion)].name,
                        action.frames.begin);
        motion.sourceRate = kRate;
        motion.clip = {whole.rig, kRate, {part.poses.begin(), part.poses.end()}};
        motion.standing.assign(part.standing.begin(), part.standing.end());
        library->actions.push_back({motion.name, "", i, {0, action.frames.size()}});
    }
    return library;
}

}  // namespace

std::vector<Corpus> corpora() {
    std::vector<Corpus> list;
    MotionLibrary made;
    addBout(made, 120, 1);
    list.push_back({"made", cutUp(made, kClips, kFrames)});
    if (const auto real = recordings()) list.push_back({"real", cutUp(*real, kClips, kFrames)});
    list.back().inTable = true;
    return list;
}

}  // namespace kumite::bench
