#include "core/project/versions.h"

#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/project/edits.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::readText;
using test::TemporaryFolder;
using test::writeText;

/// A project file without takes whose cutoff tells one state from another.
struct Saved {
    TemporaryFolder folder;
    std::filesystem::path file = folder / "bout.kumite";

    Findings save(double cutoff) const {
        Project project;
        project.segmentation.cutoff = cutoff;
        return saveProject(project, file);
    }
    double cutoff(const KeptVersion& version) const {
        return loadVersion(file, version).project.segmentation.cutoff;
    }
};

TEST(Versions, TheLastTenStatesAreKeptTheNewestFirst) {
    const Saved saved;
    for (int i = 1; i <= 14; ++i) {
        EXPECT_TRUE(saved.save(i).empty());
        // Files tell their time by the kernel's tick.
        std::this_thread::sleep_for(std::chrono::milliseconds(12));
    }
    const auto versions = keptVersions(saved.file);
    ASSERT_EQ(versions.size(), 10u);
    for (std::size_t i = 0; i < versions.size(); ++i) {
        EXPECT_EQ(saved.cutoff(versions[i]), 13.0 - static_cast<double>(i));
    }
    EXPECT_EQ(loadProject(saved.file).project.segmentation.cutoff, 14.0);
}

TEST(Versions, SavingTheSameKeepsNothing) {
    const Saved saved;
    saved.save(3);
    saved.save(3);
    EXPECT_TRUE(keptVersions(saved.file).empty());
}

TEST(Versions, AClockThatWasSetBackDoesNotMakeTheLastStateTheOldest) {
    const Saved saved;
    for (int i = 1; i <= 12; ++i) {
        saved.save(i);
        std::this_thread::sleep_for(std::chrono::milliseconds(12));
    }
    // What was saved last, as if the clock had been set back by a day before.
    std::filesystem::last_write_time(
        saved.file, std::filesystem::last_write_time(saved.file) - std::chrono::hours(24));
    saved.save(13);
    const auto versions = keptVersions(saved.file);
    ASSERT_EQ(versions.size(), 10u);
    EXPECT_EQ(saved.cutoff(versions[0]), 12.0);
    EXPECT_EQ(saved.cutoff(versions[1]), 11.0);
}

TEST(Versions, TimeIsThatOfTheSave) {
    const Saved saved;
    const auto before = std::chrono::system_clock::now() - std::chrono::seconds(1);
    saved.save(3);
    saved.save(4);
    const auto versions = keptVersions(saved.file);
    ASSERT_EQ(versions.size(), 1u);
    EXPECT_GE(versions[0].saved, before);
    EXPECT_LE(versions[0].saved, std::chrono::system_clock::now());
}

TEST(Versions, RecordingsAreFoundFromTheProjectsFolder) {
    const TemporaryFolder folder;
    Project project = test::makeBout();
    for (Fighter& fighter : project.takes[0].fighters) {
        const bool isFirst = &fighter == &project.takes[0].fighters.front();
        fighter.recording.path = folder / "recordings" / (isFirst ? "red.bvh" : "blue.bvh");
    }
    const auto file = folder / "bout.kumite";
    saveProject(project, file);
    saveProject(setSegmentation(project, {5, 0.1, ForceCurve::Norm})->project, file);
    const auto versions = keptVersions(file);
    ASSERT_EQ(versions.size(), 1u);
    EXPECT_EQ(versions[0].takes, 1);
    const LoadedProject loaded = loadVersion(file, versions[0], project);
    EXPECT_EQ(loaded.project, project) << "motions are taken over from the open project";
    EXPECT_TRUE(loaded.findings.empty());
    const auto back = restoreVersion(setSegmentation(project, {5, 0.1, ForceCurve::Norm})->project,
                                     loaded.project, "10:32");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->project, project);
    EXPECT_EQ(back->name, "Restore the version of 10:32");
    EXPECT_FALSE(restoreVersion(project, loaded.project, "10:32"));
}

TEST(Versions, DamagedOnesAreListedWithTheirProblemAndStrangersAreLeftAlone) {
    const Saved saved;
    saved.save(3);
    saved.save(4);
    writeText(versionsFolder(saved.file) / "20080131T174502.123456.kumite", "{\"kum");
    writeText(versionsFolder(saved.file) / "notes.txt", "mine");
    const auto versions = keptVersions(saved.file);
    ASSERT_EQ(versions.size(), 2u);
    EXPECT_TRUE(versions[0].problem.empty());
    EXPECT_FALSE(versions[1].problem.empty());
    EXPECT_THROW(loadVersion(saved.file, versions[1]), InputError);
    for (int i = 5; i < 20; ++i)
        saved.save(i);
    EXPECT_EQ(readText(versionsFolder(saved.file) / "notes.txt"), "mine");
}

