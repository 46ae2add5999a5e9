#include "studio/app/flow_row.h"

#include <algorithm>

namespace kumite::studio {

FlowRow::~FlowRow() {
    for (QLayoutItem* item : items_)
        delete item;
}

void FlowRow::addSpacing(int pixels) {
    addItem(new QSpacerItem(pixels, 0, QSizePolicy::Fixed, QSizePolicy::Fixed));
}

QLayoutItem* FlowRow::itemAt(int index) const {
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowRow::takeAt(int index) {
    QLayoutItem* item = itemAt(index);
    if (item != nullptr) items_.erase(items_.begin() + index);
    return item;
}

QSize FlowRow::sizeHint() const {
    // All in one line.
    const QMargins margins = contentsMargins();
    int width = 0;
    int height = 0;
    for (QLayoutItem* item : items_) {
        if (item->isEmpty() && item->spacerItem() == nullptr) continue;
        width += item->sizeHint().width() + (width > 0 ? spacing() : 0);
        height = std::max(height, item->sizeHint().height());
    }
    return {width + margins.left() + margins.right(), height + margins.top() + margins.bottom()};
}

QSize FlowRow::minimumSize() const {
    const QMargins margins = contentsMargins();
    QSize least(0, 0);
    for (const QLayoutItem* item : items_) {
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    }
    return least + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

void FlowRow::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    arrange(rect, true);
}

int FlowRow::arrange(const QRect& rect, bool place) const {
    const QRect inside = rect.marginsRemoved(contentsMargins());
    struct Placed {
        QLayoutItem* item;
        int x, width;
    };
    std::vector<Placed> line;
    int x = 0, y = 0, height = 0;
    const auto finish = [&] {
        for (const Placed& placed : line) {
            const int own = std::min(placed.item->sizeHint().height(), height);
            if (place)
                placed.item->setGeometry(QRect(inside.left() + placed.x,
                                               inside.top() + y + (height - own) / 2, placed.width,
                                               own));
        }
        line.clear();
    };
    for (QLayoutItem* item : items_) {
        const bool isSpace = item->spacerItem() != nullptr;
        if (item->isEmpty() && !isSpace) continue;
        const int width = std::min(item->sizeHint().width(), std::max(1, inside.width()));
        if (!line.empty() && x + width > inside.width()) {
            finish();
            y += height + spacing();
            x = height = 0;
        }
        if (isSpace && line.empty()) continue;  // a line begins with something to see
        line.push_back({item, x, width});
        x += width + spacing();
        height = std::max(height, item->sizeHint().height());
    }
    finish();
    const QMargins margins = contentsMargins();
    return y + height + margins.top() + margins.bottom();
}

}  // namespace kumite::studio
