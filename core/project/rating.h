#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/project/library_strikes.h"

namespace kumite {

/// A clip that people rate as natural or not, and how it was made.
struct RatedClip {
    std::string kind;  ///< "captured", "whole-body blend", "blend by parts", "key poses"
    std::string name;
    Clip clip;  ///< begins over the origin, facing +z
};

struct RatingSettings {
    int clipsPerKind = 10;
    std::uint32_t seed = 1;
};

struct RatedClips {
    std::vector<RatedClip> clips;  ///< kind after kind
    Findings findings;             ///< clips that could not be made
};

/// Clips for the naturalness test of paper C (section 5): captured examples of a strike, and of the
/// same strike blends at targets drawn within 15 cm a side of where
/// examples hit (whole bodies, and by parts), and motions assembled from five key poses each of an
/// example that is itself no source. The same seed draws the same. Throws Error as `strikesOf`
/// does; Cancelled.
RatedClips clipsToRate(const MotionLibrary& library, const StrikeRequest& request,
                       const RatingSettings& settings = {}, const Progress& progress = {});

/// 0 … count − 1 in a drawn order, the same on every machine.
std::vector<int> drawnOrder(std::size_t count, std::mt19937& random);

}  // namespace kumite
