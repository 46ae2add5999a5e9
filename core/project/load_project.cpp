#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/project/project_file.h"
#include "core/project/recordings.h"

namespace kumite {
namespace {

/// Files looked at when a recording is searched: enough for a bout's folders, not for a disk.
constexpr int kMostFiles = 5000;

/// A file below `folder` with the wanted content, first of all one of the old name.
std::optional<std::filesystem::path> findByContent(const std::filesystem::path& folder,
                                                   const RecordingRef& wanted) {
    // An .amc's hash covers two files, so it cannot be searched by content.
    if (wanted.sha256.empty() || !wanted.asf.empty()) return std::nullopt;
    const std::string suffix = lowerCase(wanted.path.extension().string());
    std::vector<std::filesystem::path> candidates;
    std::error_code error;
    int seen = 0;
    using Walk = std::filesystem::recursive_directory_iterator;
    constexpr auto kSkip = std::filesystem::directory_options::skip_permission_denied;
    for (Walk it(folder, kSkip, error), end; !error && it != end && seen < kMostFiles;
         it.increment(error), ++seen) {
        if (it->is_regular_file(error) && lowerCase(it->path().extension().string()) == suffix) {
            candidates.push_back(it->path());
        }
    }
    std::sort(candidates.begin(), candidates.end());
    std::stable_partition(candidates.begin(), candidates.end(), [&](const auto& path) {
        return path.filename() == wanted.path.filename();
    });
    for (const auto& path : candidates) {
        try {
            if (sha256(MappedFile(path).bytes()) == wanted.sha256) return path;
        } catch (const Error&) {
            // Unreadable: not the one.
        }
    }
    return std::nullopt;
}

void locate(RecordingRef& recording, const std::filesystem::path& folder, Findings& findings) {
    if (std::filesystem::exists(recording.path)) return;
    const auto found = findByContent(folder, recording);
    if (!found) return;
    findings.push_back(
        note(fmt::format("{} was not where the project says; the same recording was "
                         "found at {}.",
                         recording.path.string(), found->string())));
    recording.path = *found;
}

/// Makes the roles' joint indices fit the skeleton that was read: the names decide.
void checkRoles(Fighter& fighter, Findings& findings) {
    const Skeleton& skeleton = *fighter.motion->skeleton;
    for (const auto& [role, name] : fighter.roleNames) {
        const int joint = *fighter.roles[role];
        const bool fits = joint < skeleton.jointCount() &&
                          skeleton.joints[static_cast<std::size_t>(joint)].name == name;
        if (fits) continue;
        const int other = skeleton.find(name);
        if (other >= 0) {
            fighter.roles.set(role, other);
        } else {
            fighter.roles.clear(role);
            findings.push_back(
                warning(fmt::format("{}: joint \"{}\" is gone; the role {} has no joint now.",
                                    fighter.recording.path.string(), name, roleName(role))));
        }
    }
    fighter.roleNames.clear();
}

void attach(Fighter& fighter, const ReadResult& read, Findings& findings) {
    const std::string file = fighter.recording.path.string();
    if (!read.recording) {
        findings.push_back(warning(
            std::filesystem::exists(fighter.recording.path)
                ? read.error
                : file + ": the recording is missing; put it back or relink it. Its corrections "
                         "are kept."));
        return;
    }
    std::shared_ptr<const Motion> motion;
    try {
        motion = motionOfRoot(*read.recording, fighter.recording.root);
    } catch (const Error& error) {
        findings.push_back(warning(file + ": " + error.what()));
        return;
    }
    if (fighter.frames.begin >= motion->frameCount) {
        findings.push_back(warning(fmt::format(
            "{}: holds {} frames now, the take begins at frame {}; the recording is left out.",
            file, motion->frameCount, fighter.frames.begin)));
        return;
    }
    if (fighter.recording.sha256 != read.recording->sha256) {
        findings.push_back(
            warning(file + ": the recording has changed since the project was saved; check the "
                           "boundaries."));
        fighter.recording.sha256 = read.recording->sha256;
    }
    if (fighter.frames.end > motion->frameCount) {
        findings.push_back(warning(fmt::format("{}: holds {} frames now; the take ends there.",
                                               file, motion->frameCount)));
        fighter.frames.end = motion->frameCount;
    }
    fighter.motion = std::move(motion);
    checkRoles(fighter, findings);
}

}  // namespace

LoadedProject loadProject(const std::filesystem::path& path, const Progress& progress) {
    const auto folder = std::filesystem::absolute(path).lexically_normal().parent_path();
    LoadedProject loaded;
    {
        const MappedFile file(path);
        loaded.project = parseProject(file.bytes(), path.string(), folder);
    }
    std::vector<RecordingKey> keys;
    for (Take& take : loaded.project.takes) {
        for (Fighter& fighter : take.fighters) {
            locate(fighter.recording, folder, loaded.findings);
            keys.push_back({fighter.recording.path, fighter.recording.asf});
        }
    }
    const auto recordings = readRecordings(keys, progress);
    for (Take& take : loaded.project.takes) {
        for (Fighter& fighter : take.fighters) {
            attach(fighter, recordings.at({fighter.recording.path, fighter.recording.asf}),
                   loaded.findings);
        }
    }
    return loaded;
}

}  // namespace kumite
