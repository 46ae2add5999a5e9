#include "core/project/library.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/labelling/label.h"
#include "core/motion/blend.h"
#include "core/motion/feet.h"
#include "core/motion/retarget.h"
#include "core/project/import.h"
#include "core/project/labels.h"
#include "core/project/made_takes.h"
#include "core/project/project_file.h"

namespace kumite {
namespace {

constexpr double kSlowest = 5, kFastest = 240;  ///< Hz
constexpr std::size_t kNamesInMessage = 12;

/// Puts motions into a library one by one.
class Builder {
public:
    explicit Builder(const LibrarySettings& settings) {
        if (!(settings.rate >= kSlowest && settings.rate <= kFastest)) {
            throw Error(
                fmt::format("A library's rate lies between {:g} and {:g} Hz.", kSlowest, kFastest));
        }
        loaded_.library.rate = settings.rate;
    }

    /// Index of the new motion; −1 if it has no body or no frame.
    int add(const std::string& name, const Fighter& fighter, const Progress& progress) {
        const Skeleton& skeleton = *fighter.motion->skeleton;
        const FrameRange frames = kumite::framesOf(fighter);
        if (!footPoint(skeleton, fighter.roles, true) ||
            !footPoint(skeleton, fighter.roles, false)) {
            find({warning("has no body with two legs; it is left out.")}, name);
            return -1;
        }
        if (frames.empty()) return -1;
        find(rigLosses(*fighter.motion, frames, fighter.space, fighter.roles), name);
        Clip clip =
            clipOf(*fighter.motion, frames, fighter.space, fighter.roles, fighter.rate, progress);
        clip = resampled(clip, loaded_.library.rate);
        settle(clip, fighter.floor);
        MotionLibrary& library = loaded_.library;
        if (!library.rig) {
            library.rig = clip.rig;
            library.skeleton = fighter.motion->skeleton;
            library.space = fighter.space;
            const JointPositions positions = positionsOf(clip);
            for (const bool isLeft : {true, false}) {
                library.feet.floor[isLeft ? 0 : 1] =
                    restHeight(positions, *footPoint(*clip.rig, isLeft));
            }
        } else {
            Findings losses;
            clip = retargeted(clip, library.rig, &losses);
            find(losses, name);
        }
        LibraryMotion& motion = library.motions.emplace_back();
        motion.name = name;
        motion.sourceRate = fighter.rate;
        motion.standing = standingOf(clip);
        motion.clip = std::move(clip);
        return static_cast<int>(library.motions.size()) - 1;
    }

    void addFile(const std::filesystem::path& path, const Progress& progress) {
        TakeRequest request;
        request.fighters.push_back({});
        request.fighters.front().path = path;
        const ImportedTake imported = importTake(request, progress.part(0, 0.7));
        read({path});
        for (const Finding& finding : imported.findings) {
            if (finding.severity == Severity::Warning) loaded_.findings.push_back(finding);
        }
        const std::string name = unique(path.stem().string());
        const int motion = add(name, imported.take.fighters.front(), progress.part(0.7, 1));
        if (motion < 0) return;
        const int frames =
            loaded_.library.motions[static_cast<std::size_t>(motion)].clip.frameCount();
        loaded_.library.actions.push_back({name, "", motion, {0, frames}});
    }

    void addFolder(const std::filesystem::path& folder, const Progress& progress) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(
                 folder, std::filesystem::directory_options::skip_permission_denied)) {
            const std::string suffix = lowerCase(entry.path().extension().string());
            if (entry.is_regular_file() && (suffix == ".bvh" || suffix == ".amc"))
                files.push_back(entry.path());
        }
        std::sort(files.begin(), files.end());
        for (std::size_t i = 0; i < files.size(); ++i) {
            const double count = static_cast<double>(files.size());
            const double at = static_cast<double>(i);
            try {
                addFile(files[i], progress.part(at / count, (at + 1) / count));
            } catch (const Cancelled&) {
                throw;
            } catch (const Error& error) {
                loaded_.findings.push_back(
                    warning(fmt::format("{} It is left out.", error.what())));
            }
        }
    }

