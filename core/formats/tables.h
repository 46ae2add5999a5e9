#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/kinematics.h"
#include "core/motion/skeleton.h"

namespace kumite {

/// `frame,joint,x,y,z`: world positions in metres, y up, six decimals. Frames are numbered from
/// `firstFrame`; End Sites are left out unless asked for. Names with commas or quotes are quoted
/// as CSV does.
std::string jointPositionsCsv(const Skeleton& skeleton, const JointPositions& positions,
                              int firstFrame, bool withEndSites);

/// A field as CSV wants it: quoted where it must be.
std::string csvField(std::string_view text);

/// A line of a CSV file; empty lines are left out.
struct CsvLine {
    int number = 0;  ///< from 1, of the line where it begins
    std::vector<std::string> fields;
};
/// Reads commas, quotes (`""` inside them), LF and CRLF and a byte order mark. Throws InputError
/// for a quote that is not closed.
std::vector<CsvLine> parseCsv(std::string_view text, const std::string& file);

}  // namespace kumite