TEST(Versions, WhereTheyCannotBeKeptTheProjectIsSavedAndAWarningSaysSo) {
    const Saved saved;
    saved.save(3);
    writeText(saved.folder / ".kumite-versions", "a file is in the way");
    const Findings findings = saved.save(4);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].severity, Severity::Warning);
    EXPECT_EQ(loadProject(saved.file).project.segmentation.cutoff, 4.0);
}

/// Runs `work` in a process that is not root and may write at most `bytes` to a file; its exit
/// code is what `work` returns.
int restricted(rlim_t bytes, const std::function<int()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        constexpr uid_t kNobody = 65534;
        if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(77);
        ::_exit(work());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// 0: the save failed with a sentence that names the file.
int saveFails(const Saved& saved) {
    try {
        saved.save(4);
        return 1;
    } catch (const Error& error) {
        const std::string text = error.what();
        return text.find("bout.kumite") != std::string::npos && text.ends_with(".") ? 0 : 2;
    } catch (...) {
        return 3;
    }
}

TEST(FullDisk, OldFileStaysWholeAndNothingLiesAround) {
    const Saved saved;
    saved.save(3);
    std::filesystem::permissions(saved.folder.path(), std::filesystem::perms::all);
    const std::string old = readText(saved.file);
    EXPECT_EQ(restricted(100, [&] { return saveFails(saved); }), 0);
    EXPECT_EQ(readText(saved.file), old);
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(saved.folder.path()))
        files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(files, 1);
}

TEST(ReadOnlyFolder, OldFileStaysWhole) {
    const Saved saved;
    saved.save(3);
    const std::string old = readText(saved.file);
    using std::filesystem::perms;
    std::filesystem::permissions(
        saved.folder.path(),
        perms::all & ~(perms::owner_write | perms::group_write | perms::others_write));
    EXPECT_EQ(restricted(RLIM_INFINITY, [&] { return saveFails(saved); }), 0);
    std::filesystem::permissions(saved.folder.path(), perms::owner_all);
    EXPECT_EQ(readText(saved.file), old);
}

TEST(ReadOnlyFolder, AFolderThatMayNotEvenBeEnteredGivesASentence) {
    const Saved saved;
    saved.save(3);
    std::filesystem::permissions(saved.folder.path(), std::filesystem::perms::none);
    EXPECT_EQ(restricted(RLIM_INFINITY, [&] { return saveFails(saved); }), 0);
    std::filesystem::permissions(saved.folder.path(), std::filesystem::perms::owner_all);
    EXPECT_EQ(loadProject(saved.file).project.segmentation.cutoff, 3.0);
}

TEST(AtomicWrite, TakesAwayWhatACrashLeftButNothingThatMayStillBeWritten) {
    const TemporaryFolder folder;
    writeText(folder / ".kumite-1-1.part", "left");
    writeText(folder / ".kumite-1-2.part", "being written");
    writeText(folder / "mine.part", "somebody's");
    for (const char* old : {".kumite-1-1.part", "mine.part"}) {
        std::filesystem::last_write_time(
            folder / old, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    }
    writeFileAtomically(folder / "bout.kumite", "text");
    EXPECT_FALSE(std::filesystem::exists(folder / ".kumite-1-1.part"));
    EXPECT_TRUE(std::filesystem::exists(folder / ".kumite-1-2.part"));
    EXPECT_TRUE(std::filesystem::exists(folder / "mine.part"));
    EXPECT_EQ(readText(folder / "bout.kumite"), "text");
}

TEST(AtomicWrite, ManyThreadsIntoOneFolderDoNotDisturbEachOther) {
    const TemporaryFolder folder;
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&, t] {
                for (int i = 0; i < 50; ++i) {
                    writeFileAtomically(folder / std::to_string(t), std::string(1000, 'a' + t),
                                        Outlives::Program);
                }
            });
        }
    }
    for (int t = 0; t < 4; ++t)
        EXPECT_EQ(readText(folder / std::to_string(t)), std::string(1000, 'a' + t));
}

}  // namespace
}  // namespace kumite
