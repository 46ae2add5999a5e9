#include "core/editing/time_alignment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kumite {
namespace {

/// A frame's points with their middle on the origin of the ground.
struct Centred {
    JointPoints points;
    double squares = 0;  ///< of the horizontal coordinates

    explicit Centred(const JointPoints& frame) : points(frame) {
        const double n = static_cast<double>(std::max<Eigen::Index>(1, frame.cols()));
        for (const int axis : {0, 2}) {
            points.row(axis).array() -= frame.row(axis).sum() / n;
            squares += points.row(axis).squaredNorm();
        }
    }
};

/// With the turn that fits best the crossed products become the length of their sum's vector.
double alignedDistance(const Centred& a, const Centred& b) {
    double along = 0, across = 0, height = 0;
    for (Eigen::Index j = 0; j < a.points.cols(); ++j) {
        const double ax = a.points(0, j), az = a.points(2, j);
        const double bx = b.points(0, j), bz = b.points(2, j);
        along += ax * bx + az * bz;
        across += ax * bz - az * bx;
        const double dy = a.points(1, j) - b.points(1, j);
        height += dy * dy;
    }
    return std::max(0.0, a.squares + b.squares - 2 * std::hypot(along, across)) + height;
}

/// How a path came to a cell: the last step's direction and how many of them in a row. 0 is a
/// diagonal step; 1 … L are (1, 0), L + 1 … 2 L are (0, 1).
struct Search {
    const AlignmentGrid& grid;
    int limit;
    int states;
    std::vector<double> costs;        ///< rows × columns × states
    std::vector<std::uint16_t> from;  ///< the state before

    Search(const AlignmentGrid& g, int slopeLimit)
        : grid(g), limit(slopeLimit), states(1 + 2 * slopeLimit) {
        const std::size_t cells = static_cast<std::size_t>(g.rows) *
                                  static_cast<std::size_t>(g.columns) *
                                  static_cast<std::size_t>(states);
        costs.assign(cells, std::numeric_limits<double>::infinity());
        from.assign(cells, 0);
    }
    std::size_t index(int row, int column, int state) const {
        return (static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                static_cast<std::size_t>(column)) *
                   static_cast<std::size_t>(states) +
               static_cast<std::size_t>(state);
    }
    /// Comes to `to` from the cheapest of the states [first, last) of another cell.
    void take(std::size_t to, int row, int column, int first, int last) {
        for (int state = first; state < last; ++state) {
            const double cost = costs[index(row, column, state)];
            if (cost < costs[to]) {
                costs[to] = cost;
                from[to] = static_cast<std::uint16_t>(state);
            }
        }
    }
    void visit(int row, int column) {
        const int down = 1, right = 1 + limit;
        if (row > 0 && column > 0) take(index(row, column, 0), row - 1, column - 1, 0, states);
        for (int run = 0; run < limit; ++run) {
            if (row > 0) {
                const std::size_t to = index(row, column, down + run);
                if (run > 0) {
                    take(to, row - 1, column, down + run - 1, down + run);
                } else {
                    take(to, row - 1, column, 0, 1);
                    take(to, row - 1, column, right, right + limit);
                }
            }
            if (column > 0) {
                const std::size_t to = index(row, column, right + run);
                if (run > 0) {
                    take(to, row, column - 1, right + run - 1, right + run);
                } else {
                    take(to, row, column - 1, 0, 1);
                    take(to, row, column - 1, down, down + limit);
                }
            }
        }
        for (int state = 0; state < states; ++state)
            costs[index(row, column, state)] += grid.at(row, column);
    }
};

}  // namespace

AlignmentGrid alignmentGrid(std::span<const JointPoints> a, std::span<const JointPoints> b) {
    const std::vector<Centred> first(a.begin(), a.end());
    const std::vector<Centred> second(b.begin(), b.end());
    AlignmentGrid grid{static_cast<int>(a.size()), static_cast<int>(b.size()), {}};
    grid.values.reserve(a.size() * b.size());
    for (const Centred& row : first) {
        for (const Centred& column : second)
            grid.values.push_back(alignedDistance(row, column));
    }
    return grid;
}

std::optional<TimeAlignment> alignInTime(const AlignmentGrid& grid, int slopeLimit) {
    if (grid.rows == 0 || grid.columns == 0 || slopeLimit < 1) return std::nullopt;
    Search search(grid, slopeLimit);
    search.costs[search.index(0, 0, 0)] = grid.at(0, 0);
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = row == 0 ? 1 : 0; column < grid.columns; ++column)
            search.visit(row, column);
    }
    int row = grid.rows - 1, column = grid.columns - 1, state = 0;
    for (int other = 1; other < search.states; ++other) {
        if (search.costs[search.index(row, column, other)] <
            search.costs[search.index(row, column, state)])
            state = other;
    }
    TimeAlignment result;
    result.cost = search.costs[search.index(row, column, state)];
    if (!std::isfinite(result.cost)) return std::nullopt;
    while (row > 0 || column > 0) {
        result.path.push_back({row, column});
        const int before = search.from[search.index(row, column, state)];
        if (state <= slopeLimit) --row;
        if (state == 0 || state > slopeLimit) --column;
        state = before;
    }
    result.path.push_back({0, 0});
    std::reverse(result.path.begin(), result.path.end());
    return result;
}

std::vector<double> matchingTimes(const TimeAlignment& alignment, int smoothing) {
    std::vector<double> times, counts;
    for (const FramePair& pair : alignment.path) {
        if (pair.a == static_cast<int>(times.size())) {
            times.push_back(0);
            counts.push_back(0);
        }
        times.back() += pair.b;
        counts.back() += 1;
    }
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] /= counts[i];
    times.front() = alignment.path.front().b;
    times.back() = alignment.path.back().b;
    const int n = static_cast<int>(times.size());
    std::vector<double> smooth(times.size());
    for (int i = 0; i < n; ++i) {
        // The window shrinks toward the ends, so that they stay and no time runs backward.
        const int half = std::min({smoothing / 2, i, n - 1 - i});
        double sum = 0;
        for (int j = i - half; j <= i + half; ++j)
            sum += times[static_cast<std::size_t>(j)];
        smooth[static_cast<std::size_t>(i)] = sum / (2 * half + 1);
    }
    return smooth;
}

}  // namespace kumite
