#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/json_text.h"
#include "core/project/project_file.h"
#include "core/project/recordings.h"

namespace kumite {
namespace {

/// Files looked at when a recording is searched: enough for a bout's folders, not for a disk.
constexpr int kMostFiles = 5000;

/// Files below `folder` with the suffix of `wanted`, those of its name first, then by name.
std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder,
                                              const std::filesystem::path& wanted) {
    const std::string suffix = lowerCase(wanted.extension().string());
    std::vector<std::filesystem::path> files;
    std::error_code error;
    int seen = 0;
    using Walk = std::filesystem::recursive_directory_iterator;
    constexpr auto kSkip = std::filesystem::directory_options::skip_permission_denied;
    for (Walk it(folder, kSkip, error), end; !error && it != end && seen < kMostFiles;
         it.increment(error), ++seen) {
        if (it->is_regular_file(error) && lowerCase(it->path().extension().string()) == suffix) {
            files.push_back(it->path());
        }
    }
    std::sort(files.begin(), files.end());
    std::stable_partition(files.begin(), files.end(),
                          [&](const auto& path) { return path.filename() == wanted.filename(); });
    return files;
}

/// SHA-256 as the recording has it: of the skeleton's bytes, if there is one, and the motion's.
std::string hashOf(const std::filesystem::path& asf, const std::filesystem::path& path) {
    try {
        const FileBytes motion(path);
        if (asf.empty()) return sha256(motion.bytes());
        return sha256(std::string(FileBytes(asf).bytes()).append(motion.bytes()));
    } catch (const Error&) {
        return {};  // unreadable: not the one
    }
}

/// Finds a recording that is not where the project says by its content, in the project's folder
/// and below.
void locate(RecordingRef& recording, const std::filesystem::path& folder, Findings& findings) {
    const bool hasAsf = !recording.asf.empty();
    const bool isThere = std::filesystem::exists(recording.path) &&
                         (!hasAsf || std::filesystem::exists(recording.asf));
    if (isThere || recording.path.empty()) return;
    const auto skeletons = hasAsf ? filesBelow(folder, recording.asf)
                                  : std::vector<std::filesystem::path>{std::filesystem::path()};
    for (const auto& path : filesBelow(folder, recording.path)) {
        for (const auto& asf : skeletons) {
            if (hashOf(asf, path) != recording.sha256) continue;
            findings.push_back(note(fmt::format(
                "{} was not where the project says; the same recording was found at {}.",
                recording.path.string(), path.string())));
            recording.path = path;
            recording.asf = asf;
            return;
        }
    }
}

/// Makes the roles' joint indices fit a skeleton that changed: the names decide.
void matchRolesByName(Fighter& fighter, Findings& findings) {
    const Skeleton& skeleton = *fighter.motion->skeleton;
    for (const auto& [role, name] : fighter.roleNames) {
        const int joint = *fighter.roles[role];
        const bool fits = joint < skeleton.jointCount() &&
                          asStored(skeleton.joints[static_cast<std::size_t>(joint)].name) == name;
        if (fits) continue;
        const auto named = std::find_if(skeleton.joints.begin(), skeleton.joints.end(),
                                        [&, &wanted = name](const Joint& candidate) {
                                            return asStored(candidate.name) == wanted;
                                        });
        if (named != skeleton.joints.end()) {
            fighter.roles.set(role, static_cast<int>(named - skeleton.joints.begin()));
        } else {
            fighter.roles.clear(role);
            findings.push_back(
                warning(fmt::format("{}: joint \"{}\" is gone; the role {} has no joint now.",
                                    fighter.recording.path.string(), name, roleName(role))));
        }
    }
}

void attach(Fighter& fighter, const ReadResult& read, Findings& findings) {
    const std::string file = fighter.recording.path.string();
    if (!read.recording) {
        findings.push_back(warning(
            std::filesystem::exists(fighter.recording.path)
                ? read.error + " The recording is left out; its corrections are kept."
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
    const bool changed = fighter.recording.sha256 != read.recording->sha256;
    if (changed) {
        findings.push_back(
            warning(file +
                    ": the recording has changed since it became part of the project; check the "
                    "boundaries, then relink it to accept the change."));
    }
    if (fighter.frames.end > motion->frameCount) {
        findings.push_back(warning(fmt::format("{}: holds {} frames now; the take ends there.",
                                               file, motion->frameCount)));
    }
    fighter.motion = std::move(motion);
    if (changed) matchRolesByName(fighter, findings);
    fighter.roleNames.clear();
}

/// The motion of a recording that another project has in memory; null: none has.
std::shared_ptr<const Motion> motionKnown(const Project& known, const RecordingRef& recording) {
    for (const Take& take : known.takes) {
        for (const Fighter& fighter : take.fighters) {
            if (fighter.motion && fighter.recording == recording) return fighter.motion;
        }
    }
    return nullptr;
}

}  // namespace

LoadedProject loadProject(const std::filesystem::path& path, const Progress& progress) {
    const auto folder = std::filesystem::weakly_canonical(path).parent_path();
    Project project;
    {
        const FileBytes file(path);
        project = parseProject(file.bytes(), path.string(), folder);
    }
    return loadRecordings(std::move(project), folder, {}, progress);
}

LoadedProject loadRecordings(Project project, const std::filesystem::path& folder,
                             const Project& known, const Progress& progress) {
    LoadedProject loaded;
    loaded.project = std::move(project);
    std::vector<RecordingKey> keys;
    std::vector<Fighter*> waiting;
    for (Take& take : loaded.project.takes) {
        for (Fighter& fighter : take.fighters) {
            fighter.motion = motionKnown(known, fighter.recording);
            if (fighter.motion) {
                matchRolesByName(fighter, loaded.findings);
                fighter.roleNames.clear();
                continue;
            }
            locate(fighter.recording, folder, loaded.findings);
            keys.push_back({fighter.recording.path, fighter.recording.asf});
            waiting.push_back(&fighter);
        }
    }
    const auto recordings = readRecordings(keys, progress);
    for (Fighter* fighter : waiting) {
        attach(*fighter, recordings.at({fighter->recording.path, fighter->recording.asf}),
               loaded.findings);
    }
    return loaded;
}

}  // namespace kumite
