#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/motion/motion.h"

namespace kumite {

/// What a motion file holds: one motion per skeleton in it (nearly always one).
struct Recording {
    std::string format;  ///< "BVH" or "ASF/AMC"
    std::vector<std::shared_ptr<const Motion>> motions;
    Findings findings;  ///< what was odd in the file and what was done about it
    /// SHA-256 of the file's bytes (of the .asf's and the .amc's, one after the other).
    std::string sha256;
    std::filesystem::path asf;  ///< the skeleton file that was read beside an .amc; else empty
};

struct ReadOptions {
    /// The .asf that belongs to an .amc; by default the only one beside it.
    std::optional<std::filesystem::path> asf;
};

/// Reads a recording; what it is is decided by its content and then its name. Throws InputError
/// (`file:line:column: what, expected what`). A format that is known but not read (FBX, C3D,
/// glTF …) is refused with the way to convert it.
Recording readRecording(const std::filesystem::path& path, const ReadOptions& options = {},
                        const Progress& progress = {});

/// The motion of `recording` that `root` names: its root joint's name, or `NAME#2`, or `#2` for
/// the second in the file (names may be equal; NAME alone is then the first of them). Empty: the
/// first. Throws Error that lists what there is.
std::shared_ptr<const Motion> motionOfRoot(const Recording& recording, const std::string& root);

/// How the motions of a recording are named for `motionOfRoot`: "Hips", or "Hips#1", "Hips#2"
/// where names repeat.
std::vector<std::string> rootNames(const Recording& recording);

}  // namespace kumite
