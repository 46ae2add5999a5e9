#include "core/project/project_file.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/formats/bvh.h"
#include "core/project/analysis.h"
#include "core/project/edits.h"
#include "core/project/import.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::readText;
using test::TemporaryFolder;
using test::writeText;

/// A saved project on two real files of its own.
struct SavedBout {
    TemporaryFolder folder;
    std::filesystem::path file = folder / "bout.kumite";

    SavedBout() {
        std::filesystem::create_directories(folder / "recordings");
        TakeRequest request;
        request.name = "round 1, \"semi\"-final: \\a";
        int player = 0;
        for (const char* name : {"red.bvh", "blue.bvh"}) {
            const auto motion =
                test::bobbing(200, 60, [player](double t) { return test::boutHeight(player, t); });
            const auto path = folder / "recordings" / name;
            writeText(path, bvhText(*motion, motion->frames(), motion->frameTime));
            request.fighters.emplace_back().path = path;
            ++player;
        }
        request.fighters[1].placement = {0.1, 1.0 / 3.0, M_PI};
        request.fighters[1].offset = -0.25;
        request.fighters[0].floor = 0.02;
        Project project = addTake({}, importTake(request).take)->project;
        project = setSegmentation(project, {5.5, 0.07, ForceCurve::Vertical})->project;
        project.takes[0].fighters[0].corrections = {{Correction::Kind::Remove, 40, 0, false, false},
                                                    {Correction::Kind::Add, 55, 0, true, false},
                                                    {Correction::Kind::Move, 70, 72, false, false}};
        saveProject(project, file);
    }
};

TEST(ProjectFile, ClipsAndDraftsComeBack) {
    const SavedBout bout;
    Project project = loadProject(bout.file).project;
    EXPECT_EQ(readText(bout.file).find("drafts"), std::string::npos);
    project = addClips(project, {bout.folder / "recordings", "/elsewhere/kick.bvh"})->project;
    project = setDraft(project, "sequence", "{\"blocks\": [1, 2.5]}", "Add block")->project;
    project = setDraft(project, "of a later version", "[\"\u00e4\"]", "x")->project;
    saveProject(project, bout.file);
    EXPECT_NE(readText(bout.file).find("\"recordings\""), std::string::npos);  // relative
    const Project again = loadProject(bout.file).project;
    EXPECT_EQ(again.clips, project.clips);
    EXPECT_EQ(again.drafts, project.drafts);
    EXPECT_FALSE(setDraft(project, "sequence", "{\"blocks\":[1,2.5]}", "x"));
    EXPECT_FALSE(addClips(project, {"/elsewhere/kick.bvh"}));
    EXPECT_THROW(setDraft(project, "sequence", "{", "x"), InputError);
    project = removeClips(project, project.clips)->project;
    project = setDraft(project, "sequence", "", "Clear")->project;
    EXPECT_TRUE(project.clips.empty());
    EXPECT_EQ(project.drafts.size(), 1u);
}

TEST(ProjectFile, RoundTrip) {
    const SavedBout bout;
    const LoadedProject first = loadProject(bout.file);
    EXPECT_TRUE(first.findings.empty()) << first.findings.front().text;
    const Fighter& red = first.project.takes[0].fighters[0];
    ASSERT_TRUE(red.motion);
    EXPECT_EQ(red.corrections.size(), 3u);
    EXPECT_EQ(red.floor, 0.02);
    EXPECT_EQ(first.project.takes[0].fighters[1].placement, (Placement{0.1, 1.0 / 3.0, M_PI}));
    EXPECT_EQ(first.project.segmentation.curve, ForceCurve::Vertical);
    EXPECT_EQ(first.project.bodyModel, deLevaMale());
    const std::string text = readText(bout.file);
    saveProject(first.project, bout.file);
    EXPECT_EQ(readText(bout.file), text) << "saving what was loaded changes no byte";
    EXPECT_EQ(text.find(bout.folder.path().string()), std::string::npos)
        << "recordings are named relative to the project";
}

