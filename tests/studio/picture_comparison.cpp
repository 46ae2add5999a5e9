#include "tests/studio/picture_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kumite::studio {

namespace {

constexpr int kCell = 8;             // pixels
constexpr int kVisible = 14;         // of 255, in any colour
constexpr double kMostCells = 0.03;  // may differ visibly
constexpr double kMostMean = 2.5;    // of 255

}  // namespace

PictureDifference differenceOf(const QImage& a, const QImage& b) {
    if (a.size() != b.size() || a.isNull()) return {1, 255};
    const QSize cells((a.width() + kCell - 1) / kCell, (a.height() + kCell - 1) / kCell);
    const auto coarse = [&](const QImage& picture) {
        return picture.convertToFormat(QImage::Format_RGB32)
            .scaled(cells, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage left = coarse(a);
    const QImage right = coarse(b);
    double sum = 0;
    int visible = 0;
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            const QRgb p = left.pixel(x, y);
            const QRgb q = right.pixel(x, y);
            const int worst =
                std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                          std::abs(qBlue(p) - qBlue(q))});
            sum += worst;
            if (worst > kVisible) ++visible;
        }
    }
    const double count = cells.width() * cells.height();
    return {visible / count, sum / count};
}

bool looksAlike(const PictureDifference& difference) {
    return difference.share <= kMostCells && difference.mean <= kMostMean;
}

}  // namespace kumite::studio