    /// `isOpen`: motions know which take they are.
    void addProject(const Project& project, const Analysis& analysis, const Progress& progress,
                    bool isOpen = false) {
        const double count = std::max(1.0, static_cast<double>(project.takes.size()));
        const auto made = madeRecordings(project);
        for (std::size_t t = 0; t < project.takes.size(); ++t) {
            const Take& take = project.takes[t];
            const std::string name = unique(take.name);
            for (std::size_t p = 0; p < take.fighters.size(); ++p) {
                if (!take.fighters[p].motion) continue;
                const double at = static_cast<double>(t);
                const int motion = addFighter(
                    project, analysis, {static_cast<int>(t), static_cast<int>(p)},
                    fmt::format("{}:{}", name, p + 1), progress.part(at / count, (at + 1) / count));
                if (motion < 0) continue;
                auto& added = loaded_.library.motions[static_cast<std::size_t>(motion)];
                added.made = isMade(made, take);
                if (!isOpen) continue;
                added.take = static_cast<int>(t);
                added.player = static_cast<int>(p);
            }
        }
    }

    /// A motion file, a folder of them, or a project; `withClips`: what that names beside its
    /// takes, too.
    void addSource(const std::filesystem::path& path, bool withClips, const Progress& progress) {
        progress.update(0);
        if (std::filesystem::is_directory(path)) {
            addFolder(path, progress);
        } else if (lowerCase(path.extension().string()) == ".kumite") {
            const LoadedProject loaded = loadProject(path, progress.part(0, 0.5));
            read({path});
            read(recordingFiles(loaded.project));
            const Analysis analysis = analyse(loaded.project, {}, progress.part(0.5, 0.8));
            addProject(loaded.project, analysis, progress.part(0.8, 0.9));
            if (withClips) addClips(loaded.project, progress.part(0.9, 1));
            find(loaded.findings, path.filename().string());
        } else {
            addFile(path, progress);
        }
    }

    /// The clips that a project names beside its takes; one that cannot be read is left out.
    void addClips(const Project& project, const Progress& progress) {
        const double count = static_cast<double>(project.clips.size());
        for (std::size_t i = 0; i < project.clips.size(); ++i) {
            const double at = static_cast<double>(i);
            try {
                addSource(project.clips[i], false, progress.part(at / count, (at + 1) / count));
            } catch (const Cancelled&) {
                throw;
            } catch (const std::exception& error) {
                loaded_.findings.push_back(
                    warning(fmt::format("{} It is left out.", error.what())));
            }
        }
    }

    void find(const Findings& findings, const std::string& name) {
        for (const Finding& finding : findings)
            loaded_.findings.push_back({finding.severity, name + ": " + finding.text});
    }

    void read(const std::vector<std::filesystem::path>& files) {
        loaded_.files.insert(loaded_.files.end(), files.begin(), files.end());
    }

    LoadedLibrary finish() && {
        if (loaded_.library.motions.empty())
            throw Error("The library is empty: no source holds the motion of a body.");
        return std::move(loaded_);
    }

private:
    /// Index of its motion; −1 if there is none.
    int addFighter(const Project& project, const Analysis& analysis, FighterAddress address,
                   const std::string& name, const Progress& progress) {
        const Fighter& fighter = fighterAt(project, address);
        const FighterAnalysis& values = analysis.at(address);
        const int motion = add(name, fighter, progress);
        if (motion < 0) return motion;
        const int last =
            loaded_.library.motions[static_cast<std::size_t>(motion)].clip.frameCount() - 1;
        const auto frameAt = [&](int frame) {
            const double seconds = frame / fighter.rate;
            return std::clamp(static_cast<int>(std::lround(seconds * loaded_.library.rate)), 0,
                              last);
        };
        const Vocabulary& vocabulary = *project.labelling.vocabulary;
        const auto labels = actionLabels(fighter, values, vocabulary.size());
        for (std::size_t i = 0; i < values.segmentation->actions.size(); ++i) {
            const kumite::Action& action = values.segmentation->actions[i];
            loaded_.library.actions.push_back(
                {fmt::format("{}:{}", name, i),
                 labels[i].anyKnown() ? labelText(vocabulary, labels[i].label()) : std::string(),
                 motion,
                 {frameAt(action.begin), frameAt(action.end) + 1}});
        }
        return motion;
    }

    /// A name that no file or take of the library has yet.
    std::string unique(const std::string& wished) {
        std::string name = wished;
        for (int n = 2; !names_.insert(name).second; ++n)
            name = fmt::format("{}#{}", wished, n);
        return name;
    }

