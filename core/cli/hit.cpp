#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/cli/library_options.h"
#include "core/editing/hit_region.h"
#include "core/formats/bvh.h"
#include "core/formats/json_text.h"
#include "core/project/hit_draft.h"
#include "core/project/library_strikes.h"

namespace kumite::cli {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

struct Options {
    LibraryOptions library{{}, 60};
    StrikeRequest request;
    std::string target, limb, out, method = "best";
    bool json = false;
};

Vector3d parseTarget(const std::string& text) {
    const auto target = targetFrom(text);
    if (!target) throw UsageError("\"" + text + "\" is no target, expected x,y,z in metres.");
    return *target;
}

Json json(const Vector3d& point) {
    return {rounded(point.x()), rounded(point.y()), rounded(point.z())};
}

Json json(const Box& box) {
    return {{"low", json(box.low)}, {"high", json(box.high)}};
}

Json json(const StrikeSpace& space, const BlendFit& fit) {
    Json weights = Json::object();
    for (const ExampleWeight& w : fit.weights)
        weights[space.examples[static_cast<std::size_t>(w.example)].name] = rounded(w.weight);
    return {{"point", json(fit.point)}, {"weights", std::move(weights)}};
}

/// The striking joint's place in the motion that is written, at the frame of the hit.
Vector3d reachedIn(const Motion& motion, const MotionLibrary& library, int joint, int frame) {
    return forwardKinematics(motion, {frame, frame + 1}, library.space).at(0, joint).cast<double>();
}

void runHit(const Options& o, const Streams& streams) {
    const auto method = methodFromName(o.method);
    if (!method) throw UsageError("\"" + o.method + "\" is no method: full, partial or best.");
    StrikeRequest request = o.request;
    std::optional<Vector3d> wanted;
    if (!o.target.empty()) wanted = parseTarget(o.target);
    if (request.strike.empty() || !wanted) {
        const auto project = projectWithDraft(o.library, "hit");
        const HitDraft draft = project ? hitDraftOf(*project) : HitDraft{};
        if (request.strike.empty()) request.strike = draft.strike;
        if (!wanted) wanted = draft.target;
        if (request.strike.empty() || !wanted)
            throw UsageError("Name --strike and --target, or a project that holds them.");
    }
    const Vector3d target = *wanted;
    if (!o.limb.empty()) {
        request.striker = strikerFromName(o.limb);
        if (!request.striker)
            throw UsageError("\"" + o.limb +
                             "\" does not strike: left_hand, right_hand, left_foot, right_foot.");
    }
    const auto library = openLibrary(o.library, o.out, streams);
    const StrikeExamples examples = strikesOf(*library, request);
    const StrikeSpace space = strikeSpace(examples, {}, streams.progress("aligning"));
    const HitSettings settings;
    const HitMotion hit = hitTarget(space, target, *method, settings);
    const int joint = *strikingJoint(*space.rig, space.striker);

    const Motion motion = motionOf(hit.clip, library->skeleton, library->space);
    writeFileAtomically(o.out, bvhText(motion, motion.frames(), motion.frameTime));
    const Vector3d reached = reachedIn(motion, *library, joint, hit.hit);
    const double error = (reached - target).norm();
    const bool hits = error <= settings.tolerance;
    const bool partial = hit.solution.method == HitMethod::Partial;
    if (!hits) {
        printFindings({warning(fmt::format(
                          "The target cannot be reached: the nearest point that \"{}\" "
                          "reaches is {:.1f} cm away, at {:.2f},{:.2f},{:.2f}.",
                          request.strike, 100 * error, reached.x(), reached.y(), reached.z()))},
                      streams);
    }
    if (!o.json) {
        streams.out << fmt::format(
            "{} of {} examples, {}, {}: {:.1f} cm from the target at frame {} of {}.\n",
            strikerName(space.striker), space.examples.size(), methodName(hit.solution.method),
            hit.solution.insideNaturalRegion ? "inside the natural region"
                                             : "outside of the natural region",
            100 * error, hit.hit, hit.clip.frameCount());
        return;
    }
    const Box extended =
        extendedBox(space, settings, 0.05, 0.3, streams.progress("finding what is reached"));
    Json list = Json::array();
    for (const auto& example : space.examples)
        list.push_back({{"name", example.name}, {"point", json(example.point)}});
    Json result = {{"target", json(target)},
                   {"reached", json(reached)},
                   {"hits", hits},
                   {"error_cm", rounded(100 * error)},
                   {"method", methodName(hit.solution.method)},
                   {"inside_natural_region", hit.solution.insideNaturalRegion},
                   {"inside_extended_box", extended.contains(target)},
                   {"limb", strikerName(space.striker)},
                   {"joint", space.rig->joint(joint).name},
                   {"frame", hit.hit},
                   {"frames", hit.clip.frameCount()},
                   {"rate", hit.clip.rate},
                   {"horizontal", json(space, hit.solution.horizontal)},
                   {"vertical", partial ? json(space, hit.solution.vertical) : Json(nullptr)},
                   {"natural_region", json(space.natural)},
                   {"extended_box", json(extended)},
                   {"examples", std::move(list)}};
    result["natural_region"]["samples"] = space.samples.size();
    streams.out << result.dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
}

}  // namespace

void addHit(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "hit", "Makes a strike hit a target: examples are blended, whole or by body parts.");
    addLibraryOptions(*command, o->library);
    command->add_option("--strike", o->request.strike,
                        "the examples: an aspect (right_kick, right_kick:up) or clips, a,b,…; "
                        "without it what a project among LIB holds, as of the target");
    command->add_option("--player", o->request.player, "only fighter 1 or 2 of the projects' takes")
        ->check(CLI::Range(1, 2));
    command->add_option("--limb", o->limb,
                        "what strikes: left_hand, right_hand, left_foot, right_foot; else the "
                        "aspect's, or the fastest");
    command->add_option("--target", o->target, "x,y,z in metres");
    command->add_option("--method", o->method, "full, partial or best")->capture_default_str();
    command->add_option("--out", o->out, "the .bvh to write")->required();
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(
        "The target stands in the striker's frame at the strike's start, in which the motion is\n"
        "written: the pelvis on the floor is the origin, x to the left, y up, z along the "
        "heading.\n"
        "What hits is the wrist or the toe; \"error_cm\" is measured on the motion that is "
        "written.\n"
        "A target that cannot be reached gets the nearest point that can, and a warning.\n"
        "A recording without labels is a clip, too: the strikes in it are found.\n"
        "Examples: kumite hit bout.kumite --strike right_punch --player 1 --target 0.1,1.4,0.7 "
        "--out punch.bvh\n"
        "          kumite hit karate/ --strike martial_04 --target=-0.3,1.5,0.8 --out kick.bvh "
        "--json");
    command->callback(
        [o, &action] { action = [o](const Streams& streams) { runHit(*o, streams); }; });
}

}  // namespace kumite::cli
