#include "core/project/recordings.h"

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "core/base/parallel.h"

namespace kumite {

namespace {

/// Files that together are larger are read one after the other: a file's text and its numbers are
/// both in memory while it is read, and an hour of two fighters shall fit into 2 GB.
constexpr std::uintmax_t kSideBySideBytes = 256u << 20;

std::uintmax_t totalSize(const std::vector<RecordingKey>& keys) {
    std::uintmax_t sum = 0;
    for (const RecordingKey& key : keys) {
        std::error_code unknown;
        const auto size = std::filesystem::file_size(key.path, unknown);
        if (!unknown) sum += size;
    }
    return sum;
}

}  // namespace

std::map<RecordingKey, ReadResult> readRecordings(std::vector<RecordingKey> keys,
                                                  const Progress& progress) {
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<ReadResult> results(keys.size());
    const int count = static_cast<int>(keys.size());
    const int inOneBlock = totalSize(keys) > kSideBySideBytes ? count : 1;
    forBlocks({0, count}, inOneBlock, [&](FrameRange block) {
        for (int k = block.begin; k < block.end; ++k) {
            const auto i = static_cast<std::size_t>(k);
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
        }
    });
    std::map<RecordingKey, ReadResult> byKey;
    for (std::size_t i = 0; i < keys.size(); ++i)
        byKey[keys[i]] = std::move(results[i]);
    return byKey;
}

}  // namespace kumite
