#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace kumite {

/// A curve of a chart: points by rising x, with an error bar where `deviation` is above 0.
struct ChartSeries {
    struct Point {
        double x = 0;
        double y = 0;
        double deviation = 0;
    };
    std::string name;
    std::string colour;  ///< "#rrggbb"
    std::vector<Point> points;
};

/// Pictures for reports, as SVG text on white. Non-finite values are left out.
std::string lineChartSvg(const std::string& title, const std::string& xTitle,
                         const std::string& yTitle, const std::vector<ChartSeries>& series);

/// Bars side by side, one group per name, one bar per series (points by index).
std::string barChartSvg(const std::string& title, const std::string& yTitle,
                        const std::vector<std::string>& groups,
                        const std::vector<ChartSeries>& series);

/// Numbers from 0 to 1 as cells, white to blue; with the names of rows and columns.
std::string heatMapSvg(const std::string& title, const std::vector<std::string>& rows,
                       const std::vector<std::string>& columns, const Eigen::MatrixXd& values);

/// Text as it may stand between tags.
std::string xmlText(const std::string& text);

}  // namespace kumite
