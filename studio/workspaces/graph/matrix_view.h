#pragma once

#include <QAbstractScrollArea>
#include <QPixmap>

#include <algorithm>
#include <optional>

#include "studio/workspaces/graph/matrix_painter.h"

namespace kumite::studio {

/// A matrix to look into: hover tells, a click chooses a cell, a row or a column, a
/// double-click asks for what is behind it. The wheel scrolls, Ctrl+wheel zooms about the pointer,
/// the arrow keys walk over the cells.
class MatrixView : public QAbstractScrollArea {
    Q_OBJECT

public:
    explicit MatrixView(QWidget* parent = nullptr);

    /// `caption` stands before the legend: "P(next | own)".
    void show(MatrixTable table, MatrixOrder order, const ColourScale& scale,
              const QString& caption);
    const MatrixTable& table() const { return table_; }
    const MatrixOrder& order() const { return order_; }
    const MatrixGrid& grid() const { return grid_; }

    // Places are those of the table, whatever the order.
    void setChosen(std::optional<MatrixPlace> place);
    std::optional<MatrixPlace> chosen() const { return chosen_; }
    /// What is going on at the playhead.
    void setNow(std::optional<MatrixPlace> place);
    /// Where a cell is drawn now, in the viewport.
    QRectF rectOf(const MatrixPlace& inTable) const;

    void zoom(double factor);
    void fit();

    /// Everything, not only what is scrolled to: for pictures.
    QSize wholeSize() const;
    void paintWhole(QPainter& painter, const Colours& colours) const;

Q_SIGNALS:
    void placeChosen(const MatrixPlace& inTable);
    void placeActivated(const MatrixPlace& inTable);
    /// The place under the pointer; nothing where it left.
    void placeHovered(const std::optional<MatrixPlace>& inTable);

protected:
    bool viewportEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// Height of the scale of colours below, pixels.
    double legend() const { return std::max(30.0, 17.0 + fontMetrics().height()); }

    void layOut();
    void setGrid(const MatrixGrid& grid);
    void invalidate();
    void hover(const QPointF& position);
    void step(int rows, int columns);
    bool isEmpty() const { return table_.rows.empty() || table_.columns.empty(); }
    QFont cellFont() const;
    MatrixGrid headersFor(MatrixGrid grid, double mostName) const;

    MatrixTable table_;
    MatrixOrder order_;
    MatrixGrid grid_;
    ColourScale scale_;
    QString caption_;
    std::optional<MatrixPlace> chosen_;
    std::optional<MatrixPlace> now_;
    std::optional<MatrixPlace> hovered_;
    QPixmap still_;  ///< all but what follows pointer and playhead
    bool stillValid_ = false;
    bool zoomed_ = false;  ///< a hand chose the size of the cells
    bool settingBars_ = false;
};

}  // namespace kumite::studio
