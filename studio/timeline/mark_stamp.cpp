#include "studio/timeline/mark_stamp.h"

#include <QPainter>

#include <cmath>
#include <utility>

namespace kumite::studio {

MarkStamp::MarkStamp(double radius, double ratio, std::function<void(QPainter&)> paint)
    : margin_(static_cast<int>(std::ceil(radius * ratio)) + 1),
      ratio_(ratio),
      paint_(std::move(paint)) {}

void MarkStamp::put(QPainter& painter, const QPointF& at) {
    const auto quarters = [&](double coordinate) {
        return static_cast<long long>(std::floor(coordinate * ratio_ * kPhases + 0.5));
    };
    const long long x = quarters(at.x());
    const long long y = quarters(at.y());
    const auto phase = [](long long quarter) {
        return static_cast<int>(((quarter % kPhases) + kPhases) % kPhases);
    };
    const int phaseX = phase(x);
    const int phaseY = phase(y);
    QImage& picture = pictures_[static_cast<std::size_t>(phaseY * kPhases + phaseX)];
    if (picture.isNull()) {
        const int size = 2 * margin_ + 1;
        picture = QImage(size, size, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter inside(&picture);
        inside.setRenderHint(QPainter::Antialiasing);
        inside.translate(margin_ + double(phaseX) / kPhases, margin_ + double(phaseY) / kPhases);
        inside.scale(ratio_, ratio_);
        paint_(inside);
        inside.end();
        picture.setDevicePixelRatio(ratio_);
    }
    const auto corner = [&](long long quarter, int within) {
        return static_cast<double>((quarter - within) / kPhases - margin_) / ratio_;
    };
    painter.drawImage(QPointF(corner(x, phaseX), corner(y, phaseY)), picture);
}

}  // namespace kumite::studio
