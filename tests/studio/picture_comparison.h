#pragma once

#include <QImage>

namespace kumite::studio {

/// How much two pictures of the same thing differ, told by what eyes would see: both are averaged
/// over cells of 8 pixels, so that letters of another font or lines that moved by a pixel count
/// little, while a missing panel, a wrong colour or a moved block does.
struct PictureDifference {
    double share = 0;  ///< of the cells that differ visibly
    double mean = 0;   ///< difference of all cells, 0…255
};

/// Pictures of other sizes differ wholly.
PictureDifference differenceOf(const QImage& a, const QImage& b);

/// Whether a picture shows what the other does, drawn perhaps by another machine.
bool looksAlike(const PictureDifference& difference);

}  // namespace kumite::studio