TEST(ProjectFile, MovesAsAWholeFolder) {
    const SavedBout bout;
    const TemporaryFolder elsewhere;
    std::filesystem::copy(bout.folder.path(), elsewhere / "copy",
                          std::filesystem::copy_options::recursive);
    const LoadedProject loaded = loadProject(elsewhere / "copy" / "bout.kumite");
    EXPECT_TRUE(loaded.findings.empty());
    EXPECT_TRUE(loaded.project.takes[0].fighters[1].motion);
}

TEST(ProjectFile, ARecordingThatMovedIsFoundByItsContent) {
    const SavedBout bout;
    std::filesystem::create_directories(bout.folder / "deeper" / "still");
    std::filesystem::rename(bout.folder / "recordings" / "red.bvh",
                            bout.folder / "deeper" / "still" / "renamed.bvh");
    const LoadedProject loaded = loadProject(bout.file);
    EXPECT_TRUE(loaded.project.takes[0].fighters[0].motion);
    ASSERT_EQ(loaded.findings.size(), 1u);
    EXPECT_EQ(loaded.findings[0].severity, Severity::Note);
    EXPECT_NE(loaded.findings[0].text.find("renamed.bvh"), std::string::npos);
}

TEST(ProjectFile, AMissingRecordingLosesNothing) {
    const SavedBout bout;
    const std::string text = readText(bout.file);
    std::filesystem::remove(bout.folder / "recordings" / "red.bvh");
    const LoadedProject loaded = loadProject(bout.file);
    EXPECT_FALSE(loaded.project.takes[0].fighters[0].motion);
    EXPECT_TRUE(loaded.project.takes[0].fighters[1].motion);
    ASSERT_EQ(loaded.findings.size(), 1u);
    EXPECT_NE(loaded.findings[0].text.find("red.bvh"), std::string::npos);
    saveProject(loaded.project, bout.file);
    EXPECT_EQ(readText(bout.file), text);
}

TEST(ProjectFile, AChangedRecordingIsUsedAndWarnedAbout) {
    const SavedBout bout;
    const auto motion = test::bobbing(120, 60, [](double) { return 0.0; });
    writeText(bout.folder / "recordings" / "red.bvh",
              bvhText(*motion, motion->frames(), motion->frameTime));
    const LoadedProject loaded = loadProject(bout.file);
    const Fighter& red = loaded.project.takes[0].fighters[0];
    EXPECT_EQ(framesOf(red), (FrameRange{0, 120}));
    EXPECT_EQ(red.frames, (FrameRange{0, 200})) << "the decision stays: the old file may come back";
    ASSERT_EQ(loaded.findings.size(), 2u);
    EXPECT_NE(loaded.findings[0].text.find("changed"), std::string::npos);
    EXPECT_NO_THROW(analyse(loaded.project));
}

TEST(ProjectFile, LinksLeadToTheSameRecordings) {
    const SavedBout bout;
    const TemporaryFolder elsewhere;
    std::filesystem::create_directory_symlink(bout.folder.path(), elsewhere / "folder");
    std::filesystem::create_symlink(bout.file, elsewhere / "link.kumite");
    for (const auto& way : {elsewhere / "folder" / "bout.kumite", elsewhere / "link.kumite"}) {
        const LoadedProject loaded = loadProject(way);
        EXPECT_TRUE(loaded.findings.empty()) << loaded.findings.front().text;
        saveProject(loaded.project, way);
    }
    EXPECT_TRUE(std::filesystem::is_symlink(elsewhere / "link.kumite"));
    EXPECT_TRUE(loadProject(bout.file).findings.empty());
}

TEST(ProjectFile, JointNamesThatAreNoTextKeepTheirRoles) {
    const SavedBout bout;
    Skeleton skeleton = *test::makeHuman();
    skeleton.joints[static_cast<std::size_t>(skeleton.find("LeftKnee"))].name = "LeftKn\xEE";
    const auto motion = test::makeMotion(std::make_shared<Skeleton>(skeleton), 50, 60,
                                         [](int, int) { return 0.0; });
    const auto path = bout.folder / "latin.bvh";
    writeText(path, bvhText(*motion, motion->frames(), motion->frameTime));
    TakeRequest request;
    request.fighters.emplace_back().path = path;
    request.fighters[0].roles = {{Role::LeftKnee, "LeftKn\xEE"}};
    const auto file = bout.folder / "latin.kumite";
    saveProject(addTake({}, importTake(request).take)->project, file);
    const std::string text = readText(file);
    const LoadedProject loaded = loadProject(file);
    EXPECT_TRUE(loaded.findings.empty());
    EXPECT_TRUE(loaded.project.takes[0].fighters[0].roles.has(Role::LeftKnee));
    saveProject(loaded.project, file);
    EXPECT_EQ(readText(file), text);
    request.name = "\xFF";
    EXPECT_THROW(importTake(request), Error);
}

