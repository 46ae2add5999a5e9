#include "studio/timeline/lane_painter.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "studio/app/colour_vision.h"
#include "studio/app/comfort.h"
#include "studio/timeline/level_of_detail.h"
#include "studio/timeline/track_painter.h"

namespace kumite::studio {

namespace {

double usualLane() {
    return withTextSize(14.0);
}
constexpr double kLowestLane = 8;
double stripHeight() {
    return withTextSize(14.0);
}
constexpr int kNarrow = 3;  ///< pixels up to which a block has neither hatching nor outline
/// Of a block that has its qualifier written in it
double textWidth() {
    return withTextSize(26.0);
}

double relativeLuminance(const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/// What must not vanish under another cell of the same pixel.
int weightOf(const LaneCell& cell) {
    switch (cell.look) {
        case LaneLook::Open:
            return 0;
        case LaneLook::Nothing:
            return cell.byHand ? 2 : 1;
        case LaneLook::Rule:
            return 3;
        case LaneLook::Proposed:
            return cell.uncertain ? 5 : 4;
        case LaneLook::Accepted:
            return 6;
        case LaneLook::Hand:
            return 7;
    }
    return 0;
}

/// Paints the lanes of one row.
class LanePainter {
public:
    LanePainter(QPainter& painter, const LaneSource& lanes, const Colours& colours,
                const QRect& area)
        : painter_(painter), lanes_(lanes), colours_(colours), area_(area) {}

    /// Puts down what `paintCell` gathered.
    void finish() {
        if (!narrow_.isNull()) painter_.drawImage(area_.topLeft(), narrow_);
    }

    void paintCell(const QRect& block, int lane, const LaneCell& cell, bool withText) {
        if (cell.look == LaneLook::Open) return;
        if (block.width() <= kNarrow) return paintNarrow(block, lane, cell);
        if (cell.look == LaneLook::Nothing) {
            // A line along the middle: somebody looked, and there is nothing.
            const QColor line = cell.byHand ? colours_.secondText
                                            : mixed(colours_.ground, colours_.secondText, 0.45);
            const int y = block.center().y();
            if (cell.uncertain) {
                painter_.setPen(QPen(line, 1, Qt::DotLine));
                painter_.drawLine(block.left(), y, block.right(), y);
                return;
            }
            painter_.fillRect(QRect(block.left(), y, block.width(), cell.byHand ? 2 : 1), line);
            return;
        }
        const Ink& ink = inkOf(lane, cell);
        painter_.fillRect(block, ink.fill);
        if (ink.pattern != Qt::NoBrush)
            painter_.fillRect(block, QBrush(withAlpha(ink.letters, 0.45), ink.pattern));
        if (cell.uncertain) painter_.fillRect(block, QBrush(ink.colour, Qt::BDiagPattern));
        if (cell.look == LaneLook::Rule || cell.uncertain) {
            painter_.setPen(QPen(ink.outline, 1));
            painter_.setBrush(Qt::NoBrush);
            painter_.drawRect(block.adjusted(0, 0, -1, -1));
        }
        if (!withText || block.width() < textWidth()) return;
        painter_.setPen(ink.letters);
        const int room = block.width() - 6;
        if (cell.uncertain || ink.pattern != Qt::NoBrush) {
            // Letters on hatching cannot be read.
            const int width = std::min(room, painter_.fontMetrics().horizontalAdvance(ink.text));
            painter_.fillRect(
                QRect(block.left() + 2, block.top() + 1, width + 3, block.height() - 2), ink.fill);
        }
        painter_.drawText(block.adjusted(3, 0, -3, 0), Qt::AlignLeft | Qt::AlignVCenter,
                          painter_.fontMetrics().elidedText(ink.text, Qt::ElideRight, room));
    }

private:
    /// In what a kind of cell is painted. There are few kinds and thousands of cells.
    struct Ink {
        QColor colour, fill, outline, letters;
        Qt::BrushStyle pattern = Qt::NoBrush;  ///< besides the colour, for every eye
        QRgb narrow = 0;  ///< where there is room for neither hatching nor outline
        QString text;
    };

    /// Of blocks a few pixels wide there may be thousands; they go straight into a picture.
    void paintNarrow(const QRect& block, int lane, const LaneCell& cell) {
        if (narrow_.isNull()) {
            narrow_ = QImage(area_.size(), QImage::Format_ARGB32_Premultiplied);
            narrow_.fill(Qt::transparent);
            bits_ = reinterpret_cast<QRgb*>(narrow_.bits());
        }
        const bool nothing = cell.look == LaneLook::Nothing;
        const int left = std::max(0, block.left() - area_.left());
        const int width = std::min(block.right() - area_.left() + 1, narrow_.width()) - left;
        const int top = (nothing ? block.center().y() : block.top()) - area_.top();
        const int height = nothing ? (cell.byHand ? 2 : 1) : block.height();
        const QRgb colour = inkOf(lane, cell).narrow;
        for (int y = std::max(0, top); y < std::min(top + height, narrow_.height()); ++y) {
            QRgb* row = bits_ + y * (narrow_.bytesPerLine() / qsizetype(sizeof(QRgb)));
            for (int x = left; x < left + width; ++x)
                row[x] = colour;
        }
    }

    const Ink& inkOf(int lane, const LaneCell& cell) {
        constexpr int kLooks = int(LaneLook::Rule) + 1;
        const auto row = static_cast<std::size_t>(lane);
        if (row >= inks_.size()) inks_.resize(row + 1);
        const auto index =
            static_cast<std::size_t>((std::max<int>(cell.value, 0) * kLooks + int(cell.look)) * 4 +
                                     2 * int(cell.uncertain) + int(cell.byHand));
        std::vector<std::optional<Ink>>& inks = inks_[row];
        if (index >= inks.size()) inks.resize(index + 1);
        if (!inks[index]) inks[index] = makeInk(lane, cell);
        return *inks[index];
    }

    Qt::BrushStyle patternOf(int lane, int value) const {
        std::vector<QColor> colours;
        for (int i = 0; i <= value; ++i)
            colours.push_back(classColour(lanes_.valueColour(lane, i), colours_));
        // Painted many times a second, of few kinds.
        static std::map<std::vector<QRgb>, Qt::BrushStyle> known;
        std::vector<QRgb> key;
        for (const QColor& colour : colours)
            key.push_back(colour.rgb());
        const auto found = known.find(key);
        if (found != known.end()) return found->second;
        return known[key] = classPatterns(colours).back();
    }

    Ink makeInk(int lane, const LaneCell& cell) const {
        Ink ink;
        if (cell.look == LaneLook::Nothing) {
            const double share = cell.byHand ? 1.0 : cell.uncertain ? 0.25 : 0.45;
            ink.narrow = mixed(colours_.ground, colours_.secondText, share).rgb();
            return ink;
        }
        ink.colour = classColour(lanes_.valueColour(lane, cell.value), colours_);
        ink.pattern = patternOf(lane, cell.value);
        const double share = cell.look == LaneLook::Hand       ? 1.0
                             : cell.look == LaneLook::Accepted ? 0.62
                             : cell.look == LaneLook::Proposed ? 0.38
                                                               : 0.10;
        ink.fill = mixed(colours_.ground, ink.colour, cell.uncertain ? 0.12 : share);
        ink.outline = mixed(colours_.ground, ink.colour, 0.75);
        const QColor dark("#16171a");
        const QColor light("#f6f6f7");
        ink.letters = contrastOf(dark, ink.fill) > contrastOf(light, ink.fill) ? dark : light;
        ink.text = lanes_.valueText(lane, cell.value);
        // As dark as hatching or an outline is.
        const bool thin = cell.uncertain || cell.look == LaneLook::Rule;
        ink.narrow = (thin ? mixed(colours_.ground, ink.colour, 0.35) : ink.fill).rgb();
        return ink;
    }

    QPainter& painter_;
    const LaneSource& lanes_;
    const Colours& colours_;
    QRect area_;
    QImage narrow_;
    QRgb* bits_ = nullptr;                               ///< of `narrow_`
    std::vector<std::vector<std::optional<Ink>>> inks_;  ///< by lane and kind
};

/// Of several lanes the one that is shown where there is room for one; with its cell.
std::pair<int, LaneCell> foremost(std::span<const LaneCell> cells) {
    int best = 0;
    for (int lane = 1; lane < static_cast<int>(cells.size()); ++lane) {
        const LaneCell& cell = cells[static_cast<std::size_t>(lane)];
        if (weightOf(cell) > weightOf(cells[static_cast<std::size_t>(best)])) best = lane;
    }
    return {best, cells[static_cast<std::size_t>(best)]};
}

}  // namespace

int LanePlace::laneAt(double y, int count) const {
    if (collapsed || height <= 0 || y < area.top() || y >= area.bottom()) return -1;
    return std::clamp(static_cast<int>((y - area.top()) / height), 0, count - 1);
}

double laneHeight(double room, int count) {
    if (count == 0) return 0;
    const double each = std::floor(room / count);
    return each >= kLowestLane ? std::min(each, usualLane()) : 0;
}

double contrastOf(const QColor& a, const QColor& b) {
    const double la = relativeLuminance(a);
    const double lb = relativeLuminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QColor classColour(const QColor& colour, const Colours& colours) {
    QColor seen = colour;
    for (int i = 0; i < 8 && contrastOf(seen, colours.ground) < 2.2; ++i)
        seen = mixed(seen, colours.text, 0.12);
    return seen;
}

void paintLanes(QPainter& painter, const LaneSource& lanes, const Session& session, int player,
                const LanePlace& place, const Colours& colours, const TimeMapping& mapping) {
    const FighterAnalysis* fighter = session.fighter(player);
    const int count = lanes.laneCount();
    const std::span<const LaneCell> cells = lanes.cells(player);
    if (fighter == nullptr || count == 0 || place.area.isEmpty()) return;
    const auto& actions = fighter->segmentation->actions;
    const int rows = place.collapsed ? 1 : count;
    const double height = place.collapsed ? stripHeight() : place.height;
    painter.setRenderHint(QPainter::Antialiasing, false);
    QFont small = painter.font();
    small.setPixelSize(std::clamp(static_cast<int>(height) - 1, 8, withTextSize(11)));
    const QFont font = painter.font();
    painter.setFont(small);

    const auto top = [&](int row) { return static_cast<int>(place.area.top() + row * height); };
    for (int row = 0; row < rows; ++row) {
        const bool chosen = !place.collapsed && row == lanes.chosenLane();
        const QRect ground(static_cast<int>(place.area.left()), top(row),
                           static_cast<int>(place.area.width()), static_cast<int>(height) - 1);
        painter.fillRect(ground, mixed(colours.ground, colours.text, chosen ? 0.09 : 0.035));
        const QString name = place.collapsed ? LaneSource::tr("labels") : lanes.laneName(row);
        painter.setPen(chosen ? colours.text : colours.secondText);
        const QRectF header(4, top(row), place.area.left() - 10, height - 1);
        painter.drawText(header, Qt::AlignRight | Qt::AlignVCenter, name);
        if (chosen) {
            painter.fillRect(QRectF(place.area.left() - 4, top(row), 2, height - 1),
                             colours.accent);
        }
    }
    if (cells.size() != actions.size() * static_cast<std::size_t>(count)) {
        painter.setFont(font);
        return;
    }

    painter.setClipRect(place.area);
    const SampleAxis axis = frameAxis(fighter->input, mapping);
    // Where the visible actions begin and end is the same in every row.
    struct Span {
        int left, right;
    };
    std::vector<Span> spans;
    const auto first = std::partition_point(actions.begin(), actions.end(), [&](const Action& a) {
        return axis.xOf(a.end) < place.area.left();
    });
    for (auto action = first;
         action != actions.end() && axis.xOf(action->begin) <= place.area.right(); ++action) {
        spans.push_back({static_cast<int>(std::lround(axis.xOf(action->begin))),
                         static_cast<int>(std::lround(axis.xOf(action->end)))});
    }
    const auto begin = static_cast<std::size_t>(first - actions.begin());
    LanePainter blocks(painter, lanes, colours, place.area.toAlignedRect());
    for (int row = 0; row < rows; ++row) {
        const auto cellOf = [&](std::size_t action) {
            const auto own = cells.subspan(action * static_cast<std::size_t>(count),
                                           static_cast<std::size_t>(count));
            return place.collapsed ? foremost(own)
                                   : std::pair(row, own[static_cast<std::size_t>(row)]);
        };
        // What falls on one pixel, or says the same as its neighbour where blocks are narrow, is
        // painted as one.
        QRect block;
        std::pair<int, LaneCell> shown;
        bool any = false;
        const auto flush = [&] {
            if (any) blocks.paintCell(block, shown.first, shown.second, height >= 11);
            any = false;
        };
        for (std::size_t i = 0; i < spans.size(); ++i) {
            const auto [left, beyond] = spans[i];
            int right = beyond;
            const bool narrow = right - left < 3;
            const auto cell = cellOf(begin + i);
            if (any && right <= block.left() + 1) {
                if (weightOf(cell.second) > weightOf(shown.second)) shown = cell;
                continue;
            }
            if (any && narrow && cell == shown) {
                block.setRight(right - 1);
                continue;
            }
            flush();
            // A gap between neighbours, where there is room for one.
            if (right - left > 5) --right;
            block = QRect(left, top(row), std::max(1, right - left), static_cast<int>(height) - 1);
            shown = cell;
            any = true;
        }
        flush();
    }
    blocks.finish();
    painter.setClipping(false);
    painter.setFont(font);
}

}  // namespace kumite::studio
