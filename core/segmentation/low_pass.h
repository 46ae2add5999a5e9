#pragma once

#include <vector>

namespace kumite {

/// Zero-phase smoothing: a 2nd-order Butterworth low-pass designed at `cutoff` Hz (bilinear,
/// pre-warped), run forward and backward from steady state over `samples` at `rate` Hz, padded at
/// both ends by min(n − 1, max(9, round(0.5 · rate))) samples of odd reflection (method A2).
/// The cutoff must lie in (0, rate / 2).
std::vector<double> lowPass(const std::vector<double>& samples, double rate, double cutoff);

}  // namespace kumite
