#include "core/project/library.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/formats/bvh.h"
#include "core/project/project_file.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

void writeBobbing(const std::filesystem::path& path, int frames = 121, double rate = 60) {
    const auto motion =
        test::bobbing(frames, rate, [](double t) { return 0.03 * std::sin(2 * M_PI * 1.5 * t); });
    test::writeText(path, bvhText(*motion, motion->frames(), motion->frameTime));
}

bool mentions(const Findings& findings, const std::string& word) {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
        return finding.text.find(word) != std::string::npos;
    });
}

std::string errorOf(const std::vector<std::filesystem::path>& sources) {
    try {
        loadLibrary(sources);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Library, FilesFoldersAndProjectsInAnyMix) {
    test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "more/deep");
    writeBobbing(folder / "kick.bvh");
    writeBobbing(folder / "more/kick.bvh");
    writeBobbing(folder / "more/deep/PUNCH.BVH", 61);
    test::writeText(folder / "more/notes.txt", "no motion");
    test::writeText(folder / "more/broken.bvh", "HIERARCHY\nROOT");
    writeBobbing(folder / "red.bvh", 361);
    writeBobbing(folder / "blue.bvh", 361);
    Project project = test::makeBout();
    for (std::size_t i = 0; i < 2; ++i)
        project.takes[0].fighters[i].recording.path = folder / (i == 0 ? "red.bvh" : "blue.bvh");
    saveProject(project, folder / "bout.kumite");

    const LoadedLibrary loaded =
        loadLibrary({folder / "kick.bvh", folder / "more", folder / "bout.kumite"});
    const MotionLibrary& library = loaded.library;
    ASSERT_EQ(library.motions.size(), 5u);
    EXPECT_EQ(library.motions[0].name, "kick");
    EXPECT_EQ(library.motions[1].name, "PUNCH");
    EXPECT_EQ(library.motions[2].name, "kick#2");
    EXPECT_EQ(library.motions[3].name, "made:1");
    EXPECT_TRUE(mentions(loaded.findings, "broken.bvh"));
    EXPECT_EQ(library.actions[0].name, "kick");
    EXPECT_EQ(library.actions[0].frames, (FrameRange{0, 61}));
    const LibraryAction first = actionNamed(library, "made:1:0");
    const LibraryAction second = actionNamed(library, "made:1:1");
    EXPECT_EQ(first.frames.begin, 0);
    EXPECT_EQ(first.frames.end - 1, second.frames.begin);  // the boundary's frame is in both
    for (const LibraryMotion& motion : library.motions) {
        EXPECT_EQ(motion.clip.rate, 30);
        EXPECT_EQ(motion.standing.size(), motion.clip.frames.size());
        EXPECT_EQ(motion.clip.frames[0].turns.size(), library.rig->joints.size());
    }
}

TEST(Library, TheOpenProjectGivesTheSame) {
    const Project project = test::makeBout();
    const Analysis analysis = analyse(project);
    const LoadedLibrary loaded = libraryOf(project, analysis, {60});
    ASSERT_EQ(loaded.library.motions.size(), 2u);
    EXPECT_EQ(loaded.library.motions[0].clip.frameCount(), 361);
    const auto& actions = analysis.at({0, 0}).segmentation->actions;
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const LibraryAction action = actionNamed(loaded.library, "made:1:" + std::to_string(i));
        EXPECT_EQ(action.frames, (FrameRange{actions[i].begin, actions[i].end + 1}));
    }
}

TEST(Library, StretchesByFramesOfTheFile) {
    test::TemporaryFolder folder;
    writeBobbing(folder / "kick.bvh");
    const MotionLibrary library = loadLibrary({folder / "kick.bvh"}).library;
    EXPECT_EQ(actionNamed(library, "kick@20:60").frames, (FrameRange{10, 30}));
    EXPECT_EQ(actionNamed(library, "kick@20:").frames, (FrameRange{10, 61}));
    EXPECT_EQ(actionNamed(library, "kick@:60").frames, (FrameRange{0, 30}));
    EXPECT_EQ(actionNamed(library, "kick@20:60").name, "kick@20:60");
    for (const char* wrong : {"punch", "kick@", "kick@3", "kick@60:20", "kick@0:9999", "kick@a:b",
                              "kick@-1:5", "@1:2", "kick@1:2:3", ""}) {
        EXPECT_THROW(actionNamed(library, wrong), Error) << wrong;
    }
}

