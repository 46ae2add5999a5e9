#include "studio/timeline/curve_painter.h"

#include <QColor>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

namespace {

/// All four channels of a pixel times `share` of 256.
quint32 scaled(quint32 pixel, quint32 share) {
    const quint32 even = ((pixel & 0xff00ffU) * share >> 8) & 0xff00ffU;
    const quint32 odd = ((pixel >> 8) & 0xff00ffU) * share & 0xff00ff00U;
    return even | odd;
}

/// A run of pixels that lie below each other, in one colour.
struct Ink {
    quint32* column;      ///< its topmost pixel
    qsizetype rowLength;  ///< in pixels
    quint32 colour;       ///< opaque

    void cover(int row, double share) const {
        quint32& pixel = column[row * rowLength];
        const auto part = static_cast<quint32>(std::lround(256 * share));
        pixel = scaled(colour, part) + scaled(pixel, 256 - part);
    }
    /// What lies between two heights; rows at its ends are covered in part.
    void fill(double top, double bottom) const {
        const int first = static_cast<int>(top);
        const int last = static_cast<int>(bottom);
        if (first == last) {
            cover(first, bottom - top);
            return;
        }
        cover(first, first + 1 - top);
        quint32* pixel = column + (first + 1) * rowLength;
        for (int row = first + 1; row < last; ++row, pixel += rowLength)
            *pixel = colour;
        if (bottom > last) cover(last, bottom - last);
    }
};

}  // namespace

CurvePicture::CurvePicture(const QRectF& area, double ratio)
    : ratio_(ratio),
      left_(static_cast<int>(std::floor(area.left() * ratio))),
      top_(static_cast<int>(std::floor(area.top() * ratio))) {
    const int right = static_cast<int>(std::ceil(area.right() * ratio));
    const int bottom = static_cast<int>(std::ceil(area.bottom() * ratio));
    image_ = QImage(std::max(1, right - left_), std::max(1, bottom - top_),
                    QImage::Format_ARGB32_Premultiplied);
    image_.setDevicePixelRatio(ratio);
    image_.fill(Qt::transparent);
}

void CurvePicture::draw(const CurvePyramid& curve, const SampleAxis& axis, const ValueAxis& values,
                        const QRectF& plot, const QColor& colour, double width) {
    const SampleAxis pixels{axis.x0 * ratio_ - left_, axis.step * ratio_};
    const double thickness = width * ratio_;
    const double scale = plot.height() * ratio_ / (values.high - values.low);
    const double bottom = plot.bottom() * ratio_ - top_;
    const double highest = std::max(0.0, plot.top() * ratio_ - top_ - thickness / 2);
    const double lowest = std::min<double>(image_.height(), bottom + thickness / 2);
    const double from = std::max(0.0, std::floor(plot.left() * ratio_ - left_));
    const double to = std::min<double>(image_.width(), std::ceil(plot.right() * ratio_ - left_));
    auto* bits = reinterpret_cast<quint32*>(image_.bits());
    const qsizetype rowLength = image_.bytesPerLine() / qsizetype(sizeof(quint32));
    for (const CurveColumn& column : curveColumns(curve, pixels, from, to)) {
        const double upper = bottom - (column.high - values.low) * scale;
        const double lower = bottom - (column.low - values.low) * scale;
        // A line of that thickness is as high as this where it rises so much over a pixel.
        const double rise = lower - upper;
        const double air = std::min(thickness, thickness * std::sqrt(1 + rise * rise) - rise) / 2;
        const double top = std::max(upper - air, highest);
        const double end = std::min(lower + air, lowest);
        if (end <= top) continue;
        const Ink ink{bits + static_cast<int>(column.x), rowLength, colour.rgb()};
        // The last row ends before the picture does.
        ink.fill(top, std::min(end, image_.height() - 1e-6));
    }
}

void CurvePicture::paintOnto(QPainter& painter) const {
    painter.drawImage(QPointF(left_ / ratio_, top_ / ratio_), image_);
}

}  // namespace kumite::studio
