#pragma once

namespace kumite::studio {

/// Seconds ↔ pixels of a timeline: the stretch [begin, end] seconds is drawn over `width` pixels
/// from x = `left`.
struct TimeMapping {
    double begin = 0;
    double end = 1;
    double left = 0;
    double width = 1;

    double xOf(double seconds) const { return left + (seconds - begin) * pixelsPerSecond(); }
    double timeAt(double x) const { return begin + (x - left) / pixelsPerSecond(); }
    double pixelsPerSecond() const { return width / (end - begin); }

    /// The stretch `factor` times shorter, with the moment under `x` staying there.
    TimeMapping zoomedAbout(double x, double factor) const;
    /// The stretch moved so that what lay at x lies at x + dx.
    TimeMapping panned(double dx) const;
};

/// The distance of a ruler's labels, seconds: 1, 2 or 5 times a power of ten, or 15, 30, 60 …;
/// at least `minimumPixels` apart.
double rulerStep(double pixelsPerSecond, double minimumPixels);
/// The same in frames: 5, 10 or 20 times a power of ten, so that a fifth of it is whole.
double frameStep(double pixelsPerFrame, double minimumPixels);

}  // namespace kumite::studio