TEST(ProjectFile, ADamagedRecordingDoesNotTakeTheProjectDown) {
    const SavedBout bout;
    writeText(bout.folder / "recordings" / "red.bvh", "HIERARCHY\nROOT x\n{ nonsense");
    const LoadedProject loaded = loadProject(bout.file);
    EXPECT_FALSE(loaded.project.takes[0].fighters[0].motion);
    ASSERT_EQ(loaded.findings.size(), 1u);
    EXPECT_NE(loaded.findings[0].text.find("red.bvh:"), std::string::npos);
}

TEST(ProjectFile, AnotherSkeletonKeepsTheRolesByName) {
    const SavedBout bout;
    // The same human with a helper joint in front: every index shifts by one.
    auto skeleton = std::make_shared<Skeleton>(*test::makeHuman());
    for (Joint& joint : skeleton->joints) {
        joint.parent += 1;
        joint.firstChannel += 1;
    }
    Joint helper;
    helper.name = "reference";
    helper.channels = {Channel::Yrotation};
    skeleton->joints.insert(skeleton->joints.begin(), helper);
    skeleton->channelCount += 1;
    const auto motion = test::makeMotion(skeleton, 200, 60, [](int, int) { return 0.0; });
    writeText(bout.folder / "recordings" / "red.bvh", bvhText(*motion, motion->frames(), 1.0 / 60));
    const LoadedProject loaded = loadProject(bout.file);
    const Fighter& red = loaded.project.takes[0].fighters[0];
    EXPECT_EQ(
        red.motion->skeleton->joints[static_cast<std::size_t>(*red.roles[Role::LeftKnee])].name,
        "LeftKnee");
}

TEST(ProjectFile, ANewerVersionIsRefused) {
    const SavedBout bout;
    std::string text = readText(bout.file);
    text.replace(text.find("\"kumite\": 2"), 11, "\"kumite\": 3");
    try {
        parseProject(text, "bout.kumite", "/");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("newer"), std::string::npos);
    }
    EXPECT_THROW(parseProject("{\"kumite\": 0}", "x", "/"), InputError);
    EXPECT_THROW(parseProject("{}", "x", "/"), InputError);
    EXPECT_THROW(parseProject("[]", "x", "/"), InputError);
    EXPECT_THROW(parseProject("", "x", "/"), InputError);
}

TEST(ProjectFile, AFileOfVersionOneIsRead) {
    // As version 1 wrote it.
    const std::string text = R"({
  "kumite": 1,
  "segmentation": {"cutoff_hz": 6.0, "prominence_bw": 0.05, "curve": "norm"},
  "body_model": {"name": "none", "segments": []},
  "takes": [
    {
      "name": "round1",
      "fighters": [
        {
          "recording": {"path": "red.bvh", "sha256": "00"},
          "metres_per_unit": 0.01,
          "up": "y",
          "rate_hz": 60.0,
          "frames": [0, 200],
          "offset_s": 0.0,
          "placement": {"x_m": 0.0, "z_m": 0.0, "yaw_rad": 0.0},
          "roles": {"pelvis": [0, "Hips"]},
          "corrections": [
            {"remove": 40},
            {"add": 55, "beside": true, "removed": true},
            {"move": 70, "to": 72}
          ]
        }
      ]
    }
  ]
})";
    const Project project = parseProject(text, "bout.kumite", "/bouts");
    const Fighter& fighter = project.takes[0].fighters[0];
    EXPECT_EQ(fighter.corrections,
              (std::vector<Correction>{{Correction::Kind::Remove, 40, 0, false, false},
                                       {Correction::Kind::Add, 55, 0, true, true},
                                       {Correction::Kind::Move, 70, 72, false, false}}));
    EXPECT_TRUE(fighter.notes.empty());
    const std::string now = projectText(project, "/bouts");
    EXPECT_NE(now.find("\"kumite\": 2"), std::string::npos) << "saved as the present version";
    EXPECT_EQ(projectText(parseProject(now, "bout.kumite", "/bouts"), "/bouts"), now);
}

