#include "core/demo/com_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kumite::demo {
namespace {

using Eigen::Vector3d;

/// Coefficients of s⁰, s¹ …
using Polynomial = std::array<double, 14>;

constexpr double kStepMoment = 3.0 / 20;  // of (1−s)·step; the step's integral is 1/2

/// 3s² − 2s³.
constexpr Polynomial smoothStep() {
    Polynomial p{};
    p[2] = 3;
    p[3] = -2;
    return p;
}

Polynomial times(const Polynomial& a, const Polynomial& b) {
    Polynomial product{};
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; i + k < product.size(); ++k)
            product[i + k] += a[i] * b[k];
    }
    return product;
}

/// ∫ p over 0…1, and ∫ (1−s) p.
double integralOf(const Polynomial& p) {
    double sum = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
        sum += p[k] / static_cast<double>(k + 1);
    return sum;
}
double momentOf(const Polynomial& p) {
    double sum = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
        sum += p[k] / static_cast<double>((k + 1) * (k + 2));
    return sum;
}

/// The peak of an action, of height 1, and the same times u = 1 − 2s, which shifts it.
struct Peak {
    /// (1 − u²ⁿ)².
    explicit Peak(int n) {
        constexpr Polynomial one = {1};
        constexpr Polynomial u = {1, -2};
        Polynomial power = one;  // u²ⁿ
        for (int k = 0; k < 2 * n; ++k)
            power = times(power, u);
        Polynomial arch = one;
        for (std::size_t k = 0; k < arch.size(); ++k)
            arch[k] -= power[k];
        even = times(arch, arch);
        odd = times(even, u);
    }

    Polynomial even{};
    Polynomial odd{};
};

const Peak& peakFor(double duration) {
    static const std::array<Peak, 3> peaks = {Peak(1), Peak(2), Peak(3)};
    if (duration < 0.7) return peaks[0];
    return duration < 0.95 ? peaks[1] : peaks[2];
}

/// The shape of a dip over u = 0…1 with depth 1, and its first and second integral.
double dipAt(double u) {
    return u <= 0 || u >= 1 ? 0.0 : 16 * u * u * (1 - u) * (1 - u);
}
double dipOnce(double u) {
    if (u <= 0) return 0;
    u = std::min(u, 1.0);
    return 16 * u * u * u * (1.0 / 3 - u / 2 + u * u / 5);
}
double dipTwice(double u) {
    if (u <= 0) return 0;
    const double inside = std::min(u, 1.0);
    const double cube = inside * inside * inside;
    return 16 * cube * inside * (1.0 / 12 - inside / 10 + inside * inside / 30) +
           std::max(0.0, u - 1.0) * dipOnce(1);
}

struct Shape {
    double even = 0;
    double odd = 0;
};

/// The ground's part of an action: between the flights at its ends, if there are any.
struct Contact {
    double begin = 0;
    double end = 0;
    Vector3d startPosition;
    Vector3d startVelocity;
    Vector3d endPosition;
    Vector3d endVelocity;
    double startForce = 0;
    double endForce = 0;
    const Peak* peak = nullptr;

    double duration() const { return end - begin; }
};

Contact contactOf(const ComKnot& from, const ComKnot& to) {
    Contact c;
    const double before = from.flight / 2;
    const double after = to.flight / 2;
    c.begin = from.time + before;
    c.end = to.time - after;
    c.startVelocity = from.velocity - Vector3d(0, kGravity * before, 0);
    c.startPosition =
        from.position + from.velocity * before - Vector3d(0, kGravity * before * before / 2, 0);
    c.endVelocity = to.velocity + Vector3d(0, kGravity * after, 0);
    c.endPosition =
        to.position - to.velocity * after - Vector3d(0, kGravity * after * after / 2, 0);
    c.startForce = before > 0 ? 0.0 : from.force;
    c.endForce = after > 0 ? 0.0 : to.force;
    c.peak = &peakFor(c.duration());
    return c;
}

/// The parts whose integral is `sum` and whose moment is `way`.
Shape solve(const Peak& peak, double sum, double way) {
    const double ie = integralOf(peak.even);
    const double io = integralOf(peak.odd);
    const double me = momentOf(peak.even);
    const double mo = momentOf(peak.odd);
    const double determinant = ie * mo - io * me;
    return {(sum * mo - way * io) / determinant, (ie * way - me * sum) / determinant};
}

