#include <algorithm>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/formats/bvh.h"
#include "core/project/bout.h"
#include "core/project/bout_report.h"
#include "core/project/bout_strips.h"
#include "core/project/kept_bout.h"
#include "core/synthesis/bout_quality.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string project, mode = "auto", out, script, attack, strips, report;
    double seconds = 30;
    std::uint64_t seed = 1;
    double temperature = 1;
    int avatar = 1;
    int attacker = 1;
    bool commandFirst = false;
    bool bestSample = false;
    bool json = false;
};

/// TAKE:A:B as a captured attack; the take's name may hold colons.
CapturedAttack attackNamed(const OpenProject& open, const Interaction& interaction,
                           const std::string& text, int attacker) {
    const auto second = text.rfind(':');
    const auto first = second == std::string::npos || second == 0 ? std::string::npos
                                                                  : text.rfind(':', second - 1);
    if (first == std::string::npos) throw UsageError("--attack wants TAKE:A:B, frames A to B.");
    const int take = takeNamed(open.project, text.substr(0, first));
    FrameRange frames = parseRange(text.substr(first + 1));
    const int count = open.analysis.at({take, attacker}).frameCount();
    if (frames.begin < 0) frames.begin = 0;
    if (frames.end < 0) frames.end = count;
    return attackIn(interaction, attacker, take, frames);
}

/// Everything that a bout needs, and how it is started.
struct Prepared {
    std::shared_ptr<const BoutLibrary> library;
    BoutSettings settings;
};

Prepared prepare(const OpenProject& open, const Options& o, const Streams& streams) {
    Interaction interaction =
        deriveInteraction(open.project, open.analysis, {}, {}, streams.progress("training"));
    if (const auto why = whyNoModel(open.project, interaction)) throw Error(*why);
    printFindings(interaction.findings, streams);
    Prepared prepared;
    BoutSettings& settings = prepared.settings;
    settings.mode = *modeFromName(o.mode);
    settings.seed = o.seed;
    settings.temperature = o.temperature;
    settings.score = o.bestSample ? ChoiceScore::BestSample : ChoiceScore::Evidence;
    settings.avatar = o.avatar - 1;
    settings.reactFirst = !o.commandFirst;
    settings.attacker = o.attacker - 1;
    if (settings.mode == BoutMode::Passive) {
        const CapturedAttack attack =
            o.attack.empty() ? busiestAttack(interaction, settings.attacker)
                             : attackNamed(open, interaction, o.attack, settings.attacker);
        settings.attack = attack.actions;
        interaction = interactionWithout(open.analysis, interaction, attack,
                                         streams.progress("training without the attack"));
    }
    prepared.library =
        boutLibrary(open.project, open.analysis, interaction, streams.progress("preparing"));
    printFindings(prepared.library->findings, streams);
    if (settings.mode == BoutMode::Avatar) {
        prepared.library =
            withAvatar(prepared.library, settings.avatar, streams.progress("training the avatar"));
    }
    return prepared;
}

struct Timing {
    double microseconds = 0;  ///< a frame, both fighters
    double choiceP50 = 0;     ///< milliseconds of frames in which somebody chose
    double choiceP99 = 0;
};

Timing fight(BoutTape& tape, int frames, const Progress& progress) {
    Timing timing;
    std::vector<float> choosing;
    double sum = 0;
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        tape.advance(1);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        sum += took.count();
        if (!tape.now().newChoices().empty())
            choosing.push_back(static_cast<float>(1e3 * took.count()));
        if (i % 60 == 0) progress.update(static_cast<double>(i) / frames);
    }
    progress.update(1);
    timing.microseconds = frames > 0 ? std::round(1e7 * sum / frames) / 10 : 0;
    timing.choiceP50 = percentile(choosing, 0.5);
    timing.choiceP99 = percentile(choosing, 0.99);
    return timing;
}

void printQuality(const Json& bout, const Json& recording, const Streams& streams) {
    streams.out << fmt::format("{:41}{:>10}{:>12}\n", "", "bout", "recording");
    const auto text = [](const Json& value) {
        return value.is_number() ? fixed(value.get<double>(), 3) : std::string("-");
    };
    for (const auto& [name, value] : bout.items()) {
        if (value.is_object()) continue;
        streams.out << fmt::format("{:41}{:>10}{:>12}\n", name, text(value), text(recording[name]));
    }
}

