#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "core/base/text.h"
#include "core/formats/amc.h"
#include "core/formats/scanner.h"

namespace kumite {
namespace {

/// A degree of freedom: one channel, or `l`, the changing length of a bone, which is not used.
using Dof = std::optional<Channel>;

/// A bone as :bonedata or :root describe it. Angles still in the file's unit.
struct Bone {
    std::string name;
    std::size_t place = 0;  ///< in the text, for errors
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double length = 0;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    std::string axisOrder = "xyz";
    std::vector<Dof> dofs;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the root
    Eigen::Vector3d orientation = Eigen::Vector3d::Zero();
    int parent = -1;
    std::vector<int> children;
};

class AsfReader {
public:
    AsfReader(std::string_view text, const std::string& name) : scanner_(text, name) {
        bones_.emplace_back().name = "root";
    }

    AsfSkeleton read() {
        bool hasRoot = false;
        bool hasHierarchy = false;
        while (scanner_.skipSpace()) {
            if (scanner_.accept(":units")) {
                readUnits();
            } else if (scanner_.accept(":root")) {
                hasRoot = true;
                readRoot();
            } else if (scanner_.accept(":bonedata")) {
                while (scanner_.accept("begin"))
                    readBone();
            } else if (scanner_.accept(":hierarchy")) {
                hasHierarchy = true;
                readHierarchy();
            } else if (scanner_.peek().starts_with(':')) {
                skipSection();
            } else {
                scanner_.failHere("a section of an ASF file, such as :units or :bonedata");
            }
        }
        if (!hasRoot) scanner_.failHere("the section :root");
        if (!hasHierarchy) scanner_.failHere("the section :hierarchy");
        build();
        return std::move(asf_);
    }

private:
    bool atSection() { return scanner_.peek().empty() || scanner_.peek().starts_with(':'); }

    void skipSection() {
        do {
            scanner_.skipLine();
        } while (!atSection());
    }

    void readUnits() {
        while (!atSection()) {
            if (scanner_.accept("length")) {
                scanner_.skipSpace();
                const std::size_t place = scanner_.position();
                asf_.unitLength = scanner_.number("the unit of length");
                if (!(asf_.unitLength > 0)) {
                    scanner_.fail(place, fmt::format("found {}, expected a unit of length greater "
                                                     "than zero",
                                                     shortest(asf_.unitLength)));
                }
            } else if (scanner_.accept("angle")) {
                const std::string unit = lowerCase(scanner_.peek());
                if (!unit.starts_with("deg") && !unit.starts_with("rad")) {
                    scanner_.failHere("deg or rad");
                }
                asf_.degrees = unit.starts_with("deg");
                scanner_.next();
            } else {
                scanner_.next();
            }
        }
    }

    void readRoot() {
        Bone& root = bones_.front();
        root.place = scanner_.position();
        while (!atSection()) {
            if (scanner_.accept("order")) {
                root.dofs = readDofs();
            } else if (scanner_.accept("axis")) {
                root.axisOrder = readAxisOrder();
            } else if (scanner_.accept("position")) {
                root.position = readVector("the position of the root");
            } else if (scanner_.accept("orientation")) {
                root.orientation = readVector("the orientation of the root");
            } else {
                scanner_.failHere("order, axis, position or orientation");
            }
        }
    }

    void readBone() {
        constexpr std::size_t kMostBones = 10'000;
        if (bones_.size() > kMostBones) scanner_.failHere("10000 bones at most");
        Bone bone;
        bone.place = scanner_.position();
        while (!scanner_.accept("end")) {
            if (atSection()) scanner_.failHere("end, behind the last line of a bone");
            if (scanner_.accept("name")) {
                scanner_.skipSpace();
                bone.place = scanner_.position();
                bone.name = scanner_.next();
            } else if (scanner_.accept("direction")) {
                bone.direction = readVector("the direction of the bone");
            } else if (scanner_.accept("length")) {
                bone.length = scanner_.number("the length of the bone");
            } else if (scanner_.accept("axis")) {
                bone.axis = readVector("the axis of the bone");
                bone.axisOrder = readAxisOrder();
            } else if (scanner_.accept("dof")) {
                bone.dofs = readDofs();
            } else {
                scanner_.next();  // id, limits, masses
            }
        }
        if (bone.name.empty()) scanner_.fail(bone.place, "found a bone without name, expected one");
        if (indexOf(bone.name)) {
            scanner_.fail(bone.place,
                          fmt::format("found a second bone {}, expected one", inQuotes(bone.name)));
        }
        bones_.push_back(std::move(bone));
    }

