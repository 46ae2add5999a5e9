#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/formats/recording.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::TemporaryFolder;
using test::writeText;

const std::string kBvh =
    "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}\n"
    "MOTION\nFrames: 1\nFrame Time: 0.01\n5\n";
const std::string kAsf =
    ":version 1.10\n:units\n length 0.45\n angle deg\n:root\n order TX TY TZ RX RY RZ\n axis XYZ\n"
    ":bonedata\n:hierarchy\nbegin\nend\n";
const std::string kAmc = ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 1 2 3 4 5 6\n";

std::string messageFor(const std::filesystem::path& path, const ReadOptions& options = {}) {
    try {
        readRecording(path, options);
        return "read";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(Recording, ReadsBvhWhateverItsName) {
    const TemporaryFolder folder;
    for (const std::string name : {"a.bvh", "a.BVH", "a.txt", "a", "a.amc", "a.fbx"}) {
        writeText(folder / name, "\xEF\xBB\xBF# made by hand\n\n" + kBvh);
        const Recording recording = readRecording(folder / name);
        EXPECT_EQ(recording.format, "BVH");
        EXPECT_EQ(recording.motions.front()->channels, std::vector<double>{5});
        EXPECT_EQ(recording.sha256, sha256("\xEF\xBB\xBF# made by hand\n\n" + kBvh));
        EXPECT_TRUE(recording.asf.empty());
    }
}

TEST(Recording, NamesTheFileInErrors) {
    const TemporaryFolder folder;
    writeText(folder / "a.bvh", "HIERARCHY\nRUT\n");
    EXPECT_EQ(messageFor(folder / "a.bvh"),
              (folder / "a.bvh").string() + ":2:1: found 'RUT', expected ROOT");
    writeText(folder / "empty.bvh", "");
    EXPECT_EQ(
        messageFor(folder / "empty.bvh"),
        (folder / "empty.bvh").string() + ":1:1: found the end of the file, expected HIERARCHY");
    EXPECT_EQ(messageFor(folder / "none.bvh"),
              (folder / "none.bvh").string() + ": there is no such file.");
    EXPECT_EQ(messageFor(folder.path()),
              folder.path().string() + ": is a folder, expected a file.");
}

TEST(Recording, ReadsAmcWithTheAsfBesideIt) {
    const TemporaryFolder folder;
    writeText(folder / "walk.amc", kAmc);
    EXPECT_EQ(messageFor(folder / "walk.amc"),
              (folder / "walk.amc").string() +
                  ": found no skeleton beside it, expected an .asf file (name it with --asf)");
    writeText(folder / "anything.ASF", kAsf);
    const Recording recording = readRecording(folder / "walk.amc");
    EXPECT_EQ(recording.format, "ASF/AMC");
    EXPECT_EQ(recording.asf, folder / "anything.ASF");
    EXPECT_EQ(recording.sha256, sha256(kAsf + kAmc));
    EXPECT_EQ(recording.motions.front()->channels, (std::vector<double>{1, 2, 3, 6, 5, 4}));
}

TEST(Recording, ChoosesTheAsfWhoseNameFits) {
    const TemporaryFolder folder;
    writeText(folder / "135_06-kick.amc", kAmc);
    writeText(folder / "walk_fast.amc", kAmc);
    writeText(folder / "135-martial.asf", kAsf);
    writeText(folder / "13.asf", kAsf);
    writeText(folder / "walk.asf", kAsf);
    EXPECT_EQ(readRecording(folder / "135_06-kick.amc").asf, folder / "135-martial.asf");
    EXPECT_EQ(readRecording(folder / "walk_fast.amc").asf, folder / "walk.asf");
    writeText(folder / "135.asf", kAsf);
    EXPECT_EQ(messageFor(folder / "135_06-kick.amc"),
              (folder / "135_06-kick.amc").string() +
                  ": found several skeletons beside it (13.asf, 135-martial.asf, 135.asf, "
                  "walk.asf), expected one (name it with --asf)");
    EXPECT_EQ(readRecording(folder / "135_06-kick.amc", {.asf = folder / "13.asf"}).asf,
              folder / "13.asf");
    EXPECT_NE(messageFor(folder / "135_06-kick.amc", {.asf = folder / "no.asf"}).find("no.asf"),
              std::string::npos);
}

TEST(Recording, KnowsAmcByItsContent) {
    const TemporaryFolder folder;
    writeText(folder / "a.asf", kAsf);
    for (const std::string start : {"#!OML:ASF x\n", "# comment\n", ""}) {
        writeText(folder / "motion.txt", start + kAmc);
        EXPECT_EQ(readRecording(folder / "motion.txt").format, "ASF/AMC");
    }
    EXPECT_EQ(messageFor(folder / "a.asf"),
              (folder / "a.asf").string() +
                  ": found an ASF skeleton, which holds no motion, expected the .amc file that "
                  "belongs to it.");
}

TEST(Recording, RefusesOtherFormatsAndNamesTheWay) {
    const TemporaryFolder folder;
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.fbx", "Kaydara FBX Binary  "},
        {"b", "Kaydara FBX Binary  "},
        {"c.fbx", "; FBX 7.3.0"},
        {"d.c3d", "\x02\x50"},
        {"e.glb", "glTF"},
        {"f.gltf", "{}"},
        {"g.trc", "PathFileType\t4"},
        {"h.htr", "[Header]"},
        {"i.usda", "#usda 1.0"},
        {"j.usdz", "PK\x03\x04"},
        {"k.npz", "PK\x03\x04"},
        {"l.blend", "BLENDER"},
        {"m.npy", "\x93NUMPY"},
        {"n.dae", "<?xml"},
        {"o.FBX", "?"},
        {"p.vrm", "glTF"},
        {"q.usd", "PXR-USDC"}};
    for (const auto& [name, content] : files) {
        writeText(folder / name, content);
        const std::string message = messageFor(folder / name);
        EXPECT_NE(message.find("import it into Blender and export it as Motion Capture (.bvh)"),
                  std::string::npos)
            << message;
    }
    EXPECT_EQ(messageFor(folder / "a.fbx"),
              (folder / "a.fbx").string() +
                  ": found FBX data, expected BVH or ASF/AMC: import it into Blender and export "
                  "it as Motion Capture (.bvh).");
    writeText(folder / "junk.bin", "\x01\x02");
    EXPECT_EQ(messageFor(folder / "junk.bin"),
              (folder / "junk.bin").string() + ":1:1: found '\\x01\\x02', expected HIERARCHY");
}

Recording withRoots(const std::vector<std::string>& names) {
    Recording recording;
    for (const std::string& name : names) {
        auto skeleton = std::make_shared<Skeleton>();
        skeleton->joints.emplace_back().name = name;
        auto motion = std::make_shared<Motion>();
        motion->skeleton = skeleton;
        recording.motions.push_back(motion);
    }
    return recording;
}

TEST(Recording, NamesRoots) {
    EXPECT_EQ(rootNames(withRoots({"Hips"})), std::vector<std::string>{"Hips"});
    EXPECT_EQ(rootNames(withRoots({"Hips", "Prop", "Hips"})),
              (std::vector<std::string>{"Hips#1", "Prop", "Hips#2"}));
}

TEST(Recording, FindsTheMotionOfARoot) {
    const Recording recording = withRoots({"Hips", "Prop", "Hips"});
    const auto& motions = recording.motions;
    EXPECT_EQ(motionOfRoot(recording, ""), motions[0]);
    EXPECT_EQ(motionOfRoot(recording, "Hips"), motions[0]);
    EXPECT_EQ(motionOfRoot(recording, "Hips#1"), motions[0]);
    EXPECT_EQ(motionOfRoot(recording, "Hips#2"), motions[2]);
    EXPECT_EQ(motionOfRoot(recording, "Prop"), motions[1]);
    EXPECT_EQ(motionOfRoot(recording, "#2"), motions[1]);
    EXPECT_EQ(motionOfRoot(recording, "#3"), motions[2]);
    for (const std::string wrong : {"#0", "#4", "Hips#3", "hips", "Head"}) {
        try {
            motionOfRoot(recording, wrong);
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_EQ(error.what(),
                      "There is no root " + wrong + "; the recording has Hips#1, Prop, Hips#2.");
        }
    }
}

}  // namespace
}  // namespace kumite
