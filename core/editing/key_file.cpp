#include "core/editing/key_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/editing/pose_handles.h"
#include "core/editing/strike.h"
#include "core/formats/json_text.h"
#include "core/motion/blend.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

constexpr double kRadians = std::numbers::pi / 180;
constexpr int kVersion = 1;
constexpr int kLastFrame = 1'000'000;  ///< four hours at 60 Hz
constexpr double kFarthest = 1000;     ///< metres

void onlyKeys(const JsonReader& json, const std::set<std::string>& known) {
    for (const std::string& key : json.keys()) {
        if (!known.count(key)) {
            throw json.error(fmt::format("\"{}\" is not known here, expected one of {}", key,
                                         fmt::join(known, ", ")));
        }
    }
}

Vector3d point(const JsonReader& json) {
    if (json.size() != 3) throw json.error("expected three numbers, x, y and z in metres");
    const Vector3d p(json.at(0).number(), json.at(1).number(), json.at(2).number());
    if (p.cwiseAbs().maxCoeff() > kFarthest) throw json.error("is more than a kilometre away");
    return p;
}

/// Three angles in degrees about x, y and z, R = Rz · Rx · Ry; or a quaternion w, x, y, z.
Quaterniond turn(const JsonReader& json) {
    if (json.size() == 4) {
        const Quaterniond q(json.at(0).number(), json.at(1).number(), json.at(2).number(),
                            json.at(3).number());
        if (!(q.norm() > 1e-6) || !std::isfinite(q.norm()))
            throw json.error("expected a quaternion w, x, y, z that is not zero");
        return q.normalized();
    }
    if (json.size() != 3) {
        throw json.error(
            "expected three angles in degrees about x, y, z or a quaternion w, x, y, z");
    }
    return turnOfAngles({json.at(0).number(), json.at(1).number(), json.at(2).number()});
}

/// A joint by its name, its role or, as "#12", its index.
int jointNamed(const Rig& rig, const std::string& name, const JsonReader& json) {
    for (int j = 0; j < rig.jointCount(); ++j) {
        if (rig.joint(j).name == name && !rig.joint(j).isEndSite) return j;
    }
    if (const auto role = roleFromName(name); role && rig.roles[*role]) return *rig.roles[*role];
    if (name.starts_with("#")) {
        const auto index = parseInteger(std::string_view(name).substr(1));
        if (index && *index >= 0 && *index < rig.jointCount() && !rig.joint(*index).isEndSite)
            return *index;
    }
    throw json.error(
        fmt::format("the skeleton has no joint \"{}\"; joints are named as in their file, by role "
                    "(left_elbow) or by index (#7)",
                    name));
}

/// What `jointNamed` finds the joint by.
std::string nameOf(const Rig& rig, int joint) {
    const std::string& name = rig.joint(joint).name;
    const auto same = std::count_if(rig.joints.begin(), rig.joints.end(), [&](const auto& other) {
        return other.name == name && !other.isEndSite;
    });
    return same == 1 && asStored(name) == name ? name : fmt::format("#{}", joint);
}

/// Standing at the origin, all rotations zero.
Pose restPose(const Rig& rig) {
    Pose pose;
    pose.turns.assign(rig.joints.size(), Quaterniond::Identity());
    double lowest = 0;
    for (const Vector3d& p : restPositions(rig))
        lowest = std::min(lowest, p.y());
    pose.root.y() = -lowest;
    return pose;
}

/// Puts the pelvis over a point of the floor, facing `yaw`.
Pose placed(const Rig& rig, const Pose& pose, const JsonReader& json) {
    onlyKeys(json, {"x", "z", "yaw", "height"});
    const GroundTransform home = toOrigin(rig, pose);
    const GroundTransform now = home.inverse();
    const auto either = [&](const char* key, double otherwise) {
        return json.has(key) ? json[key].number() : otherwise;
    };
    const GroundTransform there{
        json.has("yaw") ? std::remainder(json["yaw"].number(), 360.0) * kRadians : now.yaw,
        std::clamp(either("x", now.x), -kFarthest, kFarthest),
        std::clamp(either("z", now.z), -kFarthest, kFarthest)};
    Pose result = moved(pose, there * home);
    if (json.has("height")) {
        const auto hips = handlePoint(rig, result, Handle::Hips);
        if (hips)
            result.root.y() +=
                std::clamp(json["height"].number(), -kFarthest, kFarthest) - hips->y();
    }
    return result;
}

