#include "core/demo/suit.h"

#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "core/motion/two_bone.h"

namespace kumite::demo {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Kind = Suit::Source::Kind;

constexpr double degrees(double value) {
    return value * std::numbers::pi / 180;
}

/// Puts a skeleton together, joint by joint, in the T-pose and metres; the rest pose and the unit
/// come in as each joint is added.
class Tailor {
public:
    Tailor(BodySize size, double unitsPerMetre, std::vector<Channel> rotations)
        : rotations_(std::move(rotations)) {
        suit_.size = std::move(size);
        suit_.unitsPerMetre = unitsPerMetre;
    }

    /// `offset` from the parent in the T-pose. Returns the joint's index.
    int add(const std::string& name, int parent, const Vector3d& offset, Suit::Source source) {
        Joint joint;
        joint.name = name;
        joint.parent = parent;
        joint.offset = inRestPose(parent, offset);
        joint.firstChannel = skeleton_.channelCount;
        if (parent < 0) {
            joint.channels = {Channel::Xposition, Channel::Yposition, Channel::Zposition};
        }
        joint.channels.insert(joint.channels.end(), rotations_.begin(), rotations_.end());
        skeleton_.channelCount += static_cast<int>(joint.channels.size());
        skeleton_.joints.push_back(joint);
        suit_.sources.push_back(std::move(source));
        return skeleton_.jointCount() - 1;
    }

    void end(int parent, const Vector3d& offset) {
        Joint joint;
        joint.name = skeleton_.joints[static_cast<std::size_t>(parent)].name + " End Site";
        joint.parent = parent;
        joint.offset = inRestPose(parent, offset);
        joint.firstChannel = skeleton_.channelCount;
        joint.isEndSite = true;
        skeleton_.joints.push_back(joint);
        suit_.sources.push_back({});
    }

    const BodySize& size() const { return suit_.size; }

    Suit finish() {
        skeleton_.validate();
        suit_.skeleton = std::make_shared<const Skeleton>(std::move(skeleton_));
        return std::move(suit_);
    }

private:
    Vector3d inRestPose(int parent, const Vector3d& offset) const {
        const Matrix3d rest = parent < 0 ? Matrix3d::Identity()
                                         : suit_.sources[static_cast<std::size_t>(parent)].rest;
        // Exporters print a few decimals.
        const Vector3d exact = rest * offset * suit_.unitsPerMetre;
        return (exact * 1e5).array().round() / 1e5;
    }

    std::vector<Channel> rotations_;
    Suit suit_;
    Skeleton skeleton_;
};

Suit::Source limb(Side side, Part part, const Matrix3d& rest) {
    return {Kind::Limb, 0, side, part, rest};
}

Suit::Source fixedTo(const Suit::Source& parent) {
    Suit::Source source = parent;
    source.kind = Kind::Fixed;
    return source;
}

/// A rest pose, as turns of the limbs of the left side against the T-pose.
struct RestPose {
    double armDown = 0;       ///< radians from the horizontal
    double forearmAhead = 0;  ///< bent further ahead
    double legOut = 0;
};

Matrix3d restOf(const RestPose& pose, Side side, Part part) {
    const double x = sign(side);
    switch (part) {
        case Part::UpperArm:
            return aboutZ(-x * pose.armDown);
        case Part::Forearm:
        case Part::Hand:
            return aboutZ(-x * pose.armDown) * aboutY(-x * pose.forearmAhead);
        case Part::Thigh:
        case Part::Shank:
            return aboutZ(x * pose.legOut);
        default:
            return Matrix3d::Identity();
    }
}

/// Shoulder to knuckles. Returns the hand.
int addArm(Tailor& tailor, int chest, Side side, const std::array<std::string, 4>& names,
           const RestPose& rest) {
    const BodySize& size = tailor.size();
    const double x = sign(side);
    const auto source = [&](Part part) { return limb(side, part, restOf(rest, side, part)); };
    const int clavicle =
        tailor.add(names[0], chest, {0.02 * x, size.clavicleRise, 0}, source(Part::Clavicle));
    const int upper =
        tailor.add(names[1], clavicle, {size.clavicle * x, 0.02, 0}, source(Part::UpperArm));
    const int fore = tailor.add(names[2], upper, {size.upperArm * x, 0, 0}, source(Part::Forearm));
    return tailor.add(names[3], fore, {size.forearm * x, 0, 0}, source(Part::Hand));
}

/// Hip joint to toes; `parent` lies `from` away from the pelvis.
void addLeg(Tailor& tailor, int parent, const Vector3d& from, Side side,
            const std::array<std::string, 4>& names, const RestPose& rest) {
    const BodySize& size = tailor.size();
    const double x = sign(side);
    const auto source = [&](Part part) { return limb(side, part, restOf(rest, side, part)); };
    const Vector3d hip(size.hipWidth / 2 * x, -size.hipDrop, 0);
    const int thigh = tailor.add(names[0], parent, hip - from, source(Part::Thigh));
    const int shank = tailor.add(names[1], thigh, {0, -size.thigh, 0}, source(Part::Shank));
    const int foot = tailor.add(names[2], shank, {0, -size.shank, 0}, source(Part::Foot));
    const int toe = tailor.add(names[3], foot, {0, size.toeHeight - size.ankleHeight, size.foot},
                               source(Part::Toe));
    tailor.end(toe, {0, 0, size.toe});
}

}  // namespace

