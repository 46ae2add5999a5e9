#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace kumite {

/// Places of a pose's joints as columns, metres, y up.
using JointPoints = Eigen::Matrix3Xd;

/// How unlike every frame of one motion is to every frame of another (paper C, Fig. 2): rows are
/// the first motion's frames.
struct AlignmentGrid {
    int rows = 0;
    int columns = 0;
    std::vector<double> values;

    double at(int row, int column) const {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
};

/// Cell (i, j) = least sum over the joints of |a − T b|², T a turn about y and a move on the ground
/// (rigid alignment of single frames, Kovar & Gleicher 2004). Square metres. All frames have the
/// same joints.
AlignmentGrid alignmentGrid(std::span<const JointPoints> a, std::span<const JointPoints> b);

/// A frame of the first motion and one of the second that belong together.
struct FramePair {
    int a = 0;
    int b = 0;
    bool operator==(const FramePair&) const = default;
};

struct TimeAlignment {
    std::vector<FramePair> path;  ///< from (0, 0) to the last frames of both
    double cost = 0;              ///< sum of the path's cells
};

/// The path of least cost through a grid by steps (1, 1), (1, 0) and (0, 1), with at most
/// `slopeLimit` steps (1, 0) in a row and at most as many (0, 1) (dynamic time warping, method C1);
/// every step weighs 1. Of equal paths the more diagonal one. Nothing if the limit allows no path:
/// one motion is more than slopeLimit + 1 times as long as the other.
std::optional<TimeAlignment> alignInTime(const AlignmentGrid& grid, int slopeLimit = 2);

/// For every frame of the first motion the moment of the second that belongs to it, in frames: the
/// mean of the frames that the path pairs it with, smoothed by a running mean of `smoothing` frames
/// (odd) that leaves both ends in place. Never falls; rises from 0 to the second's last frame.
std::vector<double> matchingTimes(const TimeAlignment& alignment, int smoothing = 5);

}  // namespace kumite
