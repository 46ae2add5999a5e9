#include "core/motion/role_names.h"

#include <algorithm>
#include <map>

#include "core/base/text.h"

namespace kumite {
namespace {

using enum Role;

/// A family from its names, alternatives separated by '|'.
NameFamily family(std::string_view name, std::string_view pelvis, std::string_view neck,
                  std::string_view head, std::string_view clavicle, std::string_view shoulder,
                  std::string_view elbow, std::string_view wrist, std::string_view hip,
                  std::string_view knee, std::string_view ankle, std::string_view toe) {
    return {name,
            {{Pelvis, split(pelvis, '|')},
             {Neck, split(neck, '|')},
             {Head, split(head, '|')},
             {LeftClavicle, split(clavicle, '|')},
             {LeftShoulder, split(shoulder, '|')},
             {LeftElbow, split(elbow, '|')},
             {LeftWrist, split(wrist, '|')},
             {LeftHip, split(hip, '|')},
             {LeftKnee, split(knee, '|')},
             {LeftAnkle, split(ankle, '|')},
             {LeftToe, split(toe, '|')}}};
}

bool isLetterOrDigit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// The part up to and including the first separator: "Bip01 " of "Bip01 L Foot". A side is never
/// taken for a prefix.
std::string_view firstPart(std::string_view name) {
    const auto end = std::find_if_not(name.begin(), name.end(), isLetterOrDigit);
    if (end == name.end() || end + 1 == name.end()) return {};
    const std::string word = lowerCase(std::string_view(name.begin(), end));
    if (word == "l" || word == "r" || word == "left" || word == "right") return {};
    return {name.begin(), end + 1};
}

std::string_view withoutNameSpace(std::string_view name) {
    const auto at = name.find_last_of(":|");
    return at == std::string_view::npos || at + 1 == name.size() ? name : name.substr(at + 1);
}

/// How many characters all names begin with.
std::size_t commonPrefix(const std::vector<std::string>& names) {
    if (names.size() < 2) return 0;
    std::size_t length = names.front().size();
    for (const std::string& name : names) {
        const auto end =
            std::mismatch(name.begin(), name.end(), names.front().begin(), names.front().end());
        length = std::min(length, static_cast<std::size_t>(end.first - name.begin()));
    }
    return length;
}

}  // namespace

const std::vector<NameFamily>& nameFamilies() {
    // In the order of `family`'s parameters; alternatives in the order in which they are tried.
    static const std::vector<NameFamily> families = {
        // MotionBuilder, CMU by cgspeed, Mixamo, LAFAN1, Perception Neuron
        family("HumanIK", "hips", "neck|neck1", "head", "shoulder", "arm|uparm", "forearm", "hand",
               "upleg", "leg", "foot", "toebase|toe|toes"),
        // CMU, "Max-friendly" by cgspeed; DAZ
        family("Poser", "hip", "neck", "head", "collar", "shldr|shldrbend", "forearm|forearmbend",
               "hand", "thigh|thighbend", "shin", "foot", "toe"),
        // Vicon BodyBuilder, the CMU database itself
        family("ASF", "root", "lowerneck|neck", "head", "clavicle", "humerus", "radius",
               "wrist|hand", "femur", "tibia", "foot", "toes"),
        // Biovision, Xsens MVN's BVH
        family("Biovision", "hips", "neck", "head", "collar", "shoulder", "elbow", "wrist", "hip",
               "knee", "ankle", "toe|toes"),
        family("Biovision (older)", "hips", "neck", "head", "collar", "uparm", "lowarm", "hand",
               "upleg", "lowleg", "foot", "toe|toes"),
        // 3ds Max
        family("Biped", "pelvis", "neck", "head", "clavicle", "upperarm", "forearm", "hand",
               "thigh", "calf", "foot", "toe0|toe"),
        family("Xsens", "pelvis|hips", "neck", "head", "shoulder", "upperarm", "forearm", "hand",
               "upperleg", "lowerleg", "foot", "toe"),
        family("Rokoko", "hips", "neck", "head", "shoulder", "arm", "forearm", "hand", "thigh",
               "shin", "foot", "toe"),
        // also Unity's humanoid
        family("Bandai-Namco", "hips", "neck", "head", "shoulder", "upperarm", "lowerarm", "hand",
               "upperleg", "lowerleg", "foot", "toes|toe"),
        family("Unreal", "pelvis", "neck01", "head", "clavicle", "upperarm", "lowerarm", "hand",
               "thigh", "calf", "foot", "ball"),
        // Blender
        family("Rigify", "hips|torso|spine", "neck|spine004", "head|spine006", "shoulder",
               "upperarm", "forearm", "hand", "thigh", "shin", "foot", "toe"),
        family("SMPL", "pelvis", "neck", "head", "collar", "shoulder", "elbow", "wrist", "hip",
               "knee", "ankle", "foot"),
    };
    return families;
}

std::vector<std::string> plainJointNames(const std::vector<std::string_view>& names) {
    std::vector<std::string_view> bare;
    std::map<std::string_view, std::size_t> counts;
    for (const std::string_view name : names) {
        bare.push_back(withoutNameSpace(name));
        ++counts[firstPart(bare.back())];
    }
    std::string_view shared;
    for (const auto& [part, count] : counts) {
        if (!part.empty() && 2 * count > names.size()) shared = part;
    }
    std::vector<std::string> plain;
    for (std::string_view name : bare) {
        if (!shared.empty() && name.starts_with(shared)) name.remove_prefix(shared.size());
        std::string text;
        std::copy_if(name.begin(), name.end(), std::back_inserter(text), isLetterOrDigit);
        plain.push_back(lowerCase(text));
    }
    // "mixamorigHips", "Bip01LThigh": a prefix without a separator shows as what all share.
    const std::size_t common = commonPrefix(plain);
    constexpr std::size_t kShortestPrefix = 3;
    if (common >= kShortestPrefix) {
        for (std::string& name : plain) {
            if (name.size() > common) name.erase(0, common);
        }
    }
    return plain;
}

bool isSided(std::string_view plain, std::string_view base, bool left) {
    const std::string_view word = left ? "left" : "right";
    const std::string_view letter = word.substr(0, 1);
    for (const std::string_view side : {word, letter}) {
        if (plain.size() != base.size() + side.size()) continue;
        if (plain.starts_with(side) && plain.ends_with(base)) return true;
        if (plain.starts_with(base) && plain.ends_with(side)) return true;
    }
    return false;
}

}  // namespace kumite
