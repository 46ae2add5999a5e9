#include "core/segmentation/low_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace kumite {
namespace {

/// Second-order section, transposed direct form II.
struct Butterworth {
    double b0, b1, b2, a1, a2;

    Butterworth(double rate, double cutoff) {
        const double k = std::tan(std::numbers::pi * cutoff / rate);  // pre-warped
        const double norm = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
        b0 = k * k * norm;
        b1 = 2.0 * b0;
        b2 = b0;
        a1 = 2.0 * (k * k - 1.0) * norm;
        a2 = (1.0 - std::numbers::sqrt2 * k + k * k) * norm;
    }

    /// Filters in place, from the state that a constant input of samples.front() has settled in.
    template <typename Iterator>
    void run(Iterator begin, Iterator end) const {
        if (begin == end) return;
        double s1 = (1.0 - b0) * *begin;
        double s2 = (b2 - a2) * *begin;
        for (Iterator it = begin; it != end; ++it) {
            const double x = *it;
            const double y = b0 * x + s1;
            s1 = b1 * x - a1 * y + s2;
            s2 = b2 * x - a2 * y;
            *it = y;
        }
    }
};

}  // namespace

std::vector<double> lowPass(const std::vector<double>& samples, double rate, double cutoff) {
    assert(cutoff > 0 && cutoff < rate / 2);
    if (samples.empty()) return {};
    const std::size_t n = samples.size();
    const auto wanted = static_cast<std::size_t>(std::max(9.0, std::round(0.5 * rate)));
    const std::size_t pad = std::min(n - 1, wanted);

    std::vector<double> padded;
    padded.reserve(n + 2 * pad);
    for (std::size_t i = pad; i > 0; --i)
        padded.push_back(2 * samples.front() - samples[i]);
    padded.insert(padded.end(), samples.begin(), samples.end());
    for (std::size_t i = 1; i <= pad; ++i)
        padded.push_back(2 * samples.back() - samples[n - 1 - i]);

    const Butterworth filter(rate, cutoff);
    filter.run(padded.begin(), padded.end());
    filter.run(padded.rbegin(), padded.rend());
    const auto first = padded.begin() + static_cast<std::ptrdiff_t>(pad);
    return {first, first + static_cast<std::ptrdiff_t>(n)};
}

}  // namespace kumite
