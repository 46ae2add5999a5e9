#include "core/project/export.h"

#include <array>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/bvh.h"
#include "core/motion/euler.h"
#include "core/project/report.h"

namespace kumite {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

/// Columns of a root's three position and three rotation channels.
struct RootChannels {
    std::array<int, 3> position{-1, -1, -1};  ///< by axis
    std::array<int, 3> rotation{};            ///< in the order of the matrix product
    std::array<int, 3> order{};               ///< axes of `rotation`
};

RootChannels rootChannels(const Skeleton& skeleton) {
    const Joint& root = skeleton.joints.front();
    RootChannels found;
    std::size_t rotations = 0;
    int column = root.firstChannel;
    for (const Channel channel : root.channels) {
        if (isRotation(channel) && rotations < 3) {
            found.rotation[rotations] = column;
            found.order[rotations++] = axisOf(channel);
        } else if (!isRotation(channel)) {
            found.position[static_cast<std::size_t>(axisOf(channel))] = column;
        }
        ++column;
    }
    const bool complete = rotations == 3 && found.position[0] >= 0 && found.position[1] >= 0 &&
                          found.position[2] >= 0;
    if (!complete) {
        throw Error("The root " + root.name +
                    " cannot be placed: it lacks position or rotation channels. Export without a "
                    "placement.");
    }
    return found;
}

/// The motion with its root turned and shifted; every other channel as it was.
Motion placedMotion(const Fighter& fighter) {
    Motion motion = *fighter.motion;
    if (fighter.placement == Placement{}) return motion;
    const Skeleton& skeleton = *motion.skeleton;
    const RootChannels root = rootChannels(skeleton);
    const bool zUp = fighter.space.up == UpAxis::Z;
    const double unit = fighter.space.metresPerUnit;
    // The turn about the vertical and the shift, in the file's own axes and units.
    const Eigen::Matrix3d turn = axisRotation(zUp ? 2 : 1, fighter.placement.yaw * kDegrees);
    const Eigen::Vector3d shift =
        zUp ? Eigen::Vector3d(fighter.placement.x / unit, -fighter.placement.z / unit, 0)
            : Eigen::Vector3d(fighter.placement.x / unit, 0, fighter.placement.z / unit);
    const auto width = static_cast<std::size_t>(skeleton.channelCount);
    const Eigen::Matrix3d& frameOfRoot = skeleton.joints.front().rotationFrame;
    std::array<double, 3> before{};
    for (int frame = 0; frame < motion.frameCount; ++frame) {
        double* row = motion.channels.data() + width * static_cast<std::size_t>(frame);
        const auto at = [&](int column) -> double& { return row[column]; };
        Eigen::Vector3d position(at(root.position[0]), at(root.position[1]), at(root.position[2]));
        position = turn * position + shift;
        const Eigen::Matrix3d rotation =
            turn * localRotation(skeleton.joints.front(), motion.frame(frame));
        if (frame == 0) {
            for (std::size_t i = 0; i < 3; ++i)
                before[i] = at(root.rotation[i]);
        }
        before = eulerAngles(frameOfRoot.transpose() * rotation * frameOfRoot, root.order, before);
        for (std::size_t i = 0; i < 3; ++i) {
            at(root.position[i]) = position[static_cast<Eigen::Index>(i)];
            at(root.rotation[i]) = before[i];
        }
    }
    return motion;
}

std::filesystem::path playerFile(const std::filesystem::path& file, std::size_t player) {
    std::filesystem::path name = file.stem();
    name += "-" + std::to_string(player + 1);
    name += file.extension();
    return file.parent_path() / name;
}

}  // namespace

std::vector<std::filesystem::path> exportTake(const Project& project, const Analysis& analysis,
                                              int take, const std::filesystem::path& file) {
    const std::string suffix = lowerCase(file.extension().string());
    if (suffix == ".csv") {
        writeFileAtomically(file, actionsCsv(project, analysis, take));
        return {file};
    }
    if (suffix == ".json") {
        writeFileAtomically(file, segmentationJson(project, analysis, {take, false}));
        return {file};
    }
    if (suffix != ".bvh") {
        throw Error(file.string() +
                    ": the suffix says what to write, expected .bvh, .csv or .json.");
    }
    const Take& which = project.takes.at(static_cast<std::size_t>(take));
    for (const Fighter& fighter : which.fighters) {
        if (!fighter.motion) {
            throw Error(fighter.recording.path.string() +
                        ": the recording is missing; the take cannot be written without it.");
        }
    }
    std::vector<std::filesystem::path> written;
    for (std::size_t player = 0; player < which.fighters.size(); ++player) {
        const Fighter& fighter = which.fighters[player];
        const double header = fighter.motion->frameTime;
        const double frameTime = rateOf(header) == fighter.rate ? header : 1.0 / fighter.rate;
        written.push_back(playerFile(file, player));
        writeFileAtomically(written.back(),
                            bvhText(placedMotion(fighter), fighter.frames, frameTime));
    }
    return written;
}

}  // namespace kumite
