#pragma once

#include <string>
#include <vector>

#include "core/synthesis/bout_tape.h"

namespace kumite {

/// One picture of a strip: both fighters as they stand at one moment.
struct StripFrame {
    std::array<std::vector<Eigen::Vector3d>, 2> joints;  ///< metres, y up, floor at 0; empty: none
};
/// A row of pictures at equal spaces of time.
struct Strip {
    std::string title;
    std::vector<StripFrame> frames;
};

/// Synthesised actions beside the recorded ones that they were made from (paper A, Fig. 14): for
/// each label that says more than steps, the first time a bout shows it, two rows of `pictures`
/// from its begin to its end: the bout, and the sample with its recorded opponent. At most `most`
/// actions. Cancellable.
std::vector<Strip> filmStrips(const BoutTape& tape, int pictures = 7, int most = 12,
                              const Progress& progress = {});

/// Strips below each other as an SVG picture: both fighters from the side, bones as lines, player 1
/// in the first colour. Each row is seen along the line that is square to the one between the
/// fighters in its middle picture.
std::string filmStripSvg(const BoutLibrary& library, const std::vector<Strip>& strips);

}  // namespace kumite
