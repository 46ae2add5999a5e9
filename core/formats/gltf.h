#pragma once

#include <array>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/motion/pose.h"

namespace kumite {

/// One figure of a glTF file.
struct GltfFigure {
    std::string name;            ///< of its skeleton, e.g. "player1"
    const Clip* clip = nullptr;  ///< metres, y up, as glTF has it
    double start = 0;            ///< seconds on the file's clock at which its first frame stands
    std::array<float, 3> colour = {0.8f, 0.8f, 0.8f};  ///< of its body, linear RGB, 0 … 1
};

/// The figures as one binary glTF 2.0 file (.glb): per figure a node with its skeleton (every joint
/// and End Site a node, named as in the clip), a body of capsules skinned to it, and in one common
/// animation named `title` a rotation track for each joint that turns and a translation track for
/// joint 0. Throws Error if nothing is to be written or it would be beyond 4 GB.
std::string glbBytes(std::span<const GltfFigure> figures, const std::string& title,
                     const Progress& progress = {});

}  // namespace kumite