Suit makeHumanIkSuit() {
    BodySize size;
    Tailor tailor(size, 100, {Channel::Zrotation, Channel::Xrotation, Channel::Yrotation});
    const RestPose tPose;
    const int hips =
        tailor.add("Hips", -1, Vector3d::Zero(), {Kind::Pelvis, 0, {}, {}, Matrix3d::Identity()});
    const auto leg = [&](Side side, const std::string& word) {
        addLeg(tailor, hips, Vector3d::Zero(), side,
               {word + "UpLeg", word + "Leg", word + "Foot", word + "ToeBase"}, tPose);
    };
    const auto arm = [&](int chest, Side side, const std::string& word) {
        const int hand =
            addArm(tailor, chest, side,
                   {word + "Shoulder", word + "Arm", word + "ForeArm", word + "Hand"}, tPose);
        tailor.end(hand, {size.hand * sign(side), 0, 0});
    };
    leg(Side::Left, "Left");
    leg(Side::Right, "Right");
    int chest = hips;
    const std::array<std::string, 3> spine = {"Spine", "Spine1", "Spine2"};
    for (std::size_t k = 0; k < spine.size(); ++k) {
        chest = tailor.add(spine[k], chest, {0, size.spine[k], 0},
                           {Kind::Spine, static_cast<int>(k) + 1, {}, {}, Matrix3d::Identity()});
    }
    arm(chest, Side::Left, "Left");
    const int neck = tailor.add("Neck", chest, {0, size.chestToNeck, 0},
                                {Kind::Neck, 0, {}, {}, Matrix3d::Identity()});
    const int head =
        tailor.add("Head", neck, {0, size.neck, 0}, {Kind::Head, 0, {}, {}, Matrix3d::Identity()});
    tailor.end(head, {0, size.head, 0});
    arm(chest, Side::Right, "Right");
    return tailor.finish();
}

Suit makePoserSuit() {
    BodySize size;
    size.hipWidth = 0.17;
    size.thigh = 0.405;
    size.shank = 0.41;
    size.ankleHeight = 0.08;
    size.foot = 0.135;
    size.toe = 0.065;
    size.spine = {0.12, 0.21};
    size.chestToNeck = 0.20;
    size.neck = 0.09;
    size.head = 0.185;
    size.clavicle = 0.145;
    size.upperArm = 0.275;
    size.forearm = 0.25;
    size.hand = 0.095;
    constexpr double kInchesPerMetre = 1 / 0.0254;
    Tailor tailor(size, kInchesPerMetre,
                  {Channel::Yrotation, Channel::Xrotation, Channel::Zrotation});
    const RestPose hanging{degrees(72), degrees(8), degrees(3)};
    const Suit::Source pelvis{Kind::Pelvis, 0, {}, {}, Matrix3d::Identity()};
    const int hip = tailor.add("hip", -1, Vector3d::Zero(), pelvis);
    int chest = hip;
    const std::array<std::string, 2> spine = {"abdomen", "chest"};
    for (std::size_t k = 0; k < spine.size(); ++k) {
        chest = tailor.add(spine[k], chest, {0, size.spine[k], 0},
                           {Kind::Spine, static_cast<int>(k) + 1, {}, {}, Matrix3d::Identity()});
    }
    const int neck = tailor.add("neck", chest, {0, size.chestToNeck, 0},
                                {Kind::Neck, 0, {}, {}, Matrix3d::Identity()});
    const int head =
        tailor.add("head", neck, {0, size.neck, 0}, {Kind::Head, 0, {}, {}, Matrix3d::Identity()});
    tailor.end(head, {0, size.head, 0});
    for (const Side side : {Side::Right, Side::Left}) {
        const std::string letter = side == Side::Left ? "l" : "r";
        const double x = sign(side);
        const int hand = addArm(
            tailor, chest, side,
            {letter + "Collar", letter + "Shldr", letter + "ForeArm", letter + "Hand"}, hanging);
        const Suit::Source stiff =
            fixedTo(limb(side, Part::Hand, restOf(hanging, side, Part::Hand)));
        const int thumb = tailor.add(letter + "Thumb1", hand, {0.03 * x, -0.01, 0.03}, stiff);
        tailor.end(thumb, {0.04 * x, 0, 0.02});
        const int finger = tailor.add(letter + "Mid1", hand, {size.hand * x, 0, 0}, stiff);
        tailor.end(finger, {0.05 * x, 0, 0});
    }
    for (const Side side : {Side::Right, Side::Left}) {
        const std::string letter = side == Side::Left ? "l" : "r";
        const Vector3d way(0.05 * sign(side), -0.02, 0);
        const int buttock = tailor.add(letter + "Buttock", hip, way, fixedTo(pelvis));
        addLeg(tailor, buttock, way, side,
               {letter + "Thigh", letter + "Shin", letter + "Foot", letter + "Toe"}, hanging);
    }
    return tailor.finish();
}

void dress(const Suit& suit, const Pose& pose, SuitFrame& frame) {
    const auto& joints = suit.skeleton->joints;
    const int n = static_cast<int>(suit.size.spine.size());
    std::vector<Matrix3d> world(joints.size());
    frame.root = pose.pelvis * suit.unitsPerMetre;
    frame.local.resize(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Suit::Source& source = suit.sources[i];
        const int parent = joints[i].parent;
        switch (source.kind) {
            case Kind::Pelvis:
                world[i] = pose.pelvisTurn;
                break;
            case Kind::Spine:
                world[i] = spineTurn(pose, source.spine, n);
                break;
            case Kind::Neck:
                world[i] = pose.neckTurn;
                break;
            case Kind::Head:
                world[i] = pose.headTurn;
                break;
            case Kind::Limb:
                world[i] = pose.turn(source.side, source.part) * source.rest.transpose();
                break;
            case Kind::Fixed:
                world[i] = world[static_cast<std::size_t>(parent)];
                break;
        }
        frame.local[i] =
            parent < 0 ? world[i]
                       : Matrix3d(world[static_cast<std::size_t>(parent)].transpose() * world[i]);
    }
}

}  // namespace kumite::demo
