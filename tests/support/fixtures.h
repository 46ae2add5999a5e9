#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/motion/kinematics.h"
#include "core/motion/motion.h"

namespace kumite::test {

/// The checkout that these tests were built from.
std::filesystem::path sourceFolder();

/// Folder of the real recordings: KUMITE_DATA, else shared/data beside the checkout. Nothing where
/// there is none: tests on recordings are then skipped (a clone alone cannot have them).
std::optional<std::filesystem::path> dataFolder();

/// A folder of its own for one test, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

std::string readText(const std::filesystem::path& path);
void writeText(const std::filesystem::path& path, const std::string& text);

}  // namespace kumite::test

/// Skips a test that needs the real recordings where they are not present.
#define KUMITE_NEEDS_DATA()          \
    if (!kumite::test::dataFolder()) \
    GTEST_SKIP() << "no recordings: set KUMITE_DATA to the folder that holds them"
