#pragma once

#include <string>
#include <vector>

#include "core/motion/pose.h"

namespace kumite {

/// A figure in a picture: one frame of a clip that stands in the picture's space.
struct FilmFigure {
    const Clip* clip = nullptr;
    int frame = 0;
    std::string colour = "#4878b0";  ///< "#rrggbb"; left limbs are drawn darker
    double opacity = 1;              ///< below 1 for a figure to compare with
};

/// A point that a picture shows, such as a target.
struct FilmMark {
    Eigen::Vector3d place;  ///< metres
    std::string colour = "#c03030";
};

struct FilmPicture {
    std::string caption;
    std::vector<FilmFigure> figures;
    std::vector<FilmMark> marks;
};

/// Pictures side by side, seen from one direction.
struct FilmRow {
    std::string title;
    std::vector<FilmPicture> pictures;
};

/// Side: square to the line between both fighters (one alone: to where it faces) in the row's first
/// picture, which points to the right. ThreeQuarter: 35° round from there and from above.
enum class FilmView { Side, ThreeQuarter };

struct FilmSettings {
    FilmView view = FilmView::Side;
    double pixelsPerMetre = 90;
    double floor = 0;  ///< metres
};

/// Film strips for reports (paper A, Fig. 14), as SVG text on white: capsule figures, one scale,
/// from the side a line for the floor, captions below. Pictures are as large as the largest needs.
/// The same input gives the same text.
std::string filmStripSvg(const std::string& title, const std::vector<FilmRow>& rows,
                         const FilmSettings& settings = {});

/// `count` frames from `begin` to `end` − 1, evenly spaced, both ends included.
std::vector<int> evenFrames(FrameRange frames, int count);

}  // namespace kumite
