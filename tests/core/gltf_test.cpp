#include "core/formats/gltf.h"

#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/formats/gltf_body.h"
#include "core/formats/recording.h"
#include "core/motion/blend.h"
#include "core/motion/survey.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using Eigen::Matrix4d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, 4);
    return word;
}

/// A .glb as an independent reader sees it, every rule of the specification checked that it uses.
struct Glb {
    json document;
    std::string binary;

    explicit Glb(const std::string& bytes) {
        EXPECT_EQ(bytes.substr(0, 4), "glTF");
        EXPECT_EQ(wordAt(bytes, 4), 2U);
        EXPECT_EQ(wordAt(bytes, 8), bytes.size());
        const std::size_t length = wordAt(bytes, 12);
        EXPECT_EQ(bytes.substr(16, 4), "JSON");
        EXPECT_EQ(length % 4, 0U);
        document = json::parse(bytes.substr(20, length));
        const std::size_t at = 20 + length;
        EXPECT_EQ(bytes.substr(at + 4, 4), std::string("BIN\0", 4));
        EXPECT_EQ(wordAt(bytes, at) % 4, 0U);
        EXPECT_EQ(at + 8 + wordAt(bytes, at), bytes.size());
        binary = bytes.substr(at + 8);
        EXPECT_EQ(document["asset"]["version"], "2.0");
        EXPECT_EQ(document["buffers"].size(), 1U);
        const std::size_t stated = document["buffers"][0]["byteLength"];
        EXPECT_LE(stated, binary.size());
        EXPECT_LT(binary.size() - stated, 4U);
        binary.resize(stated);
    }

    const json& accessor(int index) const {
        return document["accessors"].at(static_cast<std::size_t>(index));
    }

