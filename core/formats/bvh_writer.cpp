#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/formats/bvh.h"
#include "core/motion/euler.h"
#include "core/motion/kinematics.h"

namespace kumite {
namespace {

constexpr std::array kWrittenRotations = {Channel::Zrotation, Channel::Yrotation,
                                          Channel::Xrotation};

/// Whether a joint rotates in a frame of its own, which BVH cannot say.
bool needsConversion(const Joint& joint) {
    return joint.rotationFrame != Eigen::Matrix3d::Identity() &&
           std::any_of(joint.channels.begin(), joint.channels.end(), isRotation);
}

std::vector<Channel> writtenChannels(const Joint& joint) {
    std::vector<Channel> channels = joint.channels;
    if (!needsConversion(joint)) return channels;
    std::erase_if(channels, isRotation);
    channels.insert(channels.end(), kWrittenRotations.begin(), kWrittenRotations.end());
    return channels;
}

void append(std::string& text, double value) {
    std::array<char, 32> buffer;
    text.append(buffer.data(),
                std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

void appendOffset(std::string& text, const std::string& indent, const Joint& joint) {
    text += indent + "\tOFFSET";
    for (const double value : joint.offset) {
        text += ' ';
        append(text, value);
    }
    text += '\n';
}

void appendChannels(std::string& text, const std::string& indent, const Joint& joint) {
    if (joint.isEndSite) return;
    const std::vector<Channel> channels = writtenChannels(joint);
    text += fmt::format("{}\tCHANNELS {}", indent, channels.size());
    for (const Channel channel : channels) {
        text += ' ';
        text += channelName(channel);
    }
    text += '\n';
}

void appendHierarchy(std::string& text, const Skeleton& skeleton) {
    // Deeper levels are not indented further, or a chain of n joints would take n² bytes.
    static constexpr std::size_t kDeepestIndent = 100;
    const auto indentOf = [](std::size_t depth) {
        return std::string(std::min(depth, kDeepestIndent), '\t');
    };
    text += "HIERARCHY\n";
    std::vector<int> open;
    const auto closeDownTo = [&](int parent) {
        while (!open.empty() && open.back() != parent) {
            open.pop_back();
            text += indentOf(open.size()) + "}\n";
        }
    };
    for (int i = 0; i < skeleton.jointCount(); ++i) {
        const Joint& joint = skeleton.joints[static_cast<std::size_t>(i)];
        closeDownTo(joint.parent);
        const std::string indent = indentOf(open.size());
        const std::string head = i == 0            ? "ROOT " + joint.name
                                 : joint.isEndSite ? "End Site"
                                                   : "JOINT " + joint.name;
        text += indent + head + "\n" + indent + "{\n";
        appendOffset(text, indent, joint);
        appendChannels(text, indent, joint);
        open.push_back(i);
    }
    closeDownTo(-1);
}

/// Writes the rows of a motion, converting the joints that need it.
class RowWriter {
public:
    explicit RowWriter(const Skeleton& skeleton)
        : skeleton_(skeleton), angles_(skeleton.joints.size()) {
        for (const Joint& joint : skeleton.joints) {
            converts_ = converts_ || needsConversion(joint);
        }
    }

    void appendRow(std::string& text, std::span<const double> values) {
        const std::size_t begin = text.size();
        if (!converts_) {
            for (const double value : values)
                appendValue(text, value);
        } else {
            for (std::size_t j = 0; j < skeleton_.joints.size(); ++j)
                appendJoint(text, values, j);
        }
        if (text.size() > begin) text.back() = '\n';
    }

private:
    static void appendValue(std::string& text, double value) {
        append(text, value);
        text += ' ';
    }

    void appendJoint(std::string& text, std::span<const double> values, std::size_t index) {
        const Joint& joint = skeleton_.joints[index];
        const bool converts = needsConversion(joint);
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            if (converts && isRotation(joint.channels[c])) continue;
            appendValue(text, values[static_cast<std::size_t>(joint.firstChannel) + c]);
        }
        if (!converts) return;
        angles_[index] = eulerAngles(localRotation(joint, values), {2, 1, 0}, angles_[index]);
        for (const double angle : angles_[index])
            appendValue(text, angle);
    }

    const Skeleton& skeleton_;
    std::vector<std::array<double, 3>> angles_;  ///< of the row before, by joint
    bool converts_ = false;
};

}  // namespace

std::string bvhText(const Motion& motion, FrameRange frames, double frameTime) {
    std::string text;
    appendHierarchy(text, *motion.skeleton);
    text += fmt::format("MOTION\nFrames: {}\nFrame Time: {}\n", frames.size(), shortest(frameTime));
    RowWriter rows(*motion.skeleton);
    for (int frame = frames.begin; frame < frames.end; ++frame) {
        rows.appendRow(text, motion.frame(frame));
    }
    return text;
}

}  // namespace kumite
