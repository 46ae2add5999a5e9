#include "core/project/versions.h"

#include <algorithm>
#include <ctime>

#include <sys/stat.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"

namespace kumite {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

constexpr std::string_view kSuffix = ".kumite";

Clock::time_point modified(const fs::path& file) {
    struct stat info {};
    if (::stat(file.c_str(), &info) != 0) return Clock::now();
    const auto since =
        std::chrono::seconds(info.st_mtim.tv_sec) + std::chrono::nanoseconds(info.st_mtim.tv_nsec);
    return Clock::time_point(std::chrono::duration_cast<Clock::duration>(since));
}

/// A version's file name is the moment it was saved, in UTC: "20080131T174502.123456.kumite".
/// Names sort as the moments do.
std::string nameOf(Clock::time_point saved) {
    const auto micro =
        std::chrono::duration_cast<std::chrono::microseconds>(saved.time_since_epoch()).count();
    const std::time_t seconds = micro / 1'000'000;
    std::tm utc{};
    ::gmtime_r(&seconds, &utc);
    return fmt::format("{:04}{:02}{:02}T{:02}{:02}{:02}.{:06}{}", utc.tm_year + 1900,
                       utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec,
                       micro % 1'000'000, kSuffix);
}

std::optional<Clock::time_point> timeOf(const std::string& name) {
    constexpr std::size_t kLength = 22;
    if (name.size() != kLength + kSuffix.size() || !name.ends_with(kSuffix) || name[8] != 'T' ||
        name[15] != '.') {
        return std::nullopt;
    }
    const auto part = [&](std::size_t at, std::size_t length) {
        return parseInteger(std::string_view(name).substr(at, length)).value_or(-1);
    };
    std::tm utc{};
    utc.tm_year = part(0, 4) - 1900;
    utc.tm_mon = part(4, 2) - 1;
    utc.tm_mday = part(6, 2);
    utc.tm_hour = part(9, 2);
    utc.tm_min = part(11, 2);
    utc.tm_sec = part(13, 2);
    const int micro = part(16, 6);
    if (utc.tm_year < 0 || micro < 0) return std::nullopt;
    return Clock::from_time_t(::timegm(&utc)) + std::chrono::microseconds(micro);
}

/// Files of versions by name, which is by time, the oldest first.
std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code none;  // a folder that is not there holds no versions
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        if (timeOf(entry.path().filename().string())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

fs::path folderOf(const fs::path& project) {
    return fs::weakly_canonical(project).parent_path();
}

Project parseVersion(const fs::path& project, const fs::path& file) {
    const FileBytes text(file);
    return parseProject(text.bytes(), file.string(), folderOf(project));
}

}  // namespace

fs::path versionsFolder(const fs::path& project) {
    return folderOf(project) / ".kumite-versions" / fs::weakly_canonical(project).filename();
}

void keepVersion(const fs::path& project, std::string_view next) {
    std::error_code unknown;
    if (!fs::is_regular_file(project, unknown)) return;
    const FileBytes now(project);
    if (now.bytes() == next || now.bytes().empty()) return;
    const fs::path folder = versionsFolder(project);
    std::vector<fs::path> files = filesIn(folder);
    if (!files.empty() && FileBytes(files.back()).bytes() == now.bytes()) return;
    std::error_code refused;
    fs::create_directories(folder, refused);
    if (refused) {
        throw Error(folder.string() + ": cannot make this folder: " + refused.message() + ".");
    }
    Clock::time_point saved = modified(project);
    // Where the clock was set back it must not become the oldest, which goes first.
    if (!files.empty()) {
        saved = std::max(saved,
                         *timeOf(files.back().filename().string()) + std::chrono::microseconds(1));
    }
    files.push_back(folder / nameOf(saved));
    writeFileAtomically(files.back(), now.bytes());
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + kKeptVersions < files.size(); ++i)
        fs::remove(files[i], unknown);
}

std::vector<KeptVersion> keptVersions(const fs::path& project) {
    std::vector<KeptVersion> versions;
    for (const fs::path& file : filesIn(versionsFolder(project))) {
        KeptVersion version;
        version.file = file;
        version.saved = *timeOf(file.filename().string());
        try {
            const Project held = parseVersion(project, file);
            version.takes = static_cast<int>(held.takes.size());
            for (const Take& take : held.takes) {
                for (const Fighter& fighter : take.fighters) {
                    version.corrections += static_cast<int>(fighter.corrections.size());
                }
            }
        } catch (const std::exception& error) {
            version.problem = error.what();
        }
        versions.push_back(std::move(version));
    }
    std::reverse(versions.begin(), versions.end());
    return versions;
}

LoadedProject loadVersion(const fs::path& project, const KeptVersion& version, const Project& known,
                          const Progress& progress) {
    return loadRecordings(parseVersion(project, version.file), folderOf(project), known, progress);
}

}  // namespace kumite
