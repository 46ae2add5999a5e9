// How well labelling sessions on made bouts do, as Markdown tables:
// kumite-label-figures [SECONDS [SEEDS [FIRST_SEED]]]. Bout and session have different seeds; all
// is judged on the actions that no hand labelled.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/labelling/vocabulary.h"
#include "core/project/demo_bout.h"
#include "core/project/project_file.h"
#include "core/project/simulation.h"
#include "tests/benchmarks/bench_table.h"

namespace {

using namespace kumite;

struct Way {
    const char* name;
    bool active;
    bool mirrored;
    bool limbFirst;
    double budget;
    int batch;  ///< questions between two trainings
};
/// What random order asks does not depend on what was learnt, so it need not learn as often. It
/// needs more labels for the same accuracy: the last one goes on longer.
constexpr Way kWays[] = {
    {"active", true, true, false, 0.10, 5},
    {"active, no mirror images", true, false, false, 0.10, 5},
    {"active, limb first", true, true, true, 0.10, 5},
    {"random", false, true, false, 0.10, 30},
    {"random, no mirror images", false, false, false, 0.10, 30},
    {"random, limb first", false, true, true, 0.10, 30},
    {"random, longer", false, true, false, 0.25, 25},
};
constexpr std::size_t kActive = 0;
constexpr std::size_t kRandom = 3;
constexpr std::size_t kRandomLonger = std::size(kWays) - 1;

/// Mean and standard deviation, in percent.
std::string spread(const std::vector<double>& values) {
    double mean = 0, variance = 0;
    for (const double value : values)
        mean += value / static_cast<double>(values.size());
    for (const double value : values)
        variance += (value - mean) * (value - mean);
    if (values.size() > 1) variance /= static_cast<double>(values.size() - 1);
    return fmt::format("{:.1f} ± {:.1f}", 100 * mean, 100 * std::sqrt(variance));
}

/// Labels after which a session was and stayed at least this good, but for one round in three (a
/// curve trembles); nothing if never.
std::optional<double> labelsFor(const Simulation& session, double accuracy) {
    const auto& curve = session.curve;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (curve[i].labelAccuracy < accuracy) continue;
        std::size_t good = 0;
        for (std::size_t j = i; j < curve.size(); ++j)
            good += curve[j].labelAccuracy >= accuracy;
        if (3 * good >= 2 * (curve.size() - i)) return curve[i].labelled;
    }
    return std::nullopt;
}

struct Bout {
    Project project;
    Truth truth;
};

Bout makeBout(double seconds, std::uint64_t seed, const std::filesystem::path& folder) {
    const DemoFiles files = writeDemoBout({seconds, 60, seed}, folder);
    return {loadProject(files.project()).project, {readLabels(files.truth(), kickboxing())}};
}

Simulation play(const Bout& bout, const Way& way, std::uint32_t seed) {
    Project project = bout.project;
    project.labelling.learning.mirrored = way.mirrored;
    project.labelling.learning.limbFirst = way.limbFirst;
    SimulationSettings settings;
    settings.active = way.active;
    settings.budget = way.budget;
    settings.seed = seed;
    settings.query.batch = way.batch;
    settings.query.mirrored = way.mirrored;
    return simulateSession(project, 0, bout.truth, settings);
}

using Sessions = std::vector<std::vector<Simulation>>;  ///< per way and bout

template <typename Value>
std::string column(const std::vector<Simulation>& sessions, const Value& value) {
    std::vector<double> values;
    for (const Simulation& session : sessions)
        values.push_back(value(session));
    return spread(values);
}

void printWhole(const Sessions& all) {
    std::cout << "\n| at 10 % labelled | limb, % | whole label, % | expected by the program, % |\n"
                 "| --- | --- | --- | --- |\n";
    for (std::size_t w = 0; w < kRandomLonger; ++w) {
        std::cout << fmt::format(
            "| {} | {} | {} | {} |\n", kWays[w].name,
            column(all[w], [](const Simulation& s) { return s.scores.limbAccuracy; }),
            column(all[w], [](const Simulation& s) { return s.scores.labelAccuracy; }),
            column(all[w], [](const Simulation& s) { return s.curve.back().expectedAccuracy; }));
    }
    std::cout << fmt::format(
        "| all others, best constant footstep | | {} | |\n",
        column(all[kActive], [](const Simulation& s) { return s.scores.baselineAccuracy; }));
}

void printAspects(const Sessions& all) {
    std::cout << "\n| accuracy / macro-F1, % |";
    for (const Aspect& aspect : kickboxing().aspects)
        std::cout << " " << aspect.id << " |";
    std::cout << "\n| --- |";
    for (int a = 0; a < kickboxing().size(); ++a)
        std::cout << " --- |";
    for (std::size_t w = 0; w < kRandomLonger; ++w) {
        std::cout << "\n| " << kWays[w].name << " |";
        for (std::size_t a = 0; a < kickboxing().aspects.size(); ++a) {
            std::cout << fmt::format(
                " {} / {} |",
                column(all[w], [&](const Simulation& s) { return s.scores.aspects[a].accuracy; }),
                column(all[w], [&](const Simulation& s) { return s.scores.aspects[a].macroF1; }));
        }
    }
    std::cout << "\n";
}

/// Labels until an accuracy is reached, means over the bouts that reach it in both orders.
struct Saved {
    double active = 0, random = 0;
    std::vector<double> shares;  ///< of the labels, by bout
    int activeAlone = 0;         ///< bouts that reach it in active order only
};

