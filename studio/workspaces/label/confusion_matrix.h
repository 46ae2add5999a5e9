#pragma once

#include <QRectF>
#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

namespace kumite::studio {

/// How often a hand said one qualifier and machine or rule another.
struct ConfusionTable {
    QStringList names;  ///< of the qualifiers, as people read them
    QStringList spelt;  ///< the same as short as they are spelt: "fwd"
    bool byRule = false;
    /// counts[said by hand][answered]; a last column for actions without an answer.
    std::vector<std::vector<int>> counts;

    int size() const { return static_cast<int>(names.size()); }
    int at(int hand, int answer) const;
    int row(int hand) const;       ///< how often the hand said it
    int column(int answer) const;  ///< how often it was answered
};

/// A cell of a table: the hand's qualifier and the answered one; the number of qualifiers stands
/// for no answer.
struct ConfusionCell {
    int hand = 0;
    int answer = 0;

    bool operator==(const ConfusionCell&) const = default;
};

/// Where the parts of a table lie in a widget of some width. Names stand as they are if the cells
/// keep their least width, else as they are spelt; above the columns they stand upright.
struct ConfusionLayout {
    QRectF cells;
    double cellWidth = 0;
    double cellHeight = 0;
    double height = 0;  ///< of all
    bool spelt = false;

    QRectF rect(const ConfusionCell& cell) const;
    std::optional<ConfusionCell> at(const QPointF& point, int rows, int columns) const;
};
ConfusionLayout layOut(const ConfusionTable& table, double width, const QFontMetricsF& metrics);

/// A confusion matrix: rows by hand, columns as answered; right answers in green on the diagonal,
/// wrong ones in purple, the stronger the larger their share of the row. The arrow keys move the
/// current cell, Enter or a click opens it.
class ConfusionMatrix : public QWidget {
    Q_OBJECT

public:
    explicit ConfusionMatrix(QWidget* parent = nullptr);

    void show(const ConfusionTable& table);
    const ConfusionTable& table() const { return table_; }
    const std::optional<ConfusionCell>& current() const { return current_; }
    /// In the widget's pixels.
    QRectF cellRect(const ConfusionCell& cell) const { return layout_.rect(cell); }
    /// "forward by hand, back by machine: 3 actions, 12 % of forward"
    QString cellText(const ConfusionCell& cell) const;

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

Q_SIGNALS:
    void opened(const ConfusionCell& cell);
    /// What the pointer or the keys are on; empty: nothing.
    void pointed(const QString& text);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    int columns() const;
    void arrange();
    void move(int down, int right);
    void setHovered(std::optional<ConfusionCell> cell);
    void paintNames(QPainter& painter) const;
    void paintCell(QPainter& painter, const ConfusionCell& cell) const;

    ConfusionTable table_;
    ConfusionLayout layout_;
    std::optional<ConfusionCell> current_;
    std::optional<ConfusionCell> hovered_;
};

}  // namespace kumite::studio
