#include "core/motion/skeleton.h"

#include "core/base/error.h"

namespace kumite {

bool isRotation(Channel channel) {
    return channel >= Channel::Xrotation;
}

int axisOf(Channel channel) {
    return static_cast<int>(channel) % 3;
}

std::string_view channelName(Channel channel) {
    constexpr std::array<std::string_view, 6> kNames = {"Xposition", "Yposition", "Zposition",
                                                        "Xrotation", "Yrotation", "Zrotation"};
    return kNames[static_cast<std::size_t>(channel)];
}

std::vector<int> Skeleton::childrenOf(int joint) const {
    std::vector<int> children;
    for (int i = joint + 1; i < jointCount(); ++i) {
        if (joints[static_cast<std::size_t>(i)].parent == joint) children.push_back(i);
    }
    return children;
}

int Skeleton::find(std::string_view name) const {
    int endSite = -1;
    for (int i = 0; i < jointCount(); ++i) {
        const Joint& joint = joints[static_cast<std::size_t>(i)];
        if (joint.name != name) continue;
        if (!joint.isEndSite) return i;
        if (endSite < 0) endSite = i;
    }
    return endSite;
}

std::vector<Eigen::Vector3d> Skeleton::restPositions() const {
    std::vector<Eigen::Vector3d> positions(joints.size(), Eigen::Vector3d::Zero());
    for (std::size_t i = 1; i < joints.size(); ++i) {
        positions[i] = positions[static_cast<std::size_t>(joints[i].parent)] + joints[i].offset;
    }
    return positions;
}

void Skeleton::validate() const {
    if (joints.empty()) throw Error("A skeleton needs at least one joint.");
    int column = 0;
    for (int i = 0; i < jointCount(); ++i) {
        const Joint& joint = joints[static_cast<std::size_t>(i)];
        if (i == 0 ? joint.parent != -1 : joint.parent < 0 || joint.parent >= i) {
            throw Error("Joint " + joint.name + " does not stand behind its parent.");
        }
        if (joint.firstChannel != column) {
            throw Error("The channels of joint " + joint.name + " do not follow the ones before.");
        }
        if (joint.isEndSite && !joint.channels.empty()) {
            throw Error("The End Site " + joint.name + " has channels.");
        }
        if (!joint.offset.allFinite() || !joint.rotationFrame.allFinite()) {
            throw Error("The offset of joint " + joint.name + " is not a finite number.");
        }
        column += static_cast<int>(joint.channels.size());
    }
    if (column != channelCount) throw Error("A skeleton's channel count does not add up.");
}

}  // namespace kumite
