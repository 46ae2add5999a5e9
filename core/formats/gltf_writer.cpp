#include <algorithm>
#include <cstring>
#include <limits>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/formats/gltf.h"
#include "core/formats/gltf_body.h"
#include "core/formats/json_text.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Quaterniond;
using Eigen::Vector3d;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

enum ComponentType { kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126 };
enum Target { kNone = 0, kVertices = 34962, kIndices = 34963 };

/// The binary chunk and the accessors that describe it.
class Buffer {
public:
    template <typename T>
    int add(const std::vector<T>& values, int width, ComponentType component, const char* type,
            Target target = kNone, bool bounds = false) {
        bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
        Json view = {{"buffer", 0},
                     {"byteOffset", bytes_.size()},
                     {"byteLength", values.size() * sizeof(T)}};
        if (target != kNone) view["target"] = static_cast<int>(target);
        views_.push_back(view);
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        Json accessor = {{"bufferView", views_.size() - 1},
                         {"componentType", static_cast<int>(component)},
                         {"count", values.size() / static_cast<std::size_t>(width)},
                         {"type", type}};
        if (bounds) {
            std::vector<T> low(values.begin(), values.begin() + width), high = low;
            for (std::size_t i = 0; i < values.size(); ++i) {
                const std::size_t k = i % static_cast<std::size_t>(width);
                low[k] = std::min(low[k], values[i]);
                high[k] = std::max(high[k], values[i]);
            }
            accessor["min"] = low;
            accessor["max"] = high;
        }
        accessors_.push_back(accessor);
        return static_cast<int>(accessors_.size()) - 1;
    }

    Json views_ = Json::array();
    Json accessors_ = Json::array();
    std::string bytes_;
};

void append(std::vector<float>& values, const Eigen::Vector3f& v) {
    values.insert(values.end(), {v.x(), v.y(), v.z()});
}

/// A document as it grows, figure by figure.
class Document {
public:
    explicit Document(const std::string& title) : title_(title) {}

    void add(const GltfFigure& figure) {
        const Clip& clip = *figure.clip;
        const Rig& rig = *clip.rig;
        const int firstJoint = static_cast<int>(nodes_.size());
        const std::vector<Vector3d> rest = standingRest(rig);
        addJoints(rig, rest[0]);
        // A skinned mesh stands beside its skeleton: transforms above it would not move it.
        const int root = static_cast<int>(nodes_.size());
        nodes_.push_back({{"name", asStored(figure.name)}, {"children", {firstJoint}}});
        sceneNodes_.push_back(root);
        // A single joint has no body.
        if (const BodyMesh body = bodyMesh(rig); !body.positions.empty()) {
            nodes_.push_back({{"name", asStored(figure.name + " body")},
                              {"mesh", addBody(figure, body, rest)},
                              {"skin", addSkin(figure, rest, firstJoint)}});
            sceneNodes_.push_back(root + 1);
        }
        addTracks(figure, firstJoint);
    }

    std::string bytes() {
        Json document = {
            {"asset", {{"version", "2.0"}, {"generator", "Kumite"}}},
            {"scene", 0},
            {"scenes", {{{"name", asStored(title_)}, {"nodes", sceneNodes_}}}},
            {"nodes", nodes_},
            {"animations",
             {{{"name", asStored(title_)}, {"samplers", samplers_}, {"channels", channels_}}}},
            {"accessors", buffer_.accessors_},
            {"bufferViews", buffer_.views_},
            {"buffers", {{{"byteLength", buffer_.bytes_.size()}}}},
        };
        if (!meshes_.empty()) {
            document["meshes"] = meshes_;
            document["materials"] = materials_;
            document["skins"] = skins_;
        }
        std::string json = document.dump();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        std::string binary = std::move(buffer_.bytes_);
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        const std::size_t total = 12 + 8 + json.size() + 8 + binary.size();
        if (total > std::numeric_limits<std::uint32_t>::max())
            throw Error("A .glb file cannot hold more than 4 GB: export a shorter range.");
        std::string file;
        file.reserve(total);
        const auto word = [&](std::size_t value) {
            const auto number = static_cast<std::uint32_t>(value);
            file.append(reinterpret_cast<const char*>(&number), 4);
        };
        word(0x46546C67);  // "glTF"
        word(2);
        word(total);
        word(json.size());
        word(0x4E4F534A);  // "JSON"
        file += json;
        word(binary.size());
        word(0x004E4942);  // "BIN"
        file += binary;
        return file;
    }

private:
    /// Rest positions with the lowest joint on the floor: what is seen without the animation.
    static std::vector<Vector3d> standingRest(const Rig& rig) {
        std::vector<Vector3d> rest = restPositions(rig);
        double lowest = 0;
        for (const Vector3d& position : rest)
            lowest = std::min(lowest, position.y());
        for (Vector3d& position : rest)
            position.y() -= lowest;
        return rest;
    }

    void addJoints(const Rig& rig, const Vector3d& root) {
        const int first = static_cast<int>(nodes_.size());
        for (int i = 0; i < rig.jointCount(); ++i) {
            const Vector3d offset = i == 0 ? root : rig.joint(i).offset;
            Json node = {{"name", asStored(rig.joint(i).name)},
                         {"translation",
                          {static_cast<float>(offset.x()), static_cast<float>(offset.y()),
                           static_cast<float>(offset.z())}}};
            Json children = Json::array();
            for (int child = i + 1; child < rig.jointCount(); ++child) {
                if (rig.joint(child).parent == i) children.push_back(first + child);
            }
            if (!children.empty()) node["children"] = children;
            nodes_.push_back(node);
        }
    }