void runBout(const Options& o, const Streams& streams) {
    if (!modeFromName(o.mode)) throw UsageError("--mode is auto, avatar or passive.");
    const bool passive = o.mode == "passive";
    if (!o.attack.empty() && !passive) throw UsageError("--attack belongs to --mode passive.");
    const OpenProject open = openProject(o.project, streams);
    const Prepared prepared = prepare(open, o, streams);
    std::vector<BoutCommand> script;
    if (!o.script.empty())
        script = parseScript(FileBytes(o.script).bytes(), o.script, prepared.library->rate);
    const std::filesystem::path folder = o.out;
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
        throw Error(
            fmt::format("The folder {} cannot be made: {}.", folder.string(), failed.message()));
    }
    BoutTape tape(prepared.library, prepared.settings, std::move(script));
    const int frames = static_cast<int>(std::lround(o.seconds * prepared.library->rate));
    const Timing timing = fight(tape, frames, streams.progress("fighting"));

    const std::array<Motion, 2> motions = boutMotions(open.project, tape);
    for (const std::size_t p : {0, 1}) {
        writeFileAtomically(folder / fmt::format("player{}.bvh", p + 1),
                            bvhText(motions[p], motions[p].frames(), motions[p].frameTime));
    }
    writeFileAtomically(folder / "log.json", boutLog(tape));
    if (!o.strips.empty()) writeFileAtomically(o.strips, boutStripsSvg(tape));

    const RecordingQuality recording = recordingQuality(*prepared.library);
    const Quality quality = boutQuality(tape, recording.bar, streams.progress("judging"));
    if (!o.report.empty()) {
        writeBoutReport(
            {std::filesystem::path(o.project).stem().string(), quality, recording.quality}, tape,
            o.report, streams.progress("drawing"));
    }
    if (o.json) {
        const Json json = {{"frames", tape.end() + 1},
                           {"rate", prepared.library->rate},
                           {"choices", tape.choices().size()},
                           {"us_per_frame", timing.microseconds},
                           {"choice_ms", {{"p50", timing.choiceP50}, {"p99", timing.choiceP99}}},
                           {"quality", qualityJson(quality)},
                           {"recording_quality", qualityJson(recording.quality)}};
        streams.out << json.dump(1) << "\n";
        return;
    }
    streams.out << fmt::format("{} frames at {} Hz, {} choices, {:.0f} us a frame\n{}\n",
                               tape.end() + 1, shortest(prepared.library->rate),
                               tape.choices().size(), timing.microseconds, folder.string());
    printQuality(qualityJson(quality), qualityJson(recording.quality), streams);
}

}  // namespace

void addBout(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "bout", "Synthesises a bout from a labelled project: player1.bvh, player2.bvh, log.json.");
    command->add_option("PROJECT", o->project, "a .kumite file with labels")->required();
    command->add_option("--out", o->out, "folder for the results")->required();
    command->add_option("--mode", o->mode, "auto, avatar (steered) or passive (answers an attack)")
        ->capture_default_str();
    command->add_option("--seconds", o->seconds, "length")->check(CLI::Range(0.0, 36000.0));
    command->add_option("--seed", o->seed, "the same seed gives the same bout");
    command
        ->add_option("--temperature", o->temperature,
                     "0: always the likeliest; 1: as learnt; above: flatter")
        ->check(CLI::Range(0.0, 1000.0));
    command->add_flag("--best-sample", o->bestSample,
                      "the paper's geometry term: that of a label's best sample, which favours "
                      "frequent labels");
    command->add_option("--script", o->script, "a .json with timed commands");
    command->add_option("--avatar", o->avatar, "who is steered")->check(CLI::Range(1, 2));
    command->add_flag("--command-first", o->commandFirst,
                      "the avatar serves its command even under attack");
    command->add_option("--attacker", o->attacker, "who replays an attack")
        ->check(CLI::Range(1, 2));
    command->add_option("--attack", o->attack,
                        "TAKE:A:B, the frames of the attack; else the busiest ten seconds");
    command->add_option("--strips", o->strips,
                        "an .svg: synthesised actions beside the recorded ones they are made from");
    command->add_option("--report", o->report,
                        "a folder for report.md, quality.json and strips.svg: the bout's quality "
                        "beside the recording's, and the strips");
    command->add_flag("--json", o->json, "one JSON object on standard output");
    command->footer(
        "A script: {\"kumite_script\": 1, \"commands\": [COMMAND…]}, each COMMAND with \"at\" "
        "(seconds) and one of\n"
        "  \"act\": \"kick\" | \"punch\" | ASPECT | ASPECT:QUALIFIER   the avatar's next action\n"
        "  \"release\": true                                       forgets it\n"
        "  \"target\": [x, z]                  where the avatar shall be, metres; []: anywhere\n"
        "  \"choose\": LABEL, \"player\": 1|2    the next action\n"
        "  \"weigh\": LABEL, \"player\": 1|2, \"factor\": F    makes it F times as likely; 0 bans "
        "it\n"
        "  \"seed\": N   \"temperature\": T\n"
        "Example: kumite bout bout.kumite --mode avatar --script keys.json --out fight");
    command->callback(
        [o, &action] { action = [o](const Streams& streams) { runBout(*o, streams); }; });
}

}  // namespace kumite::cli
