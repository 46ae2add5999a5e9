#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/cli/library_options.h"
#include "core/editing/assembly.h"
#include "core/editing/key_file.h"
#include "core/formats/json_text.h"
#include "core/motion/blend.h"
#include "core/project/key_draft.h"
#include "core/project/library.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    LibraryOptions library{{}, 60};
    std::string keys, out, parts, body;
    bool direct = false, adjusted = false, json = false;
    std::optional<double> meet;
};

ClipRange rangeOf(const MotionLibrary& library, const std::string& clip) {
    const LibraryAction action = actionNamed(library, clip);
    return {action.motion, action.frames};
}

/// "left_arm=CLIP,trunk=own,all=body".
AssemblyChoices parseChoices(const MotionLibrary& library, const Options& o) {
    AssemblyChoices choices;
    if (!o.body.empty()) choices.body = rangeOf(library, o.body);
    for (const std::string_view word : split(o.parts, ',')) {
        if (trimmed(word).empty()) continue;
        const auto sign = word.find('=');
        const std::string name(trimmed(word.substr(0, sign)));
        const std::string from(sign == std::string_view::npos ? std::string_view()
                                                              : trimmed(word.substr(sign + 1)));
        const auto part = partFromName(name);
        if (from.empty() || (!part && name != "all")) {
            throw UsageError("\"" + std::string(word) +
                             "\": expected left_arm, right_arm, left_leg, right_leg, trunk or all, "
                             "then =CLIP, =own or =body.");
        }
        PartChoice choice;
        if (from == "body") {
            choice.kind = PartChoice::Kind::WithBody;
        } else {
            choice.kind = PartChoice::Kind::Own;
            if (from != "own") choice.within = rangeOf(library, from);
        }
        for (const BodyPart each : allParts()) {
            if (!part || *part == each) choices.parts[static_cast<std::size_t>(each)] = choice;
        }
    }
    return choices;
}

/// A pose of a clip by the frame of its file or take, counted from the clip's first.
Pose poseOf(const MotionLibrary& library, const std::string& clip, int at) {
    const LibraryAction action = actionNamed(library, clip);
    const LibraryMotion& motion = library.motions[static_cast<std::size_t>(action.motion)];
    const double seconds = at / motion.sourceRate;
    const int last =
        static_cast<int>(std::ceil((action.frames.size() - 1) * motion.sourceRate / library.rate));
    if (at < 0 || at > last)
        throw Error(fmt::format("clip \"{}\" has frames 0 to {}, not {}.", clip, last, at));
    return poseAt(motion.clip, action.frames.begin / library.rate + seconds);
}

/// Where a match lies: the motion, frames of its file or take, and the action there if it has one.
Json matchJson(const KeyLibrary& library, const PoseMatch& match) {
    const LibraryMotion& motion = library.motion(match.match.clip);
    Json frames = Json::array();
    for (const int f : match.match.frames)
        frames.push_back(std::lround(f * motion.sourceRate / library.features.rate));
    Json json = {{"clip", motion.name},
                 {"frames", std::move(frames)},
                 {"mismatches", match.match.mismatches},
                 {"stretch", rounded(match.match.stretch)},
                 {"distance_cm", rounded(100 * match.distance)}};
    const int middle = match.match.frames[match.match.frames.size() / 2];
    for (const LibraryAction& action : library.library->actions) {
        if (action.motion == match.match.clip && action.frames.contains(middle) &&
            action.name != motion.name) {
            json["action"] = action.name;
            if (!action.label.empty()) json["label"] = action.label;
            break;
        }
    }
    return json;
}

Json statisticsJson(const AngleStatistics& s) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    const auto vector = [&](const Eigen::Vector3d& v) {
        Json list = Json::array();
        for (int axis = 0; axis < 3; ++axis)
            list.push_back(rounded(kDegrees * v[axis]));
        return list;
    };
    return {{"mean_deg", vector(s.mean)}, {"deviation_deg", vector(s.deviation)}};
}

Json resultJson(const KeyLibrary& library, const KeyTrack& track, const AssemblyPlan& plan,
                const Assembly& made, bool adjusted) {
    Json json = {{"keys", track.keys.size()},
                 {"frames", made.clip.frameCount()},
                 {"rate", made.clip.rate},
                 {"assembly", adjusted ? "adjusted" : "direct"},
                 {"body", matchJson(library, plan.body)}};
    Json& parts = json["parts"] = Json::object();
    for (const BodyPart part : allParts()) {
        const auto& own = plan.parts[static_cast<std::size_t>(part)];
        parts[std::string(partName(part))] = own ? matchJson(library, *own) : Json("body");
    }
    Json& junctions = json["junctions"] = Json::array();
    for (const AdjustedJunction& junction : made.junctions) {
        junctions.push_back({{"part", partName(junction.part)},
                             {"joint", track.rig->joint(junction.joint).name},
                             {"query", statisticsJson(junction.values.query)},
                             {"retrieved", statisticsJson(junction.values.retrieved)},
                             {"adjusted", statisticsJson(junction.values.assembled)}});
    }
    return json;
}

