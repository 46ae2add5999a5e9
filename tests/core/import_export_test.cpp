#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/bvh.h"
#include "core/project/edits.h"
#include "core/project/export.h"
#include "core/project/import.h"
#include "core/project/placed_clip.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::readText;
using test::TemporaryFolder;
using test::writeText;

/// Arms and legs in motion, the root walking and turning; `rest` leading frames of a T-pose.
std::shared_ptr<const Motion> walking(int frames, int rest = 0, double rate = 60) {
    return test::makeMotion(test::makeHuman(), frames, rate, [rest](int frame, int column) {
        if (frame < rest) return column == 1 ? test::kHumanRootHeight : 0.0;
        if (column == 1) return test::kHumanRootHeight;
        if (column < 3) return 0.7 * frame;
        if (column == 5) return 3.0 * frame;
        return 20.0 * std::sin(column) + 8.0 * std::sin(0.1 * frame + column);
    });
}

struct Files {
    TemporaryFolder folder;

    std::filesystem::path add(const std::string& name, const Motion& motion) {
        writeText(folder / name, bvhText(motion, motion.frames(), motion.frameTime));
        return folder / name;
    }
    TakeRequest request(const std::vector<std::filesystem::path>& paths) {
        TakeRequest take;
        for (const auto& path : paths)
            take.fighters.emplace_back().path = path;
        return take;
    }
};

TEST(Import, FindsWhatIsNotSaid) {
    Files files;
    const auto imported = importTake(files.request({files.add("a.bvh", *walking(100))}));
    const Fighter& fighter = imported.take.fighters[0];
    EXPECT_EQ(imported.take.name, "a");
    EXPECT_EQ(fighter.space, (SpaceConvention{0.01, UpAxis::Y}));
    EXPECT_EQ(fighter.rate, 60);
    EXPECT_EQ(fighter.frames, (FrameRange{0, 100}));
    EXPECT_EQ(fighter.roles.count(), kRoleCount - 1) << "this skeleton has no separate spine";
    EXPECT_EQ(fighter.recording.sha256.size(), 64u);
}

TEST(Import, FilesRecordedTogetherLoseTheSameFrames) {
    Files files;
    const auto a = files.add("a.bvh", *walking(100, 1));
    const auto b = files.add("b.bvh", *walking(100, 0));
    const auto c = files.add("c.bvh", *walking(90, 0));
    const auto together = importTake(files.request({a, b})).take;
    EXPECT_EQ(together.fighters[0].frames, (FrameRange{1, 100}));
    EXPECT_EQ(together.fighters[1].frames, (FrameRange{1, 100}));
    const auto apart = importTake(files.request({a, c})).take;
    EXPECT_EQ(apart.fighters[0].frames, (FrameRange{1, 100}));
    EXPECT_EQ(apart.fighters[1].frames, (FrameRange{0, 90}));
}

TEST(Import, AnExplicitTrimReplacesDetection) {
    Files files;
    TakeRequest request = files.request({files.add("a.bvh", *walking(100, 1))});
    request.trim = FrameRange{0, -1};
    EXPECT_EQ(importTake(request).take.fighters[0].frames, (FrameRange{0, 100}));
    request.trim = FrameRange{10, 20};
    EXPECT_EQ(importTake(request).take.fighters[0].frames, (FrameRange{10, 20}));
    request.trim = FrameRange{100, -1};
    EXPECT_THROW(importTake(request), Error);
    request.trim = FrameRange{10, 101};
    EXPECT_THROW(importTake(request), Error);
}

TEST(Import, OverridesAndMendedRoles) {
    Files files;
    TakeRequest request = files.request({files.add("a.bvh", *walking(50))});
    request.rate = 25;
    FighterRequest& fighter = request.fighters[0];
    fighter.metresPerUnit = 0.02;
    fighter.up = UpAxis::Z;
    fighter.floor = 0.5;
    fighter.roles = {{Role::Head, "Neck"}};
    const Fighter made = importTake(request).take.fighters[0];
    EXPECT_EQ(made.space, (SpaceConvention{0.02, UpAxis::Z}));
    EXPECT_EQ(made.rate, 25);
    EXPECT_EQ(made.floor, 0.5);
    EXPECT_EQ(made.roles[Role::Head], made.roles[Role::Neck]);
    fighter.roles = {{Role::Head, "Nose"}};
    try {
        importTake(request);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("LeftCollar"), std::string::npos)
            << "says what there is";
    }
}