/// With the odd part within what `limit` says of the even one: the integral holds, the moment
/// gives way.
template <typename Limit>
Shape limited(const Peak& peak, double sum, Shape shape, const Limit& limit) {
    for (int round = 0; round < 8 && std::abs(shape.odd) > limit(shape.even); ++round) {
        shape.odd = std::copysign(limit(shape.even), shape.odd);
        shape.even = (sum - shape.odd * integralOf(peak.odd)) / integralOf(peak.even);
    }
    return shape;
}

/// How strong the odd part may be for the whole to keep one peak.
double oddLimit(const Contact& c, double even) {
    return std::max(0.0, 0.9 * (even - 0.2 * std::abs(c.endForce - c.startForce)));
}

/// Even and odd part of the vertical force, in body weights, and whether they do all that was
/// asked for.
std::pair<Shape, bool> verticalShape(const Contact& c, const std::optional<ForceDip>& dip) {
    const double duration = c.duration();
    const double speedGain = (c.endVelocity.y() - c.startVelocity.y()) / (kGravity * duration);
    const double climb =
        (c.endPosition.y() - c.startPosition.y() - c.startVelocity.y() * duration) /
        (kGravity * duration * duration);
    double dipIntegral = 0;
    double dipMoment = 0;
    if (dip) {
        const double u = (c.end - (dip->time - dip->width / 2)) / dip->width;
        dipIntegral = dip->depth * dipOnce(u) * dip->width / duration;
        dipMoment = dip->depth * dipTwice(u) * dip->width * dip->width / (duration * duration);
    }
    // Two equations: what the force must add up to for the speed, and for the way.
    const double sum = 1 + speedGain - (c.startForce + c.endForce) / 2 + dipIntegral;
    const double way =
        0.5 + climb - c.startForce / 2 - kStepMoment * (c.endForce - c.startForce) + dipMoment;
    const Shape wish = solve(*c.peak, sum, way);
    const bool fits = std::abs(wish.odd) <= oddLimit(c, wish.even);
    const auto limit = [&](double even) { return oddLimit(c, even); };
    return {fits ? wish : limited(*c.peak, sum, wish, limit), fits};
}

/// Lowers the knots' forces until every action has a clear peak between its ends.
void makeRoomForPeaks(std::vector<ComKnot>& knots,
                      const std::vector<std::optional<ForceDip>>& dips) {
    constexpr double kLowest = 0.32;
    constexpr double kRise = 0.11;  // of the peak above its higher end, body weights
    for (int round = 0; round < 12; ++round) {
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            const Contact c = contactOf(knots[i], knots[i + 1]);
            const auto [shape, fits] = verticalShape(c, dips[i]);
            const double rise = shape.even - std::abs(c.endForce - c.startForce) / 2;
            if (rise >= kRise && fits) continue;
            for (const std::size_t k : {i, i + 1}) {
                if (k == 0 || k + 1 == knots.size()) continue;  // nothing to be lighter than
                knots[k].force = std::max(kLowest, knots[k].force - 0.04);
            }
        }
    }
}

/// Even and odd part along x or z, m/s², weak enough to leave the vertical force its one peak.
Shape horizontalShape(const Peak& peak, double start, double startSpeed, double end,
                      double endSpeed, double duration) {
    constexpr double kStrongestEven = 0.42 * kGravity;
    constexpr double kStrongestOdd = 1.05 * kGravity;  // its own peak is 0.29 of that
    const double way = (end - start - startSpeed * duration) / (duration * duration);
    const double sum = (endSpeed - startSpeed) / duration;
    Shape shape = limited(peak, sum, solve(peak, sum, way), [](double) { return kStrongestOdd; });
    shape.even = std::clamp(shape.even, -kStrongestEven, kStrongestEven);
    return shape;
}

}  // namespace

Vector3d ComPath::Piece::accelerationAt(double time) const {
    const double s = (time - begin) / duration;
    Vector3d sum = Vector3d::Zero();
    double power = 1;
    for (const Vector3d& coefficient : acceleration) {
        sum += power * coefficient;
        power *= s;
    }
    if (dip) {
        sum.y() -=
            kGravity * dip->depth * dipAt((time - (dip->time - dip->width / 2)) / dip->width);
    }
    return sum;
}

