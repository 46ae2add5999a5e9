#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/editing/key_track.h"

namespace kumite {

/// The pose of a clip of that name at a frame of its file or take. Throws Error that says what
/// there is.
using PoseSource = std::function<Pose(const std::string& clip, int frame)>;

/// Reads keys.json (schema: README.md of this folder) into key poses of `rig`. Keys may stand in
/// any order. Throws InputError that names the place: what is missing or of the wrong kind, two
/// keys in one frame, joints that the skeleton does not have, handles out of reach of the body.
KeyTrack parseKeys(std::string_view text, const std::string& file, std::shared_ptr<const Rig> rig,
                   const PoseSource& poses);

/// Such a file that names no clip: every joint's rotation as a quaternion. parseKeys gives back the
/// same track.
std::string keysText(const KeyTrack& track);

}  // namespace kumite