TEST(Import, DifferentRatesAreKeptAndSaid) {
    Files files;
    const auto imported = importTake(files.request(
        {files.add("a.bvh", *walking(60, 0, 60)), files.add("b.bvh", *walking(120, 0, 120))}));
    EXPECT_EQ(imported.take.fighters[0].rate, 60);
    EXPECT_EQ(imported.take.fighters[1].rate, 120);
    ASSERT_FALSE(imported.findings.empty());
    EXPECT_NE(imported.findings.back().text.find("60 and 120 Hz"), std::string::npos);
}

TEST(Import, TheSameFileCanBeBothFighters) {
    Files files;
    const auto path = files.add("a.bvh", *walking(50));
    const Take take = importTake(files.request({path, path})).take;
    EXPECT_EQ(take.fighters[0].motion, take.fighters[1].motion) << "read once";
}

TEST(Import, NonsenseIsRefused) {
    Files files;
    EXPECT_THROW(importTake({}), Error);
    EXPECT_THROW(importTake(files.request({files.folder / "absent.bvh"})), Error);
    TakeRequest request = files.request({files.add("a.bvh", *walking(50))});
    request.rate = 0;
    EXPECT_THROW(importTake(request), Error);
    request.rate.reset();
    request.fighters[0].root = "Tail";
    EXPECT_THROW(importTake(request), Error);
}

struct Exported {
    Files files;
    Project project;

    explicit Exported(const Placement& placement = {}) {
        TakeRequest request = files.request({files.add("a.bvh", *walking(100, 1))});
        request.fighters[0].placement = placement;
        project = addTake({}, importTake(request).take)->project;
    }
    std::vector<std::filesystem::path> write(const std::string& name) {
        return exportTake(project, analyse(project), 0, files.folder / name);
    }
};

TEST(Export, BvhGivesBackWhatCameIn) {
    Exported exported;
    const auto written = exported.write("out.bvh");
    ASSERT_EQ(written.size(), 1u);
    EXPECT_EQ(written[0].filename(), "out-1.bvh");
    const auto motion = readRecording(written[0]).motions[0];
    const Motion& original = *exported.project.takes[0].fighters[0].motion;
    ASSERT_EQ(motion->frameCount, original.frameCount - 1) << "the T-pose is not part of the take";
    EXPECT_EQ(motion->frameTime, original.frameTime);
    for (int frame = 0; frame < motion->frameCount; ++frame) {
        for (std::size_t c = 0; c < motion->frame(frame).size(); ++c) {
            ASSERT_EQ(motion->frame(frame)[c], original.frame(frame + 1)[c]);
        }
    }
}

TEST(Export, APlacementMovesTheRootAndNothingElse) {
    const Placement place{1.5, -0.5, 0.7};
    Exported exported(place);
    const Fighter& fighter = exported.project.takes[0].fighters[0];
    const auto motion = readRecording(exported.write("out.bvh")[0]).motions[0];
    const auto positions = forwardKinematics(*motion, motion->frames(), fighter.space);
    const auto original = forwardKinematics(*fighter.motion, fighter.frames, fighter.space);
    for (int frame = 0; frame < motion->frameCount; frame += 7) {
        for (int joint = 0; joint < positions.jointCount; ++joint) {
            const Eigen::Vector3d expected =
                placed(fighter, 0, original.at(frame, joint).cast<double>());
            EXPECT_LT((positions.at(frame, joint).cast<double>() - expected).norm(), 1e-5);
        }
        for (std::size_t c = 6; c < motion->frame(frame).size(); ++c) {
            ASSERT_EQ(motion->frame(frame)[c], fighter.motion->frame(frame + 1)[c]);
        }
        if (frame > 0) {
            // The yaw track stays continuous through full turns.
            EXPECT_LT(std::abs(motion->frame(frame)[5] - motion->frame(frame - 7)[5]), 30);
        }
    }
}

