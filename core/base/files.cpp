#include "core/base/files.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <openssl/evp.h>

#include "core/base/error.h"

namespace kumite {
namespace {

/// "cannot WHAT PATH: why the system refused".
Error systemError(const std::string& what, const std::filesystem::path& path) {
    return Error(path.string() + ": cannot " + what + ": " + std::strerror(errno) + ".");
}

/// Closes a file descriptor at the end of its scope.
struct Descriptor {
    int number = -1;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

/// False, with errno set, if not all could be written.
bool writeAll(int file, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

constexpr std::string_view kTemporary = ".kumite-";
constexpr std::string_view kPart = ".part";
constexpr auto kForgotten = std::chrono::minutes(10);

/// Removes temporary files beside `mine` that nobody can be writing any more, going by the clock of
/// the disk that holds them.
void removeForgotten(const std::filesystem::path& mine) {
    namespace fs = std::filesystem;
    std::error_code unknown;  // what cannot be looked at stays
    const fs::file_time_type now = fs::last_write_time(mine, unknown);
    if (unknown) return;
    const fs::path folder = mine.has_parent_path() ? mine.parent_path() : ".";
    for (fs::directory_iterator entry(folder, unknown); entry != fs::directory_iterator();
         entry.increment(unknown)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(kTemporary) || !name.ends_with(kPart)) continue;
        std::error_code gone;
        const fs::file_time_type written = entry->last_write_time(gone);
        if (!gone && now - written > kForgotten) fs::remove(entry->path(), gone);
    }
}

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& path) {
    std::error_code unknown;  // what cannot be examined fails below, with the system's reason
    if (std::filesystem::is_directory(path, unknown)) {
        throw Error(path.string() + ": is a folder, expected a file.");
    }
    // Without O_NONBLOCK the opening of a pipe that nobody writes would never return.
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    if (file.number < 0) throw systemError("read", path);
    struct stat info {};
    if (::fstat(file.number, &info) != 0) throw systemError("read", path);
    if (!S_ISREG(info.st_mode)) {
        throw Error(path.string() + ": is no regular file; save it as one first.");
    }
    const auto expected = static_cast<std::size_t>(info.st_size);
    data_ = std::make_unique_for_overwrite<char[]>(expected);
    while (size_ < expected) {
        const ssize_t got = ::read(file.number, data_.get() + size_, expected - size_);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw systemError("read", path);
        if (got == 0) return;  // it was cut short meanwhile
        size_ += static_cast<std::size_t>(got);
    }
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                         Outlives outlives) {
    // A link is followed: the file it points to is replaced, the link stays.
    std::filesystem::path target = path;
    std::error_code unknown;  // what cannot be looked at fails below, with the system's reason
    if (std::filesystem::is_symlink(path, unknown)) {
        const auto pointedTo = std::filesystem::weakly_canonical(path, unknown);
        if (!unknown) target = pointedTo;
    }
    const auto kind = std::filesystem::status(target, unknown).type();
    if (kind == std::filesystem::file_type::directory) {
        throw Error(path.string() + ": is a folder, expected a file to write.");
    }
    const bool isSpecial = kind != std::filesystem::file_type::regular &&
                           kind != std::filesystem::file_type::not_found;
    if (isSpecial) {
        const Descriptor file{::open(target.c_str(), O_WRONLY | O_CLOEXEC)};
        if (file.number < 0 || !writeAll(file.number, content)) throw systemError("write", path);
        return;
    }
    static std::atomic<int> number = 0;  // two threads may write into one folder
    const std::filesystem::path temporary =
        target.parent_path() / (std::string(kTemporary) + std::to_string(::getpid()) + "-" +
                                std::to_string(++number) + std::string(kPart));

    const auto giveUp = [&](const std::string& what) {
        Error error = systemError(what, path);
        ::unlink(temporary.c_str());
        return error;
    };
    {
        Descriptor file{::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
        if (file.number < 0) throw systemError("write", path);
        struct stat old {};
        if (::stat(target.c_str(), &old) == 0) ::fchmod(file.number, old.st_mode & 0777);
        if (!writeAll(file.number, content)) throw giveUp("write");
        if (outlives == Outlives::PowerCut && ::fsync(file.number) != 0) throw giveUp("write");
    }
    if (outlives == Outlives::PowerCut) removeForgotten(temporary);
    if (::rename(temporary.c_str(), target.c_str()) != 0) throw giveUp("write");
    if (outlives == Outlives::Program) return;
    // The rename itself must survive a power cut, too; where a folder cannot be synced, it is not.
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    const Descriptor directory{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (directory.number >= 0) ::fsync(directory.number);
}

void refuseToOverwrite(const std::filesystem::path& output,
                       const std::vector<std::filesystem::path>& sources) {
    for (const std::filesystem::path& source : sources) {
        std::error_code notBoth;
        if (!std::filesystem::equivalent(output, source, notBoth) || notBoth) continue;
        throw Error(output.string() + ": is what is read here; write to another file.");
    }
}

std::string sha256(std::string_view bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int length = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) !=
        1) {
        throw Error("The system's OpenSSL library cannot compute SHA-256.");
    }
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < length; ++i) {
        text += kDigits[digest[i] >> 4];
        text += kDigits[digest[i] & 15];
    }
    return text;
}

}  // namespace kumite
