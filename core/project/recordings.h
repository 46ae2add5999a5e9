#pragma once

#include <compare>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/formats/recording.h"

namespace kumite {

/// A recording as a project names it: the file and, for an .amc, its skeleton.
struct RecordingKey {
    std::filesystem::path path;
    std::filesystem::path asf;

    auto operator<=>(const RecordingKey&) const = default;
};

/// A recording that was read, or the sentence that says why it could not be.
struct ReadResult {
    std::shared_ptr<const Recording> recording;
    std::string error;
};

/// Reads recordings side by side, each file once. Only a cancel is thrown.
std::map<RecordingKey, ReadResult> readRecordings(std::vector<RecordingKey> keys,
                                                  const Progress& progress = {});

}  // namespace kumite
