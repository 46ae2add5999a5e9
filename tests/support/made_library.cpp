#include "tests/support/made_library.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/base/error.h"
#include "core/motion/blend.h"
#include "core/motion/role_mapping.h"
#include "tests/support/builders.h"

namespace kumite::test {
namespace {

constexpr double kRate = 30;

/// A pose at the origin, its joints turned at random by up to `turn` radians.
Pose posture(const Rig& rig, unsigned seed, double turn) {
    std::mt19937 random(seed);
    const auto uniform = [&] { return random() / 2147483648.0 - 1; };
    Pose pose;
    pose.root = {0, kHumanRootHeight / 100, 0};
    pose.turns.assign(rig.joints.size(), Eigen::Quaterniond::Identity());
    for (int joint = 1; joint < rig.jointCount(); ++joint) {
        const Eigen::Vector3d axis(uniform(), uniform(), uniform());
        if (rig.joint(joint).isEndSite) continue;
        pose.turns[static_cast<std::size_t>(joint)] =
            Eigen::AngleAxisd(turn * uniform(), axis.normalized());
    }
    return pose;
}

class Maker {
public:
    Maker() : library_(std::make_shared<MotionLibrary>()) {
        library_->skeleton = makeHuman();
        library_->space = {0.01, UpAxis::Y};
        library_->rate = kRate;
        // Feet at random heights: none is below this floor, so that poses are shown as they are.
        library_->feet.floor = {-10, -10};
        const auto still = bobbing(1, kRate, [](double) { return 0.0; });
        library_->rig = std::make_shared<const Rig>(
            rigOf(*still, {0, 1}, library_->space, mapRoles(*still->skeleton).roles));
    }
    const Rig& rig() const { return *library_->rig; }

    void add(const std::string& name, int frames, const std::function<Pose(double)>& poseAt) {
        LibraryMotion motion;
        motion.name = name;
        motion.sourceRate = kRate;
        motion.clip = {library_->rig, kRate, {}};
        for (int i = 0; i < frames; ++i)
            motion.clip.frames.push_back(poseAt(static_cast<double>(i) / (frames - 1)));
        motion.standing.assign(motion.clip.frames.size(), Standing{false, false});
        library_->actions.push_back(
            {name, "", static_cast<int>(library_->motions.size()), {0, frames}});
        library_->motions.push_back(std::move(motion));
    }
    std::shared_ptr<const MotionLibrary> made() { return library_; }

private:
    std::shared_ptr<MotionLibrary> library_;
};

double eased(double s) {
    return s * s * (3 - 2 * s);
}

}  // namespace

std::shared_ptr<const MotionLibrary> madeLibrary() {
    Maker maker;
    const Pose stance = posture(maker.rig(), 1, 0.3);
    unsigned seed = 10;
    for (const char* name : {"kick", "punch", "block", "turn"}) {
        const Pose high = posture(maker.rig(), ++seed, 1.2);
        const double bend = 0.02 * (seed - 10), walk = 0.3 * (seed - 11);
        maker.add(name, 60, [=](double s) {
            const double there = eased(s < 0.5 ? 2 * s : 2 - 2 * s);
            Pose pose = blend(stance, high, there * (1 - bend));
            return moved(pose, {bend * 10 * s, walk * s, 1.0 * s});
        });
    }
    const Pose far = posture(maker.rig(), 99, 2.5), farther = posture(maker.rig(), 98, 2.5);
    maker.add("lonely", 60,
              [=](double s) { return blend(far, farther, 0.3 + 0.2 * std::sin(4 * M_PI * s)); });
    return maker.made();
}

std::shared_ptr<const MotionLibrary> oneWayLibrary() {
    Maker maker;
    const Pose from = posture(maker.rig(), 1, 0.3), to = posture(maker.rig(), 5, 1.2);
    maker.add("one", 60, [=](double s) {
        return moved(blend(from, to, eased(std::clamp(2 * s - 0.5, 0.0, 1.0))), {0, 0, s});
    });
    return maker.made();
}

const LibraryAction& actionOf(const MotionLibrary& library, const std::string& name) {
    for (const LibraryAction& action : library.actions) {
        if (action.name == name) return action;
    }
    throw Error("no action " + name);
}

MotionPart partOf(const MotionLibrary& library, const std::string& name) {
    return library.part(actionOf(library, name));
}

}  // namespace kumite::test
