#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace kumite {

/// A file's bytes, read whole: a mapped file that another program cuts short meanwhile would end
/// this one. Errors name the path and the system's reason.
class FileBytes {
public:
    explicit FileBytes(const std::filesystem::path& path);

    std::string_view bytes() const { return {data_.get(), size_}; }

private:
    std::unique_ptr<char[]> data_;
    std::size_t size_ = 0;
};

/// What a written file outlives: the end of the program at any instant, or a power cut too, for
/// which the disk must be waited for.
enum class Outlives { Program, PowerCut };

/// Writes `content` so that a reader, or a crash at any moment, sees either the old file or the
/// whole new one: a temporary file beside it, flushed to disk, renamed over it. A link is followed;
/// what is no regular file (a pipe, /dev/stdout) is written straight. Temporary files that a crash
/// left there are taken away where a power cut is to be outlived. Throws Error; the old file is
/// then as it was. Any thread.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                         Outlives outlives = Outlives::PowerCut);

/// Throws Error if `output` is one of the files that are read: a result must never replace its
/// source.
void refuseToOverwrite(const std::filesystem::path& output,
                       const std::vector<std::filesystem::path>& sources);

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace kumite
