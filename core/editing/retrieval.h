#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/editing/pose_features.h"

namespace kumite {

/// The features of every pose of a set of clips, all at one rate, clip after clip.
struct FeatureLibrary {
    struct Clip {
        std::string name;
        int begin = 0;  ///< its first frame in `bits`
        int frames = 0;
    };
    double rate = 30;  ///< Hz
    std::vector<Clip> clips;
    std::vector<PoseBits> bits;

    void add(std::string name, std::span<const PoseBits> frames);
};

/// Frames of a clip of a library.
struct ClipRange {
    int clip = 0;
    FrameRange frames;

    bool operator==(const ClipRange&) const = default;
};

/// What is looked for: the features of some key poses in order, and when they come.
struct KeySequence {
    std::vector<PoseBits> bits;
    std::vector<int> frames;  ///< strictly rising, at the library's rate
};

struct RetrievalSettings {
    PoseBits mask = kAllPoseBits;  ///< which features count: see maskOf(BodyPart)
    double fastest = 0.5;          ///< the time between two keys may shrink to this share …
    double slowest = 2.0;          ///< … or grow to this multiple
    int results = 12;
    /// Where it is looked for; empty: everywhere.
    std::vector<ClipRange> within;
};

/// A place in the library that resembles the keys.
struct KeyMatch {
    int clip = 0;
    std::vector<int> frames;  ///< of the clip, one per key, strictly rising
    int mismatches = 0;       ///< features that differ, over all keys
    double stretch = 0;       ///< mean |log| of its times between keys against the query's
};

/// The library's places that match the keys best (method C2): fewest features that differ, summed
/// over the keys, then the timing that is nearest to the query's, then the order of the library. No
/// two results share more than half of their frames. Exact in the number of differing features;
/// of places that tie in it, those that fit without any change of timing are looked at first.
/// Empty if no clip is long enough. Throws Error if the keys are none or not in order.
std::vector<KeyMatch> findSimilar(const FeatureLibrary& library, const KeySequence& keys,
                                  const RetrievalSettings& settings = {},
                                  const Progress& progress = {});

}  // namespace kumite
