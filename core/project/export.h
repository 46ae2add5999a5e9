#pragma once

#include <filesystem>
#include <vector>

#include "core/project/analysis.h"

namespace kumite {

/// Writes a take by the file's suffix and returns what was written:
/// `.csv` its actions; `.json` its segmentation with minima and corrections;
/// `.eaf` its labels for ELAN; `.bvh` one file per player, `-1` and `-2` before the suffix, with
/// the joints and channels that came in, at the rate and trim of the take. A placement moves the
/// root (or the first joint below it that can move); every other channel stays bit for bit.
/// `.glb` and `.npz` hold all fighters in the bout's space, in metres, y up, floors at 0
/// (formats/gltf.h, npz.h).
/// Throws Error, also for a suffix that is not known or a recording that is missing.
std::vector<std::filesystem::path> exportTake(const Project& project, const Analysis& analysis,
                                              int take, const std::filesystem::path& file);

}  // namespace kumite
