#include "studio/help/keys_sheet.h"

#include <QCoreApplication>
#include <QPagedPaintDevice>
#include <QPainter>

#include <algorithm>

#include "studio/app/keys_page.h"

namespace kumite::studio {

namespace {

/// Goes down a column, on to the next one and to new pages. Measures in millimetres.
class Sheet {
public:
    explicit Sheet(QPagedPaintDevice& device) : device_(device) {}

    bool paint(const std::vector<KeyGroup>& groups) {
        if (!painter_.begin(&device_)) return false;
        unit_ = device_.logicalDpiX() / 25.4;
        width_ = painter_.viewport().width() / unit_;
        height_ = painter_.viewport().height() / unit_;
        columns_ = width_ > 240 ? 3 : 2;
        columnWidth_ = (width_ - (columns_ - 1) * kBetween) / columns_;
        beginPage();
        for (const KeyGroup& group : groups)
            paintGroup(group);
        return painter_.end();
    }

private:
    static constexpr double kBetween = 6;
    static constexpr double kKeys = 34;
    static constexpr double kTitle = 12;

    void setFont(double points, bool bold) {
        QFont font(QStringLiteral("sans-serif"));
        font.setPointSizeF(points);
        font.setBold(bold);
        painter_.setFont(font);
    }

    QRectF units(double x, double y, double width, double height) const {
        return {x * unit_, y * unit_, width * unit_, height * unit_};
    }

    double heightOf(const QString& text, double width) {
        return painter_
                   .boundingRect(units(0, 0, width, 1000), Qt::AlignLeft | Qt::TextWordWrap, text)
                   .height() /
               unit_;
    }

    void beginPage() {
        column_ = 0;
        y_ = kTitle;
        setFont(14, true);
        painter_.setPen(Qt::black);
        painter_.drawText(units(0, 0, width_, kTitle), Qt::AlignLeft | Qt::AlignTop,
                          QCoreApplication::translate("KeysSheet", "Kumite: keys and mouse"));
    }

    /// Room for so much, in this column or the next.
    void need(double height) {
        if (y_ + height <= height_) return;
        y_ = kTitle;
        if (++column_ < columns_) return;
        device_.newPage();
        beginPage();
    }

    void paintGroup(const KeyGroup& group) {
        // A title is never the last line of a column.
        need(16);
        const double x = column_ * (columnWidth_ + kBetween);
        setFont(9, true);
        painter_.drawText(units(x, y_, columnWidth_, 5), Qt::AlignLeft | Qt::AlignVCenter,
                          group.title);
        y_ += 5;
        painter_.setPen(QPen(QColor(0, 0, 0, 90), 0.2 * unit_));
        painter_.drawLine(QPointF(x * unit_, y_ * unit_),
                          QPointF((x + columnWidth_) * unit_, y_ * unit_));
        painter_.setPen(Qt::black);
        y_ += 1;
        for (const KeyGroup::Row& row : group.rows)
            paintRow(row);
        y_ += 3;
    }

    void paintRow(const KeyGroup::Row& row) {
        const double textWidth = columnWidth_ - kKeys - 2;
        setFont(8, true);
        const double keysHeight = heightOf(row.keys, kKeys);
        setFont(8, false);
        const double height = std::max(keysHeight, heightOf(row.text, textWidth)) + 0.7;
        need(height);
        const double x = column_ * (columnWidth_ + kBetween);
        painter_.drawText(units(x + kKeys + 2, y_, textWidth, height),
                          Qt::AlignLeft | Qt::TextWordWrap, row.text);
        setFont(8, true);
        painter_.drawText(units(x, y_, kKeys, height), Qt::AlignLeft | Qt::TextWordWrap, row.keys);
        y_ += height;
    }

    QPagedPaintDevice& device_;
    QPainter painter_;
    double unit_ = 1;  ///< dots a millimetre
    double width_ = 0;
    double height_ = 0;
    int columns_ = 2;
    double columnWidth_ = 0;
    int column_ = 0;
    double y_ = 0;
};

}  // namespace

bool paintKeysSheet(const std::vector<KeyGroup>& groups, QPagedPaintDevice& device) {
    return Sheet(device).paint(groups);
}

}  // namespace kumite::studio
