#pragma once

#include <filesystem>
#include <vector>

namespace kumite {

/// Files that belong together: unless all is well in the end they are taken away again, so that
/// their names can be used once more.
class NewFiles {
public:
    /// Throws Error if one of them is there already.
    explicit NewFiles(std::vector<std::filesystem::path> files);
    ~NewFiles();
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;

    const std::vector<std::filesystem::path>& paths() const { return files_; }
    void stay() { stay_ = true; }

private:
    std::vector<std::filesystem::path> files_;
    bool stay_ = false;
};

}  // namespace kumite
