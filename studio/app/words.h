#pragma once

#include <QString>

namespace kumite::studio {

/// How numbers and names read everywhere in the window; independent of the locale.

/// 64.25 s → "1:04.250"; minutes, seconds, milliseconds.
QString timeText(double seconds);
/// With as many decimals as `step` seconds between two texts need: "1:04", "1:04.2".
QString timeText(double seconds, double step);
/// 0.7249 → "0.72 BW".
QString bodyWeightsText(double bodyWeights);
/// 0.123 → "12 %".
QString percentText(double share);
/// 0 → "fighter 1".
QString fighterText(int player);

}  // namespace kumite::studio
