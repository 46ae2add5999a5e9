#include "core/motion/motion.h"

#include <array>
#include <cmath>

#include "core/base/error.h"

namespace kumite {

void Motion::validate() const {
    if (!skeleton) throw Error("A motion needs a skeleton.");
    skeleton->validate();
    if (!(frameTime > 0) || !std::isfinite(frameTime)) {
        throw Error("A motion's frame time must be a positive number of seconds.");
    }
    const auto expected =
        static_cast<std::size_t>(frameCount) * static_cast<std::size_t>(skeleton->channelCount);
    if (frameCount < 0 || channels.size() != expected) {
        throw Error("A motion's channel values do not fill its frames.");
    }
    for (const double value : channels) {
        if (!std::isfinite(value)) throw Error("A channel value is not a finite number.");
    }
}

double rateOf(double frameTime) {
    constexpr double kTolerance = 5e-4;
    const double rate = 1.0 / frameTime;
    const double whole = std::round(rate);
    if (whole > 0 && std::abs(rate - whole) <= kTolerance * whole) return whole;
    for (const double ntsc : {24.0, 30.0, 60.0, 120.0}) {
        const double exact = ntsc / 1.001;
        if (std::abs(rate - exact) <= kTolerance * exact) return exact;
    }
    return rate;
}

}  // namespace kumite
