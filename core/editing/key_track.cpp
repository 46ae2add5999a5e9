#include "core/editing/key_track.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/motion/blend.h"

namespace kumite {
namespace {

constexpr std::array<std::string_view, 5> kNames = {"linear", "smooth", "in", "out", "hold"};

std::vector<KeyPose>::iterator at(KeyTrack& track, int frame) {
    const auto index = track.find(frame);
    if (!index) throw Error(fmt::format("There is no key at frame {}.", frame));
    return track.keys.begin() + *index;
}

}  // namespace

std::string_view easingName(Easing easing) {
    return kNames[static_cast<std::size_t>(easing)];
}

std::optional<Easing> easingFromName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Easing>(found - kNames.begin());
}

double eased(Easing easing, double t) {
    switch (easing) {
        case Easing::Linear:
            return t;
        case Easing::Smooth:
            return t * t * t * (10 - 15 * t + 6 * t * t);
        case Easing::In:
            return t * t;
        case Easing::Out:
            return t * (2 - t);
        case Easing::Hold:
            break;
    }
    return t < 1 ? 0 : 1;
}

std::optional<int> KeyTrack::find(int frame) const {
    const auto found = std::lower_bound(keys.begin(), keys.end(), frame,
                                        [](const KeyPose& key, int f) { return key.frame < f; });
    if (found == keys.end() || found->frame != frame) return std::nullopt;
    return static_cast<int>(found - keys.begin());
}

KeyTrack withKey(KeyTrack track, KeyPose key) {
    const auto place =
        std::lower_bound(track.keys.begin(), track.keys.end(), key.frame,
                         [](const KeyPose& other, int frame) { return other.frame < frame; });
    if (place != track.keys.end() && place->frame == key.frame) {
        *place = std::move(key);
    } else {
        track.keys.insert(place, std::move(key));
    }
    return track;
}

KeyTrack withoutKey(KeyTrack track, int frame) {
    track.keys.erase(at(track, frame));
    return track;
}

KeyTrack withMovedKey(KeyTrack track, int from, int to) {
    KeyPose key = *at(track, from);
    key.frame = to;
    return withKey(withoutKey(std::move(track), from), std::move(key));
}

KeyTrack withCopiedKey(KeyTrack track, int from, int to) {
    KeyPose key = *at(track, from);
    key.frame = to;
    return withKey(std::move(track), std::move(key));
}

KeyTrack withEasing(KeyTrack track, int frame, Easing easing) {
    at(track, frame)->easing = easing;
    return track;
}

KeyTrack withShiftedKeys(KeyTrack track, int from, int to) {
    const auto first = static_cast<std::size_t>(at(track, from) - track.keys.begin());
    if (to < 0 || (first > 0 && to <= track.keys[first - 1].frame))
        throw Error(fmt::format("Frame {} is not behind the key before.", to));
    for (std::size_t k = first; k < track.keys.size(); ++k)
        track.keys[k].frame += to - from;
    return track;
}

KeyTrack retimed(KeyTrack track, int first, double factor) {
    if (!(factor > 0) || !std::isfinite(factor))
        throw Error("Keys can be brought nearer or farther by a factor above 0 only.");
    const auto from = static_cast<std::size_t>(at(track, first) - track.keys.begin());
    for (std::size_t k = from + 1; k < track.keys.size(); ++k) {
        const double frame = first + factor * (track.keys[k].frame - first);
        constexpr double kFarthest = 1e8;
        if (frame > kFarthest) throw Error("Keys cannot be brought that far.");
        track.keys[k].frame =
            std::max(track.keys[k - 1].frame + 1, static_cast<int>(std::lround(frame)));
    }
    return track;
}

void validate(const KeyTrack& track) {
    if (!track.rig) throw Error("Key poses need a skeleton.");
    if (!(track.rate > 0)) throw Error("Key poses need a rate above 0.");
    for (std::size_t k = 0; k < track.keys.size(); ++k) {
        const KeyPose& key = track.keys[k];
        if (key.pose.turns.size() != track.rig->joints.size()) {
            throw Error(
                fmt::format("The key at frame {} is a pose of another skeleton.", key.frame));
        }
        if (k > 0 && key.frame <= track.keys[k - 1].frame) {
            throw Error(fmt::format("The key at frame {} comes after one at frame {}.", key.frame,
                                    track.keys[k - 1].frame));
        }
    }
}

Pose poseAt(const KeyTrack& track, double frame) {
    const auto& keys = track.keys;
    if (frame <= keys.front().frame) return keys.front().pose;
    if (frame >= keys.back().frame) return keys.back().pose;
    const auto after = std::upper_bound(keys.begin(), keys.end(), frame,
                                        [](double f, const KeyPose& key) { return f < key.frame; });
    const KeyPose& a = *(after - 1);
    const KeyPose& b = *after;
    return blend(a.pose, b.pose, eased(a.easing, (frame - a.frame) / (b.frame - a.frame)));
}

Clip clipOf(const KeyTrack& track) {
    validate(track);
    Clip clip{track.rig, track.rate, {}};
    if (track.keys.empty()) return clip;
    for (int f = track.keys.front().frame; f <= track.keys.back().frame; ++f)
        clip.frames.push_back(poseAt(track, f));
    return clip;
}

}  // namespace kumite
