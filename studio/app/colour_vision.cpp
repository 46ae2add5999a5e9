#include "studio/app/colour_vision.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kumite::studio {

namespace {

using Three = std::array<double, 3>;

double linear(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double encoded(double value) {
    value = std::clamp(value, 0.0, 1.0);
    return value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

Three linearOf(const QColor& colour) {
    return {linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())};
}

Three times(const std::array<Three, 3>& matrix, const Three& vector) {
    Three result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            result[i] += matrix[i][j] * vector[j];
    }
    return result;
}

/// Of linear red, green and blue.
std::array<Three, 3> matrixOf(Vision vision) {
    switch (vision) {
        case Vision::Protan:
            return {{{0.152286, 1.052583, -0.204868},
                     {0.114503, 0.786281, 0.099216},
                     {-0.003882, -0.048116, 1.051998}}};
        case Vision::Deutan:
            return {{{0.367322, 0.860646, -0.227968},
                     {0.280085, 0.672501, 0.047413},
                     {-0.011820, 0.042940, 0.968881}}};
        case Vision::Tritan:
            return {{{1.255528, -0.076749, -0.178779},
                     {-0.078411, 0.930809, 0.147602},
                     {0.004733, 0.691367, 0.303900}}};
        case Vision::Usual:
            break;
    }
    return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

/// CIE L*a*b* under daylight (D65).
Three labOf(const QColor& colour) {
    const Three xyz =
        times({{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}},
              linearOf(colour));
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f(xyz[0] / 0.9505), y = f(xyz[1]), z = f(xyz[2] / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace

QColor seenBy(const QColor& colour, Vision vision) {
    if (vision == Vision::Usual) return colour;
    const Three seen = times(matrixOf(vision), linearOf(colour));
    return QColor::fromRgbF(static_cast<float>(encoded(seen[0])),
                            static_cast<float>(encoded(seen[1])),
                            static_cast<float>(encoded(seen[2])));
}

double colourDifference(const QColor& a, const QColor& b) {
    const Three first = labOf(a), second = labOf(b);
    return std::hypot(first[0] - second[0], first[1] - second[1], first[2] - second[2]);
}

double leastDifference(const QColor& a, const QColor& b) {
    double least = colourDifference(a, b);
    for (const Vision vision : kVisions)
        least = std::min(least, colourDifference(seenBy(a, vision), seenBy(b, vision)));
    return least;
}

std::vector<Qt::BrushStyle> classPatterns(const std::vector<QColor>& colours) {
    // Slanted lines mean that a label is unsure.
    constexpr Qt::BrushStyle kStyles[] = {Qt::NoBrush, Qt::VerPattern, Qt::Dense6Pattern,
                                          Qt::HorPattern, Qt::CrossPattern};
    std::vector<Qt::BrushStyle> patterns;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto isTaken = [&](Qt::BrushStyle style) {
            for (std::size_t j = 0; j < i; ++j) {
                if (patterns[j] == style && leastDifference(colours[i], colours[j]) < kToldApart)
                    return true;
            }
            return false;
        };
        const auto* style = std::find_if_not(std::begin(kStyles), std::end(kStyles), isTaken);
        patterns.push_back(style == std::end(kStyles) ? Qt::NoBrush : *style);
    }
    return patterns;
}

}  // namespace kumite::studio
