#include "core/project/chart_svg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/formats/json_text.h"

namespace kumite {
namespace {

constexpr double kWidth = 640, kHeight = 400;
constexpr double kLeft = 76, kRight = 150, kTop = 44, kBottom = 56;

std::string at(double value) {
    return fixed(value, 1);
}

std::string label(double x, double y, const std::string& text, const char* anchor,
                  const std::string& more = "") {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", at(x), at(y),
                       anchor, more, xmlText(text));
}

std::string line(double x1, double y1, double x2, double y2, const std::string& colour) {
    return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\"/>\n", at(x1),
                       at(y1), at(x2), at(y2), colour);
}

std::string opened(double width, double height, const std::string& title) {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
               "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\">\n<rect "
               "width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
               at(width), at(height)) +
           label(16, 24, title, "start", " font-size=\"15\"");
}

/// The values between which an axis runs, and its step: 1, 2 or 5 times a power of ten.
struct Axis {
    double low = 0, high = 1, step = 1;

    Axis(double smallest, double largest) {
        if (!(largest > smallest)) largest = smallest + 1;
        const double raw = (largest - smallest) / 6;
        const double power = std::pow(10.0, std::floor(std::log10(raw)));
        const double ratio = raw / power;
        step = power * (ratio <= 1 ? 1 : ratio <= 2 ? 2 : ratio <= 5 ? 5 : 10);
        low = step * std::floor(smallest / step);
        high = step * std::ceil(largest / step);
    }
    double share(double value) const { return (value - low) / (high - low); }
    int decimals() const { return std::max(0, -static_cast<int>(std::floor(std::log10(step)))); }
};

double yAt(const Axis& axis, double value) {
    return kHeight - kBottom - axis.share(value) * (kHeight - kTop - kBottom);
}

/// Beyond so many times what all other bars span a bar is cut off, or the others could not be seen.
constexpr double kFarOut = 8;

/// The vertical axis with its grid, over all values and their error bars; of bars (they begin at 0)
/// without those that are far out.
Axis drawYAxis(const std::vector<ChartSeries>& series, bool bars, const std::string& title,
               std::string& svg) {
    std::vector<ChartSeries::Point> points;
    for (const ChartSeries& each : series) {
        for (const ChartSeries::Point& point : each.points) {
            if (std::isfinite(point.y)) points.push_back(point);
        }
    }
    if (bars) {
        std::sort(points.begin(), points.end(),
                  [](const auto& a, const auto& b) { return std::abs(a.y) < std::abs(b.y); });
        while (points.size() > 1 &&
               std::abs(points.back().y) > kFarOut * std::abs(points[points.size() - 2].y))
            points.pop_back();
    }
    double low = bars ? 0 : INFINITY, high = bars ? 0 : -INFINITY;
    for (const ChartSeries::Point& point : points) {
        low = std::min(low, point.y - point.deviation);
        high = std::max(high, point.y + point.deviation);
    }
    if (!std::isfinite(low)) low = 0, high = 1;
    const Axis axis(low, high);
    for (double value = axis.low; value <= axis.high + axis.step / 2; value += axis.step) {
        const double y = yAt(axis, value);
        svg += line(kLeft, y, kWidth - kRight, y, "#dddddd");
        svg += label(kLeft - 8, y + 4, fixed(value, axis.decimals()), "end");
    }
    svg += label(0, 0, title, "middle",
                 fmt::format(" transform=\"translate(20 {}) rotate(-90)\"",
                             at((kTop + kHeight - kBottom) / 2)));
    return axis;
}

void drawLegend(const std::vector<ChartSeries>& series, std::string& svg) {
    double y = kTop + 10;
    for (const ChartSeries& each : series) {
        svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"14\" height=\"10\" fill=\"{}\"/>\n",
                           at(kWidth - kRight + 16), at(y - 9), each.colour);
        svg += label(kWidth - kRight + 36, y, each.name, "start");
        y += 20;
    }
}

std::string errorBar(const Axis& axis, double x, const ChartSeries::Point& point) {
    if (!(point.deviation > 0)) return {};
    return line(x, yAt(axis, point.y - point.deviation), x, yAt(axis, point.y + point.deviation),
                "#333333");
}

}  // namespace

