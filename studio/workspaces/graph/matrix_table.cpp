#include "studio/workspaces/graph/matrix_table.h"

#include <algorithm>
#include <numeric>

#include "core/interaction/row_order.h"

namespace kumite::studio {

namespace {

/// Groups that are farther apart than this (Hellinger distance) are drawn apart.
constexpr double kApart = 0.55;

std::vector<int> ordered(const std::vector<MatrixTable::Line>& lines, bool byName) {
    std::vector<int> order(lines.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        const auto& x = lines[static_cast<std::size_t>(a)];
        const auto& y = lines[static_cast<std::size_t>(b)];
        return byName ? x.name < y.name : x.count > y.count;
    });
    return order;
}

int positionIn(const std::vector<int>& order, int index) {
    const auto found = std::find(order.begin(), order.end(), index);
    return found == order.end() ? -1 : static_cast<int>(found - order.begin());
}

int indexAt(const std::vector<int>& order, int position) {
    const bool there = position >= 0 && position < static_cast<int>(order.size());
    return there ? order[static_cast<std::size_t>(position)] : -1;
}

}  // namespace

MatrixPlace MatrixOrder::inTable(const MatrixPlace& shown) const {
    return {indexAt(rows, shown.row), indexAt(columns, shown.column)};
}

MatrixPlace MatrixOrder::shown(const MatrixPlace& inTable) const {
    return {positionIn(rows, inTable.row), positionIn(columns, inTable.column)};
}

MatrixOrder orderOf(const MatrixTable& table, MatrixSort sort) {
    if (sort != MatrixSort::Similarity) {
        const bool byName = sort == MatrixSort::Name;
        const bool sameLabels = std::equal(
            table.rows.begin(), table.rows.end(), table.columns.begin(), table.columns.end(),
            [](const auto& row, const auto& column) { return row.name == column.name; });
        if (sameLabels) {
            // The same order for both, so that staying with a label is the diagonal.
            std::vector<MatrixTable::Line> both = table.rows;
            for (std::size_t i = 0; i < both.size(); ++i)
                both[i].count += table.columns[i].count;
            const std::vector<int> order = ordered(both, byName);
            return {order, order, {}};
        }
        return {ordered(table.rows, byName), ordered(table.columns, byName), {}};
    }
    const Eigen::MatrixXd sizes = table.values.cwiseAbs();
    const RowOrder rows = orderBySimilarity(sizes);
    MatrixOrder order{rows.order, orderBySimilarity(sizes.transpose()).order, {}};
    for (std::size_t i = 1; i < rows.joins.size(); ++i) {
        if (rows.joins[i] > kApart) order.groups.push_back(static_cast<int>(i));
    }
    return order;
}

}  // namespace kumite::studio
