#include "core/interaction/row_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace kumite {

namespace {

Eigen::MatrixXd hellingerDistances(const Eigen::MatrixXd& rows) {
    Eigen::MatrixXd roots = rows.cwiseMax(0.0);
    for (Eigen::Index i = 0; i < roots.rows(); ++i) {
        const double sum = roots.row(i).sum();
        if (sum > 0) roots.row(i) /= sum;
    }
    roots = roots.cwiseSqrt();
    const Eigen::VectorXd squares = roots.rowwise().squaredNorm();
    Eigen::MatrixXd distances = -2.0 * roots * roots.transpose();
    distances.colwise() += squares;
    distances.rowwise() += squares.transpose();
    return (0.5 * distances).cwiseMax(0.0).cwiseSqrt();
}

struct Merge {
    int a = 0;  ///< the clusters by their lowest row
    int b = 0;
    double height = 0;
};

/// Follows nearest neighbours until two clusters are each other's. Average linkage never lets a
/// merge bring clusters nearer than they were, so the chain's beginning stays good.
std::vector<Merge> mergesOf(Eigen::MatrixXd distance) {
    const auto count = static_cast<int>(distance.rows());
    std::vector<double> size(static_cast<std::size_t>(count), 1.0);
    std::vector<bool> alive(static_cast<std::size_t>(count), true);
    std::vector<Merge> merges;
    std::vector<int> chain;
    while (static_cast<int>(merges.size()) + 1 < count) {
        if (chain.empty()) {
            const auto first = std::find(alive.begin(), alive.end(), true);
            chain.push_back(static_cast<int>(first - alive.begin()));
        }
        const int tip = chain.back();
        const int before = chain.size() > 1 ? chain[chain.size() - 2] : -1;
        int nearest = before;
        double best = before >= 0 ? distance(tip, before) : std::numeric_limits<double>::max();
        for (int other = 0; other < count; ++other) {
            if (other == tip || !alive[static_cast<std::size_t>(other)]) continue;
            if (distance(tip, other) < best) {
                best = distance(tip, other);
                nearest = other;
            }
        }
        if (nearest != before || before < 0) {
            chain.push_back(nearest);
            continue;
        }
        chain.resize(chain.size() - 2);
        const int a = std::min(tip, before);
        const int b = std::max(tip, before);
        merges.push_back({a, b, best});
        double& sizeA = size[static_cast<std::size_t>(a)];
        const double sizeB = size[static_cast<std::size_t>(b)];
        distance.row(a) = (sizeA * distance.row(a) + sizeB * distance.row(b)) / (sizeA + sizeB);
        distance.col(a) = distance.row(a).transpose();
        sizeA += sizeB;
        alive[static_cast<std::size_t>(b)] = false;
    }
    std::stable_sort(merges.begin(), merges.end(),
                     [](const Merge& x, const Merge& y) { return x.height < y.height; });
    return merges;
}

/// A cluster's rows in order, and the height of the join before each but the first.
struct Branch {
    std::vector<int> rows;
    std::vector<double> joins;

    void turn() {
        std::reverse(rows.begin(), rows.end());
        std::reverse(joins.begin(), joins.end());
    }
};

Branch join(Branch left, Branch right, double height, const Eigen::MatrixXd& distance) {
    struct Way {
        bool turnLeft, turnRight;
    };
    constexpr Way kWays[] = {{false, false}, {false, true}, {true, false}, {true, true}};
    const Way* best = kWays;
    double nearest = std::numeric_limits<double>::max();
    for (const Way& way : kWays) {
        const int end = way.turnLeft ? left.rows.front() : left.rows.back();
        const int begin = way.turnRight ? right.rows.back() : right.rows.front();
        if (distance(end, begin) >= nearest) continue;
        nearest = distance(end, begin);
        best = &way;
    }
    if (best->turnLeft) left.turn();
    if (best->turnRight) right.turn();
    left.rows.insert(left.rows.end(), right.rows.begin(), right.rows.end());
    left.joins.push_back(height);
    left.joins.insert(left.joins.end(), right.joins.begin(), right.joins.end());
    return left;
}

}  // namespace

RowOrder orderBySimilarity(const Eigen::MatrixXd& rows) {
    const auto count = static_cast<int>(rows.rows());
    if (count == 0) return {};
    const Eigen::MatrixXd distance = hellingerDistances(rows);
    std::vector<Branch> branches(static_cast<std::size_t>(count));
    // The cluster of which a row was the lowest stands for it until it is merged itself.
    for (int i = 0; i < count; ++i)
        branches[static_cast<std::size_t>(i)].rows = {i};
    for (const Merge& merge : mergesOf(distance)) {
        Branch& a = branches[static_cast<std::size_t>(merge.a)];
        Branch& b = branches[static_cast<std::size_t>(merge.b)];
        a = join(std::move(a), std::move(b), merge.height, distance);
    }
    RowOrder result{std::move(branches.front().rows), {1.0}};
    const auto& joins = branches.front().joins;
    result.joins.insert(result.joins.end(), joins.begin(), joins.end());
    return result;
}

}  // namespace kumite
