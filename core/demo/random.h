#pragma once

#include <cstdint>
#include <span>

namespace kumite::demo {

/// A stream of random numbers that is the same on every machine (SplitMix64, Steele et al. 2014;
/// the standard library's distributions are not).
class Random {
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

    double uniform();  ///< in [0, 1)
    double uniform(double low, double high);
    double normal(double mean, double deviation);
    /// Normal, drawn again until it lies within [low, high].
    double normalWithin(double mean, double deviation, double low, double high);
    bool chance(double probability) { return uniform() < probability; }
    /// An index drawn with probability proportional to its weight; the weights' sum is positive.
    int pick(std::span<const double> weights);

private:
    std::uint64_t next();

    std::uint64_t state_;
};

/// A smooth random curve of time with mean 0 and values within ±1: cubic between a random value
/// every 1/frequency seconds. The same for the same seed and channel at any rate of sampling.
double smoothNoise(std::uint64_t seed, int channel, double time, double frequency);

}  // namespace kumite::demo
