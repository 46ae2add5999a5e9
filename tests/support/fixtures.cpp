#include "tests/support/fixtures.h"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <unistd.h>

namespace kumite::test {

std::filesystem::path sourceFolder() {
    return KUMITE_SOURCE_DIR;
}

std::optional<std::filesystem::path> dataFolder() {
    const char* set = std::getenv("KUMITE_DATA");
    const std::filesystem::path folder =
        set ? std::filesystem::path(set) : sourceFolder() / ".." / "shared" / "data";
    if (!std::filesystem::exists(folder / "MANIFEST.md")) return std::nullopt;
    return std::filesystem::canonical(folder);
}

TemporaryFolder::TemporaryFolder() {
    static std::atomic<int> counter{0};
    path_ = std::filesystem::temp_directory_path() /
            ("kumite-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string readText(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void writeText(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace kumite::test
