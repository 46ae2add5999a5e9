// A made motion kept as a take: the same poses, one file, nothing left behind where it failed.

#include "core/project/kept_clip.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/editing/assembly.h"
#include "core/formats/bvh.h"
#include "core/motion/blend.h"
#include "core/project/analysis.h"
#include "core/project/library.h"
#include "core/project/made_takes.h"
#include "core/project/placed_clip.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

/// A library of one recording, and a clip that is part of it.
struct Made {
    test::TemporaryFolder folder;
    LoadedLibrary loaded;
    Clip clip;

    Made() {
        const auto motion = test::bobbing(
            90, 60, [](double t) { return 0.03 * std::sin(2 * std::numbers::pi * 1.5 * t); });
        test::writeText(folder / "bob.bvh", bvhText(*motion, motion->frames(), motion->frameTime));
        loaded = loadLibrary({folder / "bob.bvh"}, {60});
        clip = loaded.library.motions[0].clip;
        clip.frames.erase(clip.frames.begin(), clip.frames.begin() + 20);
    }
};

TEST(KeptClip, IsATakeOfTheSamePoses) {
    Made made;
    const Project project = test::makeBout();
    const KeptClip kept =
        keepClip(project, made.loaded.library, made.clip, "mine", made.folder.path());
    EXPECT_EQ(kept.file, made.folder / "mine.bvh");
    EXPECT_EQ(kept.edit.name, "Keep motion as take mine");
    ASSERT_EQ(kept.edit.project.takes.size(), project.takes.size() + 1);
    const Take& take = kept.edit.project.takes.back();
    EXPECT_EQ(take.name, "mine");
    ASSERT_EQ(take.fighters.size(), 1u);

    EXPECT_TRUE(isMade(madeRecordings(kept.edit.project), take));
    EXPECT_FALSE(isMade(madeRecordings(kept.edit.project), project.takes[0]));
    const Analysis analysis = analyse(kept.edit.project);
    const auto library =
        std::make_shared<const MotionLibrary>(libraryOf(kept.edit.project, analysis).library);
    const KeyLibrary keys = keyLibrary(library);
    for (std::size_t m = 0; m < library->motions.size(); ++m) {
        const LibraryMotion& motion = library->motions[m];
        EXPECT_EQ(motion.made, motion.take == static_cast<int>(project.takes.size()));
        EXPECT_EQ(keys.features.clips[m].frames > 0, !motion.made) << "nothing is found in it";
    }
    const int index = static_cast<int>(project.takes.size());
    const Clip shown = placedClip(analysis.at({index, 0}));
    ASSERT_EQ(shown.frames.size(), made.clip.frames.size());
    EXPECT_NEAR(shown.rate, made.clip.rate, 1e-6);
    const JointPositions wanted = positionsOf(made.clip);
    const JointPositions found = positionsOf(shown);
    for (int frame : {0, 30, 69}) {
        for (int joint = 0; joint < wanted.jointCount; ++joint) {
            EXPECT_NEAR((found.at(frame, joint) - wanted.at(frame, joint)).norm(), 0, 1e-4)
                << frame << " " << joint;
        }
    }
}

TEST(KeptClip, NeverReplacesAFile) {
    Made made;
    test::writeText(made.folder / "mine.bvh", "precious");
    EXPECT_THROW(
        keepClip(test::makeBout(), made.loaded.library, made.clip, "mine", made.folder.path()),
        Error);
    EXPECT_EQ(test::readText(made.folder / "mine.bvh"), "precious");
}

TEST(KeptClip, LeavesNoFileBehindWhereItFails) {
    Made made;
    const Project project = test::makeBout();
    // A name that a take has already.
    EXPECT_THROW(keepClip(project, made.loaded.library, made.clip, project.takes[0].name,
                          made.folder.path()),
                 Error);
    std::stop_source cancel;
    Progress progress;
    progress.stop = cancel.get_token();
    progress.report = [&](double fraction) {
        if (fraction >= 0.6) cancel.request_stop();
    };
    EXPECT_THROW(
        keepClip(project, made.loaded.library, made.clip, "mine", made.folder.path(), progress),
        Cancelled);
    EXPECT_FALSE(std::filesystem::exists(made.folder / "mine.bvh"));
}

}  // namespace
}  // namespace kumite