    /// The accessor's numbers; checks that it lies within its view, the view within the buffer,
    /// that it is aligned and that its bounds are true.
    std::vector<double> read(int index) const {
        const json& accessor = this->accessor(index);
        const std::map<std::string, std::size_t> widths = {
            {"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        const std::map<int, std::size_t> sizes = {{5123, 2}, {5125, 4}, {5126, 4}};
        const std::size_t width = widths.at(accessor["type"]);
        const int component = accessor["componentType"];
        const std::size_t size = sizes.at(component);
        const std::size_t count = accessor["count"];
        EXPECT_GT(count, 0U);
        const json& view = document["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
        const std::size_t offset = view["byteOffset"], length = view["byteLength"];
        EXPECT_LE(offset + length, binary.size());
        EXPECT_EQ(offset % size, 0U);
        EXPECT_EQ(count * width * size, length);
        std::vector<double> values;
        for (std::size_t i = 0; i < count * width; ++i) {
            const char* from = binary.data() + offset + i * size;
            if (component == 5126) {
                float value = 0;
                std::memcpy(&value, from, 4);
                EXPECT_TRUE(std::isfinite(value));
                values.push_back(value);
            } else {
                std::uint32_t value = 0;
                std::memcpy(&value, from, size);
                values.push_back(value);
            }
        }
        if (accessor.contains("min")) {
            for (std::size_t k = 0; k < width; ++k) {
                double low = INFINITY, high = -INFINITY;
                for (std::size_t i = k; i < values.size(); i += width) {
                    low = std::min(low, values[i]);
                    high = std::max(high, values[i]);
                }
                EXPECT_FLOAT_EQ(accessor["min"][k].get<float>(), static_cast<float>(low));
                EXPECT_FLOAT_EQ(accessor["max"][k].get<float>(), static_cast<float>(high));
            }
        }
        return values;
    }

    int nodeNamed(const std::string& name) const {
        for (std::size_t i = 0; i < document["nodes"].size(); ++i) {
            if (document["nodes"][i]["name"] == name) return static_cast<int>(i);
        }
        return -1;
    }

    std::vector<int> parents() const {
        std::vector<int> parents(document["nodes"].size(), -1);
        for (std::size_t i = 0; i < parents.size(); ++i) {
            for (const json& child : document["nodes"][i].value("children", json::array())) {
                EXPECT_EQ(parents.at(child.get<std::size_t>()), -1) << "two parents";
                parents.at(child.get<std::size_t>()) = static_cast<int>(i);
            }
        }
        return parents;
    }

    /// World transforms of all nodes with the animation at its key `frame`.
    std::vector<Matrix4d> worldAt(std::size_t frame) const {
        const std::vector<int> parent = parents();
        std::vector<Vector3d> places(parent.size(), Vector3d::Zero());
        std::vector<Quaterniond> turns(parent.size(), Quaterniond::Identity());
        for (std::size_t i = 0; i < parent.size(); ++i) {
            const json& node = document["nodes"][i];
            if (node.contains("translation")) {
                const auto place = node["translation"].get<std::vector<double>>();
                places[i] = {place.at(0), place.at(1), place.at(2)};
            }
        }
        const json& animation = document["animations"].at(0);
        for (const json& channel : animation["channels"]) {
            const json& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
            const auto values = read(sampler["output"]);
            const auto node = channel["target"]["node"].get<std::size_t>();
            if (channel["target"]["path"] == "rotation") {
                const double* q = values.data() + 4 * frame;
                turns[node] = Quaterniond(q[3], q[0], q[1], q[2]);
            } else {
                const double* p = values.data() + 3 * frame;
                places[node] = {p[0], p[1], p[2]};
            }
        }
        std::vector<Matrix4d> world(parent.size());
        std::vector<bool> known(parent.size(), false);
        const std::function<Matrix4d(int)> of = [&](int node) -> Matrix4d {
            if (node < 0) return Matrix4d::Identity();
            const auto i = static_cast<std::size_t>(node);
            if (!known[i]) {
                Matrix4d local = Matrix4d::Identity();
                local.topLeftCorner<3, 3>() = turns[i].toRotationMatrix();
                local.topRightCorner<3, 1>() = places[i];
                world[i] = of(parent[i]) * local;
                known[i] = true;
            }
            return world[i];
        };
        for (std::size_t i = 0; i < parent.size(); ++i)
            of(static_cast<int>(i));
        return world;
    }
};

Clip swayingHuman(int frames, double rate) {
    const auto motion =
        test::makeMotion(test::makeHuman(), frames, rate, [](int frame, int column) {
            if (column == 1) return test::kHumanRootHeight;
            return column < 3 ? 2.0 * frame
                              : 40 * std::sin(0.05 * frame * (1 + column % 5) + column);
        });
    const Fighter fighter = test::makeFighter(motion, rate);
    return clipOf(*motion, motion->frames(), fighter.space, fighter.roles);
}

std::string bothFighters(const Clip& first, const Clip& second) {
    return glbBytes(std::vector<GltfFigure>{{"player1", &first, 0, {1, 0, 0}},
                                            {"player2", &second, 0.5, {0, 0, 1}}},
                    "round 1");
}

TEST(Gltf, KeepsTheRulesOfTheSpecification) {
    const Clip first = swayingHuman(20, 60), second = swayingHuman(15, 30);
    const Glb glb(bothFighters(first, second));
    const json& document = glb.document;
    for (std::size_t i = 0; i < document["accessors"].size(); ++i)
        EXPECT_FALSE(glb.read(static_cast<int>(i)).empty());

    // Every scene root has no parent, and every node hangs below one.
    const std::vector<int> parents = glb.parents();
    std::set<int> roots;
    for (const json& node : document["scenes"][0]["nodes"])
        roots.insert(node.get<int>());
    for (std::size_t i = 0; i < parents.size(); ++i) {
        int top = static_cast<int>(i);
        while (parents[static_cast<std::size_t>(top)] >= 0)
            top = parents[static_cast<std::size_t>(top)];
        EXPECT_TRUE(roots.count(top)) << i;
    }
    for (const int root : roots)
        EXPECT_EQ(parents[static_cast<std::size_t>(root)], -1);

    ASSERT_EQ(document["skins"].size(), 2U);
    for (const json& skin : document["skins"]) {
        EXPECT_EQ(glb.accessor(skin["inverseBindMatrices"])["count"], skin["joints"].size());
        EXPECT_EQ(glb.accessor(skin["inverseBindMatrices"])["type"], "MAT4");
    }
    ASSERT_EQ(document["animations"].size(), 1U);
    const json& animation = document["animations"][0];
    std::set<std::pair<int, std::string>> targets;
    for (const json& channel : animation["channels"]) {
        const json& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
        const auto times = glb.read(sampler["input"]);
        EXPECT_TRUE(glb.accessor(sampler["input"]).contains("min"));
        EXPECT_GE(times.front(), 0);
        for (std::size_t i = 1; i < times.size(); ++i)
            EXPECT_GT(times[i], times[i - 1]);
        EXPECT_EQ(glb.accessor(sampler["output"])["count"], times.size());
        const auto values = glb.read(sampler["output"]);
        EXPECT_TRUE(targets
                        .insert({channel["target"]["node"].get<int>(),
                                 channel["target"]["path"].get<std::string>()})
                        .second);
        if (channel["target"]["path"] != "rotation") continue;
        for (std::size_t i = 0; i < values.size(); i += 4) {
            const Eigen::Map<const Eigen::Vector4d> turn(values.data() + i);
            EXPECT_NEAR(turn.norm(), 1, 1e-6);
            if (i > 0) {
                const Eigen::Map<const Eigen::Vector4d> before(values.data() + i - 4);
                EXPECT_GE(turn.dot(before), 0);
            }
        }
    }
    EXPECT_NEAR(glb.accessor(animation["samplers"].back()["input"])["min"][0].get<double>(), 0.5,
                1e-6);
}

TEST(Gltf, MeshesAreBoundToTheirSkins) {
    const Clip clip = swayingHuman(3, 60);
    const Glb glb(bothFighters(clip, clip));
    for (const json& node : glb.document["nodes"]) {
        if (!node.contains("mesh")) continue;
        const json& mesh = glb.document["meshes"].at(node["mesh"].get<std::size_t>());
        const json& skin = glb.document["skins"].at(node["skin"].get<std::size_t>());
        const json& primitive = mesh["primitives"][0];
        const std::size_t vertices = glb.accessor(primitive["attributes"]["POSITION"])["count"];
        EXPECT_TRUE(glb.accessor(primitive["attributes"]["POSITION"]).contains("max"));
        for (const char* name : {"NORMAL", "JOINTS_0", "WEIGHTS_0"})
            EXPECT_EQ(glb.accessor(primitive["attributes"][name])["count"], vertices);
        const auto indices = glb.read(primitive["indices"]);
        EXPECT_EQ(indices.size() % 3, 0U);
        for (const double index : indices)
            EXPECT_LT(index, static_cast<double>(vertices));
        for (const double joint : glb.read(primitive["attributes"]["JOINTS_0"]))
            EXPECT_LT(joint, static_cast<double>(skin["joints"].size()));
        const auto weights = glb.read(primitive["attributes"]["WEIGHTS_0"]);
        for (std::size_t i = 0; i < weights.size(); i += 4)
            EXPECT_EQ(weights[i] + weights[i + 1] + weights[i + 2] + weights[i + 3], 1);
        const auto normals = glb.read(primitive["attributes"]["NORMAL"]);
        for (std::size_t i = 0; i < normals.size(); i += 3)
            EXPECT_NEAR(Vector3d(normals[i], normals[i + 1], normals[i + 2]).norm(), 1, 1e-6);
    }
}

TEST(Gltf, BodiesAreClosedAndTurnedOutward) {
    const Clip clip = swayingHuman(1, 60);
    const BodyMesh body = bodyMesh(*clip.rig);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0;
    for (std::size_t i = 0; i < body.triangles.size(); i += 3) {
        const auto* t = body.triangles.data() + i;
        for (int k = 0; k < 3; ++k)
            ++edges[{t[k], t[(k + 1) % 3]}];
        volume += body.positions[t[0]].dot(body.positions[t[1]].cross(body.positions[t[2]])) / 6.0;
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.count({edge.second, edge.first}));
    }
    // Between what the trunk alone holds and what a person holds.
    EXPECT_GT(volume, 0.02);
    EXPECT_LT(volume, 0.1);
}

TEST(Gltf, JointsAreWhereTheClipHasThem) {
    const Clip first = swayingHuman(20, 60), second = moved(swayingHuman(20, 60), {2, 1, 1});
    const Glb glb(bothFighters(first, second));
    const JointPositions expected[] = {positionsOf(first), positionsOf(second)};
    for (const std::size_t frame : {0U, 7U, 19U}) {
        const auto world = glb.worldAt(frame);
        for (std::size_t player = 0; player < 2; ++player) {
            const json& joints = glb.document["skins"][player]["joints"];
            for (std::size_t joint = 0; joint < joints.size(); ++joint) {
                const Vector3d place =
                    world[joints[joint].get<std::size_t>()].topRightCorner<3, 1>();
                const auto e =
                    expected[player].at(static_cast<int>(frame), static_cast<int>(joint));
                EXPECT_LT((place - e.cast<double>()).norm(), 1e-5);
            }
        }
    }
}

// A vertex of the skin goes with its joint: ends of capsules stay round their joints.
TEST(Gltf, SkinsFollowTheirJoints) {
    const Clip clip = swayingHuman(10, 60);
    const Glb glb(bothFighters(clip, clip));
    const auto world = glb.worldAt(9);
    const JointPositions expected = positionsOf(clip);
    const json& skin = glb.document["skins"][0];
    const auto inverse = glb.read(skin["inverseBindMatrices"]);
    const json& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
    const auto positions = glb.read(attributes["POSITION"]);
    const auto joints = glb.read(attributes["JOINTS_0"]);
    double farthest = 0;
    for (std::size_t v = 0; 3 * v < positions.size(); ++v) {
        const auto joint = static_cast<std::size_t>(joints[4 * v]);
        const Eigen::Map<const Matrix4d> bind(inverse.data() + 16 * joint);
        const Eigen::Vector4d rest(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2], 1);
        const Vector3d place =
            (world[skin["joints"][joint].get<std::size_t>()] * bind * rest).head<3>();
        double nearest = 1;
        for (int j = 0; j < expected.jointCount; ++j)
            nearest = std::min(nearest, (place - expected.at(9, j).cast<double>()).norm());
        farthest = std::max(farthest, nearest);
    }
    // The trunk has a radius of 12 cm; the skull's ball of 9 cm stands 10 cm over the head's joint.
    EXPECT_LT(farthest, std::hypot(0.1, 0.09) + 1e-6);
}

TEST(Gltf, AJointAloneHasNoBody) {
    auto rig = std::make_shared<Rig>(*swayingHuman(1, 60).rig);
    rig->joints.resize(1);
    rig->roles = RoleMap();
    Clip clip{rig, 60, {Pose{}, Pose{}}};
    for (Pose& pose : clip.frames)
        pose.turns.assign(1, Eigen::Quaterniond::Identity());
    const Glb glb(glbBytes(std::vector<GltfFigure>{{"player1", &clip, 0, {1, 1, 1}}}, "point"));
    EXPECT_FALSE(glb.document.contains("meshes"));
    EXPECT_FALSE(glb.document.contains("skins"));
    for (const json& view : glb.document["bufferViews"])
        EXPECT_GT(view["byteLength"].get<int>(), 0);
}

TEST(Gltf, RefusesNothing) {
    EXPECT_THROW(glbBytes({}, "none"), Error);
    const Clip empty{swayingHuman(1, 60).rig, 60, {}};
    EXPECT_THROW(glbBytes(std::vector<GltfFigure>{{"player1", &empty, 0, {1, 1, 1}}}, "none"),
                 Error);
}

TEST(Gltf, OfARecordingToATenthOfAMillimetre) {
    KUMITE_NEEDS_DATA();
    const Recording recording =
        readRecording(*test::dataFolder() / "cmu_karate" / "martial_04.bvh");
    const Motion& motion = *recording.motions.front();
    const Survey survey = surveyMotion(motion);
    const FrameRange frames{1, 400};
    const Clip clip = clipOf(motion, frames, survey.space, survey.roles.roles);
    const Glb glb(glbBytes(std::vector<GltfFigure>{{"player1", &clip, 0, {1, 1, 1}}}, "kicks"));
    const auto expected = forwardKinematics(motion, frames, survey.space);
    const auto world = glb.worldAt(398);
    const json& joints = glb.document["skins"][0]["joints"];
    ASSERT_EQ(joints.size(), static_cast<std::size_t>(expected.jointCount));
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
        const Vector3d place = world[joints[joint].get<std::size_t>()].topRightCorner<3, 1>();
        EXPECT_LT((place - expected.at(398, static_cast<int>(joint)).cast<double>()).norm(), 1e-4);
    }
}

}  // namespace
}  // namespace kumite
