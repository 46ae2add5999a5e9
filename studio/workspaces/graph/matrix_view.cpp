#include "studio/workspaces/graph/matrix_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "studio/app/grid_keys.h"
#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

constexpr double kUsualCell = 17;
constexpr double kLargestFitted = 34;

}  // namespace

MatrixView::MatrixView(QWidget* parent) : QAbstractScrollArea(parent) {
    setAccessibleName(tr("Matrix of transitions"));
    setAccessibleDescription(tr(
        "A row is what goes on, a column what follows. Arrows lead from cell to cell; the moments "
        "behind the chosen one are listed beside it."));
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(200, 140);
}

QFont MatrixView::cellFont() const {
    QFont small = font();
    small.setPointSizeF(std::max(7.5, small.pointSizeF() - 1.0));
    return small;
}

void MatrixView::show(MatrixTable table, MatrixOrder order, const ColourScale& scale,
                      const QString& caption) {
    const bool sameSize =
        table.rows.size() == table_.rows.size() && table.columns.size() == table_.columns.size();
    table_ = std::move(table);
    order_ = std::move(order);
    scale_ = scale;
    caption_ = caption;
    if (!sameSize) {
        hovered_.reset();
        chosen_.reset();
        now_.reset();
        zoomed_ = false;
    }
    layOut();
    invalidate();
}

MatrixGrid MatrixView::headersFor(MatrixGrid grid, double mostName) const {
    const QFontMetrics metrics(cellFont());
    grid.rows = static_cast<int>(table_.rows.size());
    grid.columns = static_cast<int>(table_.columns.size());
    grid.rowHeader = MatrixPainter::nameRoom(metrics, table_.rows, mostName);
    grid.columnHeader = MatrixPainter::nameRoom(metrics, table_.columns, 0.75 * mostName);
    return grid;
}

void MatrixView::layOut() {
    MatrixGrid grid = grid_;
    grid.view = QSizeF(viewport()->width(), std::max(0.0, viewport()->height() - legend()));
    grid = headersFor(grid, std::clamp(0.34 * grid.view.width(), 90.0, 190.0));
    if (!zoomed_) {
        // All of it where its names can still be read, else as much as there is room for.
        grid = grid.fitted(kLargestFitted);
        grid.cell = std::max(grid.cell, kUsualCell);
    }
    setGrid(grid.scrolled(grid_.scroll));
}

void MatrixView::setGrid(const MatrixGrid& grid) {
    grid_ = grid;
    settingBars_ = true;
    const QSizeF most = grid_.scrollable();
    const auto set = [this](QScrollBar* bar, double most, double page, double at) {
        bar->setRange(0, static_cast<int>(std::ceil(most)));
        bar->setPageStep(static_cast<int>(page));
        bar->setSingleStep(static_cast<int>(grid_.cell));
        bar->setValue(static_cast<int>(std::lround(at)));
    };
    set(horizontalScrollBar(), most.width(), grid_.body().width(), grid_.scroll.x());
    set(verticalScrollBar(), most.height(), grid_.body().height(), grid_.scroll.y());
    settingBars_ = false;
    invalidate();
}

void MatrixView::invalidate() {
    stillValid_ = false;
    viewport()->update();
}

void MatrixView::setChosen(std::optional<MatrixPlace> place) {
    if (place == chosen_) return;
    chosen_ = place;
    if (chosen_) setGrid(grid_.revealing(order_.shown(*chosen_)));
    viewport()->update();
}

void MatrixView::setNow(std::optional<MatrixPlace> place) {
    if (place == now_) return;
    now_ = place;
    viewport()->update();
}

QRectF MatrixView::rectOf(const MatrixPlace& inTable) const {
    return grid_.cellRect(order_.shown(inTable));
}

void MatrixView::zoom(double factor) {
    zoomed_ = true;
    setGrid(grid_.zoomedAbout(grid_.body().center(), factor));
}

void MatrixView::fit() {
    zoomed_ = true;
    setGrid(grid_.fitted(kLargestFitted));
}

void MatrixView::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(viewport()->size()) * ratio).toSize();
    if (!stillValid_ || still_.size() != pixels) {
        still_ = QPixmap(pixels);
        still_.setDevicePixelRatio(ratio);
        still_.fill(c.ground);
        QPainter painter(&still_);
        painter.setFont(cellFont());
        MatrixPainter matrix(painter, table_, order_, grid_, scale_, c);
        if (!isEmpty()) {
            matrix.paint();
            matrix.paintLegend(
                QRectF(8, grid_.view.height() + 3, viewport()->width() - 16, legend() - 4),
                caption_);
        }
        stillValid_ = true;
    }
    QPainter painter(viewport());
    painter.drawPixmap(0, 0, still_);
    if (isEmpty()) return;
    painter.setFont(cellFont());
    MatrixPainter matrix(painter, table_, order_, grid_, scale_, c);
    if (now_) matrix.paintFrame(order_.shown(*now_), c.accent, true, true);
    if (hovered_) matrix.paintFrame(*hovered_, withAlpha(c.text, 0.6), true);
    if (chosen_) matrix.paintFrame(order_.shown(*chosen_), hasFocus() ? c.accent : c.text, true);
}