    /// Lines of a bone and its children, between begin and end.
    void readHierarchy() {
        scanner_.expect("begin");
        while (!scanner_.accept("end")) {
            const int parent = readBoneName();
            while (scanner_.moreOnLine()) {
                const std::size_t position = scanner_.position();
                const int child = readBoneName();
                Bone& bone = bones_[static_cast<std::size_t>(child)];
                if (child == 0 || bone.parent >= 0) {
                    scanner_.fail(position, fmt::format("found bone {} a second time, expected one "
                                                        "parent for each",
                                                        inQuotes(bone.name)));
                }
                bone.parent = parent;
                bones_[static_cast<std::size_t>(parent)].children.push_back(child);
            }
        }
    }

    int readBoneName() {
        const auto index = indexOf(scanner_.peek());
        if (!index) scanner_.failHere("the name of a bone of :bonedata, or end");
        scanner_.next();
        return *index;
    }

    std::optional<int> indexOf(std::string_view name) const {
        for (std::size_t i = 0; i < bones_.size(); ++i) {
            if (bones_[i].name == name) return static_cast<int>(i);
        }
        return std::nullopt;
    }

    Eigen::Vector3d readVector(std::string_view what) {
        Eigen::Vector3d vector;
        for (double& value : vector)
            value = scanner_.number(fmt::format("a number: {}", what));
        return vector;
    }

    /// The order in which the rotations are applied: "XYZ" is about x first, R = Rz · Ry · Rx.
    std::string readAxisOrder() {
        std::string order = lowerCase(scanner_.peek());
        std::string sorted = order;
        std::sort(sorted.begin(), sorted.end());
        if (sorted != "xyz") scanner_.failHere("an order of rotations, such as XYZ");
        scanner_.next();
        return order;
    }

    std::vector<Dof> readDofs() {
        std::vector<Dof> dofs;
        for (;;) {
            const std::string word = lowerCase(scanner_.peek());
            const bool isLength = word == "l" || word == "tl";
            const bool isChannel = word.size() == 2 && (word[0] == 't' || word[0] == 'r') &&
                                   word[1] >= 'x' && word[1] <= 'z';
            if (!isLength && !isChannel) return dofs;
            const Dof dof = isLength ? Dof() : Dof(channelOf(word[0] == 'r', word[1] - 'x'));
            if (std::find(dofs.begin(), dofs.end(), dof) != dofs.end()) {
                scanner_.failHere("each degree of freedom once");
            }
            dofs.push_back(dof);
            scanner_.next();
        }
    }

    static Channel channelOf(bool rotation, int axis) {
        return static_cast<Channel>((rotation ? 3 : 0) + axis);
    }

    /// From bones to joints, depth first.
    void build() {
        Skeleton skeleton;
        std::vector<int> jointOf(bones_.size(), -1);
        std::vector<int> waiting = {0};
        while (!waiting.empty()) {
            const auto index = static_cast<std::size_t>(waiting.back());
            waiting.pop_back();
            const Bone& bone = bones_[index];
            jointOf[index] = skeleton.jointCount();
            const int parent =
                bone.parent < 0 ? -1 : jointOf[static_cast<std::size_t>(bone.parent)];
            addJoint(bone, parent, skeleton);
            if (bone.children.empty() && index > 0) addEndSite(bone, skeleton);
            waiting.insert(waiting.end(), bone.children.rbegin(), bone.children.rend());
        }
        for (std::size_t i = 0; i < bones_.size(); ++i) {
            if (jointOf[i] >= 0) continue;
            scanner_.fail(bones_[i].place,
                          fmt::format("found bone {} that does not hang on the root, expected it "
                                      "in :hierarchy",
                                      inQuotes(bones_[i].name)));
        }
        if (skeleton.channelCount == 0) {
            scanner_.fail(bones_.front().place,
                          "found a skeleton without any dof, expected an order for the root");
        }
        asf_.skeleton = std::make_shared<const Skeleton>(std::move(skeleton));
    }