Saved savedBy(const Sessions& all, double accuracy) {
    Saved saved;
    for (std::size_t i = 0; i < all[kActive].size(); ++i) {
        const auto active = labelsFor(all[kActive][i], accuracy);
        const auto random = labelsFor(all[kRandomLonger][i], accuracy);
        saved.activeAlone += active && !random;
        if (!active || !random) continue;
        saved.active += *active;
        saved.random += *random;
        saved.shares.push_back(1 - *active / *random);
    }
    const auto both = static_cast<double>(std::max<std::size_t>(1, saved.shares.size()));
    saved.active /= both;
    saved.random /= both;
    return saved;
}

/// What active order saves: at what it reaches with a part of the labels.
void printSaved(const Sessions& all) {
    std::cout << "\n| whole label, % | labels, active | labels, random | saved, % |\n"
                 "| --- | --- | --- | --- |\n";
    for (const double accuracy : {0.85, 0.90, 0.92, 0.94, 0.95, 0.96}) {
        const Saved saved = savedBy(all, accuracy);
        if (saved.shares.empty()) continue;
        std::cout << fmt::format(
            "| {:.0f} | {:.0f} | {:.0f} | {} ({} of {} bouts{}) |\n", 100 * accuracy, saved.active,
            saved.random, spread(saved.shares), saved.shares.size(), all[kActive].size(),
            saved.activeAlone > 0
                ? fmt::format(", {} more reached by active alone", saved.activeAlone)
                : "");
    }
}

void addRows(const Sessions& all, const std::string& size) {
    const std::string others =
        column(all[kActive], [](const Simulation& s) { return s.scores.baselineAccuracy; });
    for (const auto& [w, order] :
         {std::pair(kActive, "asked for by the machine"), std::pair(kRandom, "random order")}) {
        bench::addRow(
            {std::string("labels that are right with 10 % said by hand, ") + order, size,
             fmt::format("{} % whole, {} % limb",
                         column(all[w], [](const Simulation& s) { return s.scores.labelAccuracy; }),
                         column(all[w], [](const Simulation& s) { return s.scores.limbAccuracy; })),
             fmt::format("everything others: {} % whole", others)});
    }
    for (const double accuracy : {0.90, 0.95}) {
        const Saved saved = savedBy(all, accuracy);
        if (saved.shares.empty()) continue;
        bench::addRow({fmt::format("labels said by hand until {:.0f} % are right", 100 * accuracy),
                       size, fixed(saved.active, 0),
                       fmt::format("random order: {:.0f}", saved.random),
                       bench::timesText(saved.random / saved.active)});
    }
}

void printCurves(const Sessions& all) {
    std::cout << "\n| share labelled, % | active | random | active, stop hint |\n"
                 "| --- | --- | --- | --- |\n";
    for (const double share : {0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.10}) {
        const auto at = [share](const Simulation& session) {
            const CurvePoint* last = &session.curve.front();
            for (const CurvePoint& point : session.curve) {
                if (point.labelled <= std::ceil(share * session.actions)) last = &point;
            }
            return last->labelAccuracy;
        };
        const auto hinted = [share](const Simulation& session) {
            return session.stopHint && *session.stopHint <= share * session.actions;
        };
        std::cout << fmt::format("| {:.0f} | {} | {} | {} of {} |\n", 100 * share,
                                 column(all[kActive], at), column(all[kRandomLonger], at),
                                 std::count_if(all[kActive].begin(), all[kActive].end(), hinted),
                                 all[kActive].size());
    }
    double falls = 0, rounds = 0, worst = 0;
    for (const Simulation& session : all[kActive]) {
        for (std::size_t i = 1; i < session.curve.size(); ++i) {
            const double fall = session.curve[i - 1].labelAccuracy - session.curve[i].labelAccuracy;
            falls += fall > 0.005;
            worst = std::max(worst, fall);
            ++rounds;
        }
    }
    std::cout << fmt::format(
        "\nOf {:.0f} rounds of active sessions {:.0f} made the rest worse by more than half a "
        "percent, the worst by {:.1f} %.\n",
        rounds, falls, 100 * worst);
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int index, double usual) {
        return argc > index ? parseNumber(argv[index]).value_or(usual) : usual;
    };
    const double seconds = number(1, 900);
    const int seeds = static_cast<int>(number(2, 5));
    const int first = static_cast<int>(number(3, 101));
    const auto start = std::chrono::steady_clock::now();
    const auto folder = std::filesystem::temp_directory_path() / "kumite-label-figures";
    Sessions all(std::size(kWays));
    int actions = 0;
    for (int seed = first; seed < first + seeds; ++seed) {
        const Bout bout = makeBout(seconds, static_cast<std::uint64_t>(seed), folder);
        for (std::vector<Simulation>& sessions : all)
            sessions.emplace_back();
        forBlocks({0, static_cast<int>(std::size(kWays))}, 1, [&](FrameRange ways) {
            const auto w = static_cast<std::size_t>(ways.begin);
            all[w].back() = play(bout, kWays[w], static_cast<std::uint32_t>(7000 + seed));
            std::cerr << fmt::format("bout {}: {}, {:.1f} %\n", seed, kWays[w].name,
                                     100 * all[w].back().scores.labelAccuracy);
        });
        actions += all[kActive].back().actions;
    }
    std::filesystem::remove_all(folder);
    std::cout << fmt::format(
        "{} bouts of {:.0f} s, two fighters, {} actions in all, seeds {} to {}; mean ± standard "
        "deviation over the bouts.\n",
        seeds, seconds, actions, first, first + seeds - 1);
    printWhole(all);
    printAspects(all);
    printSaved(all);
    printCurves(all);
    addRows(all, fmt::format("{} made bouts of {:.0f} minutes", seeds, seconds / 60));
    std::cout << fmt::format(
        "\n{:.0f} s\n",
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return 0;
}
