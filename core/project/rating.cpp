#include "core/project/rating.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/editing/assembly.h"
#include "core/editing/hit.h"
#include "core/motion/blend.h"

namespace kumite {

namespace {

using Eigen::Vector3d;

constexpr int kKeys = 5;
constexpr double kAround = 0.15;  // metres around the point of an example

/// Uniform in [0, 1), the same on every machine (std::uniform_real_distribution is not).
double draw(std::mt19937& random) {
    return random() / 4294967296.0;
}

/// Near where an example hits, in any direction.
Vector3d drawnTarget(const StrikeSpace& space, std::mt19937& random) {
    const auto i = static_cast<std::size_t>(draw(random) * double(space.examples.size()));
    Vector3d target = space.examples[i].point;
    for (int axis = 0; axis < 3; ++axis)
        target[axis] += kAround * (2 * draw(random) - 1);
    return target;
}

/// Over the origin and facing +z at its first frame.
Clip fromOrigin(Clip clip) {
    const GroundTransform there = toOrigin(*clip.rig, clip.frames.front());
    return moved(std::move(clip), there);
}

/// Key poses of a strike at even moments, its full stretch among them.
KeyTrack keysOf(const Strike& strike) {
    KeyTrack track;
    track.rig = strike.clip.rig;
    track.rate = strike.clip.rate;
    const int last = strike.clip.frameCount() - 1;
    for (int k = 0; k < kKeys; ++k) {
        const int even = k * last / (kKeys - 1);
        const int frame = k == kKeys / 2 && strike.hit > 0 && strike.hit < last ? strike.hit : even;
        if (track.find(frame)) continue;
        track = withKey(std::move(track),
                        {frame, strike.clip.frames[static_cast<std::size_t>(frame)], {}});
    }
    return track;
}

/// "bout:1:12" of the strike, and the motion that it was cut out of; −1 where that is not known.
int motionOfStrike(const MotionLibrary& library, const std::string& name) {
    int found = -1;
    std::size_t longest = 0;
    for (std::size_t m = 0; m < library.motions.size(); ++m) {
        const std::string& motion = library.motions[m].name;
        if (name.starts_with(motion) && motion.size() >= longest) {
            found = static_cast<int>(m);
            longest = motion.size();
        }
    }
    return found;
}

/// The library without one of its motions as a source of poses.
std::shared_ptr<const MotionLibrary> without(const MotionLibrary& library, int motion) {
    auto rest = std::make_shared<MotionLibrary>(library);
    if (motion >= 0) rest->motions[static_cast<std::size_t>(motion)].made = true;
    return rest;
}

class Maker {
public:
    Maker(const MotionLibrary& library, const StrikeExamples& examples,
          const RatingSettings& settings)
        : library_(library), examples_(examples), settings_(settings), random_(settings.seed) {
        for (const Strike& each : examples_.strikes)
            motions_.push_back(motionOfStrike(library_, each.name));
    }

    RatedClips made(const Progress& progress) {
        space_ = strikeSpace(examples_, {}, progress.part(0, 0.4));
        captured();
        blended("whole-body blend", HitMethod::Full);
        blended("blend by parts", HitMethod::Partial);
        fromKeys(progress.part(0.4, 1));
        return std::move(result_);
    }

private:
    void add(const std::string& kind, const std::string& name, Clip clip) {
        if (clip.frameCount() < 2) return;
        result_.clips.push_back({kind, name, fromOrigin(std::move(clip))});
    }

    void captured() {
        for (const int i : chosen())
            add("captured", strike(i).name, strike(i).clip);
    }

    void blended(const std::string& kind, HitMethod method) {
        for (int i = 0; i < settings_.clipsPerKind; ++i) {
            const Vector3d target = drawnTarget(space_, random_);
            const HitMotion hit = hitTarget(space_, target, method);
            add(kind,
                fmt::format("{:.2f},{:.2f},{:.2f} missed by {:.1f} cm", target.x(), target.y(),
                            target.z(), 100 * hit.error),
                hit.clip);
        }
    }

    void fromKeys(const Progress& progress) {
        const std::vector<int> all = chosen();
        // Examples of one motion share a library.
        int known = -2;
        KeyLibrary keys;
        for (std::size_t i = 0; i < all.size(); ++i) {
            progress.update(static_cast<double>(i) / static_cast<double>(all.size()));
            const Strike& example = strike(all[i]);
            try {
                const int motion = motions_[static_cast<std::size_t>(all[i])];
                if (motion != known) keys = keyLibrary(without(library_, motion));
                known = motion;
                const KeyTrack track = keysOf(example);
                add("key poses", example.name,
                    assemble(keys, track, planAssembly(keys, track)).clip);
            } catch (const Error& error) {
                result_.findings.push_back(warning(
                    fmt::format("No motion from key poses of {}: {}", example.name, error.what())));
            }
        }
    }

    const Strike& strike(int i) const { return examples_.strikes[static_cast<std::size_t>(i)]; }

    std::vector<int> chosen() {
        std::vector<int> order = drawnOrder(examples_.strikes.size(), random_);
        order.resize(std::min(order.size(), static_cast<std::size_t>(settings_.clipsPerKind)));
        // Those of one motion after each other.
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
            return motions_[static_cast<std::size_t>(a)] < motions_[static_cast<std::size_t>(b)];
        });
        return order;
    }

    const MotionLibrary& library_;
    const StrikeExamples& examples_;
    RatingSettings settings_;
    std::mt19937 random_;
    std::vector<int> motions_;  ///< of each example
    StrikeSpace space_;
    RatedClips result_;
};

}  // namespace

std::vector<int> drawnOrder(std::size_t count, std::mt19937& random) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[static_cast<std::size_t>(draw(random) * double(i))]);
    return order;
}

RatedClips clipsToRate(const MotionLibrary& library, const StrikeRequest& request,
                       const RatingSettings& settings, const Progress& progress) {
    const StrikeExamples examples = strikesOf(library, request);
    return Maker(library, examples, settings).made(progress);
}

}  // namespace kumite
