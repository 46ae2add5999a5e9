#include "studio/workspaces/label/confusion_matrix.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/grid_keys.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

constexpr double kLeastCell = 25;
constexpr double kWidestCell = 46;
constexpr double kHighestCell = 24;
constexpr double kGap = 6;  ///< between names and cells

const QColor kRight("#009e73");
const QColor kWrong("#cc79a7");

double widest(const QStringList& texts, const QFontMetricsF& metrics) {
    double width = 0;
    for (const QString& text : texts)
        width = std::max(width, std::ceil(metrics.horizontalAdvance(text)));
    return width;
}

bool hasOpenAnswers(const ConfusionTable& table) {
    return table.column(table.size()) > 0;
}

QString openText() {
    return ConfusionMatrix::tr("no answer");
}

}  // namespace

int ConfusionTable::at(int hand, int answer) const {
    const auto& row = counts[static_cast<std::size_t>(hand)];
    return static_cast<std::size_t>(answer) < row.size() ? row[static_cast<std::size_t>(answer)]
                                                         : 0;
}

int ConfusionTable::row(int hand) const {
    int sum = 0;
    for (const int count : counts[static_cast<std::size_t>(hand)])
        sum += count;
    return sum;
}

int ConfusionTable::column(int answer) const {
    int sum = 0;
    for (int hand = 0; hand < size(); ++hand)
        sum += at(hand, answer);
    return sum;
}

QRectF ConfusionLayout::rect(const ConfusionCell& cell) const {
    return {cells.left() + cell.answer * cellWidth, cells.top() + cell.hand * cellHeight, cellWidth,
            cellHeight};
}

std::optional<ConfusionCell> ConfusionLayout::at(const QPointF& point, int rows,
                                                 int columns) const {
    if (!cells.contains(point) || cellWidth <= 0 || cellHeight <= 0) return std::nullopt;
    const ConfusionCell cell{static_cast<int>((point.y() - cells.top()) / cellHeight),
                             static_cast<int>((point.x() - cells.left()) / cellWidth)};
    if (cell.hand >= rows || cell.answer >= columns) return std::nullopt;
    return cell;
}

ConfusionLayout layOut(const ConfusionTable& table, double width, const QFontMetricsF& metrics) {
    ConfusionLayout layout;
    if (table.size() == 0) return layout;
    const bool open = hasOpenAnswers(table);
    const int columns = table.size() + (open ? 1 : 0);
    const auto cellFor = [&](const QStringList& names) {
        return (width - widest(names, metrics) - kGap - 1) / columns;
    };
    layout.spelt = cellFor(table.names) < kLeastCell;
    const QStringList& names = layout.spelt ? table.spelt : table.names;
    layout.cellWidth = std::min(kWidestCell, std::floor(cellFor(names)));
    layout.cellHeight = std::clamp(layout.cellWidth, metrics.height() + 2, kHighestCell);
    QStringList above = names;
    if (open) above.append(openText());
    layout.cells = QRectF(widest(names, metrics) + kGap, widest(above, metrics) + kGap,
                          columns * layout.cellWidth, table.size() * layout.cellHeight);
    layout.height = layout.cells.bottom() + 1;
    return layout;
}

ConfusionMatrix::ConfusionMatrix(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setAccessibleName(tr("Confusion matrix"));
}

void ConfusionMatrix::show(const ConfusionTable& table) {
    if (table.names != table_.names) current_.reset();
    table_ = table;
    hovered_.reset();
    arrange();
}

int ConfusionMatrix::columns() const {
    return table_.size() + (table_.size() > 0 && hasOpenAnswers(table_) ? 1 : 0);
}

QString ConfusionMatrix::cellText(const ConfusionCell& cell) const {
    const int count = table_.at(cell.hand, cell.answer);
    const int all = table_.row(cell.hand);
    const QString hand = table_.names[cell.hand];
    const QString answer = cell.answer < table_.size() ? table_.names[cell.answer] : openText();
    const QString who = table_.byRule ? tr("by rule") : tr("by machine");
    QString text = cell.hand == cell.answer ? tr("%1 by hand and %2: ").arg(hand, who)
                                            : tr("%1 by hand, %2 %3: ").arg(hand, answer, who);
    text += count == 1 ? tr("1 action") : tr("%1 actions").arg(count);
    if (all > 0) text += tr(", %1 of %2").arg(percentText(double(count) / all), hand);
    return text;
}

int ConfusionMatrix::heightForWidth(int width) const {
    return static_cast<int>(std::ceil(layOut(table_, width, QFontMetricsF(font())).height));
}

QSize ConfusionMatrix::sizeHint() const {
    return {260, heightForWidth(260)};
}

void ConfusionMatrix::arrange() {
    layout_ = layOut(table_, width(), QFontMetricsF(font()));
    setMinimumHeight(heightForWidth(width()));  // the page scrolls rather than cut it
    updateGeometry();
    update();
}

