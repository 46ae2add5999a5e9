#include "studio/workspaces/graph/matrix_grid.h"

#include <algorithm>
#include <cmath>

namespace kumite::studio {

QRectF MatrixGrid::body() const {
    return {rowHeader, columnHeader, std::max(0.0, view.width() - rowHeader),
            std::max(0.0, view.height() - columnHeader)};
}

QRectF MatrixGrid::cellRect(const MatrixPlace& place) const {
    return {rowHeader + cell * place.column - scroll.x(),
            columnHeader + cell * place.row - scroll.y(), cell, cell};
}

QRectF MatrixGrid::rowName(int row) const {
    return {0, cellRect({row, 0}).top(), rowHeader, cell};
}

QRectF MatrixGrid::columnName(int column) const {
    return {cellRect({0, column}).left(), 0, cell, columnHeader};
}

std::optional<MatrixPlace> MatrixGrid::at(const QPointF& point) const {
    const int row = static_cast<int>(std::floor((point.y() - columnHeader + scroll.y()) / cell));
    const int column = static_cast<int>(std::floor((point.x() - rowHeader + scroll.x()) / cell));
    const bool inRows = point.y() >= columnHeader && row >= 0 && row < rows;
    const bool inColumns = point.x() >= rowHeader && column >= 0 && column < columns;
    if (inRows && inColumns) return MatrixPlace{row, column};
    if (inRows && point.x() >= 0 && point.x() < rowHeader) return MatrixPlace{row, -1};
    if (inColumns && point.y() >= 0 && point.y() < columnHeader) return MatrixPlace{-1, column};
    return std::nullopt;
}

MatrixGrid::Range MatrixGrid::visibleRows() const {
    const int begin = std::max(0, static_cast<int>(std::floor(scroll.y() / cell)));
    const int end = static_cast<int>(std::ceil((scroll.y() + body().height()) / cell));
    return {std::min(begin, rows), std::clamp(end, 0, rows)};
}

MatrixGrid::Range MatrixGrid::visibleColumns() const {
    const int begin = std::max(0, static_cast<int>(std::floor(scroll.x() / cell)));
    const int end = static_cast<int>(std::ceil((scroll.x() + body().width()) / cell));
    return {std::min(begin, columns), std::clamp(end, 0, columns)};
}

QSizeF MatrixGrid::scrollable() const {
    return {std::max(0.0, cell * columns - body().width()),
            std::max(0.0, cell * rows - body().height())};
}

MatrixGrid MatrixGrid::scrolled(const QPointF& to) const {
    MatrixGrid grid = *this;
    const QSizeF most = scrollable();
    grid.scroll = {std::clamp(to.x(), 0.0, most.width()), std::clamp(to.y(), 0.0, most.height())};
    return grid;
}

MatrixGrid MatrixGrid::revealing(const MatrixPlace& place) const {
    const auto along = [this](double now, int index, double room) {
        if (index < 0) return now;
        const double begin = cell * index;
        return std::max(std::min(now, begin), begin + cell - room);
    };
    return scrolled({along(scroll.x(), place.column, body().width()),
                     along(scroll.y(), place.row, body().height())});
}

MatrixGrid MatrixGrid::zoomedAbout(const QPointF& point, double factor) const {
    MatrixGrid grid = *this;
    grid.cell = std::clamp(cell * factor, kSmallest, kLargest);
    const double scale = grid.cell / cell;
    const QPointF inside(std::max(0.0, point.x() - rowHeader),
                         std::max(0.0, point.y() - columnHeader));
    return grid.scrolled((scroll + inside) * scale - inside);
}

MatrixGrid MatrixGrid::fitted(double most) const {
    MatrixGrid grid = *this;
    const double wide = columns > 0 ? body().width() / columns : most;
    const double high = rows > 0 ? body().height() / rows : most;
    grid.cell = std::clamp(std::floor(std::min(wide, high)), kSmallest, most);
    return grid.scrolled({0, 0});
}

}  // namespace kumite::studio