std::string xmlText(const std::string& text) {
    std::string escaped;
    for (const char c : asStored(text)) {
        if (c == '&') {
            escaped += "&amp;";
        } else if (c == '<') {
            escaped += "&lt;";
        } else if (c == '>') {
            escaped += "&gt;";
        } else if (c == '"') {
            escaped += "&quot;";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

std::string lineChartSvg(const std::string& title, const std::string& xTitle,
                         const std::string& yTitle, const std::vector<ChartSeries>& series) {
    std::string svg = opened(kWidth, kHeight, title);
    const Axis y = drawYAxis(series, false, yTitle, svg);
    double low = INFINITY, high = -INFINITY;
    for (const ChartSeries& each : series) {
        for (const ChartSeries::Point& point : each.points) {
            low = std::min(low, point.x);
            high = std::max(high, point.x);
        }
    }
    const auto xAt = [&](double value) {
        const double share = high > low ? (value - low) / (high - low) : 0.5;
        return kLeft + 12 + share * (kWidth - kLeft - kRight - 24);
    };
    for (const ChartSeries& each : series) {
        std::string path;
        std::string dots;
        for (const ChartSeries::Point& point : each.points) {
            if (!std::isfinite(point.y)) continue;
            const double px = xAt(point.x);
            path += fmt::format("{}{} {}", path.empty() ? "M" : " L", at(px), at(yAt(y, point.y)));
            dots += errorBar(y, px, point);
            dots += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"{}\"/>\n", at(px),
                                at(yAt(y, point.y)), each.colour);
        }
        svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                           path, each.colour);
        svg += dots;
    }
    if (!series.empty()) {
        for (const ChartSeries::Point& point : series.front().points)
            svg += label(xAt(point.x), kHeight - kBottom + 18, shortest(point.x), "middle");
    }
    svg += label((kLeft + kWidth - kRight) / 2, kHeight - 14, xTitle, "middle");
    drawLegend(series, svg);
    return svg + "</svg>\n";
}

std::string barChartSvg(const std::string& title, const std::string& yTitle,
                        const std::vector<std::string>& groups,
                        const std::vector<ChartSeries>& series) {
    std::string svg = opened(kWidth, kHeight, title);
    const Axis y = drawYAxis(series, true, yTitle, svg);
    const double group = (kWidth - kLeft - kRight) / std::max<double>(1, groups.size());
    const double bar = 0.8 * group / std::max<double>(1, series.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const double left = kLeft + (static_cast<double>(g) + 0.1) * group;
        for (std::size_t s = 0; s < series.size(); ++s) {
            if (g >= series[s].points.size()) continue;
            const ChartSeries::Point& point = series[s].points[g];
            if (!std::isfinite(point.y)) continue;
            const double x = left + static_cast<double>(s) * bar;
            const double end = yAt(y, std::clamp(point.y, y.low, y.high));
            const double top = std::min(yAt(y, 0), end);
            svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                               at(x), at(top), at(bar - 2), at(std::abs(yAt(y, 0) - end)),
                               series[s].colour);
            if (point.y >= y.low && point.y <= y.high) {
                svg += errorBar(y, x + bar / 2 - 1, point);
                continue;
            }
            // It goes on beyond the axis: a gap, and how far.
            const double inside = point.y < y.low ? end - 14 : end + 14;
            svg +=
                fmt::format("<path d=\"M{} {} l{} -8\" stroke=\"#ffffff\" stroke-width=\"4\"/>\n",
                            at(x - 2), at(inside + 4), at(bar + 2));
            svg += label(x + bar / 2 - 1, inside + (point.y < y.low ? -10 : 20), fixed(point.y, 0),
                         "middle", " font-size=\"10\"");
        }
        svg += label(left + 0.4 * group, kHeight - kBottom + 18, groups[g], "middle");
    }
    drawLegend(series, svg);
    return svg + "</svg>\n";
}

std::string heatMapSvg(const std::string& title, const std::vector<std::string>& rows,
                       const std::vector<std::string>& columns, const Eigen::MatrixXd& values) {
    constexpr double kCell = 14, kLetter = 5.8, kTitle = 40;
    const auto room = [](const std::vector<std::string>& names) {
        std::size_t longest = 8;
        for (const std::string& name : names)
            longest = std::max(longest, name.size());
        return kLetter * static_cast<double>(longest) + 12;
    };
    const double names = 16 + room(rows), head = kTitle + room(columns);
    const double width = names + kCell * static_cast<double>(columns.size()) + 24;
    std::string svg =
        opened(std::max(width, 320.0), head + kCell * static_cast<double>(rows.size()) + 20, title);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = head + kCell * static_cast<double>(i);
        svg += label(names - 6, y + 11, rows[i], "end", " font-size=\"10\"");
        for (std::size_t j = 0; j < columns.size(); ++j) {
            const double value = values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            if (!std::isfinite(value)) continue;
            const double ink = std::sqrt(std::clamp(value, 0.0, 1.0));
            svg += fmt::format(
                "<rect x=\"{}\" y=\"{}\" width=\"13\" height=\"13\" fill=\"#{:02x}{:02x}{:02x}\">"
                "<title>{} → {}: {}</title></rect>\n",
                at(names + kCell * static_cast<double>(j)), at(y),
                static_cast<int>(255 - 245 * ink), static_cast<int>(255 - 175 * ink),
                static_cast<int>(255 - 90 * ink), xmlText(rows[i]), xmlText(columns[j]),
                fixed(value, 3));
        }
    }
    for (std::size_t j = 0; j < columns.size(); ++j) {
        svg += label(0, 0, columns[j], "start",
                     fmt::format(" font-size=\"10\" transform=\"translate({} {}) rotate(-90)\"",
                                 at(names + kCell * static_cast<double>(j) + 11), at(head - 6)));
    }
    return svg + "</svg>\n";
}

}  // namespace kumite
