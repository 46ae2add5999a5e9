// The rules of the house that a reader of includes can check.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

/// What an `#include` line names; empty for other lines.
std::string includedBy(std::string_view line) {
    line = trimmed(line);
    if (!line.starts_with("#include")) return {};
    const auto begin = line.find_first_of("<\"");
    const auto end = line.find_last_of(">\"");
    return begin < end ? std::string(line.substr(begin + 1, end - begin - 1)) : std::string();
}

/// Calls `check(file, include)` for every include of every source below a folder.
template <typename Check>
int forIncludes(const std::string& folder, const Check& check) {
    int files = 0;
    const std::filesystem::path root = test::sourceFolder();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
        const std::string suffix = entry.path().extension().string();
        if (suffix != ".h" && suffix != ".cpp") continue;
        ++files;
        const std::string text = test::readText(entry.path());
        const std::string name = entry.path().lexically_relative(root).generic_string();
        for (const std::string_view line : split(text, '\n')) {
            const std::string include = includedBy(line);
            if (!include.empty()) check(name, include);
        }
    }
    return files;
}

/// The room of core that a path lies in; empty outside of core.
std::string roomOf(const std::string& path) {
    const auto parts = split(path, '/');
    return parts.size() > 2 && parts[0] == "core" ? std::string(parts[1]) : std::string();
}

bool isQt(const std::string& include) {
    return include.size() > 1 && include[0] == 'Q' && include[1] >= 'A' && include[1] <= 'Z';
}

TEST(House, CoreKnowsNeitherQtNorVtk) {
    const int files = forIncludes("core", [](const std::string& file, const std::string& include) {
        const bool foreign =
            isQt(include) || include.starts_with("vtk") || include.starts_with("studio/");
        EXPECT_FALSE(foreign) << file << " includes " << include;
    });
    EXPECT_GT(files, 50);
}

TEST(House, RoomsOfCoreKnowOnlyTheRoomsBelowThem) {
    const std::vector<std::string> order = {
        "base",      "motion",      "demo",       "formats",   "editing", "segmentation", "quality",
        "labelling", "interaction", "transition", "synthesis", "project", "cli"};
    // The truth of a made bout is its plan: what judges it must not know it, nor be known by it.
    const std::map<std::string, std::set<std::string>> notAllowed = {
        {"formats", {"demo"}},
        {"editing", {"demo"}},
        {"segmentation", {"demo", "formats"}},
        {"quality", {"demo", "formats"}},
        {"labelling", {"demo"}},
        {"interaction", {"demo", "formats"}},
        {"transition", {"demo", "formats", "segmentation", "labelling", "interaction"}},
        {"synthesis", {"demo"}}};
    const auto level = [&](const std::string& room) {
        return std::find(order.begin(), order.end(), room) - order.begin();
    };
    forIncludes("core", [&](const std::string& file, const std::string& include) {
        const std::string from = roomOf(file);
        const std::string to = roomOf(include);
        if (to.empty()) return;
        EXPECT_LE(level(to), level(from)) << file << " includes " << include;
        EXPECT_LT(level(to), static_cast<std::ptrdiff_t>(order.size())) << include;
        const auto barred = notAllowed.find(from);
        if (barred == notAllowed.end()) return;
        EXPECT_FALSE(barred->second.count(to)) << file << " includes " << include;
    });
}

TEST(House, TheDemoBoutKnowsNothingOfWhatJudgesIt) {
    const int files =
        forIncludes("core/demo", [](const std::string& file, const std::string& include) {
            const std::string to = roomOf(include);
            const bool allowed = to.empty() || to == "demo" || to == "base" || to == "motion";
            EXPECT_TRUE(allowed) << file << " includes " << include;
        });
    EXPECT_GT(files, 20);
}

TEST(House, OneFileKnowsLibsvm) {
    forIncludes("core", [](const std::string& file, const std::string& include) {
        if (file == "core/labelling/msvm.cpp") return;
        EXPECT_NE(include, "svm.h") << file;
        EXPECT_NE(include, "libsvm/svm.h") << file;
    });
}

TEST(House, XmlLivesInTheFormatsAlone) {
    forIncludes("core", [](const std::string& file, const std::string& include) {
        if (file.starts_with("core/formats/")) return;
        EXPECT_NE(include, "pugixml.hpp") << file;
    });
}

TEST(House, NumbersInTheWindowFollowTheLanguage) {
    // What is measured on standard error, what another program is told; and times of a clock.
    const std::set<std::string> others{"loop_watch.cpp", "bout_export.cpp", "words.cpp"};
    const std::filesystem::path studio = test::sourceFolder() / "studio";
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(studio)) {
        const std::filesystem::path& path = entry.path();
        if (path.extension() != ".cpp" || others.contains(path.filename().string())) continue;
        ++files;
        const std::string text = test::readText(path);
        for (const std::string_view line : split(text, '\n')) {
            const bool formats = line.find(", 'f', ") != std::string_view::npos ||
                                 line.find(", 'g', ") != std::string_view::npos;
            EXPECT_FALSE(formats && line.find("QLocale") == std::string_view::npos)
                << path.filename() << " writes a number as English does; numberText of "
                << "studio/app/words.h does not: " << trimmed(line);
        }
    }
    EXPECT_GT(files, 100);
}

TEST(House, VtkLivesInTheViewAlone) {
    forIncludes("studio", [](const std::string& file, const std::string& include) {
        if (file.starts_with("studio/view3d/")) return;
        EXPECT_FALSE(include.starts_with("vtk")) << file << " includes " << include;
    });
}

}  // namespace
}  // namespace kumite
