#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/recording.h"

namespace kumite {

/// Where one number of a bone's line in an AMC file goes.
struct AmcValue {
    int column = -1;  ///< of Motion::channels; -1: the number is not used (`l`, a length)
    bool isAngle = false;
    double shift = 0.0;  ///< added to it: the bone's offset, the root's position or orientation
};

/// An ASF skeleton and how AMC lines fill its channels.
struct AsfSkeleton {
    std::shared_ptr<const Skeleton> skeleton;
    bool degrees = true;
    double unitLength = 1.0;  ///< the file's `length`: lengths divided by it are inches
    /// By bone, in the order of the bone's `dof`. Bones without one have no line.
    std::map<std::string, std::vector<AmcValue>, std::less<>> lines;
    Findings findings;
};

/// Reads an Acclaim skeleton (.asf). A bone becomes the joint where it begins, named after the
/// bone; a leaf bone's far end becomes an End Site. Throws InputError.
AsfSkeleton readAsf(std::string_view text, const std::string& name);

/// Reads the motion (.amc) of `asf`. Where it does not say its rate (`:SAMPLES-PER-SECOND`), which
/// hardly any file does, 120 Hz is assumed and reported.
/// Throws InputError.
Recording readAmc(std::string_view text, const std::string& name, const AsfSkeleton& asf,
                  const Progress& progress = {});

}  // namespace kumite