    int addSkin(const GltfFigure& figure, const std::vector<Vector3d>& rest, int firstJoint) {
        std::vector<float> inverse;
        Json joints = Json::array();
        for (std::size_t i = 0; i < rest.size(); ++i) {
            joints.push_back(firstJoint + static_cast<int>(i));
            const Eigen::Vector3f back = (-rest[i]).cast<float>();
            inverse.insert(inverse.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
            append(inverse, back);
            inverse.push_back(1);
        }
        skins_.push_back({{"name", asStored(figure.name)},
                          {"inverseBindMatrices", buffer_.add(inverse, 16, kFloat, "MAT4")},
                          {"skeleton", firstJoint},
                          {"joints", joints}});
        return static_cast<int>(skins_.size()) - 1;
    }

    int addBody(const GltfFigure& figure, const BodyMesh& body, const std::vector<Vector3d>& rest) {
        std::vector<float> positions, normals, weights;
        std::vector<std::uint16_t> joints;
        for (std::size_t i = 0; i < body.positions.size(); ++i) {
            append(positions, body.positions[i] + rest[0].cast<float>());
            append(normals, body.normals[i]);
            joints.insert(joints.end(), {body.joints[i], 0, 0, 0});
            weights.insert(weights.end(), {1, 0, 0, 0});
        }
        const auto& colour = figure.colour;
        materials_.push_back({{"name", asStored(figure.name)},
                              {"pbrMetallicRoughness",
                               {{"baseColorFactor", {colour[0], colour[1], colour[2], 1}},
                                {"metallicFactor", 0},
                                {"roughnessFactor", 0.8}}}});
        Json attributes = {
            {"POSITION", buffer_.add(positions, 3, kFloat, "VEC3", kVertices, true)},
            {"NORMAL", buffer_.add(normals, 3, kFloat, "VEC3", kVertices)},
            {"JOINTS_0", buffer_.add(joints, 4, kUnsignedShort, "VEC4", kVertices)},
            {"WEIGHTS_0", buffer_.add(weights, 4, kFloat, "VEC4", kVertices)},
        };
        meshes_.push_back(
            {{"name", asStored(figure.name + " body")},
             {"primitives",
              {{{"attributes", attributes},
                {"indices", buffer_.add(body.triangles, 1, kUnsignedInt, "SCALAR", kIndices)},
                {"material", materials_.size() - 1}}}}});
        return static_cast<int>(meshes_.size()) - 1;
    }

    void addTrack(int times, const std::vector<float>& values, bool rotation, int node) {
        const int output =
            buffer_.add(values, rotation ? 4 : 3, kFloat, rotation ? "VEC4" : "VEC3");
        samplers_.push_back({{"input", times}, {"output", output}, {"interpolation", "LINEAR"}});
        channels_.push_back(
            {{"sampler", samplers_.size() - 1},
             {"target", {{"node", node}, {"path", rotation ? "rotation" : "translation"}}}});
    }

    void addTracks(const GltfFigure& figure, int firstJoint) {
        const Clip& clip = *figure.clip;
        std::vector<float> seconds, places;
        for (std::size_t i = 0; i < clip.frames.size(); ++i) {
            seconds.push_back(
                static_cast<float>(figure.start + static_cast<double>(i) / clip.rate));
            append(places, clip.frames[i].root.cast<float>());
        }
        const int times = buffer_.add(seconds, 1, kFloat, "SCALAR", kNone, true);
        addTrack(times, places, false, firstJoint);
        for (int joint = 0; joint < clip.rig->jointCount(); ++joint) {
            const auto j = static_cast<std::size_t>(joint);
            std::vector<float> turns;
            turns.reserve(4 * clip.frames.size());
            bool turnsAtAll = false;
            Quaterniond before = Quaterniond::Identity();
            for (const Pose& pose : clip.frames) {
                Quaterniond turn = pose.turns[j].normalized();
                // Interpolated component by component: neighbours on one side of the sphere.
                if (turn.dot(before) < 0) turn.coeffs() = -turn.coeffs();
                turnsAtAll = turnsAtAll || turn.vec().norm() > 1e-9;
                const Eigen::Vector4f xyzw = turn.coeffs().cast<float>();
                turns.insert(turns.end(), {xyzw[0], xyzw[1], xyzw[2], xyzw[3]});
                before = turn;
            }
            if (turnsAtAll) addTrack(times, turns, true, firstJoint + joint);
        }
    }

    std::string title_;
    Buffer buffer_;
    Json nodes_ = Json::array(), sceneNodes_ = Json::array(), skins_ = Json::array(),
         meshes_ = Json::array(), materials_ = Json::array(), samplers_ = Json::array(),
         channels_ = Json::array();
};

}  // namespace

std::string glbBytes(std::span<const GltfFigure> figures, const std::string& title,
                     const Progress& progress) {
    if (figures.empty()) throw Error("There is no figure to write.");
    Document document(title);
    double done = 0;
    for (const GltfFigure& figure : figures) {
        if (figure.clip->frames.empty())
            throw Error("There is no frame of " + figure.name + " to write.");
        if (figure.clip->rig->joints.size() > std::numeric_limits<std::uint16_t>::max())
            throw Error("A glTF skeleton cannot have more than 65 535 joints.");
        document.add(figure);
        progress.update(++done / static_cast<double>(figures.size() + 1));
    }
    return document.bytes();
}

}  // namespace kumite
