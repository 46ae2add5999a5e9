#include "core/project/kept_clip.h"

#include "core/base/files.h"
#include "core/formats/bvh.h"
#include "core/project/import.h"
#include "core/project/made_takes.h"
#include "core/project/new_files.h"

namespace kumite {

std::string clipText(const MotionLibrary& library, const Clip& clip, const Progress& progress) {
    const Motion motion = motionOf(clip, library.skeleton, library.space, progress);
    return bvhText(motion, motion.frames(), motion.frameTime);
}

KeptClip keepClip(const Project& project, const MotionLibrary& library, const Clip& clip,
                  const std::string& name, const std::filesystem::path& folder,
                  const Progress& progress) {
    // Says early if the name cannot be used.
    Take named;
    named.name = name;
    named.fighters.resize(1);
    addTake(project, named);

    NewFiles written({folder / (name + ".bvh")});
    const std::filesystem::path& file = written.paths().front();
    writeFileAtomically(file, clipText(library, clip, progress.part(0, 0.6)));
    TakeRequest request;
    request.name = name;
    request.rate = clip.rate;
    request.trim = FrameRange{0, -1};
    FighterRequest fighter;
    fighter.path = file;
    fighter.metresPerUnit = library.space.metresPerUnit;
    fighter.up = library.space.up;
    fighter.floor = 0;
    request.fighters.push_back(fighter);
    Take take = importTake(request, progress.part(0.6, 1)).take;
    take.fighters.front().roles = library.rig->roles;
    KeptClip kept{*addMadeTake(project, take), file};
    kept.edit.name = "Keep motion as take " + name;
    written.stay();
    return kept;
}

}  // namespace kumite
