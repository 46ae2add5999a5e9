#include "studio/workspaces/sequence/distance_grid_view.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/theme.h"

namespace kumite::studio {

DistanceGridView::DistanceGridView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Distances of poses where motions are joined"));
    setToolTip(tr(
        "How far the poses are from each other: the last frames of what was there down, "
        "the first frames of what comes in to the right. The stronger the colour, the nearer they "
        "are; the ring is where both were joined."));
}

void DistanceGridView::show(std::vector<DistanceGrid> grids) {
    grids_ = std::move(grids);
    setVisible(!grids_.empty());
    update();
}

QSize DistanceGridView::sizeHint() const {
    return {220, 96};
}

void DistanceGridView::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    QPainter painter(this);
    QFont small = font();
    small.setPointSizeF(std::max(7.5, small.pointSizeF() - 1.5));
    painter.setFont(small);
    const QFontMetrics metrics(small);
    painter.setPen(c.secondText);
    const int label = metrics.height();
    painter.drawText(rect().adjusted(label + 2, 0, 0, 0), Qt::AlignBottom | Qt::AlignLeft,
                     tr("frames that come in →"));
    painter.save();
    painter.translate(0, height() - label);
    painter.rotate(-90);
    painter.drawText(QRect(0, 0, height() - label, label), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("← frames there"));
    painter.restore();
    if (grids_.empty()) return;
    const double room = width() - label - 2;
    const double gap = 6;
    const auto count = static_cast<double>(grids_.size());
    const double wide = std::min(160.0, (room - gap * (count - 1)) / count);
    float least = grids_.front().distances.front(), most = least;
    for (const DistanceGrid& grid : grids_) {
        for (const float distance : grid.distances) {
            least = std::min(least, distance);
            most = std::max(most, distance);
        }
    }
    const float span = std::max(1e-6f, most - least);
    for (std::size_t g = 0; g < grids_.size(); ++g) {
        const DistanceGrid& grid = grids_[g];
        QImage image(grid.columns, grid.rows, QImage::Format_RGB32);
        for (int row = 0; row < grid.rows; ++row) {
            for (int column = 0; column < grid.columns; ++column) {
                const double far = (grid.at(row, column) - least) / span;
                image.setPixelColor(column, row, mixed(c.fighters[0], c.ground, std::sqrt(far)));
            }
        }
        const QRectF box(label + 2 + static_cast<double>(g) * (wide + gap), 1, wide,
                         height() - label - 4);
        painter.drawImage(box, image);
        painter.setPen(c.line);
        painter.drawRect(box);
        const QPointF at(box.left() + (grid.column + 0.5) / grid.columns * box.width(),
                         box.top() + (grid.row + 0.5) / grid.rows * box.height());
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(c.accent, 2));
        painter.drawEllipse(at, 4, 4);
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
}

}  // namespace kumite::studio