Vector3d ComPath::Piece::velocityAt(double time) const {
    const double s = (time - begin) / duration;
    Vector3d sum = Vector3d::Zero();
    double power = s;
    for (std::size_t k = 0; k < acceleration.size(); ++k) {
        sum += power / static_cast<double>(k + 1) * acceleration[k];
        power *= s;
    }
    sum = velocity + duration * sum;
    if (dip) {
        sum.y() -= kGravity * dip->depth * dip->width *
                   dipOnce((time - (dip->time - dip->width / 2)) / dip->width);
    }
    return sum;
}

Vector3d ComPath::Piece::positionAt(double time) const {
    const double s = (time - begin) / duration;
    Vector3d sum = Vector3d::Zero();
    double power = s * s;
    for (std::size_t k = 0; k < acceleration.size(); ++k) {
        sum += power / static_cast<double>((k + 1) * (k + 2)) * acceleration[k];
        power *= s;
    }
    sum = position + velocity * (time - begin) + duration * duration * sum;
    if (dip) {
        sum.y() -= kGravity * dip->depth * dip->width * dip->width *
                   dipTwice((time - (dip->time - dip->width / 2)) / dip->width);
    }
    return sum;
}

void ComPath::addFlight(double begin, double duration, const Vector3d& position,
                        const Vector3d& velocity) {
    if (duration <= 0) return;
    Piece piece;
    piece.begin = begin;
    piece.duration = duration;
    piece.position = position;
    piece.velocity = velocity;
    piece.acceleration.fill(Vector3d::Zero());
    piece.acceleration[0].y() = -kGravity;
    pieces_.push_back(piece);
}

ComPath::ComPath(std::vector<ComKnot>& knots, const std::vector<std::optional<ForceDip>>& dips) {
    makeRoomForPeaks(knots, dips);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const ComKnot& from = knots[i];
        ComKnot& to = knots[i + 1];
        addFlight(from.time, from.flight / 2, from.position, from.velocity);
        const Contact c = contactOf(from, to);
        Piece piece;
        piece.begin = c.begin;
        piece.duration = c.duration();
        piece.position = c.startPosition;
        piece.velocity = c.startVelocity;
        piece.dip = dips[i];
        const Shape y = verticalShape(c, dips[i]).first;
        const Peak& along = peakFor(0);
        const Shape x = horizontalShape(along, c.startPosition.x(), c.startVelocity.x(),
                                        c.endPosition.x(), c.endVelocity.x(), piece.duration);
        const Shape z = horizontalShape(along, c.startPosition.z(), c.startVelocity.z(),
                                        c.endPosition.z(), c.endVelocity.z(), piece.duration);
        const Peak& up = *c.peak;
        constexpr Polynomial kStep = smoothStep();
        for (std::size_t k = 0; k < piece.acceleration.size(); ++k) {
            const double vertical =
                (c.endForce - c.startForce) * kStep[k] + y.even * up.even[k] + y.odd * up.odd[k];
            piece.acceleration[k] = {x.even * along.even[k] + x.odd * along.odd[k],
                                     kGravity * vertical,
                                     z.even * along.even[k] + z.odd * along.odd[k]};
        }
        piece.acceleration[0].y() += kGravity * (c.startForce - 1);
        pieces_.push_back(piece);
        const Vector3d endPosition = piece.positionAt(c.end);
        const Vector3d endVelocity = piece.velocityAt(c.end);
        addFlight(c.end, to.flight / 2, endPosition, endVelocity);
        to.position = pieces_.back().positionAt(to.time);
        to.velocity = pieces_.back().velocityAt(to.time);
    }
}

const ComPath::Piece& ComPath::pieceAt(double time) const {
    const auto after =
        std::upper_bound(pieces_.begin(), pieces_.end(), time,
                         [](double value, const Piece& piece) { return value < piece.begin; });
    return after == pieces_.begin() ? pieces_.front() : *(after - 1);
}

Vector3d ComPath::position(double time) const {
    return pieceAt(time).positionAt(time);
}

Vector3d ComPath::velocity(double time) const {
    return pieceAt(time).velocityAt(time);
}

Vector3d ComPath::force(double time) const {
    return pieceAt(time).accelerationAt(time) / kGravity + Vector3d(0, 1, 0);
}

}  // namespace kumite::demo
