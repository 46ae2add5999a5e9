#include "core/formats/npz.h"

#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

std::uint32_t numberAt(const std::string& bytes, std::size_t at, std::size_t size) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, size);
    return number;
}

/// The members of a stored zip archive, read through its directory.
std::map<std::string, std::string> membersOf(const std::string& archive) {
    std::map<std::string, std::string> members;
    const std::size_t end = archive.size() - 22;
    EXPECT_EQ(numberAt(archive, end, 4), 0x06054b50U);
    const std::uint32_t count = numberAt(archive, end + 10, 2);
    std::size_t entry = numberAt(archive, end + 16, 4);
    EXPECT_EQ(entry + numberAt(archive, end + 12, 4), end);
    for (std::uint32_t i = 0; i < count; ++i) {
        EXPECT_EQ(numberAt(archive, entry, 4), 0x02014b50U);
        const std::size_t size = numberAt(archive, entry + 24, 4);
        const std::size_t nameLength = numberAt(archive, entry + 28, 2);
        const std::size_t local = numberAt(archive, entry + 42, 4);
        const std::string name = archive.substr(entry + 46, nameLength);
        EXPECT_EQ(numberAt(archive, local, 4), 0x04034b50U);
        EXPECT_EQ(archive.substr(local + 30, nameLength), name);
        EXPECT_EQ(numberAt(archive, local + 18, 4), size);
        members[name] = archive.substr(local + 30 + nameLength, size);
        entry += 46 + nameLength;
    }
    EXPECT_EQ(entry, end);
    return members;
}

Clip twoFrames() {
    const auto motion = test::bobbing(2, 60, [](double t) { return t; });
    const Fighter fighter = test::makeFighter(motion, 60);
    return clipOf(*motion, motion->frames(), fighter.space, fighter.roles);
}

TEST(Npz, ArraysStandWithTypeAndShape) {
    const Clip clip = twoFrames();
    const auto members = membersOf(npzBytes(clipArrays(clip, 0.25, "_2")));
    ASSERT_EQ(members.size(), 6U);
    const std::string& positions = members.at("positions_2.npy");
    EXPECT_EQ(positions.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header = numberAt(positions, 8, 2);
    EXPECT_EQ((10 + header) % 64, 0U);
    EXPECT_EQ(positions[9 + header], '\n');
    EXPECT_NE(positions.find("{'descr': '<f4', 'fortran_order': False, 'shape': (2,25,3,), }"),
              std::string::npos);
    const JointPositions expected = positionsOf(clip);
    ASSERT_EQ(positions.size() - 10 - header, 4 * expected.xyz.size());
    EXPECT_EQ(
        std::memcmp(positions.data() + 10 + header, expected.xyz.data(), 4 * expected.xyz.size()),
        0);
    EXPECT_NE(members.at("rate_2.npy").find("'shape': ()"), std::string::npos);
    EXPECT_NE(members.at("names_2.npy").find("'<U19'"), std::string::npos);
}

TEST(Npz, TextsMayBeAnyUtf8) {
    const NpyArray array = npyTexts("names", {"a", "\xC3\xA4\xE2\x82\xAC\xF0\x9F\xA5\x8B", "\xFF"});
    EXPECT_EQ(array.dtype, "<U3");
    std::vector<std::uint32_t> points(9);
    ASSERT_EQ(array.data.size(), 36U);
    std::memcpy(points.data(), array.data.data(), 36);
    EXPECT_EQ(points, (std::vector<std::uint32_t>{'a', 0, 0, 0xE4, 0x20AC, 0x1F94B, 0xFFFD, 0, 0}));
}

TEST(Npz, TheSameClipGivesTheSameBytes) {
    const Clip clip = twoFrames();
    EXPECT_EQ(npzBytes(clipArrays(clip, 0, "")), npzBytes(clipArrays(clip, 0, "")));
}

/// A Python that has numpy: the first on the path, or the system's.
std::string pythonWithNumpy() {
    for (const std::string python : {"python3", "/usr/bin/python3"}) {
        if (std::system((python + " -c 'import numpy' >/dev/null 2>&1").c_str()) == 0)
            return python;
    }
    return {};
}

TEST(Npz, NumpyReadsIt) {
    const std::string python = pythonWithNumpy();
    if (python.empty()) GTEST_SKIP() << "no Python with numpy";
    const test::TemporaryFolder folder;
    test::writeText(folder / "clip.npz", npzBytes(clipArrays(twoFrames(), 0.5, "")));
    test::writeText(folder / "check.py",
                    "import sys, numpy as np\n"
                    "z = np.load(sys.argv[1])\n"
                    "assert z['positions'].shape == (2, 25, 3), z['positions'].shape\n"
                    "assert z['rotations'].shape == (2, 25, 4)\n"
                    "assert (z['rotations'][:, :, 0] == 1).all()\n"
                    "assert list(z['names'][:2]) == ['Hips', 'Chest'], z['names']\n"
                    "assert z['parents'][0] == -1 and z['parents'][1] == 0\n"
                    "assert float(z['rate']) == 60 and float(z['start']) == 0.5\n"
                    "assert abs(z['positions'][0, 0, 1] - 0.92) < 1e-6\n");
    const std::string command =
        python + " " + (folder / "check.py").string() + " " + (folder / "clip.npz").string();
    EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace kumite
