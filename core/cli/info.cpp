#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/formats/recording.h"
#include "core/motion/feet.h"
#include "core/motion/survey.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

/// All that is known about one skeleton of a file.
struct Facts {
    std::shared_ptr<const Motion> motion;
    Survey survey;
    std::optional<double> floor;
    std::optional<FootSkate> skate;
    Eigen::Vector3f low, high;  ///< box around all joints over all frames, metres
};

Facts gather(std::shared_ptr<const Motion> motion, const Progress& progress) {
    Facts facts;
    facts.survey = surveyMotion(*motion);
    const RoleMap& roles = facts.survey.roles.roles;
    const JointPositions positions =
        forwardKinematics(*motion, {facts.survey.leadingRestFrames, motion->frameCount},
                          facts.survey.space, progress);
    facts.floor = floorHeight(*motion->skeleton, roles, positions);
    facts.low = facts.high = positions.at(0, 0);
    std::array<std::vector<Eigen::Vector3f>, 2> toes;
    const std::array feet = {footPoint(*motion->skeleton, roles, true),
                             footPoint(*motion->skeleton, roles, false)};
    for (int frame = 0; frame < positions.frameCount; ++frame) {
        for (int joint = 0; joint < positions.jointCount; ++joint) {
            facts.low = facts.low.cwiseMin(positions.at(frame, joint));
            facts.high = facts.high.cwiseMax(positions.at(frame, joint));
        }
        for (std::size_t i = 0; i < 2; ++i) {
            if (feet[i]) toes[i].push_back(positions.at(frame, *feet[i]));
        }
    }
    if (feet[0] && feet[1]) {
        facts.skate = measureFootSkate(toes[0], toes[1], facts.survey.rate, *facts.floor);
    }
    facts.motion = std::move(motion);
    return facts;
}

int jointCount(const Skeleton& skeleton) {
    return static_cast<int>(std::count_if(skeleton.joints.begin(), skeleton.joints.end(),
                                          [](const Joint& joint) { return !joint.isEndSite; }));
}

std::string nameOf(const Skeleton& skeleton, int joint) {
    return skeleton.joints[static_cast<std::size_t>(joint)].name;
}

Json toJson(const Facts& facts, const Recording& recording, const std::string& root) {
    const Skeleton& skeleton = *facts.motion->skeleton;
    Json roles = Json::object();
    for (const Role role : allRoles()) {
        const auto joint = facts.survey.roles.roles[role];
        if (joint) roles[std::string(roleName(role))] = nameOf(skeleton, *joint);
    }
    Json joints = Json::array();
    for (const Joint& joint : skeleton.joints) {
        if (!joint.isEndSite) joints.push_back(joint.name);
    }
    Json findings = Json::array();
    const auto addFindings = [&](const Findings& list) {
        for (const Finding& finding : list) {
            findings.push_back(
                {{"severity", finding.severity == Severity::Note ? "note" : "warning"},
                 {"text", finding.text}});
        }
    };
    addFindings(recording.findings);
    addFindings(facts.survey.findings);
    Json json = {{"format", recording.format},
                 {"root", root},
                 {"roots", rootNames(recording)},
                 {"joints", jointCount(skeleton)},
                 {"joint_names", std::move(joints)},
                 {"channels", skeleton.channelCount},
                 {"frames", facts.motion->frameCount},
                 {"rate", facts.survey.rate},
                 {"frame_time", facts.motion->frameTime},
                 {"metres_per_unit", facts.survey.space.metresPerUnit},
                 {"unit", facts.survey.unitName},
                 {"up", facts.survey.space.up == UpAxis::Y ? "y" : "z"},
                 {"floor", nullptr},
                 {"leg_m", facts.survey.legLength},
                 {"rest_frames", facts.survey.leadingRestFrames},
                 {"foot_skate", nullptr},
                 {"family", facts.survey.roles.family},
                 {"roles", std::move(roles)},
                 {"sha256", recording.sha256},
                 {"findings", std::move(findings)}};
    if (facts.floor) json["floor"] = *facts.floor;
    if (facts.skate) json["foot_skate"] = facts.skate->ratio();
    return json;
}

void printText(const Facts& facts, const Recording& recording, const std::string& root,
               const Streams& streams) {
    const Skeleton& skeleton = *facts.motion->skeleton;
    const Survey& survey = facts.survey;
    const auto line = [&](std::string_view what, const std::string& value) {
        streams.out << fmt::format("{:<10} {}\n", what, value);
    };
    const auto roots = rootNames(recording);
    line("skeleton",
         fmt::format(
             "{} joints, {} channels, root {}{}", jointCount(skeleton), skeleton.channelCount, root,
             roots.size() > 1 ? fmt::format(" (of {}; choose with --root)", fmt::join(roots, ", "))
                              : ""));
    line("motion", fmt::format("{} frames at {:g} Hz, {:.2f} s", facts.motion->frameCount,
                               survey.rate, facts.motion->frameCount / survey.rate));
    line("unit",
         fmt::format("{} ({} m){}", survey.unitName, shortest(survey.space.metresPerUnit),
                     survey.legLength > 0 ? fmt::format(", legs {:.2f} m", survey.legLength) : ""));
    line("up", survey.space.up == UpAxis::Y ? "y" : "z");
    if (facts.floor) line("floor", fmt::format("{:.3f} m", *facts.floor));
    line("space",
         fmt::format("{:.2f} × {:.2f} × {:.2f} m (x, y, z)", facts.high.x() - facts.low.x(),
                     facts.high.y() - facts.low.y(), facts.high.z() - facts.low.z()));
    if (facts.skate) {
        line("feet", fmt::format("{:.1f} % of frames skate", 100 * facts.skate->ratio()));
    }
    line("names", survey.roles.family);
    for (const Role role : allRoles()) {
        const auto joint = survey.roles.roles[role];
        line("", fmt::format("{:<15} {}", roleName(role), joint ? nameOf(skeleton, *joint) : "-"));
    }
}

}  // namespace

void addInfo(CLI::App& app, Action& action) {
    struct Options {
        std::string file, asf, root;
        bool json = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "info", "What a recording holds: skeleton, roles, unit, up axis, frames, rate, findings.");
    command->add_option("FILE", o->file, "a .bvh or .amc file")->required();
    command->add_option("--asf", o->asf, "skeleton of an .amc; default: the only one beside it");
    command->add_option("--root", o->root, "which skeleton, where a file holds several");
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer("Example: kumite info kick.bvh --json");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            ReadOptions read;
            if (!o->asf.empty()) read.asf = o->asf;
            const Recording recording = readRecording(o->file, read, streams.progress("reading"));
            const Facts facts =
                gather(motionOfRoot(recording, o->root), streams.progress("computing"));
            const std::string root = o->root.empty() ? rootNames(recording).front() : o->root;
            if (o->json) {
                streams.out << toJson(facts, recording, root)
                                   .dump(1, ' ', false, Json::error_handler_t::replace)
                            << "\n";
                return;
            }
            printText(facts, recording, root, streams);
            printFindings(recording.findings, streams);
            printFindings(facts.survey.findings, streams);
        };
    });
}

}  // namespace kumite::cli