QSize MatrixView::wholeSize() const {
    const MatrixGrid grid = headersFor(grid_, 400);
    return {static_cast<int>(grid.rowHeader + std::max(14.0, grid.cell) * grid.columns) + 8,
            static_cast<int>(grid.columnHeader + std::max(14.0, grid.cell) * grid.rows + legend())};
}

void MatrixView::paintWhole(QPainter& painter, const Colours& colours) const {
    MatrixGrid grid = headersFor(grid_, 400);
    grid.cell = std::max(14.0, grid.cell);
    grid.scroll = {};
    const QSizeF whole = wholeSize();
    grid.view = QSizeF(whole.width(), whole.height() - legend());
    painter.fillRect(QRectF(QPointF(), whole), colours.ground);
    painter.setFont(cellFont());
    MatrixPainter matrix(painter, table_, order_, grid, scale_, colours);
    matrix.paint();
    matrix.paintLegend(QRectF(8, grid.view.height() + 3, whole.width() - 16, legend() - 4),
                       caption_);
}

void MatrixView::resizeEvent(QResizeEvent*) {
    layOut();
}

void MatrixView::changeEvent(QEvent* event) {
    QAbstractScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) invalidate();
}

void MatrixView::scrollContentsBy(int, int) {
    if (settingBars_) return;
    grid_ = grid_.scrolled(
        {double(horizontalScrollBar()->value()), double(verticalScrollBar()->value())});
    invalidate();
}

void MatrixView::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ControlModifier) {
        zoomed_ = true;
        setGrid(grid_.zoomedAbout(event->position(), std::pow(1.0015, event->angleDelta().y())));
        event->accept();
        return;
    }
    QScrollBar* bar =
        event->modifiers() & Qt::ShiftModifier ? horizontalScrollBar() : verticalScrollBar();
    const QPoint turned = event->angleDelta();
    bar->setValue(bar->value() - (turned.y() != 0 ? turned.y() : turned.x()) / 2);
    event->accept();
}

void MatrixView::hover(const QPointF& position) {
    const auto place = isEmpty() ? std::nullopt : grid_.at(position);
    if (place == hovered_) return;
    hovered_ = place;
    Q_EMIT placeHovered(place ? std::optional(order_.inTable(*place)) : std::nullopt);
    viewport()->update();
}

void MatrixView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || isEmpty()) return;
    const auto place = grid_.at(event->position());
    if (!place) return;
    setChosen(order_.inTable(*place));
    Q_EMIT placeChosen(*chosen_);
}

void MatrixView::mouseMoveEvent(QMouseEvent* event) {
    hover(event->position());
}

void MatrixView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || isEmpty()) return;
    if (const auto place = grid_.at(event->position())) {
        Q_EMIT placeActivated(order_.inTable(*place));
    }
}

void MatrixView::step(int rows, int columns) {
    MatrixPlace at = chosen_ ? order_.shown(*chosen_) : MatrixPlace{0, 0};
    if (chosen_) {
        // Past the first row or column lie the names.
        at.row = std::clamp(at.row + rows, at.column < 0 ? 0 : -1, grid_.rows - 1);
        at.column = std::clamp(at.column + columns, at.row < 0 ? 0 : -1, grid_.columns - 1);
    }
    setChosen(order_.inTable(at));
    Q_EMIT placeChosen(*chosen_);
}

void MatrixView::keyPressEvent(QKeyEvent* event) {
    const auto way = isEmpty() ? std::nullopt : gridStep(*event);
    if (way) {
        step(way->rows, way->columns);
    } else {
        QWidget::keyPressEvent(event);
    }
}

bool MatrixView::event(QEvent* event) {
    // Inside the matrix the arrow keys walk over cells, elsewhere over frames.
    if (claimsGridKey(event)) return true;
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        viewport()->update();
    }
    return QAbstractScrollArea::event(event);
}

bool MatrixView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        hover(QPointF(-1, -1));
    } else if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto place = isEmpty() ? std::nullopt : grid_.at(help->pos());
        QString tip;
        if (place) {
            const MatrixPlace at = order_.inTable(*place);
            QStringList parts;
            if (at.row >= 0) parts.append(table_.rows[static_cast<std::size_t>(at.row)].name);
            if (at.column >= 0)
                parts.append(table_.columns[static_cast<std::size_t>(at.column)].name);
            tip = parts.join(QStringLiteral(" → "));
        }
        QToolTip::showText(help->globalPos(), tip, this);
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

}  // namespace kumite::studio