TEST(ProjectFile, SyntaxErrorsNameLineAndColumn) {
    try {
        parseProject("{\n \"kumite\": 1,\n oops }", "bout.kumite", "/");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.line(), 3);
        EXPECT_EQ(std::string(error.what()).substr(0, 14), "bout.kumite:3:");
    }
}

TEST(ProjectFile, WrongKindsAreNamedByTheirPlace) {
    const SavedBout bout;
    const std::string text = readText(bout.file);
    const auto messageFor = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        changed.replace(changed.find(from), from.size(), to);
        try {
            parseProject(changed, "b", "/");
            return std::string("accepted");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
    };
    EXPECT_EQ(messageFor("\"rate_hz\": 60.0", "\"rate_hz\": \"fast\""),
              "b: takes[0].fighters[0].rate_hz: expected a number.");
    EXPECT_EQ(messageFor("\"rate_hz\": 60.0", "\"rate_hz\": -1"),
              "b: takes[0].fighters[0].rate_hz: expected a number above 0.");
    EXPECT_EQ(messageFor("\"up\": \"y\"", "\"up\": \"x\""),
              "b: takes[0].fighters[0].up: expected \"y\" or \"z\".");
    EXPECT_EQ(messageFor("\"pelvis\"", "\"tail\""),
              "b: takes[0].fighters[0].roles: \"tail\" is no joint role.");
    EXPECT_EQ(messageFor("\"remove\": 40", "\"delete\": 40"),
              "b: takes[0].fighters[0].corrections[0]: expected \"remove\", \"add\", \"move\" or "
              "\"keep\".");
    EXPECT_EQ(messageFor("\"frames\": [0, 200]", "\"frames\": [9, 3]"),
              "b: takes[0].fighters[0].frames: expected [begin, end] with 0 <= begin < end.");
    EXPECT_EQ(messageFor("\"offset_s\"", "\"offset\""),
              "b: takes[0].fighters[0]: \"offset_s\" is missing.");
}

TEST(ProjectFile, HalfAFileIsAnErrorNeverACrash) {
    const SavedBout bout;
    const std::string text = readText(bout.file);
    const std::size_t end = text.find_last_of('}');
    for (std::size_t size = 0; size <= end; size += 7) {
        EXPECT_THROW(parseProject(text.substr(0, size), "b", "/"), InputError) << size;
    }
}

TEST(ProjectFile, CorrectionsOfTheSavedBoutWork) {
    const SavedBout bout;
    const Project project = loadProject(bout.file).project;
    const Analysis analysis = analyse(project);
    bool added = false;
    for (const Boundary& boundary : analysis.at({0, 0}).segmentation->boundaries) {
        added |= boundary.frame == 55 && boundary.source == BoundarySource::Added;
    }
    EXPECT_TRUE(added);
}

TEST(BodyModelFile, ReadsWhatAProjectHolds) {
    const TemporaryFolder folder;
    writeText(folder / "legs.json",
              R"({"name": "legs", "segments": [{"name": "thigh", "mass": 1,
                  "from": ["left_hip"], "to": "left_knee", "fraction": 0.4}]})");
    const BodyModel model = readBodyModel(folder / "legs.json");
    ASSERT_EQ(model.segments.size(), 1u);
    EXPECT_EQ(model.segments[0].to, Role::LeftKnee);
    writeText(folder / "bad.json", R"({"name": "x", "segments": [{"name": "a", "mass": 0,
                  "from": ["left_hip"]}]})");
    EXPECT_THROW(readBodyModel(folder / "bad.json"), InputError);
    const auto shipped = test::sourceFolder() / "resources" / "body_models" / "de_leva_female.json";
    double sum = 0;
    for (const BodySegment& segment : readBodyModel(shipped).segments)
        sum += segment.mass;
    EXPECT_NEAR(sum, 1.0, 1e-3);
}

}  // namespace
}  // namespace kumite
