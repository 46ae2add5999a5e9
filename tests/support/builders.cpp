#include "tests/support/builders.h"

#include <cmath>

#include "core/motion/role_mapping.h"

namespace kumite::test {

std::shared_ptr<const Skeleton> makeSkeleton(const std::vector<JointSpec>& specs) {
    auto skeleton = std::make_shared<Skeleton>();
    for (const JointSpec& spec : specs) {
        Joint joint;
        joint.name = spec.name;
        joint.parent = spec.parent;
        joint.offset = spec.offset;
        joint.firstChannel = skeleton->channelCount;
        joint.isEndSite = spec.channels.empty();
        for (const char c : spec.channels) {
            joint.channels.push_back(static_cast<Channel>(std::string("XYZxyz").find(c)));
        }
        skeleton->channelCount += static_cast<int>(joint.channels.size());
        skeleton->joints.push_back(joint);
    }
    skeleton->validate();
    return skeleton;
}

std::shared_ptr<const Motion> makeMotion(std::shared_ptr<const Skeleton> skeleton, int frames,
                                         double rate,
                                         const std::function<double(int, int)>& value) {
    auto motion = std::make_shared<Motion>();
    motion->skeleton = std::move(skeleton);
    motion->frameTime = 1.0 / rate;
    motion->frameCount = frames;
    for (int frame = 0; frame < frames; ++frame) {
        for (int column = 0; column < motion->skeleton->channelCount; ++column) {
            motion->channels.push_back(value(frame, column));
        }
    }
    motion->validate();
    return motion;
}

std::shared_ptr<const Skeleton> makeHuman() {
    static const auto human = makeSkeleton({
        {"Hips", -1, {0, 0, 0}, "XYZzxy"},
        {"Chest", 0, {0, 20, 0}, "zxy"},
        {"Neck", 1, {0, 30, 0}, "zxy"},
        {"Head", 2, {0, 10, 0}, "zxy"},
        {"Head End Site", 3, {0, 20, 0}, ""},
        {"LeftCollar", 1, {4, 26, 0}, "zxy"},
        {"LeftShoulder", 5, {14, 0, 0}, "zxy"},
        {"LeftElbow", 6, {28, 0, 0}, "zxy"},
        {"LeftWrist", 7, {25, 0, 0}, "zxy"},
        {"LeftWrist End Site", 8, {10, 0, 0}, ""},
        {"RightCollar", 1, {-4, 26, 0}, "zxy"},
        {"RightShoulder", 10, {-14, 0, 0}, "zxy"},
        {"RightElbow", 11, {-28, 0, 0}, "zxy"},
        {"RightWrist", 12, {-25, 0, 0}, "zxy"},
        {"RightWrist End Site", 13, {-10, 0, 0}, ""},
        {"LeftHip", 0, {9, 0, 0}, "zxy"},
        {"LeftKnee", 15, {0, -42, 0}, "zxy"},
        {"LeftAnkle", 16, {0, -42, 0}, "zxy"},
        {"LeftToe", 17, {0, -8, 15}, "zxy"},
        {"LeftToe End Site", 18, {0, 0, 5}, ""},
        {"RightHip", 0, {-9, 0, 0}, "zxy"},
        {"RightKnee", 20, {0, -42, 0}, "zxy"},
        {"RightAnkle", 21, {0, -42, 0}, "zxy"},
        {"RightToe", 22, {0, -8, 15}, "zxy"},
        {"RightToe End Site", 23, {0, 0, 5}, ""},
    });
    return human;
}

std::shared_ptr<const Motion> bobbing(int frames, double rate,
                                      const std::function<double(double)>& height) {
    return makeMotion(makeHuman(), frames, rate, [&](int frame, int column) {
        return column == 1 ? kHumanRootHeight + 100.0 * height(frame / rate) : 0.0;
    });
}

Fighter makeFighter(std::shared_ptr<const Motion> motion, double rate) {
    Fighter fighter;
    fighter.recording = {"/recordings/made.bvh", {}, "", ""};
    fighter.space = {0.01, UpAxis::Y};
    fighter.rate = rate;
    fighter.frames = motion->frames();
    fighter.roles = mapRoles(*motion->skeleton).roles;
    fighter.motion = std::move(motion);
    return fighter;
}

double boutHeight(int player, double seconds) {
    return player == 0
               ? 0.020 * std::sin(2 * M_PI * 1.6 * seconds) + 0.006 * std::sin(17.0 * seconds)
               : 0.015 * std::sin(2 * M_PI * 2.1 * seconds + 1.0) + 0.010 * std::sin(9.0 * seconds);
}

Project makeBout() {
    constexpr int kFrames = 361;
    constexpr double kRate = 60.0;
    Project project;
    Take take;
    take.name = "made";
    for (const int player : {0, 1}) {
        take.fighters.push_back(makeFighter(
            bobbing(kFrames, kRate, [player](double t) { return boutHeight(player, t); }), kRate));
    }
    project.takes.push_back(std::move(take));
    return project;
}

}  // namespace kumite::test
