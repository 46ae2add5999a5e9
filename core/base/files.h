#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kumite {

/// A file's bytes, mapped read-only for as long as the object lives. Errors name the path and the
/// system's reason.
class MappedFile {
public:
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::string_view bytes() const { return {data_, size_}; }

private:
    const char* data_ = nullptr;
    std::size_t size_ = 0;
};

/// What a written file outlives: the end of the program at any instant, or a power cut too, for
/// which the disk must be waited for.
enum class Outlives { Program, PowerCut };

/// Writes `content` so that a reader, or a crash at any moment, sees either the old file or the
/// whole new one: a temporary file beside it, flushed to disk, renamed over it. A link is followed;
/// what is no regular file (a pipe, /dev/stdout) is written straight. Throws Error; the old file is
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
