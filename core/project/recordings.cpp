#include "core/project/recordings.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace kumite {

std::map<RecordingKey, ReadResult> readRecordings(std::vector<RecordingKey> keys,
                                                  const Progress& progress) {
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<ReadResult> results(keys.size());
    forBlocks({0, static_cast<int>(keys.size())}, 1, [&](FrameRange block) {
        const auto i = static_cast<std::size_t>(block.begin);
        ReadOptions options;
        if (!keys[i].asf.empty()) options.asf = keys[i].asf;
        try {
            results[i].recording =
                std::make_shared<Recording>(readRecording(keys[i].path, options, progress));
        } catch (const Cancelled&) {
            throw;
        } catch (const std::exception& error) {
            results[i].error = error.what();
        }
    });
    std::map<RecordingKey, ReadResult> byKey;
    for (std::size_t i = 0; i < keys.size(); ++i) byKey[keys[i]] = std::move(results[i]);
    return byKey;
}

}  // namespace kumite