/// Draws handles to points given in the pose's own frame: below the pelvis, x left, z ahead.
Pose drawn(const Rig& rig, Pose pose, const JsonReader& json) {
    const GroundTransform fromHome = toOrigin(rig, pose).inverse();
    Pins pins;
    for (const std::string& name : json.keys()) {
        const auto handle = handleFromName(name);
        if (!handle || !handleJoint(rig, *handle)) {
            throw json.error(fmt::format(
                "there is no handle \"{}\"; expected left_hand, right_hand, left_foot, right_foot, "
                "hips, chest or head of a skeleton that has it",
                name));
        }
        const Vector3d place = fromHome * point(json[name]);
        const DragResult result = dragged(rig, pose, *handle, place, pins);
        constexpr double kNear = 0.5;
        if (result.missing > kNear) {
            throw json[name].error(
                fmt::format("lies {:.2f} m out of reach of the body", result.missing));
        }
        pose = result.pose;
        pins[*handle] = true;
    }
    return pose;
}

KeyPose readKey(const JsonReader& json, const Rig& rig, const PoseSource& poses,
                const Pose& before) {
    onlyKeys(json, {"frame", "clip", "at", "mirror", "root", "turns", "place", "handles", "easing",
                    "note"});
    KeyPose key;
    key.frame = json["frame"].integer();
    if (key.frame < 0 || key.frame > kLastFrame)
        throw json["frame"].error(fmt::format("expected a frame from 0 to {}", kLastFrame));
    key.pose = before;
    if (json.has("clip")) {
        const std::string clip = json["clip"].text();
        try {
            key.pose = poses(clip, json.has("at") ? json["at"].integer() : 0);
        } catch (const InputError&) {
            throw;
        } catch (const Error& error) {
            std::string sentence = error.what();
            if (!sentence.empty() && sentence.back() == '.') sentence.pop_back();
            throw json["clip"].error(sentence);
        }
    } else if (json.has("at")) {
        throw json.error("\"at\" needs a \"clip\"");
    }
    if (json.has("mirror") && json["mirror"].boolean()) key.pose = mirrored(rig, key.pose);
    if (json.has("root")) key.pose.root = point(json["root"]);
    if (json.has("turns")) {
        const JsonReader turns = json["turns"];
        for (const std::string& name : turns.keys())
            key.pose.turns[static_cast<std::size_t>(jointNamed(rig, name, turns))] =
                turn(turns[name]);
    }
    if (json.has("place")) key.pose = placed(rig, key.pose, json["place"]);
    if (json.has("handles")) key.pose = drawn(rig, key.pose, json["handles"]);
    if (json.has("easing")) {
        const auto easing = easingFromName(json["easing"].text());
        if (!easing) throw json["easing"].error("expected linear, smooth, in, out or hold");
        key.easing = *easing;
    }
    return key;
}

}  // namespace

KeyTrack parseKeys(std::string_view text, const std::string& file, std::shared_ptr<const Rig> rig,
                   const PoseSource& poses) {
    const Json document = parseJson(text, file);
    const JsonReader json(document, file, "");
    if (!json.isObject() || !json.has("key_poses"))
        throw json.error("expected an object with \"key_poses\": 1, \"rate\" and \"keys\"");
    onlyKeys(json, {"key_poses", "rate", "keys", "note"});
    if (json["key_poses"].integer() != kVersion)
        throw json["key_poses"].error(fmt::format("only version {} is known", kVersion));
    KeyTrack track;
    track.rig = std::move(rig);
    if (json.has("rate")) {
        track.rate = json["rate"].positive();
        if (track.rate < 1 || track.rate > 1000)
            throw json["rate"].error("expected a rate from 1 to 1000 Hz");
    }
    const JsonReader keys = json["keys"];
    if (keys.size() == 0) throw keys.error("expected at least one key");
    Pose before = restPose(*track.rig);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        KeyPose key = readKey(keys.at(k), *track.rig, poses, before);
        if (track.find(key.frame)) {
            throw keys.at(k)["frame"].error(
                fmt::format("there is another key at frame {}", key.frame));
        }
        before = key.pose;
        track = withKey(std::move(track), std::move(key));
    }
    return track;
}

std::string keysText(const KeyTrack& track) {
    validate(track);
    Json keys = Json::array();
    for (const KeyPose& key : track.keys) {
        Json turns = Json::object();
        for (int j = 0; j < track.rig->jointCount(); ++j) {
            if (track.rig->joint(j).isEndSite) continue;
            const Quaterniond& q = key.pose.turns[static_cast<std::size_t>(j)];
            turns[nameOf(*track.rig, j)] = {q.w(), q.x(), q.y(), q.z()};
        }
        const Vector3d& root = key.pose.root;
        keys.push_back({{"frame", key.frame},
                        {"root", {root.x(), root.y(), root.z()}},
                        {"turns", std::move(turns)},
                        {"easing", std::string(easingName(key.easing))}});
    }
    return prettyJson({{"key_poses", kVersion}, {"rate", track.rate}, {"keys", std::move(keys)}});
}

}  // namespace kumite
