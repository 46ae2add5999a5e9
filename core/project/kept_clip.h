#pragma once

#include <filesystem>
#include <string>

#include "core/motion/motion_library.h"
#include "core/project/edits.h"

namespace kumite {

/// A made motion that became a take.
struct KeptClip {
    Edit edit;
    std::filesystem::path file;
};
/// Writes a clip of the library's rig as NAME.bvh into `folder` and adds it as a take of one
/// fighter, at the clip's rate, its floor at 0. The file must not be there yet. Throws Error; then
/// neither file nor project changed. Cancellable.
KeptClip keepClip(const Project& project, const MotionLibrary& library, const Clip& clip,
                  const std::string& name, const std::filesystem::path& folder,
                  const Progress& progress = {});

/// The clip as a BVH file with the skeleton and the conventions of the library.
std::string clipText(const MotionLibrary& library, const Clip& clip, const Progress& progress = {});

}  // namespace kumite
