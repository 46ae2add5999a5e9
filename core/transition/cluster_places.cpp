#include "core/transition/cluster_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kumite {
namespace {

/// The direction of the largest eigenvalue of a symmetric matrix without negative ones that
/// matter, and that eigenvalue; by power iteration from a fixed start.
std::pair<Eigen::VectorXd, double> strongest(const Eigen::MatrixXd& matrix) {
    Eigen::VectorXd direction(matrix.rows());
    for (Eigen::Index i = 0; i < direction.size(); ++i)
        direction[i] = 1.0 + 0.37 * static_cast<double>(i % 7) - 0.11 * static_cast<double>(i % 3);
    double value = 0;
    constexpr int kSteps = 100;
    for (int step = 0; step < kSteps; ++step) {
        const Eigen::VectorXd next = matrix * direction;
        value = next.norm();
        if (value < 1e-12) return {Eigen::VectorXd::Zero(matrix.rows()), 0};
        direction = next / value;
    }
    return {direction, value};
}

}  // namespace

std::vector<Eigen::Vector2d> clusterPlaces(const PoseClusters& clusters, int most,
                                           const Progress& progress) {
    const MetricPoints& points = clusters.centres.points();
    const int all = points.count();
    const int count = std::min(all, std::max(1, most));
    std::vector<Eigen::Vector2d> places(static_cast<std::size_t>(all), Eigen::Vector2d::Zero());
    if (count < 2) return places;
    Eigen::MatrixXd squares(count, count);
    for (int i = 0; i < count; ++i) {
        progress.update(static_cast<double>(i) / count);
        squares(i, i) = 0;
        for (int j = 0; j < i; ++j) {
            const double distance = metricDistance(points.shape, points.at(i), points.at(j));
            squares(i, j) = squares(j, i) = distance * distance;
        }
    }
    // Double centring makes scalar products of distances (Torgerson 1952).
    const Eigen::VectorXd means = squares.rowwise().mean();
    Eigen::MatrixXd products = -0.5 * (squares.colwise() - means);
    products.rowwise() += 0.5 * means.transpose();
    products.array() -= 0.5 * means.mean();
    double farthest = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const auto [direction, value] = strongest(products);
        for (int i = 0; i < count; ++i)
            places[static_cast<std::size_t>(i)][axis] = std::sqrt(value) * direction[i];
        products -= value * direction * direction.transpose();
    }
    for (int i = count; i < all; ++i) {
        int nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int j = 0; j < count; ++j) {
            const double distance =
                metricDistanceWithin(points.shape, points.at(i), points.at(j), least);
            if (distance < least) {
                least = distance;
                nearest = j;
            }
        }
        places[static_cast<std::size_t>(i)] = places[static_cast<std::size_t>(nearest)];
    }
    for (const Eigen::Vector2d& place : places)
        farthest = std::max(farthest, place.norm());
    if (farthest > 0) {
        for (Eigen::Vector2d& place : places)
            place /= farthest;
    }
    return places;
}

}  // namespace kumite
