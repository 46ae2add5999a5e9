#include "core/formats/recording.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/amc.h"
#include "core/formats/bvh.h"

namespace kumite {
namespace {

namespace fs = std::filesystem;

/// A format that is not read: told by how its files begin, else by their extension.
struct ForeignFormat {
    std::string_view name;
    std::string_view beginning;
    std::string_view extension;
};

constexpr std::array kForeignFormats = {
    ForeignFormat{"FBX", "Kaydara FBX Binary", ".fbx"},
    ForeignFormat{"FBX", "; FBX", ".fbx"},
    ForeignFormat{"C3D", "\x02\x50", ".c3d"},
    ForeignFormat{"glTF", "glTF", ".glb"},
    ForeignFormat{"glTF", "glTF", ".gltf"},
    ForeignFormat{"VRM", "glTF", ".vrm"},
    ForeignFormat{"TRC", "PathFileType", ".trc"},
    ForeignFormat{"HTR", "[Header]", ".htr"},
    ForeignFormat{"USD", "PXR-USDC", ".usd"},
    ForeignFormat{"USD", "#usda", ".usda"},
    ForeignFormat{"USD", "PXR-USDC", ".usdc"},
    ForeignFormat{"zipped", "PK\x03\x04", ".usdz"},
    ForeignFormat{"NumPy", "PK\x03\x04", ".npz"},
    ForeignFormat{"NumPy", "\x93NUMPY", ".npy"},
    ForeignFormat{"Blender", "BLENDER", ".blend"},
    ForeignFormat{"Collada", "<?xml", ".dae"},
};

/// Which of the foreign formats a file is; a beginning and extension that both fit count most.
const ForeignFormat* foreignFormat(std::string_view bytes, std::string_view extension) {
    const auto begins = [&](const ForeignFormat& f) { return bytes.starts_with(f.beginning); };
    const auto isNamed = [&](const ForeignFormat& f) { return f.extension == extension; };
    const ForeignFormat* found = nullptr;
    for (const ForeignFormat& format : kForeignFormats) {
        if (begins(format) && isNamed(format)) return &format;
        if (!found && (begins(format) || isNamed(format))) found = &format;
    }
    return found;
}

/// The first word of a text file, in lower case: behind a byte order mark, space and comments.
std::string firstWord(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size()));
        if (!text.starts_with('#') && !text.starts_with("//")) break;
        text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    }
    constexpr std::size_t kLongest = 32;
    return lowerCase(text.substr(0, std::min(text.find_first_of(" \t\r\n\v\f"), kLongest)));
}

bool isAmcText(std::string_view text) {
    const std::string word = firstWord(text);
    return text.starts_with("#!OML") || word == ":fully-specified" || word == ":degrees" ||
           word == ":radians";
}

std::string leadingDigits(const std::string& text) {
    return text.substr(0, std::min(text.find_first_not_of("0123456789"), text.size()));
}

/// Whether an .asf's name fits an .amc's: the same leading number (the subject: 135.asf and
/// 135_06.amc), or without such numbers the beginning of it.
bool namesFit(const fs::path& asf, const fs::path& amc) {
    const std::string skeleton = lowerCase(asf.stem().string());
    const std::string motion = lowerCase(amc.stem().string());
    const std::string subject = leadingDigits(skeleton);
    if (!subject.empty()) return subject == leadingDigits(motion);
    return motion.starts_with(skeleton);
}

