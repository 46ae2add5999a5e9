#pragma once

namespace kumite {

/// Acceleration of gravity, m/s²: what makes a force one body weight (method A2).
inline constexpr double kGravity = 9.80665;

}  // namespace kumite
