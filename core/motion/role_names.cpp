#include "core/motion/role_names.h"

#include <algorithm>
#include <map>

#include "core/base/text.h"

namespace kumite {
namespace {

using enum Role;

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
    static const std::vector<NameFamily> families = {
        {"HumanIK",  // MotionBuilder, CMU by cgspeed, Mixamo, LAFAN1, Perception Neuron
         {{Pelvis, {"hips"}},
          {Neck, {"neck", "neck1"}},
          {Head, {"head"}},
          {LeftClavicle, {"shoulder"}},
          {LeftShoulder, {"arm", "uparm"}},
          {LeftElbow, {"forearm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"upleg"}},
          {LeftKnee, {"leg"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toebase", "toe", "toes"}}}},
        {"Poser",  // CMU, "Max-friendly" by cgspeed; DAZ
         {{Pelvis, {"hip"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"collar"}},
          {LeftShoulder, {"shldr", "shldrbend"}},
          {LeftElbow, {"forearm", "forearmbend"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"thigh", "thighbend"}},
          {LeftKnee, {"shin"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toe"}}}},
        {"ASF",  // Vicon BodyBuilder, the CMU database itself
         {{Pelvis, {"root"}},
          {Neck, {"lowerneck", "neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"clavicle"}},
          {LeftShoulder, {"humerus"}},
          {LeftElbow, {"radius"}},
          {LeftWrist, {"wrist", "hand"}},
          {LeftHip, {"femur"}},
          {LeftKnee, {"tibia"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toes"}}}},
        {"Biovision",  // Biovision, Xsens MVN's BVH
         {{Pelvis, {"hips"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"collar"}},
          {LeftShoulder, {"shoulder"}},
          {LeftElbow, {"elbow"}},
          {LeftWrist, {"wrist"}},
          {LeftHip, {"hip"}},
          {LeftKnee, {"knee"}},
          {LeftAnkle, {"ankle"}},
          {LeftToe, {"toe", "toes"}}}},
        {"Biovision (older)",
         {{Pelvis, {"hips"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"collar"}},
          {LeftShoulder, {"uparm"}},
          {LeftElbow, {"lowarm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"upleg"}},
          {LeftKnee, {"lowleg"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toe", "toes"}}}},
        {"Biped",  // 3ds Max
         {{Pelvis, {"pelvis"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"clavicle"}},
          {LeftShoulder, {"upperarm"}},
          {LeftElbow, {"forearm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"thigh"}},
          {LeftKnee, {"calf"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toe0", "toe"}}}},
        {"Xsens",
         {{Pelvis, {"pelvis", "hips"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"shoulder"}},
          {LeftShoulder, {"upperarm"}},
          {LeftElbow, {"forearm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"upperleg"}},
          {LeftKnee, {"lowerleg"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toe"}}}},
        {"Rokoko",
         {{Pelvis, {"hips"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"shoulder"}},
          {LeftShoulder, {"arm"}},
          {LeftElbow, {"forearm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"thigh"}},
          {LeftKnee, {"shin"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toe"}}}},
        {"Bandai-Namco",  // also Unity's humanoid
         {{Pelvis, {"hips"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"shoulder"}},
          {LeftShoulder, {"upperarm"}},
          {LeftElbow, {"lowerarm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"upperleg"}},
          {LeftKnee, {"lowerleg"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toes", "toe"}}}},
        {"Unreal",
         {{Pelvis, {"pelvis"}},
          {Neck, {"neck01"}},
          {Head, {"head"}},
          {LeftClavicle, {"clavicle"}},
          {LeftShoulder, {"upperarm"}},
          {LeftElbow, {"lowerarm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"thigh"}},
          {LeftKnee, {"calf"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"ball"}}}},
        {"Rigify",  // Blender
         {{Pelvis, {"hips", "torso", "spine"}},
          {Neck, {"neck", "spine004"}},
          {Head, {"head", "spine006"}},
          {LeftClavicle, {"shoulder"}},
          {LeftShoulder, {"upperarm"}},
          {LeftElbow, {"forearm"}},
          {LeftWrist, {"hand"}},
          {LeftHip, {"thigh"}},
          {LeftKnee, {"shin"}},
          {LeftAnkle, {"foot"}},
          {LeftToe, {"toe"}}}},
        {"SMPL",
         {{Pelvis, {"pelvis"}},
          {Neck, {"neck"}},
          {Head, {"head"}},
          {LeftClavicle, {"collar"}},
          {LeftShoulder, {"shoulder"}},
          {LeftElbow, {"elbow"}},
          {LeftWrist, {"wrist"}},
          {LeftHip, {"hip"}},
          {LeftKnee, {"knee"}},
          {LeftAnkle, {"ankle"}},
          {LeftToe, {"foot"}}}},
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