/// The .asf that belongs to `amc`: the only one beside it, or the only one whose name fits.
fs::path findAsf(const fs::path& amc) {
    const fs::path folder = amc.has_parent_path() ? amc.parent_path() : fs::path(".");
    std::vector<fs::path> all;
    std::error_code unreadable;  // a folder that cannot be listed counts as one without an .asf
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) {
        if (lowerCase(entry.path().extension().string()) == ".asf") {
            all.push_back(amc.parent_path() / entry.path().filename());
        }
    }
    if (all.empty()) {
        throw InputError(amc.string(), 0, 0,
                         "found no skeleton beside it, expected an .asf file (name it with --asf)");
    }
    if (all.size() == 1) return all.front();
    std::sort(all.begin(), all.end());
    std::vector<fs::path> fitting;
    for (const fs::path& asf : all) {
        if (namesFit(asf, amc)) fitting.push_back(asf);
    }
    if (fitting.size() == 1) return fitting.front();
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const fs::path& asf : all)
        names.push_back(asf.filename().string());
    throw InputError(amc.string(), 0, 0,
                     fmt::format("found several skeletons beside it ({}), expected one (name it "
                                 "with --asf)",
                                 fmt::join(names, ", ")));
}

Recording readAsfAndAmc(const fs::path& amc, std::string_view amcText, const ReadOptions& options,
                        const Progress& progress) {
    const fs::path asf = options.asf ? *options.asf : findAsf(amc);
    const FileBytes asfFile(asf);
    const AsfSkeleton skeleton = readAsf(asfFile.bytes(), asf.string());
    Recording recording = readAmc(amcText, amc.string(), skeleton, progress);
    recording.findings.insert(recording.findings.begin(), skeleton.findings.begin(),
                              skeleton.findings.end());
    recording.sha256 = sha256(std::string(asfFile.bytes()) + std::string(amcText));
    recording.asf = asf;
    return recording;
}

}  // namespace

Recording readRecording(const fs::path& path, const ReadOptions& options,
                        const Progress& progress) {
    std::error_code error;
    if (!fs::exists(path, error)) {
        throw InputError(
            path.string(), 0, 0,
            error ? "cannot be read: " + error.message() + "." : "there is no such file.");
    }
    const FileBytes file(path);
    const std::string_view bytes = file.bytes();
    const std::string extension = lowerCase(path.extension().string());
    const bool isBvh = firstWord(bytes) == "hierarchy";
    if (!isBvh && (extension == ".amc" || isAmcText(bytes))) {
        return readAsfAndAmc(path, bytes, options, progress);
    }
    if (!isBvh && (extension == ".asf" || firstWord(bytes) == ":version")) {
        throw InputError(path.string(), 0, 0,
                         "found an ASF skeleton, which holds no motion, expected the .amc file "
                         "that belongs to it.");
    }
    if (!isBvh) {
        if (const ForeignFormat* format = foreignFormat(bytes, extension)) {
            throw InputError(path.string(), 0, 0,
                             fmt::format("found {} data, expected BVH or ASF/AMC: import it into "
                                         "Blender and export it as Motion Capture (.bvh).",
                                         format->name));
        }
    }
    Recording recording = readBvh(bytes, path.string(), progress);
    recording.sha256 = sha256(bytes);
    return recording;
}

std::vector<std::string> rootNames(const Recording& recording) {
    std::map<std::string, int> total;
    for (const auto& motion : recording.motions)
        ++total[motion->skeleton->joints.front().name];
    std::map<std::string, int> seen;
    std::vector<std::string> names;
    for (const auto& motion : recording.motions) {
        const std::string& name = motion->skeleton->joints.front().name;
        const int number = ++seen[name];
        names.push_back(total[name] == 1 ? name : fmt::format("{}#{}", name, number));
    }
    return names;
}

std::shared_ptr<const Motion> motionOfRoot(const Recording& recording, const std::string& root) {
    if (recording.motions.empty()) throw Error("The recording holds no skeleton.");
    if (root.empty()) return recording.motions.front();
    const std::vector<std::string> names = rootNames(recording);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (root == names[i] || root == fmt::format("#{}", i + 1)) return recording.motions[i];
    }
    // A repeated name without a number means its first, as no name at all does.
    for (const auto& motion : recording.motions) {
        if (motion->skeleton->joints.front().name == root) return motion;
    }
    throw Error(
        fmt::format("There is no root {}; the recording has {}.", root, fmt::join(names, ", ")));
}

}  // namespace kumite