TEST(Library, AStretchToTheLastFrameEndsThereAtAnyRate) {
    test::TemporaryFolder folder;
    writeBobbing(folder / "kick.bvh");
    for (const double rate : {30.0, 60.0, 120.0}) {
        const MotionLibrary library = loadLibrary({folder / "kick.bvh"}, {rate}).library;
        const FrameRange whole = actionNamed(library, "kick").frames;
        EXPECT_EQ(actionNamed(library, "kick@0:121").frames, whole) << rate;
        EXPECT_THROW(actionNamed(library, "kick@0:123"), Error) << rate;
        EXPECT_THROW(actionNamed(library, "kick@0:2147483647"), Error) << rate;
    }
}

TEST(Library, TheFloorLiesAtZero) {
    test::TemporaryFolder folder;
    const auto motion = test::bobbing(61, 30, [](double) { return 0.4; });
    test::writeText(folder / "high.bvh", bvhText(*motion, motion->frames(), motion->frameTime));
    const MotionLibrary library = loadLibrary({folder / "high.bvh"}).library;
    EXPECT_NEAR(library.motions[0].clip.frames[0].root.y(), test::kHumanRootHeight / 100, 1e-6);
    EXPECT_NEAR(library.feet.floor[0], 0, 1e-6);
    EXPECT_TRUE(library.motions[0].standing[10][0]);
}

TEST(Library, DifferentSkeletonsComeOntoTheFirst) {
    KUMITE_NEEDS_DATA();
    const auto data = *test::dataFolder();
    const LoadedLibrary loaded =
        loadLibrary({data / "cmu_moves/02_05.bvh", data / "awkward/Boxing_Toes.bvh",
                     data / "awkward/sinusoidal_noEndSite.bvh"});
    ASSERT_EQ(loaded.library.motions.size(), 2u);
    EXPECT_TRUE(mentions(loaded.findings, "no body"));
    const MotionLibrary& library = loaded.library;
    EXPECT_EQ(library.skeleton->joints.size(), library.rig->joints.size());
    for (const LibraryMotion& motion : library.motions) {
        EXPECT_EQ(motion.clip.rig, library.rig);
        EXPECT_EQ(motion.clip.frames[0].turns.size(), library.rig->joints.size());
    }
}

TEST(Library, WhatCannotBeUsedIsSaid) {
    test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "empty");
    test::writeText(folder / "broken.bvh", "HIERARCHY\nROOT");
    test::writeText(folder / "broken.kumite", "{]");
    EXPECT_NE(errorOf({}), "");
    EXPECT_NE(errorOf({folder / "empty"}), "");
    EXPECT_NE(errorOf({folder / "absent.bvh"}).find("absent.bvh"), std::string::npos);
    EXPECT_NE(errorOf({folder / "broken.bvh"}).find("broken.bvh"), std::string::npos);
    EXPECT_NE(errorOf({folder / "broken.kumite"}).find("broken.kumite"), std::string::npos);
    writeBobbing(folder / "kick.bvh");
    for (const double rate : {0.0, -30.0, 1e9, std::nan("")})
        EXPECT_THROW(loadLibrary({folder / "kick.bvh"}, {rate}), Error);
    std::stop_source stop;
    stop.request_stop();
    Progress cancelled;
    cancelled.stop = stop.get_token();
    EXPECT_THROW(loadLibrary({folder / "kick.bvh"}, {}, cancelled), Cancelled);
}

}  // namespace
}  // namespace kumite