TEST(Export, APlacementBelowAHelperJoint) {
    Skeleton skeleton = *test::makeHuman();
    for (Joint& joint : skeleton.joints) {
        joint.parent += 1;
        joint.firstChannel += 2;
    }
    Joint helper;
    helper.name = "Armature";
    helper.channels = {Channel::Yposition, Channel::Zrotation};
    helper.offset = {3, 0, 5};
    skeleton.joints.insert(skeleton.joints.begin(), helper);
    skeleton.channelCount += 2;
    const auto motion =
        test::makeMotion(std::make_shared<Skeleton>(skeleton), 20, 60,
                         [](int frame, int column) { return 10.0 * std::sin(frame + column); });
    Fighter fighter = test::makeFighter(motion, 60);
    fighter.placement = {1, 2, 0.5};
    Project project;
    project.takes = {{"t", {fighter}}};
    const TemporaryFolder folder;
    const auto written = exportTake(project, analyse(project), 0, folder / "o.bvh");
    const auto back = readRecording(written[0]).motions[0];
    const auto moved = forwardKinematics(*back, back->frames(), fighter.space);
    const auto original = forwardKinematics(*motion, motion->frames(), fighter.space);
    for (int frame = 0; frame < 20; ++frame) {
        for (int joint = 1; joint < moved.jointCount; ++joint) {
            const Eigen::Vector3d expected =
                placed(fighter, 0, original.at(frame, joint).cast<double>());
            EXPECT_LT((moved.at(frame, joint).cast<double>() - expected).norm(), 1e-5);
        }
        EXPECT_EQ(back->frame(frame)[0], motion->frame(frame)[0]);
    }
}

TEST(Export, NeverReplacesARecording) {
    Files files;
    const auto recording = files.add("red-1.bvh", *walking(100));
    const std::string content = readText(recording);
    const Project project = addTake({}, importTake(files.request({recording})).take)->project;
    EXPECT_THROW(exportTake(project, analyse(project), 0, files.folder / "red.bvh"), Error);
    EXPECT_EQ(readText(recording), content);
}

TEST(Export, AnotherRateIsWritten) {
    Exported exported;
    exported.project.takes[0].fighters[0].rate = 50;
    EXPECT_DOUBLE_EQ(readRecording(exported.write("o.bvh")[0]).motions[0]->frameTime, 0.02);
}

TEST(Export, ActionsAsTableAndJson) {
    Exported exported;
    const Analysis analysis = analyse(exported.project);
    const std::string csv = readText(exported.write("a.csv")[0]);
    const auto lines = std::count(csv.begin(), csv.end(), '\n');
    EXPECT_EQ(lines,
              1 + static_cast<std::ptrdiff_t>(analysis.at({0, 0}).segmentation->actions.size()));
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "take,player,action,begin,end,peak,begin_s,end_s,peak_force,note");
    EXPECT_NE(readText(exported.write("a.json")[0]).find("\"prominence\""), std::string::npos);
}

TEST(Export, PosesStandInTheBoutsSpace) {
    const Exported exported({1.5, -0.5, 0.7});
    const Analysis analysis = analyse(exported.project);
    const FighterAnalysis& fighter = analysis.at({0, 0});
    Findings losses;
    const Clip clip = placedClip(fighter, &losses);
    EXPECT_TRUE(losses.empty());
    EXPECT_EQ(clip.rate, fighter.input.rate);
    const JointPositions positions = positionsOf(clip);
    ASSERT_EQ(positions.frameCount, fighter.frameCount());
    for (int frame = 0; frame < positions.frameCount; frame += 9) {
        for (int joint = 0; joint < positions.jointCount; ++joint) {
            const Eigen::Vector3d expected =
                placed(fighter.input, fighter.body->floor,
                       fighter.motion->positions.at(frame, joint).cast<double>());
            EXPECT_LT((positions.at(frame, joint).cast<double>() - expected).norm(), 1e-5);
        }
    }
}

TEST(Export, GltfAndNumpyHoldTheTakeInOneFile) {
    Exported exported;
    const auto glb = exported.write("a.glb");
    ASSERT_EQ(glb.size(), 1U);
    EXPECT_EQ(readText(glb[0]).substr(0, 4), "glTF");
    EXPECT_NE(readText(glb[0]).find("\"player1\""), std::string::npos);
    const auto npz = exported.write("a.npz");
    ASSERT_EQ(npz.size(), 1U);
    EXPECT_NE(readText(npz[0]).find("rotations.npy"), std::string::npos);
}

TEST(Export, WhatCannotBeWrittenIsSaid) {
    Exported exported;
    EXPECT_THROW(exported.write("a.fbx"), Error);
    EXPECT_THROW(exported.write("no/folder/a.csv"), Error);
    exported.project.takes[0].fighters[0].motion = nullptr;
    for (const char* name : {"a.bvh", "a.glb", "a.npz"})
        EXPECT_THROW(exported.write(name), Error);
}

}  // namespace
}  // namespace kumite
