#pragma once

#include <vector>

namespace kumite {

/// Maps frames of the query to frames of a retrieved clip so that the feature poses fall on each
/// other (paper C, 4.2.1). Between two of them a cubic Bézier curve leads, whose inner control
/// points stand a third of the way in time; it passes every feature pose without a kink and never
/// runs backward (slopes after Fritsch & Carlson 1980). Before the first and after the last feature
/// pose time goes on at the slope that the curve has there; with one feature pose, at slope 1.
class TimeMapping {
public:
    /// Both strictly rising, of one length, at least one. Throws Error.
    TimeMapping(std::vector<double> query, std::vector<double> clip);

    /// The moment of the clip, in its frames, that belongs to a moment of the query.
    double operator()(double queryFrame) const;

    /// The four control points of the curve between feature poses k and k + 1: frames of the query
    /// and of the clip.
    struct Point {
        double query = 0, clip = 0;
    };
    std::vector<Point> controlPoints(int k) const;

private:
    std::vector<double> query_, clip_, slope_;
};

}  // namespace kumite