void printText(const KeyLibrary& library, const KeyTrack& track, const AssemblyPlan& plan,
               const Assembly& made, const Streams& streams) {
    const auto line = [&](std::string_view what, const PoseMatch& match) {
        const LibraryMotion& motion = library.motion(match.match.clip);
        const double perFrame = motion.sourceRate / library.features.rate;
        streams.out << fmt::format("{:<10} {} frames {} to {}, {} features differ\n", what,
                                   motion.name, std::lround(match.match.frames.front() * perFrame),
                                   std::lround(match.match.frames.back() * perFrame),
                                   match.match.mismatches);
    };
    line("body", plan.body);
    for (const BodyPart part : allParts()) {
        const auto& own = plan.parts[static_cast<std::size_t>(part)];
        if (own) line(partName(part), *own);
    }
    streams.out << fmt::format("{} keys became {} frames at {:g} Hz.\n", track.keys.size(),
                               made.clip.frameCount(), made.clip.rate);
}

struct Query {
    KeyTrack track;
    AssemblyChoices choices;
    AssemblySettings settings;
};

Query namedQuery(const MotionLibrary& library, const Options& o) {
    Query query;
    query.choices = parseChoices(library, o);
    query.settings.adjusted = !o.direct;
    query.settings.meetKeys = o.meet.value_or(0);
    const FileBytes file(o.keys);
    query.track =
        parseKeys(file.bytes(), o.keys, library.rig,
                  [&](const std::string& clip, int at) { return poseOf(library, clip, at); });
    return query;
}

/// What a project among the sources holds; what the options say goes first.
Query heldQuery(const std::shared_ptr<const MotionLibrary>& library, const Options& o) {
    const auto project = projectWithDraft(o.library, "keys");
    if (!project) throw UsageError("Name --keys, or a project that holds key poses.");
    const KeyDraft draft = keyDraftOf(*project, library->rig, library->rate);
    Query query{draft.track, choicesOf(*library, draft), draft.assembly};
    const AssemblyChoices said = parseChoices(*library, o);
    if (!o.body.empty()) query.choices.body = said.body;
    if (!o.parts.empty()) query.choices.parts = said.parts;
    if (o.direct || o.adjusted) query.settings.adjusted = o.adjusted;
    if (o.meet) query.settings.meetKeys = *o.meet;
    return query;
}

void runKeyframes(const Options& o, const Streams& streams) {
    if (o.direct && o.adjusted) throw UsageError("Either --direct or --adjusted.");
    if (!o.keys.empty()) refuseToOverwrite(o.out, {o.keys});
    const auto motions = openLibrary(o.library, o.out, streams);
    const auto [track, choices, settings] =
        o.keys.empty() ? heldQuery(motions, o) : namedQuery(*motions, o);
    const KeyLibrary library = keyLibrary(motions, {}, streams.progress("finding features"));
    const AssemblyPlan plan = planAssembly(library, track, choices, streams.progress("searching"));
    const Assembly made = assemble(library, track, plan, settings);
    writeClip(*motions, made.clip, o.out);
    if (o.json) {
        streams.out << resultJson(library, track, plan, made, settings.adjusted)
                           .dump(1, ' ', false, Json::error_handler_t::replace)
                    << "\n";
    } else {
        printText(library, track, plan, made, streams);
    }
}

constexpr char kFooter[] =
    R"(keys.json, an object: "key_poses": 1; "rate": Hz of the keys' frames and of the result (60);
"keys": [{
  "frame": 24,                      when; one key a frame, in any order
  "clip": "martial_04", "at": 310,  the pose of that clip at that frame of it; without a clip
                                    the pose of the key before (of the first: standing at rest)
  "mirror": true,                   right for left
  "turns": {"right_elbow": [0, 80, 0], "Chest": [1, 0, 0, 0]},
                                    rotations against the parent, by role or joint name: degrees
                                    about x, y, z (R = Rz Rx Ry) or a quaternion w, x, y, z
  "root": [0, 0.9, 0],              place of the root, metres
  "place": {"x": 0, "z": 1, "yaw": 30, "height": 0.85},
                                    pelvis over this point of the floor, facing (degrees)
  "handles": {"left_hand": [0.2, 1.4, 0.5]},
                                    drawn there by inverse kinematics, in the pose's own frame:
                                    pelvis on the floor the origin, x left, y up, z ahead; metres;
                                    left_hand, right_hand, left_foot, right_foot, hips, chest, head
  "easing": "smooth"                of the way to the next key: linear, smooth, in, out, hold
}, …]
Without --parts, arms and trunk come from the clip that the whole body is taken from, unless
another clip matches the keys better in them; legs always do. The result begins at the first key and ends at the last.
Example: kumite keyframes karate/ --keys keys.json --parts right_arm=martial_03,trunk=body --out x.bvh)";

}  // namespace

void addKeyframes(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "keyframes", "Makes a motion of a few key poses, assembled from a library's body parts.");
    addLibraryOptions(*command, o->library);
    command->add_option(
        "--keys", o->keys,
        "the key poses, keys.json (see below); without it what a project among LIB holds");
    command->add_option("--out", o->out, "the .bvh to write")->required();
    command->add_option("--body", o->body, "clip that the whole body comes from; else the best");
    command->add_option("--parts", o->parts,
                        "where parts come from: left_arm=CLIP,trunk=own,all=body; own: the best "
                        "for that part alone");
    command->add_flag("--direct", o->direct, "junction joints as retrieved");
    command->add_flag("--adjusted", o->adjusted,
                      "junction joints with the keys' mean and deviation (default)");
    command
        ->add_option("--meet", o->meet, "0 to 1: how far the result is drawn to the key poses (0)")
        ->check(CLI::Range(0.0, 1.0));
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(kFooter);
    command->callback(
        [o, &action] { action = [o](const Streams& streams) { runKeyframes(*o, streams); }; });
}

}  // namespace kumite::cli