    /// Shifts a clip so that its floor is at y = 0.
    static void settle(Clip& clip, std::optional<double> floor) {
        if (!floor) {
            const JointPositions positions = positionsOf(clip);
            floor = std::min(restHeight(positions, *footPoint(*clip.rig, true)),
                             restHeight(positions, *footPoint(*clip.rig, false)));
        }
        for (Pose& pose : clip.frames)
            pose.root.y() -= *floor;
    }

    LoadedLibrary loaded_;
    std::set<std::string> names_;
};

std::string knownNames(const MotionLibrary& library) {
    std::string text;
    for (std::size_t i = 0; i < library.actions.size() && i < kNamesInMessage; ++i)
        text += (i > 0 ? ", " : "") + library.actions[i].name;
    if (library.actions.size() > kNamesInMessage)
        text += fmt::format(" … ({} in all)", library.actions.size());
    return text;
}

/// The action or motion of exactly this name.
std::optional<LibraryAction> exactly(const MotionLibrary& library, std::string_view name) {
    for (const LibraryAction& action : library.actions) {
        if (action.name == name) return action;
    }
    for (std::size_t m = 0; m < library.motions.size(); ++m) {
        if (library.motions[m].name == name) {
            return LibraryAction{std::string(name),
                                 "",
                                 static_cast<int>(m),
                                 {0, library.motions[m].clip.frameCount()}};
        }
    }
    return std::nullopt;
}

}  // namespace

LoadedLibrary loadLibrary(const std::vector<std::filesystem::path>& sources,
                          const LibrarySettings& settings, const Progress& progress) {
    Builder builder(settings);
    const double count = std::max(1.0, static_cast<double>(sources.size()));
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const double at = static_cast<double>(i);
        const Progress part = progress.part(at / count, (at + 1) / count);
        builder.addSource(sources[i], true, part);
    }
    return std::move(builder).finish();
}

LoadedLibrary libraryOf(const Project& project, const Analysis& analysis,
                        const LibrarySettings& settings, const Progress& progress) {
    Builder builder(settings);
    builder.addProject(project, analysis, progress.part(0, 0.5), true);
    builder.addClips(project, progress.part(0.5, 1));
    return std::move(builder).finish();
}

LibraryAction actionNamed(const MotionLibrary& library, std::string_view name) {
    if (auto action = exactly(library, name)) return *action;
    const auto sign = name.rfind('@');
    const auto range = sign == std::string_view::npos ? std::string_view() : name.substr(sign + 1);
    const auto parts = split(range, ':');
    auto action =
        sign == std::string_view::npos ? std::nullopt : exactly(library, name.substr(0, sign));
    if (!action || parts.size() != 2) {
        throw Error(
            fmt::format("The library has no clip \"{}\"; it has {}.", name, knownNames(library)));
    }
    const LibraryMotion& motion = library.motions[static_cast<std::size_t>(action->motion)];
    const double perFrame = library.rate / motion.sourceRate;
    const auto frameIn = [&](std::string_view text) {
        const auto frame = parseInteger(text);
        if (!frame || *frame < 0)
            throw Error(fmt::format("\"{}\": expected frames as A:B after the @.", name));
        return *frame;
    };
    // Of what lies far behind the end it is enough to know that it does.
    const auto shown = [&](double frame) {
        return static_cast<int>(std::min(std::floor(frame * perFrame + 1e-6), 1e9));
    };
    // A file's frames count from its beginning; an action's name takes those of its take too.
    // The frame before the end is the last: where it is shown, that frame is the last, too.
    const FrameRange frames{
        parts[0].empty() ? action->frames.begin : shown(frameIn(parts[0]) + 0.5 / perFrame),
        parts[1].empty() ? action->frames.end : shown(frameIn(parts[1]) - 1.0) + 1};
    if (frames.empty() || frames.begin < action->frames.begin || frames.end > action->frames.end) {
        throw Error(fmt::format("\"{}\": these frames are not in it; it has {} to {}.", name,
                                std::lround(action->frames.begin / perFrame),
                                std::lround((action->frames.end - 1) / perFrame)));
    }
    action->name = name;
    action->frames = frames;
    return *action;
}

}  // namespace kumite
