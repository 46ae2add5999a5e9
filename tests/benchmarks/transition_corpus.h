#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/motion_library.h"
#include "core/transition/pose_clusters.h"

/// What the programs that measure transitions work on.
namespace kumite::bench {

constexpr int kClips = 73, kFrames = 3648;  ///< the paper's corpus
constexpr double kRate = 30;                ///< Hz

/// Processor seconds of this process, all threads.
double processorSeconds();
/// Processor seconds of some work; repeated until it took `least`, the mean of all.
double timed(const std::function<void()>& work, double least = 0.2);

/// Both fighters of a made bout as motions of one rig.
void addBout(MotionLibrary& library, double seconds, std::uint64_t seed);

/// Real recordings (KUMITE_DATA, else ../shared/data) as a library; nothing where there are none.
std::optional<MotionLibrary> recordings();

/// A library of the paper's size.
struct Corpus {
    std::string name;
    std::shared_ptr<const MotionLibrary> library;
    bool inTable = false;  ///< of one its figures stand in the table of the benchmarks
};
/// Stretches of a made bout; of recordings, where there are some. The last one is in the table.
std::vector<Corpus> corpora();

/// Lloyd's k-means in the space of poses: means are sign-aligned and normalised; the centre is at
/// last the frame nearest to the mean.
PoseClusters kMeans(const PointSource& source, int k, int iterations);

}  // namespace kumite::bench
