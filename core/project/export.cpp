#include "core/project/export.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/bvh.h"
#include "core/formats/gltf.h"
#include "core/formats/npz.h"
#include "core/motion/euler.h"
#include "core/project/label_files.h"
#include "core/project/placed_clip.h"
#include "core/project/report.h"

namespace kumite {
namespace {

/// The channels that a placement rewrites: those of the first joint, from the root down, that has
/// all positions and rotations. Only helper joints with one child stand above it.
struct PlacedJoint {
    int joint = 0;
    std::array<int, 3> position{-1, -1, -1};  ///< columns, by axis
    std::array<int, 3> rotation{};            ///< columns, in the order of the matrix product
    std::array<int, 3> order{};               ///< axes of `rotation`
};

std::optional<PlacedJoint> completeChannels(const Skeleton& skeleton, int index) {
    const Joint& joint = skeleton.joints[static_cast<std::size_t>(index)];
    PlacedJoint found;
    found.joint = index;
    std::size_t rotations = 0;
    int column = joint.firstChannel;
    for (const Channel channel : joint.channels) {
        if (!isRotation(channel)) {
            found.position[static_cast<std::size_t>(axisOf(channel))] = column;
        } else if (rotations < 3) {
            found.rotation[rotations] = column;
            found.order[rotations++] = axisOf(channel);
        }
        ++column;
    }
    const bool complete =
        rotations == 3 && std::count(found.position.begin(), found.position.end(), -1) == 0;
    return complete ? std::optional(found) : std::nullopt;
}

PlacedJoint placedJoint(const Skeleton& skeleton) {
    int joint = 0;
    for (;;) {
        if (const auto found = completeChannels(skeleton, joint)) return *found;
        const std::vector<int> children = skeleton.childrenOf(joint);
        if (children.size() != 1) break;
        joint = children.front();
    }
    throw Error(
        "The placement cannot be written: neither the root nor a joint right below it has "
        "all position and rotation channels.");
}

/// Where a joint's parent stands, in the file's axes and units.
struct Transform {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

Transform parentTransform(const Motion& motion, int frame, int joint) {
    const Joint& own = motion.skeleton->joints[static_cast<std::size_t>(joint)];
    if (own.parent < 0) return {};
    const Joint& parent = motion.skeleton->joints[static_cast<std::size_t>(own.parent)];
    Transform above = parentTransform(motion, frame, own.parent);
    const auto row = motion.frame(frame);
    Eigen::Vector3d offset = parent.offset;
    for (std::size_t c = 0; c < parent.channels.size(); ++c) {
        if (isRotation(parent.channels[c])) continue;
        offset[axisOf(parent.channels[c])] = row[static_cast<std::size_t>(parent.firstChannel) + c];
    }
    above.position += above.rotation * offset;
    above.rotation = above.rotation * localRotation(parent, row);
    return above;
}

/// The motion turned and shifted as a whole; only one joint's channels change.
Motion placedMotion(const Fighter& fighter) {
    Motion motion = *fighter.motion;
    if (fighter.placement == Placement{}) return motion;
    const PlacedJoint placed = placedJoint(*motion.skeleton);
    const Joint& joint = motion.skeleton->joints[static_cast<std::size_t>(placed.joint)];
    const bool zUp = fighter.space.up == UpAxis::Z;
    const double unit = fighter.space.metresPerUnit;
    // The turn about the vertical and the shift, in the file's own axes and units.
    const Eigen::Matrix3d turn =
        axisRotation(zUp ? 2 : 1, fighter.placement.yaw * 180.0 / std::numbers::pi);
    const Eigen::Vector3d shift =
        zUp ? Eigen::Vector3d(fighter.placement.x / unit, -fighter.placement.z / unit, 0)
            : Eigen::Vector3d(fighter.placement.x / unit, 0, fighter.placement.z / unit);
    const auto width = static_cast<std::size_t>(motion.skeleton->channelCount);
    std::array<double, 3> before{};
    for (int frame = 0; frame < motion.frameCount; ++frame) {
        const Transform parent = parentTransform(motion, frame, placed.joint);
        double* row = motion.channels.data() + width * static_cast<std::size_t>(frame);
        Eigen::Vector3d position;
        for (int axis = 0; axis < 3; ++axis) {
            position[axis] = row[placed.position[static_cast<std::size_t>(axis)]];
        }
        // New local transform = parent⁻¹ · placement · parent · old local transform.
        position =
            (parent.rotation.transpose() *
             (turn * (parent.position + parent.rotation * position) + shift - parent.position))
                .eval();
        const Eigen::Matrix3d rotation = parent.rotation.transpose() * turn * parent.rotation *
                                         localRotation(joint, motion.frame(frame));
        for (std::size_t i = 0; i < 3 && frame == 0; ++i)
            before[i] = row[placed.rotation[i]];
        before = eulerAngles(joint.rotationFrame.transpose() * rotation * joint.rotationFrame,
                             placed.order, before);
        for (std::size_t i = 0; i < 3; ++i) {
            row[placed.position[i]] = position[static_cast<Eigen::Index>(i)];
            row[placed.rotation[i]] = before[i];
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

/// Both fighters in the bout's space, as the studio shows them.
struct PlacedTake {
    std::vector<Clip> clips;
    std::vector<double> starts;  ///< seconds after the take's first moment
};

PlacedTake placedTake(const Take& take, const std::vector<FighterAnalysis>& fighters) {
    PlacedTake placed;
    for (const FighterAnalysis& fighter : fighters) {
        placed.clips.push_back(placedClip(fighter));
        placed.starts.push_back(timeOfFrame(fighter.input, 0) - timeSpan(take).begin);
    }
    return placed;
}

std::string glbOf(const Take& take, const PlacedTake& placed) {
    constexpr std::array<float, 3> kColours[] = {{0.80f, 0.22f, 0.15f}, {0.13f, 0.30f, 0.75f}};
    std::vector<GltfFigure> figures;
    for (std::size_t i = 0; i < placed.clips.size(); ++i) {
        figures.push_back({"player" + std::to_string(i + 1), &placed.clips[i], placed.starts[i],
                           kColours[i % std::size(kColours)]});
    }
    return glbBytes(figures, take.name);
}

std::string npzOf(const PlacedTake& placed) {
    std::vector<NpyArray> arrays;
    for (std::size_t i = 0; i < placed.clips.size(); ++i) {
        const std::string suffix = i == 0 ? "" : "_" + std::to_string(i + 1);
        for (NpyArray& array : clipArrays(placed.clips[i], placed.starts[i], suffix))
            arrays.push_back(std::move(array));
    }
    return npzBytes(arrays);
}

}  // namespace

std::vector<std::filesystem::path> exportTake(const Project& project, const Analysis& analysis,
                                              int take, const std::filesystem::path& file) {
    const std::string suffix = lowerCase(file.extension().string());
    const std::vector<std::filesystem::path> sources = recordingFiles(project);
    refuseToOverwrite(file, sources);
    if (suffix == ".csv") {
        writeFileAtomically(file, actionsCsv(project, analysis, take));
        return {file};
    }
    if (suffix == ".json") {
        writeFileAtomically(file, segmentationJson(project, analysis, {take, false}));
        return {file};
    }
    if (suffix == ".eaf") {
        writeLabels(project, analysis, take, file);
        return {file};
    }
    if (suffix != ".bvh" && suffix != ".glb" && suffix != ".npz") {
        throw Error(file.string() +
                    ": the suffix says what to write, expected .bvh, .glb, .npz, .csv, .json or "
                    ".eaf.");
    }
    const Take& which = project.takes.at(static_cast<std::size_t>(take));
    for (const Fighter& fighter : which.fighters) {
        if (!fighter.motion) {
            throw Error(fighter.recording.path.string() +
                        ": the recording is missing; the take cannot be written without it.");
        }
    }
    if (suffix != ".bvh") {
        const PlacedTake placed =
            placedTake(which, analysis.takes.at(static_cast<std::size_t>(take)));
        writeFileAtomically(file, suffix == ".glb" ? glbOf(which, placed) : npzOf(placed));
        return {file};
    }
    std::vector<std::filesystem::path> written;
    for (std::size_t player = 0; player < which.fighters.size(); ++player) {
        const Fighter& fighter = which.fighters[player];
        const double header = fighter.motion->frameTime;
        const double frameTime = rateOf(header) == fighter.rate ? header : 1.0 / fighter.rate;
        written.push_back(playerFile(file, player));
        refuseToOverwrite(written.back(), sources);
        writeFileAtomically(written.back(),
                            bvhText(placedMotion(fighter), framesOf(fighter), frameTime));
    }
    return written;
}

}  // namespace kumite
