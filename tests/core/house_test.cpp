// The rules of the house that a reader of includes can check.
#include <filesystem>
#include <map>
#include <regex>

#include <gtest/gtest.h>

#include "tests/support/fixtures.h"

namespace kumite {
namespace {

/// Calls `check(file, include)` for every include of every source below a folder.
template <typename Check>
int forIncludes(const std::string& folder, const Check& check) {
    static const std::regex include(R"(#include\s*[<"]([^>"]+)[>"])");
    int files = 0;
    const std::filesystem::path root(KUMITE_SOURCE_DIR);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
        const std::string suffix = entry.path().extension().string();
        if (suffix != ".h" && suffix != ".cpp") continue;
        ++files;
        const std::string text = test::readText(entry.path());
        const std::string name = entry.path().lexically_relative(root).generic_string();
        for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
            check(name, (*it)[1].str());
        }
    }
    return files;
}

TEST(House, CoreKnowsNeitherQtNorVtk) {
    const int files = forIncludes("core", [](const std::string& file, const std::string& include) {
        EXPECT_FALSE(std::regex_match(include, std::regex("Q[A-Z].*|vtk.*|studio/.*")))
            << file << " includes " << include;
    });
    EXPECT_GT(files, 50);
}

TEST(House, RoomsOfCoreKnowOnlyTheRoomsBelowThem) {
    const std::vector<std::string> order = {"base", "motion", "formats", "segmentation", "project", "cli"};
    const std::map<std::string, std::string> notAllowed = {{"segmentation", "formats"}};
    const auto level = [&](const std::string& room) {
        return std::find(order.begin(), order.end(), room) - order.begin();
    };
    forIncludes("core", [&](const std::string& file, const std::string& include) {
        static const std::regex room(R"(core/(\w+)/.*)");
        std::smatch from, to;
        ASSERT_TRUE(std::regex_match(file, from, room));
        if (!std::regex_match(include, to, room)) return;
        EXPECT_LE(level(to[1]), level(from[1])) << file << " includes " << include;
        EXPECT_LT(level(to[1]), static_cast<std::ptrdiff_t>(order.size())) << include;
        const auto barred = notAllowed.find(from[1]);
        if (barred == notAllowed.end()) return;
        EXPECT_NE(barred->second, to[1].str()) << file;
    });
}

TEST(House, VtkLivesInTheViewAlone) {
    forIncludes("studio", [](const std::string& file, const std::string& include) {
        if (file.starts_with("studio/view3d/")) return;
        EXPECT_FALSE(include.starts_with("vtk")) << file << " includes " << include;
    });
}

}  // namespace
}  // namespace kumite
