#include "core/editing/time_mapping.h"

#include <algorithm>

#include "core/base/error.h"

namespace kumite {
namespace {

bool rises(const std::vector<double>& values) {
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (!(values[i] > values[i - 1])) return false;
    }
    return true;
}

}  // namespace

TimeMapping::TimeMapping(std::vector<double> query, std::vector<double> clip)
    : query_(std::move(query)), clip_(std::move(clip)) {
    if (query_.empty() || query_.size() != clip_.size())
        throw Error("Feature poses must come in pairs, one of the query and one of the clip.");
    if (!rises(query_) || !rises(clip_))
        throw Error("Feature poses must follow each other in time.");
    const std::size_t n = query_.size();
    std::vector<double> secant;
    for (std::size_t i = 0; i + 1 < n; ++i)
        secant.push_back((clip_[i + 1] - clip_[i]) / (query_[i + 1] - query_[i]));
    slope_.assign(n, 1.0);
    if (n < 2) return;
    slope_.front() = secant.front();
    slope_.back() = secant.back();
    // The harmonic mean lies within what keeps both neighbouring curves from running backward.
    for (std::size_t i = 1; i + 1 < n; ++i)
        slope_[i] = 2 * secant[i - 1] * secant[i] / (secant[i - 1] + secant[i]);
}

std::vector<TimeMapping::Point> TimeMapping::controlPoints(int k) const {
    const auto i = static_cast<std::size_t>(k);
    const double third = (query_[i + 1] - query_[i]) / 3;
    return {{query_[i], clip_[i]},
            {query_[i] + third, clip_[i] + slope_[i] * third},
            {query_[i + 1] - third, clip_[i + 1] - slope_[i + 1] * third},
            {query_[i + 1], clip_[i + 1]}};
}

double TimeMapping::operator()(double t) const {
    if (t <= query_.front()) return clip_.front() + slope_.front() * (t - query_.front());
    if (t >= query_.back()) return clip_.back() + slope_.back() * (t - query_.back());
    const auto after = std::upper_bound(query_.begin(), query_.end(), t);
    const auto k = static_cast<int>(after - query_.begin()) - 1;
    const auto p = controlPoints(k);
    // The control points are evenly spaced in the query's time: its parameter is linear in t.
    const double u = (t - p[0].query) / (p[3].query - p[0].query), v = 1 - u;
    return v * v * v * p[0].clip + 3 * v * v * u * p[1].clip + 3 * v * u * u * p[2].clip +
           u * u * u * p[3].clip;
}

}  // namespace kumite
