#include "core/demo/random.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace kumite::demo {
namespace {

std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;

double toUnit(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream)
    : state_(mixed(seed * kStep + 1) ^ mixed(stream + kStep)) {}

std::uint64_t Random::next() {
    state_ += kStep;
    return mixed(state_);
}

double Random::uniform() {
    return toUnit(next());
}

double Random::uniform(double low, double high) {
    return low + (high - low) * uniform();
}

double Random::normal(double mean, double deviation) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return mean + deviation * radius * std::cos(2.0 * std::numbers::pi * uniform());
}

double Random::normalWithin(double mean, double deviation, double low, double high) {
    for (;;) {
        const double value = normal(mean, deviation);
        if (value >= low && value <= high) return value;
    }
}

int Random::pick(std::span<const double> weights) {
    double left = uniform() * std::accumulate(weights.begin(), weights.end(), 0.0);
    int last = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] <= 0) continue;
        last = static_cast<int>(i);
        left -= weights[i];
        if (left < 0) break;
    }
    return last;
}

double smoothNoise(std::uint64_t seed, int channel, double time, double frequency) {
    const double at = time * frequency;
    const double cell = std::floor(at);
    const double x = at - cell;
    const auto valueAt = [&](double knot) {
        const auto index = static_cast<std::uint64_t>(static_cast<std::int64_t>(knot));
        const auto stream = static_cast<std::uint64_t>(channel) + 1;
        return 2.0 * toUnit(mixed(index * kStep ^ mixed(seed + stream * kStep))) - 1.0;
    };
    // Uniform cubic B-spline: twice differentiable, never beyond its knots' values.
    const double y = 1.0 - x;
    return (y * y * y * valueAt(cell - 1) + (3 * x * x * x - 6 * x * x + 4) * valueAt(cell) +
            (3 * y * y * y - 6 * y * y + 4) * valueAt(cell + 1) + x * x * x * valueAt(cell + 2)) /
           6.0;
}

}  // namespace kumite::demo
