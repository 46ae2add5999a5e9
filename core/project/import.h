#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/formats/recording.h"
#include "core/motion/survey.h"
#include "core/project/project.h"
#include "core/project/recordings.h"

namespace kumite {

/// What a user says about a file when it becomes a fighter; what is left out is found.
struct FighterRequest {
    std::filesystem::path path;
    std::optional<std::filesystem::path> asf;
    std::string root;
    std::optional<double> metresPerUnit;
    std::optional<UpAxis> up;
    double offset = 0;  ///< seconds
    Placement placement;
    std::optional<double> floor;
    /// Role → joint name, mends the mapping; an empty name: the skeleton has no such joint.
    std::vector<std::pair<Role, std::string>> roles;
};

struct TakeRequest {
    std::string name;  ///< empty: the first file's stem
    std::vector<FighterRequest> fighters;
    std::optional<double> rate;  ///< Hz; the headers are wrong
    /// Frames of the files that the take holds; replaces the detection of a leading T-pose. An
    /// end of -1 means the last frame of each file.
    std::optional<FrameRange> trim;
};

/// How a project names a recording that was read from `path`: absolute, links resolved. Throws
/// Error if the path is no text that a project file can hold.
RecordingRef referTo(const Recording& recording, const std::filesystem::path& path,
                     const std::string& root);

/// A take made of recordings, and what was found on the way (each text names its file).
struct ImportedTake {
    Take take;
    std::vector<Survey> surveys;  ///< of each fighter's whole recording
    Findings findings;
};

/// What has to be read for a request, in the order of its fighters.
std::vector<RecordingKey> recordingsOf(const TakeRequest& request);

/// Reads the files of a request and makes a take of them. Two files of equal length are taken as
/// recorded together: if either starts with a T-pose, both lose those frames. Throws Error.
ImportedTake importTake(const TakeRequest& request, const Progress& progress = {});
/// The same from recordings that were read before.
ImportedTake makeTake(const TakeRequest& request,
                      const std::map<RecordingKey, ReadResult>& recordings);

}  // namespace kumite
