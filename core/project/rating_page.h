#pragma once

#include <string>
#include <vector>

#include "core/project/rating.h"

namespace kumite {

/// A page (HTML, everything in it) that shows the clips as moving figures in an order drawn by
/// `seed`, asks of each whether it is natural, and ends with a table: of each kind how many were
/// found natural, in percent with the 95 % interval of Wilson; the answers can be saved as CSV.
/// Kinds and names stand in the page only scrambled: reading its text does not tell them.
/// `title`: what is rated. Frames are brought to 30 a second. Throws Error if there is no clip.
std::string ratingPage(const std::vector<RatedClip>& clips, const std::string& title,
                       std::uint32_t seed);

/// Lower and upper end of Wilson's 95 % interval of a share, `natural` of `count`; 0 and 1 for
/// none.
std::pair<double, double> wilsonInterval(int natural, int count);

}  // namespace kumite
