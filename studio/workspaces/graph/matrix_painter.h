#pragma once

#include <QCoreApplication>
#include <QFontMetrics>

#include <optional>

#include "studio/workspaces/graph/colour_scale.h"
#include "studio/workspaces/graph/matrix_grid.h"
#include "studio/workspaces/graph/matrix_table.h"

class QPainter;

namespace kumite::studio {

struct Colours;

/// Paints a matrix: for the view, and for pictures that are saved.
class MatrixPainter {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::MatrixPainter)

public:
    MatrixPainter(QPainter& painter, const MatrixTable& table, const MatrixOrder& order,
                  const MatrixGrid& grid, const ColourScale& scale, const Colours& colours);

    /// Cells, names of rows and columns, groups.
    void paint();
    /// A frame around what is chosen (or just pointed at), and a band along its row and column.
    void paintFrame(const MatrixPlace& shown, const QColor& colour, bool band, bool dashed = false);
    /// The colours with their numbers, `caption` before them.
    void paintLegend(const QRectF& area, const QString& caption);

    /// How much room the names need, up to `most`.
    static double nameRoom(const QFontMetrics& metrics, const std::vector<MatrixTable::Line>& lines,
                           double most);

private:
    void paintCells();
    void paintRowNames();
    void paintColumnNames();

    QPainter& painter_;
    const MatrixTable& table_;
    const MatrixOrder& order_;
    const MatrixGrid& grid_;
    const ColourScale& scale_;
    const Colours& colours_;
};

}  // namespace kumite::studio
