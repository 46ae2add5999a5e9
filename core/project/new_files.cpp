#include "core/project/new_files.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace kumite {

NewFiles::NewFiles(std::vector<std::filesystem::path> files) : files_(std::move(files)) {
    for (const auto& file : files_) {
        if (std::filesystem::exists(file))
            throw Error(fmt::format("{} is there already: choose another name.", file.string()));
    }
}

NewFiles::~NewFiles() {
    if (stay_) return;
    std::error_code ignored;
    for (const auto& file : files_)
        std::filesystem::remove(file, ignored);
}

}  // namespace kumite
