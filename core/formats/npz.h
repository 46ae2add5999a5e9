#pragma once

#include <string>
#include <vector>

#include "core/motion/pose.h"

namespace kumite {

/// An array of numpy's .npy format, version 1.0 (2.0 for long headers), little-endian, C order.
struct NpyArray {
    std::string name;   ///< key in the .npz
    std::string dtype;  ///< "<f4", "<f8", "<i4", "<U12"
    std::vector<std::size_t> shape;
    std::string data;
};

NpyArray npyFloats(std::string name, std::vector<std::size_t> shape,
                   const std::vector<float>& values);
NpyArray npyNumber(std::string name, double value);  ///< of no dimension
NpyArray npyIntegers(std::string name, const std::vector<std::int32_t>& values);
/// Text as numpy's fixed-width UCS-4; what is no UTF-8 becomes U+FFFD.
NpyArray npyTexts(std::string name, const std::vector<std::string>& texts);

/// The bytes of a .npz: a zip archive of `NAME.npy`, stored. Throws Error beyond 4 GB.
std::string npzBytes(const std::vector<NpyArray>& arrays);

/// A clip as arrays, each key ending in `suffix`: `positions` (frames × joints × 3, metres, y up,
/// in space), `rotations` (frames × joints × 4: w, x, y, z relative to the parent), `names`,
/// `parents` (−1: none), `rate` (Hz), `start` (seconds on the common clock).
std::vector<NpyArray> clipArrays(const Clip& clip, double start, const std::string& suffix);

}  // namespace kumite
