#include <clocale>
#include <filesystem>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::readText;
using test::TemporaryFolder;
using test::writeText;

TEST(Text, ReadsNumbersAsFilesWriteThem) {
    EXPECT_EQ(parseNumber(".0083"), 0.0083);
    EXPECT_EQ(parseNumber("+5."), 5.0);
    EXPECT_EQ(parseNumber("-1.5E-3"), -0.0015);
    for (const char* bad :
         {"", "+", "++1", "+-1", "1,5", "1 ", " 1", "nan", "inf", "1e999", "0x10", "1x"}) {
        EXPECT_EQ(parseNumber(bad), std::nullopt) << bad;
    }
    EXPECT_EQ(parseInteger("12"), 12);
    for (const char* bad : {"", "1.0", "99999999999", "-", "a"}) {
        EXPECT_EQ(parseInteger(bad), std::nullopt) << bad;
    }
}

TEST(Text, WritesNumbersThatReadBackExactly) {
    for (const double value : {0.1, 1.0 / 3.0, 1e-300, 123456789.123456789, -2.5, 5e-324}) {
        EXPECT_EQ(parseNumber(shortest(value)), value);
    }
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(fixed(1.005, 2), "1.00");  // 1.005 lies below its decimal
    EXPECT_EQ(fixed(-0.0001, 3), "0.000");
    EXPECT_EQ(fixed(-0.5, 1), "-0.5");
}

TEST(Text, SplitsAndTrims) {
    EXPECT_EQ(split("a:b:", ':'), (std::vector<std::string_view>{"a", "b", ""}));
    EXPECT_EQ(split("", ':'), (std::vector<std::string_view>{""}));
    EXPECT_EQ(trimmed(" \t x y\r\n"), "x y");
    EXPECT_EQ(trimmed(" \n"), "");
    EXPECT_TRUE(equalsIgnoringCase("CHANNELS", "channels"));
}

// FIPS 180-2, appendix B.
TEST(Sha256, KnownAnswers) {
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(AtomicWrite, ReplacesWholeFilesAndKeepsModeAndLinks) {
    const TemporaryFolder folder;
    const auto file = folder / "a.txt";
    writeFileAtomically(file, "first");
    ::chmod(file.c_str(), 0640);
    std::filesystem::create_symlink(file, folder / "link.txt");
    writeFileAtomically(folder / "link.txt", "second");
    EXPECT_EQ(readText(file), "second");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms{0640});
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2)
        << "no temporary file stays behind";
}

TEST(AtomicWrite, AFailureLeavesTheOldFileAndNamesIt) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "taken");
    writeText(folder / "taken" / "inside", "x");
    try {
        writeFileAtomically(folder / "taken", "text");
        FAIL() << "a folder cannot be written";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("taken"), std::string::npos);
    }
    EXPECT_EQ(readText(folder / "taken" / "inside"), "x");
    EXPECT_THROW(writeFileAtomically(folder / "no" / "such" / "folder.txt", "x"), Error);
}

TEST(AtomicWrite, WritesIntoWhatIsNoRegularFile) {
    const TemporaryFolder folder;
    const auto pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    writeFileAtomically(pipe, "through");
    char text[16] = {};
    EXPECT_EQ(::read(reader, text, sizeof text), 7);
    ::close(reader);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    EXPECT_THROW(FileBytes{pipe}, Error) << "reading it would wait for ever";
}

TEST(FileBytes, ReadsEmptyFilesAndRefusesFolders) {
    const TemporaryFolder folder;
    writeText(folder / "empty", "");
    EXPECT_EQ(FileBytes(folder / "empty").bytes(), "");
    writeText(folder / "some", "abc");
    EXPECT_EQ(FileBytes(folder / "some").bytes(), "abc");
    EXPECT_THROW(FileBytes(folder.path()), Error);
    EXPECT_THROW(FileBytes(folder / "absent"), Error);
}

TEST(ForBlocks, CoversEveryFrameOnceAndReportsTheFirstError) {
    std::vector<int> hits(1000, 0);
    forBlocks({3, 1000}, 7, [&](FrameRange block) {
        for (int i = block.begin; i < block.end; ++i)
            ++hits[static_cast<std::size_t>(i)];
    });
    for (int i = 0; i < 1000; ++i)
        EXPECT_EQ(hits[static_cast<std::size_t>(i)], i >= 3) << i;
    forBlocks({5, 5}, 1, [](FrameRange) { FAIL(); });
    const auto failing = [] {
        forBlocks({0, 100}, 1, [](FrameRange block) {
            if (block.begin >= 50) throw Error("block " + std::to_string(block.begin));
        });
    };
    EXPECT_THROW(failing(), Error);
}

TEST(Progress, PartsAddUpAndAStopThrows) {
    std::vector<double> seen;
    std::stop_source stop;
    const Progress whole{[&](double f) { seen.push_back(f); }, stop.get_token()};
    whole.part(0.5, 1.0).update(0.5);
    EXPECT_EQ(seen, std::vector<double>{0.75});
    stop.request_stop();
    EXPECT_THROW(whole.part(0, 1).update(0.1), Cancelled);
}

TEST(InputError, NamesThePlace) {
    EXPECT_STREQ(InputError("a.bvh", 3, 7, "what").what(), "a.bvh:3:7: what");
    EXPECT_STREQ(InputError("a.bvh", 3, 0, "what").what(), "a.bvh:3: what");
    EXPECT_STREQ(InputError("a.bvh", 0, 0, "what").what(), "a.bvh: what");
}

}  // namespace
}  // namespace kumite
