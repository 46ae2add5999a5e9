#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <optional>

namespace kumite::studio {

/// A place of a matrix by its position in the shown order; -1 for the whole row or column.
struct MatrixPlace {
    int row = -1;
    int column = -1;

    bool isCell() const { return row >= 0 && column >= 0; }
    bool operator==(const MatrixPlace&) const = default;
};

/// Where the parts of a matrix lie in its view, pixels: square cells, names of rows at the left, of
/// columns above. Knows nothing of what is drawn.
struct MatrixGrid {
    static constexpr double kSmallest = 5;
    static constexpr double kLargest = 64;

    QSizeF view;
    double rowHeader = 0;     ///< width of the names at the left
    double columnHeader = 0;  ///< height of the names above
    double cell = 16;
    int rows = 0;
    int columns = 0;
    QPointF scroll;  ///< what of the cells lies left of and above the view

    QRectF body() const;
    QRectF cellRect(const MatrixPlace& place) const;
    QRectF rowName(int row) const;
    QRectF columnName(int column) const;
    /// What a point is on: a cell, a row's or a column's name.
    std::optional<MatrixPlace> at(const QPointF& point) const;

    struct Range {
        int begin = 0;
        int end = 0;
    };
    Range visibleRows() const;
    Range visibleColumns() const;

    /// How far it can be scrolled.
    QSizeF scrollable() const;
    MatrixGrid scrolled(const QPointF& to) const;
    /// Scrolled by as little as shows a cell whole.
    MatrixGrid revealing(const MatrixPlace& place) const;
    /// Cells `factor` times as large; what lies under a point stays there.
    MatrixGrid zoomedAbout(const QPointF& point, double factor) const;
    /// Cells as large as lets all be seen, but not larger than `most`.
    MatrixGrid fitted(double most) const;
};

}  // namespace kumite::studio