void ConfusionMatrix::resizeEvent(QResizeEvent*) {
    arrange();
}

void ConfusionMatrix::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) arrange();
    QWidget::changeEvent(event);
}

bool ConfusionMatrix::event(QEvent* event) {
    // The arrows belong to the matrix while it has the focus, not to the playhead.
    return claimsGridKey(event, {Qt::Key_Return, Qt::Key_Enter}) || QWidget::event(event);
}

void ConfusionMatrix::keyPressEvent(QKeyEvent* event) {
    if (const auto step = gridStep(*event)) {
        move(step->rows, step->columns);
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (current_) Q_EMIT opened(*current_);
    } else {
        QWidget::keyPressEvent(event);
    }
}

void ConfusionMatrix::move(int down, int right) {
    if (table_.size() == 0) return;
    const ConfusionCell from = current_.value_or(ConfusionCell{-down, -right});
    current_ = {std::clamp(from.hand + down, 0, table_.size() - 1),
                std::clamp(from.answer + right, 0, columns() - 1)};
    setAccessibleDescription(cellText(*current_));
    Q_EMIT pointed(cellText(*current_));
    update();
}

void ConfusionMatrix::setHovered(std::optional<ConfusionCell> cell) {
    if (cell == hovered_) return;
    hovered_ = cell;
    setToolTip(cell ? cellText(*cell) : QString());
    Q_EMIT pointed(toolTip());
    update();
}

void ConfusionMatrix::mouseMoveEvent(QMouseEvent* event) {
    setHovered(layout_.at(event->position(), table_.size(), columns()));
}

void ConfusionMatrix::mousePressEvent(QMouseEvent* event) {
    const auto cell = layout_.at(event->position(), table_.size(), columns());
    if (!cell || event->button() != Qt::LeftButton) return;
    current_ = cell;
    setAccessibleDescription(cellText(*cell));
    update();
    Q_EMIT opened(*cell);
}

void ConfusionMatrix::leaveEvent(QEvent*) {
    setHovered({});
}

void ConfusionMatrix::paintNames(QPainter& painter) const {
    const Colours& c = coloursFor(palette());
    const QStringList& names = layout_.spelt ? table_.spelt : table_.names;
    const auto marked = [this](int hand, int answer) {
        const auto& cell = hovered_ ? hovered_ : current_;
        return cell && (cell->hand == hand || cell->answer == answer);
    };
    for (int hand = 0; hand < table_.size(); ++hand) {
        painter.setPen(marked(hand, -1) ? c.text : c.secondText);
        const QRectF row = layout_.rect({hand, 0});
        painter.drawText(QRectF(0, row.top(), layout_.cells.left() - kGap, row.height()),
                         Qt::AlignRight | Qt::AlignVCenter, names[hand]);
    }
    for (int answer = 0; answer < columns(); ++answer) {
        painter.setPen(marked(-1, answer) ? c.text : c.secondText);
        const QRectF column = layout_.rect({0, answer});
        painter.save();
        painter.translate(column.center().x(), layout_.cells.top() - kGap);
        painter.rotate(-90);
        painter.drawText(QRectF(0, -column.width() / 2, layout_.cells.top(), column.width()),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         answer < table_.size() ? names[answer] : openText());
        painter.restore();
    }
}

void ConfusionMatrix::paintCell(QPainter& painter, const ConfusionCell& cell) const {
    const Colours& c = coloursFor(palette());
    const QRectF rect = layout_.rect(cell).adjusted(0.5, 0.5, -0.5, -0.5);
    const int count = table_.at(cell.hand, cell.answer);
    const bool right = cell.hand == cell.answer;
    QColor fill = mixed(c.panel, c.line, 0.35);
    if (count > 0) {
        const double share = std::sqrt(double(count) / table_.row(cell.hand));
        fill = mixed(fill, right ? kRight : kWrong, 0.15 + 0.6 * share);
    }
    painter.fillRect(rect, fill);
    if (count > 0) {
        painter.setPen(c.text);
        painter.drawText(rect, Qt::AlignCenter, QString::number(count));
    }
    if (right) {
        painter.setPen(QPen(mixed(c.line, c.secondText, 0.6), 1));
        painter.drawRect(rect);
    }
    if (cell == hovered_) {
        painter.setPen(QPen(c.text, 1));
        painter.drawRect(rect);
    }
    if (cell == current_) {
        painter.setPen(QPen(hasFocus() ? c.accent : c.secondText, 2));
        painter.drawRect(rect.adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void ConfusionMatrix::paintEvent(QPaintEvent*) {
    if (table_.size() == 0) return;
    QPainter painter(this);
    paintNames(painter);
    for (int hand = 0; hand < table_.size(); ++hand) {
        for (int answer = 0; answer < columns(); ++answer)
            paintCell(painter, {hand, answer});
    }
}

}  // namespace kumite::studio
