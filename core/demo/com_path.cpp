#include "core/demo/com_path.h"

#include <algorithm>
#include <cmath>

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

/// p · (1 − 2s).
Polynomial timesU(const Polynomial& p) {
    Polynomial product{};
    for (std::size_t k = 0; k < p.size(); ++k) {
        product[k] += p[k];
        if (k + 1 < p.size()) product[k + 1] -= 2 * p[k];
    }
    return product;
}

/// The peak of an action, of height 1: even, (1 − u²ⁿ)², and odd, u times that; u = 1 − 2s.
struct Peak {
    explicit Peak(int n) {
        const double m = 2.0 * n;
        integral = 1 - 2 / (m + 1) + 1 / (2 * m + 1);
        oddMoment = (1.0 / 3 - 2 / (m + 3) + 1 / (2 * m + 3)) / 2;
        Polynomial power{};  // uᵏ
        power[0] = 1;
        for (int k = 0; k <= 4 * n; ++k) {
            const double factor = k == 0 ? 1.0 : (k == 2 * n ? -2.0 : (k == 4 * n ? 1.0 : 0.0));
            for (std::size_t i = 0; i < even.size(); ++i)
                even[i] += factor * power[i];
            power = timesU(power);
        }
        odd = timesU(even);
    }

    Polynomial even{};
    Polynomial odd{};
    double integral = 0;   ///< of the even part; its moment with (1−s) is half of that
    double oddMoment = 0;  ///< of (1−s) times the odd part, whose integral is 0
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
    return c;
}

/// Even and odd part of the vertical force, in body weights.
Shape verticalShape(const Contact& c, const std::optional<ForceDip>& dip) {
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
    Shape shape;
    const Peak& peak = peakFor(duration);
    shape.even = (1 + speedGain - (c.startForce + c.endForce) / 2 + dipIntegral) / peak.integral;
    shape.odd = (0.5 + climb - c.startForce / 2 - kStepMoment * (c.endForce - c.startForce) -
                 shape.even * peak.integral / 2 + dipMoment) /
                peak.oddMoment;
    return shape;
}

/// How strong the odd part may be for the whole to keep one peak.
double oddLimit(const Contact& c, double even) {
    return std::max(0.0, 0.9 * (even - 0.2 * std::abs(c.endForce - c.startForce)));
}

/// Lowers the knots' forces until every action has a clear peak between its ends.
void makeRoomForPeaks(std::vector<ComKnot>& knots,
                      const std::vector<std::optional<ForceDip>>& dips) {
    constexpr double kLowest = 0.32;
    constexpr double kRise = 0.16;  // of the peak above its higher end, body weights
    for (int round = 0; round < 12; ++round) {
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            const Contact c = contactOf(knots[i], knots[i + 1]);
            const Shape shape = verticalShape(c, dips[i]);
            const double rise = shape.even - std::abs(c.endForce - c.startForce) / 2;
            if (rise >= kRise && std::abs(shape.odd) <= oddLimit(c, shape.even)) continue;
            for (ComKnot* knot : {&knots[i], &knots[i + 1]}) {
                knot->force = std::max(kLowest, knot->force - 0.04);
            }
        }
    }
}

/// Even and odd part along x or z, m/s², weak enough to leave the vertical force its one peak.
Shape horizontalShape(double start, double startSpeed, double end, double endSpeed,
                      double duration) {
    constexpr double kStrongestEven = 0.42 * kGravity;
    constexpr double kStrongestOdd = 1.05 * kGravity;  // its own peak is 0.29 of that
    const Peak& peak = peakFor(0);
    Shape shape;
    shape.even = std::clamp((endSpeed - startSpeed) / duration / peak.integral, -kStrongestEven,
                            kStrongestEven);
    const double way = (end - start - startSpeed * duration) / (duration * duration);
    shape.odd = std::clamp((way - shape.even * peak.integral / 2) / peak.oddMoment, -kStrongestOdd,
                           kStrongestOdd);
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
        Shape y = verticalShape(c, dips[i]);
        const double limit = oddLimit(c, y.even);
        y.odd = std::clamp(y.odd, -limit, limit);
        const Shape x = horizontalShape(c.startPosition.x(), c.startVelocity.x(), c.endPosition.x(),
                                        c.endVelocity.x(), piece.duration);
        const Shape z = horizontalShape(c.startPosition.z(), c.startVelocity.z(), c.endPosition.z(),
                                        c.endVelocity.z(), piece.duration);
        const Peak& up = peakFor(piece.duration);
        const Peak& along = peakFor(0);
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
