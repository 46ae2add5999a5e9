// The figures of synthesised bouts:
//   kumite-bout-figures quality [PROJECT [SEEDS [SECONDS]]] the quality table, all modes; without a
//                                                           project: of a made bout and a recorded
//                                                           dance with the labels of the rules
//   kumite-bout-figures speed [PROJECT [SECONDS]]           time per frame and per choice; without
//   a
//                                                           project: of the made bout
//   kumite-bout-figures growth                              a choice over the number of actions
//   kumite-bout-figures soak PROJECT [SECONDS]              a long bout: bounds, drift, memory
#include <chrono>
#include <iostream>

#include <fmt/format.h>
#include <sys/resource.h>

#include "core/base/text.h"
#include "core/project/bout.h"
#include "core/project/import.h"
#include "core/project/kept_bout.h"
#include "core/project/labelling.h"
#include "core/project/labels.h"
#include "core/project/project_file.h"
#include "core/synthesis/bout_quality.h"
#include "core/synthesis/draw.h"
#include "tests/benchmarks/bench_table.h"
#include "tests/support/fixtures.h"
#include "tests/support/labelled_bout.h"

namespace {

using namespace kumite;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double peakMegabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct Opened {
    Project project;
    Analysis analysis;
    Interaction interaction;
    std::shared_ptr<const BoutLibrary> library;

    explicit Opened(const std::string& path) : Opened(loadProject(path).project) {}
    explicit Opened(Project opened) : project(std::move(opened)) {
        analysis = analyse(project);
        interaction = deriveInteraction(project, analysis);
        const double start = now();
        library = boutLibrary(project, analysis, interaction);
        std::cout << fmt::format(
            "{} and {} transitions, {} and {} labels; library {:.2f} s\n",
            library->fighter(0).model.sampleCount(), library->fighter(1).model.sampleCount(),
            library->graph->nodeCount(0), library->graph->nodeCount(1), now() - start);
        for (const Finding& finding : library->findings)
            std::cout << finding.text << "\n";
    }
};

/// Four takes of a couple dance. Nobody labelled them: the rules alone speak, which tell stances
/// and know no strikes of a dance.
std::optional<Project> recordedDance() {
    const auto data = test::dataFolder();
    if (!data) return std::nullopt;
    Project project;
    for (const char* number : {"01", "03", "05", "09"}) {
        TakeRequest request;
        request.name = number;
        request.rate = 60;  // The headers say 120.
        for (const char* subject : {"60_", "61_"}) {
            FighterRequest fighter;
            fighter.path = *data / "cmu_salsa" / (std::string(subject) + number + ".bvh");
            request.fighters.push_back(fighter);
        }
        request.trim = FrameRange{1, -1};  // Frame 0 is a rest pose.
        project = addTake(project, importTake(request).take)->project;
    }
    const Analysis analysis = analyse(project);
    const AutoLabels labels = labelAutomatically(project, analysis);
    if (const auto edit = acceptLabels(project, analysis, labels.proposals.fighters))
        project = edit->project;
    return project;
}

// ---- quality -----------------------------------------------------------------------------------

std::string cell(const std::optional<double>& value, double factor, int decimals) {
    return value ? fixed(factor * *value, decimals) : "-";
}

void printRow(const std::string& name, const Quality& q) {
    const auto share = [](const std::optional<Penetration>& p) {
        return p ? std::optional(p->share) : std::nullopt;
    };
    const auto worst = [](const std::optional<Penetration>& p) {
        return p ? std::optional(p->worst) : std::nullopt;
    };
    std::cout << fmt::format(
                     "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |", name,
                     cell(q.footSkate, 100, 2), cell(share(q.floor), 100, 2),
                     cell(worst(q.floor), 100, 1), cell(share(q.interpenetration), 100, 2),
                     cell(worst(q.interpenetration), 100, 1), cell(q.joinAccelerationRatio, 1, 2),
                     cell(q.recordedAccelerationRatio, 1, 2), cell(q.joinVelocityRatio, 1, 2),
                     cell(q.facingError, 57.29578, 1), cell(q.hitTiming, 1000, 0),
                     q.distance ? fixed(q.distance->mean, 2) : "-")
              << fmt::format(" {} |\n", q.variety ? fixed(q.variety->share(), 2) : "-");
}

/// A mode's bouts beside the recording that they were made of.
void addQualityRow(const std::string& what, const std::string& size, const Quality& bouts,
                   const Quality& recording) {
    const auto text = [](const Quality& q) {
        return fmt::format("feet skate {} %, bodies in each other {} %, joins {}",
                           cell(q.footSkate, 100, 1),
                           q.interpenetration ? fixed(100 * q.interpenetration->share, 1) : "-",
                           cell(q.joinAccelerationRatio, 1, 2));
    };
    bench::addRow({what, size, text(bouts), "recording: " + text(recording)});
}

/// What a player does from time to time, so that an avatar has something to do.
std::vector<BoutCommand> someKeys(const BoutLibrary& library, double seconds, std::uint64_t seed) {
    const std::vector<std::string> words = {"kick", "punch", "left_punch", "right_kick", "jump"};
    std::vector<BoutCommand> commands;
    std::uint64_t count = 0;
    for (double at = 1; at < seconds; at += 1.5) {
        BoutCommand command;
        command.frame = static_cast<int>(at * library.rate);
        const double number = drawn(seed, 7, count++);
        command.words = words[static_cast<std::size_t>(number * static_cast<double>(words.size()))];
        try {
            commandedNodes(library, 0, command.words);
            commands.push_back(command);
        } catch (const Error&) {
            // Never shown by this fighter.
        }
        BoutCommand target;
        target.kind = BoutCommand::Kind::Target;
        target.frame = command.frame;
        target.target = {2 * drawn(seed, 8, count) - 1, 2 * drawn(seed, 9, count) - 1};
        commands.push_back(target);
    }
    return commands;
}

/// Means, and of what must not happen the worst.
Quality together(const std::vector<Quality>& all) {
    Quality sum = all.front();
    const double share = 1.0 / static_cast<double>(all.size());
    const auto mean = [&](auto member) {
        std::optional<double>& value = sum.*member;
        if (!value) return;
        value = 0;
        for (const Quality& each : all)
            *value += share * (each.*member).value_or(0);
    };
    const auto worst = [&](auto member) {
        std::optional<Penetration>& value = sum.*member;
        if (!value) return;
        value = Penetration{};
        for (const Quality& each : all) {
            value->share += share * (each.*member)->share;
            value->worst = std::max(value->worst, (each.*member)->worst);
        }
    };
    for (const auto member :
         {&Quality::footSkate, &Quality::joinAccelerationRatio, &Quality::recordedAccelerationRatio,
          &Quality::joinVelocityRatio, &Quality::facingError, &Quality::hitTiming})
        mean(member);
    worst(&Quality::floor);
    worst(&Quality::interpenetration);
    if (sum.distance) {
        sum.distance->mean = 0;
        for (const Quality& each : all)
            sum.distance->mean += share * each.distance->mean;
    }
    if (sum.variety) {
        for (std::size_t i = 1; i < all.size(); ++i) {
            sum.variety->distinct += all[i].variety->distinct;
            sum.variety->total += all[i].variety->total;
        }
    }
    return sum;
}

/// What player 1 replays: its busiest attack, or where it has none, as in a dance, ten seconds of
/// what it does.
CapturedAttack replayed(const Opened& opened) {
    try {
        return busiestAttack(opened.interaction, 0);
    } catch (const Error& error) {
        std::cout << error.what() << " It replays ten seconds of what it does.\n";
    }
    CapturedAttack attack;
    const auto& actions = opened.interaction.graph->actions[0];
    for (std::size_t i = 0; i < actions.size(); ++i) {
        if (actions[i].take == 0 && actions[i].beginSeconds >= 5 && actions[i].endSeconds <= 15)
            attack.actions.push_back(static_cast<int>(i));
    }
    return attack;
}

/// `of`: what the bouts are made of, for the table.
void quality(const Opened& opened, const std::string& of, int seeds, double seconds) {
    const CapturedAttack attack = replayed(opened);
    const auto passive =
        boutLibrary(opened.project, opened.analysis,
                    interactionWithout(opened.analysis, opened.interaction, attack));
    const auto steered = withAvatar(opened.library, 0);
    const RecordingQuality recording = recordingQuality(*opened.library);
    std::cout << "| bout | skate % | floor % | floor cm | bodies % | bodies cm | join acc | as "
                 "recorded | join vel | facing deg | hits ms | distance m | variety |\n"
                 "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | "
                 "---: | ---: |\n";
    printRow("recording", recording.quality);
    for (const BoutMode mode : {BoutMode::Automatic, BoutMode::Avatar, BoutMode::Passive}) {
        std::vector<Quality> all;
        for (int seed = 1; seed <= seeds; ++seed) {
            BoutSettings settings;
            settings.mode = mode;
            settings.seed = static_cast<std::uint64_t>(seed);
            settings.attack = attack.actions;
            const auto& library = mode == BoutMode::Passive  ? passive
                                  : mode == BoutMode::Avatar ? steered
                                                             : opened.library;
            BoutTape tape(library, settings,
                          mode == BoutMode::Avatar ? someKeys(*library, seconds, settings.seed)
                                                   : std::vector<BoutCommand>());
            tape.advance(static_cast<int>(seconds * library->rate));
            all.push_back(boutQuality(tape, recording.bar));
            printRow(fmt::format("{} {}", modeName(mode), seed), all.back());
            if (seed > 1) continue;
            const test::TemporaryFolder folder;
            const KeptBout kept =
                keepBout(opened.project, opened.analysis, tape, "kept", folder.path());
            std::cout << fmt::format(
                "<!-- detection alone finds its boundaries: F1 {:.3f} {:.3f} -->\n",
                kept.foundAgain[0], kept.foundAgain[1]);
        }
        printRow(fmt::format("**{}, {} seeds**", modeName(mode), seeds), together(all));
        addQualityRow(fmt::format("synthesised bouts of {}, {}", of, modeName(mode)),
                      fmt::format("{} bouts of {:.0f} s", seeds, seconds), together(all),
                      recording.quality);
    }
}

Project madeBout() {
    const test::TemporaryFolder folder;
    return test::LabelledBout(folder.path(), 300, 3).project;
}

void qualityOfBoth(int seeds, double seconds) {
    std::cout << "A made bout of 5 minutes, seed 3:\n";
    quality(Opened(madeBout()), "a made bout", seeds, seconds);
    if (auto dance = recordedDance()) {
        std::cout << "\nA recorded couple dance, labels of the rules:\n";
        quality(Opened(std::move(*dance)), "a recorded dance", seeds, seconds);
    }
}

// ---- speed -------------------------------------------------------------------------------------

void speed(const std::string& path, double seconds) {
    const Opened opened(path.empty() ? madeBout() : loadProject(path).project);
    BoutSettings settings;
    Bout bout(opened.library, settings);
    const int frames = static_cast<int>(seconds * opened.library->rate);
    std::vector<float> plain, choosing;
    for (int i = 0; i < frames; ++i) {
        const double start = now();
        bout.step();
        const auto microseconds = static_cast<float>(1e6 * (now() - start));
        (bout.newChoices().empty() ? plain : choosing).push_back(microseconds);
    }
    double sum = 0;
    for (const auto* list : {&plain, &choosing}) {
        for (const float each : *list)
            sum += each;
    }
    std::cout << fmt::format(
        "{} frames: {:.1f} us a frame; without a choice p50 {:.1f}, p99 {:.1f}; with one p50 "
        "{:.1f}, "
        "p99 {:.1f} us\n",
        frames, sum / frames, percentile(plain, 0.5), percentile(plain, 0.99),
        percentile(choosing, 0.5), percentile(choosing, 0.99));
    bench::addRow(
        {"a frame of a synthesised bout", fmt::format("{} frames, {:.0f} s", frames, seconds),
         fmt::format("{}, in the median {}, with a choice {}", bench::timeText(1e-6 * sum / frames),
                     bench::timeText(1e-6 * percentile(plain, 0.5)),
                     bench::timeText(1e-6 * percentile(choosing, 0.5)))});
    const double start = now();
    Bout copy = bout;
    std::cout << fmt::format("a snapshot: {:.1f} us\n", 1e6 * (now() - start));
}

/// Two streams of labels and numbers drawn at random, without motions.
void growth() {
    constexpr int kLabels = 60, kQueries = 200;
    std::cout << "| actions | choice ms |\n| ---: | ---: |\n";
    for (const int actions : {1000, 3000, 10000, 30000}) {
        std::vector<LabelTriple> triples;
        std::vector<int> classes, indices;
        Eigen::MatrixXd rows(actions, 36);
        std::uint64_t count = 0;
        const auto label = [&] {
            const double number = drawn(1, 1, count++);
            return static_cast<int>(kLabels * number * number);
        };
        for (int i = 0; i < actions; ++i) {
            triples.push_back({label(), label(), label()});
            classes.push_back(triples.back().next);
            indices.push_back(i);
            for (Eigen::Index j = 0; j < rows.cols(); ++j)
                rows(i, j) = drawn(2, static_cast<std::uint64_t>(j), count++);
        }
        const std::vector<Label> labels(kLabels, othersLabel(kickboxing()));
        const ChoiceModel model(
            LabelTerm(LabelEstimator::Equ7, kickboxing(), labels, labels, triples),
            GeometryTerm({}, rows, classes, kLabels), rows, triples, indices, 12);
        double sum = 0;
        const double start = now();
        for (int i = 0; i < kQueries; ++i) {
            const Eigen::VectorXd known = rows.row(i).head(24).transpose();
            sum +=
                optionsOf(model.candidates(i % kLabels, i % 7, known), {}).options.front().chance;
        }
        const double each = 1000 * (now() - start) / kQueries;
        std::cout << fmt::format("| {} | {:.3f} |\n", actions, each);
        if (!(sum > 0)) std::cout << "unexpected\n";  // keeps the work from being left out
    }
}

// ---- soak --------------------------------------------------------------------------------------

void soak(const std::string& path, double seconds) {
    const Opened opened(path);
    BoutSettings settings;
    settings.seed = 5;
    Bout bout(opened.library, settings);
    const int frames = static_cast<int>(seconds * opened.library->rate);
    double fastest = 0, lowest = 10, highest = 0, farthest = 0, drift = 0, still = 0, stillest = 0;
    const double start = now();
    const double before = peakMegabytes();
    std::array<JointFrames, 2> last = {bout.shown(0).joints, bout.shown(1).joints};
    double tenth = 0;
    for (int i = 0; i < frames; ++i) {
        bout.step();
        double moved = 0;
        for (const int player : {0, 1}) {
            const JointFrames& joints = bout.shown(player).joints;
            JointFrames& old = last[static_cast<std::size_t>(player)];
            for (std::size_t j = 0; j < joints.positions.size(); ++j) {
                const double way = (joints.positions[j] - old.positions[j]).norm();
                moved = std::max(moved, way);
                lowest = std::min(lowest, joints.positions[j].y());
                highest = std::max(highest, joints.positions[j].y());
                if (!joints.positions[j].allFinite()) {
                    std::cout << fmt::format("frame {}: not finite\n", bout.frame());
                    return;
                }
            }
            old = joints;
        }
        fastest = std::max(fastest, moved * opened.library->rate);
        still = moved < 1e-5 ? still + 1 : 0;
        stillest = std::max(stillest, still / opened.library->rate);
        farthest = std::max(farthest, (bout.shown(0).pose.root - bout.shown(1).pose.root).norm());
        drift = std::max(drift, 0.5 * (bout.shown(0).pose.root + bout.shown(1).pose.root).norm());
        if (i == frames / 10) tenth = now() - start;
    }
    const double all = now() - start;
    std::cout << fmt::format(
        "{:.0f} s of bout in {:.1f} s (first tenth {:.2f} of it): fastest joint {:.1f} m/s, "
        "heights "
        "{:.2f} to {:.2f} m, apart at most {:.2f} m, away from the start {:.1f} m, still for "
        "{:.2f} s "
        "at most, memory +{:.0f} MB\n",
        seconds, all, tenth / all, fastest, lowest, highest, farthest, drift, stillest,
        peakMegabytes() - before);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "growth";
    const std::string path = argc > 2 ? argv[2] : "";
    const auto number = [&](int index, double otherwise) {
        return argc > index ? parseNumber(argv[index]).value_or(otherwise) : otherwise;
    };
    try {
        if (what == "quality") {
            const int seeds = static_cast<int>(number(3, 5));
            if (path.empty()) {
                qualityOfBoth(seeds, number(4, 60));
            } else {
                quality(Opened(path), path, seeds, number(4, 60));
            }
        }
        if (what == "speed") speed(path, number(3, 60));
        if (what == "growth") growth();
        if (what == "soak") soak(path, number(3, 3600));
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