    void addJoint(const Bone& bone, int parent, Skeleton& skeleton) {
        Joint joint;
        joint.name = bone.name;
        joint.parent = parent;
        joint.offset = bone.parent < 0 ? bone.position : tipOf(bone.parent);
        joint.rotationFrame = rotation(bone.axis, bone.axisOrder);
        joint.firstChannel = skeleton.channelCount;
        joint.channels = channelsOf(bone);
        skeleton.channelCount += static_cast<int>(joint.channels.size());
        addLine(bone, joint);
        skeleton.joints.push_back(std::move(joint));
    }

    void addEndSite(const Bone& bone, Skeleton& skeleton) {
        Joint end;
        end.name = bone.name + " End Site";
        end.parent = skeleton.jointCount() - 1;
        end.offset = bone.length * bone.direction;
        end.firstChannel = skeleton.channelCount;
        end.isEndSite = true;
        skeleton.joints.push_back(std::move(end));
    }

    /// Where a bone ends, seen from where it begins. The root is a point.
    Eigen::Vector3d tipOf(int index) const {
        const Bone& bone = bones_[static_cast<std::size_t>(index)];
        return bone.length * bone.direction;
    }

    /// A bone's channels: positions, then rotations from the one applied last to the first, which
    /// is the order of the matrix product. The root has its order of rotations in `axis`.
    std::vector<Channel> channelsOf(const Bone& bone) const {
        std::vector<Channel> positions;
        std::vector<Channel> rotations;
        for (const Dof& dof : bone.dofs) {
            if (dof) (isRotation(*dof) ? rotations : positions).push_back(*dof);
        }
        if (bone.parent < 0) {
            const auto rank = [&](Channel channel) {
                return bone.axisOrder.find(static_cast<char>('x' + axisOf(channel)));
            };
            std::sort(rotations.begin(), rotations.end(),
                      [&](Channel a, Channel b) { return rank(a) < rank(b); });
        }
        positions.insert(positions.end(), rotations.rbegin(), rotations.rend());
        return positions;
    }

    void addLine(const Bone& bone, const Joint& joint) {
        if (bone.dofs.empty()) return;
        std::vector<AmcValue> line;
        for (const Dof& dof : bone.dofs) {
            AmcValue value;
            if (dof) {
                const auto at = std::find(joint.channels.begin(), joint.channels.end(), *dof);
                value.column = joint.firstChannel + static_cast<int>(at - joint.channels.begin());
                value.isAngle = isRotation(*dof);
                value.shift = value.isAngle ? degrees(bone.orientation[axisOf(*dof)])
                                            : joint.offset[axisOf(*dof)];
            } else {
                asf_.findings.push_back(warning(
                    fmt::format("Bone {} changes its length: that is not used.", bone.name)));
            }
            line.push_back(value);
        }
        asf_.lines[bone.name] = std::move(line);
    }

    double degrees(double angle) const {
        return asf_.degrees ? angle : angle * 180.0 / std::numbers::pi;
    }

    Eigen::Matrix3d rotation(const Eigen::Vector3d& angles, const std::string& order) const {
        Eigen::Matrix3d product = Eigen::Matrix3d::Identity();
        if (angles.isZero(0)) return product;
        for (const char letter : order) {
            const int axis = letter - 'x';
            const double radians = degrees(angles[axis]) * std::numbers::pi / 180.0;
            product = Eigen::AngleAxisd(radians, Eigen::Vector3d::Unit(axis)).toRotationMatrix() *
                      product;
        }
        return product;
    }

    Scanner scanner_;
    AsfSkeleton asf_;
    std::vector<Bone> bones_;  ///< the root first
};

}  // namespace

AsfSkeleton readAsf(std::string_view text, const std::string& name) {
    return AsfReader(text, name).read();
}

}  // namespace kumite
