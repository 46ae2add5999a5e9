#include "core/motion/role_mapping.h"

#include <map>

#include <gtest/gtest.h>

#include "tests/support/builders.h"

namespace kumite {
namespace {

using enum Role;
using test::JointSpec;
using test::makeSkeleton;

std::string jointOf(const Skeleton& skeleton, const RoleMapping& mapping, Role role) {
    const auto joint = mapping.roles[role];
    return joint ? skeleton.joints[static_cast<std::size_t>(*joint)].name : "";
}

/// Names of one exporter for: hips, spine, chest, neck, head; clavicle, shoulder, elbow, wrist,
/// hip, knee, ankle, toe as the left side is called and as the right side is called.
struct Convention {
    std::string family;
    std::vector<std::string> middle;
    std::vector<std::string> left;
    std::vector<std::string> right;
    std::string above;  ///< a helper joint above the hips, if any
};

std::shared_ptr<const Skeleton> bodyWithNames(const Convention& names) {
    std::vector<JointSpec> joints;
    const auto add = [&](const std::string& name, int parent, Eigen::Vector3d offset) {
        joints.push_back({name, parent, offset, joints.empty() ? "XYZzxy" : "zxy"});
        return static_cast<int>(joints.size()) - 1;
    };
    int root = -1;
    if (!names.above.empty()) root = add(names.above, -1, {0, 0, 0});
    const int hips = add(names.middle[0], root, {0, 0, 0});
    const int spine = add(names.middle[1], hips, {0, 10, 0});
    const int chest = add(names.middle[2], spine, {0, 15, 0});
    const int neck = add(names.middle[3], chest, {0, 25, 0});
    add(names.middle[4], neck, {0, 10, 0});
    for (const bool left : {true, false}) {
        const auto& side = left ? names.left : names.right;
        const double x = left ? 1 : -1;
        const int clavicle = add(side[0], chest, {4 * x, 20, 0});
        const int shoulder = add(side[1], clavicle, {14 * x, 0, 0});
        const int elbow = add(side[2], shoulder, {28 * x, 0, 0});
        add(side[3], elbow, {25 * x, 0, 0});
        const int hip = add(side[4], hips, {9 * x, -2, 0});
        const int knee = add(side[5], hip, {0, -42, 0});
        const int ankle = add(side[6], knee, {0, -40, 0});
        add(side[7], ankle, {0, -8, 15});
    }
    return makeSkeleton(joints);
}

std::vector<std::string> sided(const std::string& prefix, const std::vector<std::string>& bases,
                               const std::string& suffix = "") {
    std::vector<std::string> names;
    for (const std::string& base : bases)
        names.push_back(prefix + base + suffix);
    return names;
}

std::vector<Convention> conventions() {
    const std::vector<std::string> ik = {"Shoulder", "Arm", "ForeArm", "Hand",
                                         "UpLeg",    "Leg", "Foot",    "ToeBase"};
    const std::vector<std::string> poser = {"Collar", "Shldr", "ForeArm", "Hand",
                                            "Thigh",  "Shin",  "Foot",    "Toe"};
    const std::vector<std::string> bio = {"Collar", "Shoulder", "Elbow", "Wrist",
                                          "Hip",    "Knee",     "Ankle", "Toe"};
    const std::vector<std::string> asf = {"clavicle", "humerus", "radius", "wrist",
                                          "femur",    "tibia",   "foot",   "toes"};
    const std::vector<std::string> biped = {"Clavicle", "UpperArm", "Forearm", "Hand",
                                            "Thigh",    "Calf",     "Foot",    "Toe0"};
    const std::vector<std::string> xsens = {"Shoulder", "UpperArm", "ForeArm", "Hand",
                                            "UpperLeg", "LowerLeg", "Foot",    "Toe"};
    const std::vector<std::string> rokoko = {"Shoulder", "Arm",  "ForeArm", "Hand",
                                             "Thigh",    "Shin", "Foot",    "Toe"};
    const std::vector<std::string> bandai = {"Shoulder", "UpperArm", "LowerArm", "Hand",
                                             "UpperLeg", "LowerLeg", "Foot",     "Toes"};
    const std::vector<std::string> unreal = {"clavicle", "upperarm", "lowerarm", "hand",
                                             "thigh",    "calf",     "foot",     "ball"};
    std::vector<std::string> lafan = ik;
    lafan.back() = "Toe";
    const auto mixamo = [](const std::vector<std::string>& n) { return sided("mixamorig:", n); };
    return {
        {"HumanIK",
         {"Hips", "LowerBack", "Spine1", "Neck", "Head"},
         sided("Left", ik),
         sided("Right", ik),
         ""},
        {"HumanIK", mixamo({"Hips", "Spine", "Spine2", "Neck", "Head"}), mixamo(sided("Left", ik)),
         mixamo(sided("Right", ik)), ""},
        {"HumanIK", sided("Character1_", {"Hips", "Spine", "Spine1", "Neck", "Head"}),
         sided("Character1_Left", ik), sided("Character1_Right", ik), "Character1_Reference"},
        {"HumanIK",
         {"Hips", "Spine", "Spine2", "Neck", "Head"},
         sided("Left", lafan),
         sided("Right", lafan),
         ""},
        {"HumanIK", sided("Robot_", {"Hips", "Spine", "Spine3", "Neck", "Head"}),
         sided("Robot_Left", ik), sided("Robot_Right", ik), ""},
        {"Poser",
         {"hip", "abdomen", "chest", "neck", "head"},
         sided("l", poser),
         sided("r", poser),
         ""},
        {"Biovision",
         {"Hips", "Ab", "Chest", "Neck", "Head"},
         sided("Left", bio),
         sided("Right", bio),
         ""},
        {"ASF",
         {"root", "lowerback", "thorax", "lowerneck", "head"},
         sided("l", asf),
         sided("r", asf),
         ""},
        {"Biped",
         {"Bip01 Pelvis", "Bip01 Spine", "Bip01 Spine1", "Bip01 Neck", "Bip01 Head"},
         sided("Bip01 L ", biped),
         sided("Bip01 R ", biped),
         "Bip01"},
        {"Xsens",
         {"Pelvis", "L5", "T8", "Neck", "Head"},
         sided("Left", xsens),
         sided("Right", xsens),
         ""},
        {"Rokoko",
         {"Hips", "Spine", "Spine2", "Neck", "Head"},
         sided("Left", rokoko),
         sided("Right", rokoko),
         ""},
        {"Bandai-Namco",
         {"Hips", "Spine", "Chest", "Neck", "Head"},
         sided("", bandai, "_L"),
         sided("", bandai, "_R"),
         "joint_Root"},
        {"Unreal",
         {"pelvis", "spine_01", "spine_03", "neck_01", "head"},
         sided("", unreal, "_l"),
         sided("", unreal, "_r"),
         "root"},
    };
}

TEST(MapRoles, EveryNamingFamily) {
    const std::array<Role, 5> middle = {Pelvis, Spine, Chest, Neck, Head};
    const std::array<Role, 8> limbs = {LeftClavicle, LeftShoulder, LeftElbow, LeftWrist,
                                       LeftHip,      LeftKnee,     LeftAnkle, LeftToe};
    for (const Convention& names : conventions()) {
        SCOPED_TRACE(names.family + " with " + names.left[1]);
        const auto skeleton = bodyWithNames(names);
        const RoleMapping mapping = mapRoles(*skeleton);
        EXPECT_EQ(mapping.family, names.family);
        EXPECT_TRUE(mapping.findings.empty()) << mapping.findings.front().text;
        for (std::size_t i = 0; i < middle.size(); ++i) {
            EXPECT_EQ(jointOf(*skeleton, mapping, middle[i]), names.middle[i]);
        }
        for (std::size_t i = 0; i < limbs.size(); ++i) {
            EXPECT_EQ(jointOf(*skeleton, mapping, limbs[i]), names.left[i]);
            EXPECT_EQ(jointOf(*skeleton, mapping, mirrored(limbs[i])), names.right[i]);
        }
    }
}

TEST(MapRoles, NamesThatSayNothingAreReadOffTheShape) {
    Convention numbers{"topology", {}, {}, {}, ""};
    for (int i = 0; i < 5; ++i)
        numbers.middle.push_back("bone" + std::to_string(i));
    for (int i = 0; i < 8; ++i) {
        numbers.left.push_back("bone" + std::to_string(10 + i));
        numbers.right.push_back("bone" + std::to_string(20 + i));
    }
    const auto skeleton = bodyWithNames(numbers);
    const RoleMapping mapping = mapRoles(*skeleton);
    EXPECT_EQ(mapping.family, "topology");
    ASSERT_FALSE(mapping.findings.empty());
    EXPECT_EQ(mapping.findings.front().severity, Severity::Warning);
    const std::map<Role, std::string> expected = {
        {Pelvis, "bone0"},     {Chest, "bone2"},         {Neck, "bone3"},
        {Head, "bone4"},       {LeftShoulder, "bone11"}, {LeftElbow, "bone12"},
        {LeftWrist, "bone13"}, {LeftHip, "bone14"},      {LeftKnee, "bone15"},
        {LeftAnkle, "bone16"}, {LeftToe, "bone17"},      {RightElbow, "bone22"},
        {RightKnee, "bone25"}, {RightToe, "bone27"}};
    for (const auto& [role, name] : expected) {
        EXPECT_EQ(jointOf(*skeleton, mapping, role), name) << roleName(role);
    }
}

TEST(MapRoles, PrefixesNeedNoSeparator) {
    for (Convention names : conventions()) {
        if (names.family != "Biped" && names.family != "HumanIK") continue;
        const auto glue = [](std::vector<std::string>& list) {
            for (std::string& name : list) {
                std::erase_if(name, [](char c) { return c == ' ' || c == ':' || c == '_'; });
            }
        };
        glue(names.middle);
        glue(names.left);
        glue(names.right);
        names.above.clear();
        EXPECT_EQ(mapRoles(*bodyWithNames(names)).family, names.family) << names.left[0];
    }
}

TEST(MapRoles, AMissingLimbDoesNotUnsayTheNamesOfTheOthers) {
    Convention names = conventions()[5];
    names.left[6] = "lX";
    names.right[6] = "rX";  // ankles without a telling name
    const auto skeleton = bodyWithNames(names);
    const RoleMapping mapping = mapRoles(*skeleton);
    EXPECT_EQ(mapping.family, "Poser");
    EXPECT_EQ(jointOf(*skeleton, mapping, LeftAnkle), "lX") << "read off the shape";
    EXPECT_EQ(jointOf(*skeleton, mapping, LeftToe), "lToe");
}

TEST(MapRoles, OfEqualNamesTheJointThatCarriesTheBodyIsMeant) {
    // Marker leaves that repeat the names of joints, as some exporters write them.
    auto names = conventions()[2];
    const auto body = bodyWithNames(names);
    Skeleton skeleton = *body;
    for (const char* leaf : {"Neck", "LeftFoot", "Hips"}) {
        Joint joint;
        joint.name = leaf;
        joint.parent = 1;
        joint.firstChannel = skeleton.channelCount;
        joint.channels = {Channel::Zrotation};
        ++skeleton.channelCount;
        skeleton.joints.push_back(joint);
    }
    const RoleMapping mapping = mapRoles(skeleton);
    EXPECT_EQ(jointOf(skeleton, mapping, Neck), "Character1_Neck");
    EXPECT_EQ(jointOf(skeleton, mapping, LeftAnkle), "Character1_LeftFoot");
    EXPECT_EQ(jointOf(skeleton, mapping, Pelvis), "Character1_Hips");
}

TEST(MapRoles, EndSitesStandForMissingHandsFeetAndHead) {
    const auto skeleton = makeSkeleton({{"Hips", -1, {0, 0, 0}, "XYZzxy"},
                                        {"Spine", 0, {0, 15, 0}, "zxy"},
                                        {"Spine End Site", 1, {0, 30, 0}, ""},
                                        {"LeftArm", 1, {16, 0, 0}, "zxy"},
                                        {"LeftForeArm", 3, {26, 0, 0}, "zxy"},
                                        {"LeftForeArm End Site", 4, {22, 0, 0}, ""},
                                        {"RightArm", 1, {-16, 0, 0}, "zxy"},
                                        {"RightForeArm", 6, {-26, 0, 0}, "zxy"},
                                        {"RightForeArm End Site", 7, {-22, 0, 0}, ""},
                                        {"LeftUpLeg", 0, {9, 0, 0}, "zxy"},
                                        {"LeftLeg", 9, {0, -44, 0}, "zxy"},
                                        {"LeftFoot", 10, {0, -42, 0}, "zxy"},
                                        {"LeftFoot End Site", 11, {0, -5, 9}, ""},
                                        {"RightUpLeg", 0, {-9, 0, 0}, "zxy"},
                                        {"RightLeg", 13, {0, -44, 0}, "zxy"},
                                        {"RightFoot", 14, {0, -42, 0}, "zxy"},
                                        {"RightFoot End Site", 15, {0, -5, 9}, ""}});
    const RoleMapping mapping = mapRoles(*skeleton);
    EXPECT_EQ(jointOf(*skeleton, mapping, LeftWrist), "LeftForeArm End Site");
    EXPECT_EQ(jointOf(*skeleton, mapping, RightToe), "RightFoot End Site");
    EXPECT_EQ(jointOf(*skeleton, mapping, Neck), "Spine");
    EXPECT_EQ(jointOf(*skeleton, mapping, Head), "Spine End Site");
    EXPECT_EQ(mapping.findings.size(), 1u) << "the stand-in for the neck is reported";
}

TEST(MapRoles, ASkeletonWithoutABodyGetsNoRolesAndAFinding) {
    const auto chain = makeSkeleton({{"base", -1, {0, 0, 0}, "XYZ"},
                                     {"child1", 0, {0, 5, 0}, "zxy"},
                                     {"child2", 1, {0, 5, 0}, "zxy"}});
    const RoleMapping mapping = mapRoles(*chain);
    EXPECT_EQ(mapping.family, "none");
    EXPECT_EQ(mapping.roles.count(), 0);
    ASSERT_EQ(mapping.findings.size(), 1u);
    EXPECT_EQ(mapRoles(*makeSkeleton({{"only", -1, {0, 0, 0}, "X"}})).family, "none");
}

TEST(Roles, NamesAndMirrorsComeBack) {
    for (const Role role : allRoles()) {
        EXPECT_EQ(roleFromName(roleName(role)), role);
        EXPECT_EQ(mirrored(mirrored(role)), role);
    }
    EXPECT_EQ(mirrored(LeftKnee), RightKnee);
    EXPECT_EQ(mirrored(Neck), Neck);
    EXPECT_EQ(roleFromName("tail"), std::nullopt);
}

}  // namespace
}  // namespace kumite
