#include "studio/app/comfort.h"

#include <QAbstractButton>
#include <QHeaderView>
#include <QScreen>
#include <QTableView>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

namespace {

int size = 100;
bool reduced = false;

constexpr const char* kOwnPoints = "pointsAt100";
constexpr int kWidest = 150;  ///< of a control that is made for a text

/// Hairlines stay, and what has no limit.
int scaled(int pixels, double ratio) {
    constexpr int kLine = 8;
    return pixels <= kLine || pixels >= QWIDGETSIZE_MAX
               ? pixels
               : static_cast<int>(std::lround(pixels * ratio));
}

void rescaleSections(QHeaderView& header, double ratio) {
    header.setMinimumSectionSize(-1);
    for (int i = 0; i < header.count(); ++i) {
        if (header.sectionResizeMode(i) == QHeaderView::Fixed)
            header.resizeSection(i, static_cast<int>(std::lround(header.sectionSize(i) * ratio)));
    }
}

}  // namespace

void setTextSize(int percent) {
    size = std::clamp(percent, 100, 200);
}

int textSize() {
    return size;
}

int withTextSize(int pixels) {
    return pixels * size / 100;
}

double withTextSize(double pixels) {
    return pixels * size / 100;
}

QSize roomFor(const QWidget& dialog, QSize size) {
    const QSize wished(withTextSize(size.width()), withTextSize(size.height()));
    return wished.boundedTo(dialog.screen()->availableSize() - QSize(40, 80));
}

void rescale(QWidget& root, double ratio) {
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        // Parts of Qt's own widgets follow their owners.
        if (widget->objectName().startsWith(QLatin1String("qt_"))) continue;
        if (widget->isWindow()) continue;
        if (widget->font().resolveMask() & QFont::SizeResolved &&
            widget->testAttribute(Qt::WA_SetFont)) {
            QFont own = widget->font();
            // A new style sheet brings old fonts back: what counts is the size at the beginning.
            if (!widget->property(kOwnPoints).isValid())
                widget->setProperty(kOwnPoints, own.pointSizeF() * 100 * ratio / size);
            own.setPointSizeF(widget->property(kOwnPoints).toDouble() * size / 100);
            widget->setFont(own);
        }
        const QSize least = widget->minimumSize();
        const QSize most = widget->maximumSize();
        // Views and panels may be as narrow as ever: the window has room for so much only.
        const auto low = [&](int pixels, int limit) {
            return pixels == limit || pixels <= kWidest ? scaled(pixels, ratio) : pixels;
        };
        widget->setMaximumSize(scaled(most.width(), ratio), scaled(most.height(), ratio));
        widget->setMinimumSize(low(least.width(), most.width()),
                               low(least.height(), most.height()));
        if (auto* button = qobject_cast<QAbstractButton*>(widget))
            button->setIconSize(button->iconSize() * ratio);
        if (auto* table = qobject_cast<QTableView*>(widget)) {
            rescaleSections(*table->horizontalHeader(), ratio);
            QHeaderView& rows = *table->verticalHeader();
            rows.setDefaultSectionSize(
                static_cast<int>(std::lround(rows.defaultSectionSize() * ratio)));
        }
    }
}

void setMotionReduced(bool is) {
    reduced = is;
}

bool isMotionReduced() {
    return reduced;
}

}  // namespace kumite::studio
