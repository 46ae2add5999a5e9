#pragma once

#include <cstdint>

namespace kumite {

/// A number in [0, 1) that depends on nothing but its arguments: the `count`-th draw of a stream
/// (a fighter) of a seed. Without a state, so that a bout that is rewound or goes on with another
/// seed draws what it would have drawn. SplitMix64 (Steele, Lea, Flood 2014) over the mixed words.
inline double drawn(std::uint64_t seed, std::uint64_t stream, std::uint64_t count) {
    const auto mixed = [](std::uint64_t word) {
        word += 0x9E3779B97F4A7C15u;
        word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9u;
        word = (word ^ (word >> 27)) * 0x94D049BB133111EBu;
        return word ^ (word >> 31);
    };
    const std::uint64_t word = mixed(mixed(mixed(seed) ^ stream) ^ count);
    return static_cast<double>(word >> 11) * 0x1.0p-53;
}

}  // namespace kumite
