#include "studio/timeline/time_mapping.h"

#include <array>
#include <cmath>

namespace kumite::studio {

TimeMapping TimeMapping::zoomedAbout(double x, double factor) const {
    const double still = timeAt(x);
    TimeMapping zoomed = *this;
    zoomed.begin = still - (still - begin) / factor;
    zoomed.end = still + (end - still) / factor;
    return zoomed;
}

TimeMapping TimeMapping::panned(double dx) const {
    const double seconds = dx / pixelsPerSecond();
    TimeMapping moved = *this;
    moved.begin -= seconds;
    moved.end -= seconds;
    return moved;
}

double rulerStep(double pixelsPerSecond, double minimumPixels) {
    constexpr std::array<double, 15> kSteps = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1,  2,
                                               5,    10,   15,   30,  60,  120, 300};
    for (const double step : kSteps) {
        if (step * pixelsPerSecond >= minimumPixels) return step;
    }
    return 600 * std::ceil(minimumPixels / (600 * pixelsPerSecond));
}

double frameStep(double pixelsPerFrame, double minimumPixels) {
    for (double power = 5;; power *= 10) {
        for (const double factor : {1.0, 2.0, 4.0, 10.0}) {
            if (factor * power * pixelsPerFrame >= minimumPixels) return factor * power;
        }
    }
}

}  // namespace kumite::studio
