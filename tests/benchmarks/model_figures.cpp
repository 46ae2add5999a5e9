// The figures of the transition model:
//   kumite-model-figures growth             training, what-if and memory over the number of actions
//   kumite-model-figures edits [MINUTES]    a demo bout: the whole model, then after single edits
//   kumite-model-figures law [MINUTES [SEEDS]]
//       what is learnt against the choreographer's law: mean KL divergence over minutes of bout
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <sys/resource.h>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/demo/random.h"
#include "core/interaction/surprise.h"
#include "core/project/demo_bout.h"
#include "core/project/interaction.h"
#include "core/project/label_files.h"
#include "core/project/project_file.h"
#include "tests/benchmarks/bench_table.h"

namespace {

using namespace kumite;

/// Runs a piece of work and returns its seconds.
template <typename Work>
double timed(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double peakMegabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

// ---- growth ------------------------------------------------------------------------------------

/// Two streams of labels and numbers drawn at random, without motions.
struct MadeBout {
    std::shared_ptr<CoupledGraph> graph = std::make_shared<CoupledGraph>();
    std::array<Eigen::MatrixXd, 2> numbers;

    MadeBout(int actions, int labels) {
        demo::Random random(11);
        const Vocabulary& vocabulary = kickboxing();
        std::vector<Label> all;
        std::vector<double> weights;
        for (int i = 0; i < labels; ++i) {
            Label label = othersLabel(vocabulary);
            label[0] = i % 5;
            label[2] = i / 5 % 4;
            label[6] = i / 20;
            all.push_back(label);
            weights.push_back(1.0 / (1 + i));  // a few are frequent, many are rare
        }
        LabelledTake take;
        for (int p = 0; p < 2; ++p) {
            LabelledStream stream{60, 0, 0, {}, {}};
            int frame = 0;
            for (int i = 0; i < actions; ++i) {
                const int end = frame + 10 + static_cast<int>(random.uniform(0, 60));
                stream.actions.push_back({frame, end, (frame + end) / 2});
                stream.labels.push_back(all[static_cast<std::size_t>(random.pick(weights))]);
                frame = end;
            }
            take.players.push_back(std::move(stream));
        }
        *graph = coupledGraph(vocabulary, std::vector{take});
        for (const std::size_t mover : {0, 1}) {
            const auto& transitions = graph->transitions[mover];
            numbers[mover].resize(static_cast<Eigen::Index>(transitions.size()), 36);
            for (std::size_t i = 0; i < transitions.size(); ++i) {
                const double common = random.normal(0, 1);
                for (Eigen::Index j = 0; j < 36; ++j)
                    numbers[mover](static_cast<Eigen::Index>(i), j) =
                        random.normal(0, 1) + common + 0.03 * transitions[i].nextNode;
            }
        }
    }
};

void growth() {
    constexpr int kLabels = 60, kQueries = 100;
    std::cout << fmt::format("{:>8} {:>7} {:>12} {:>12} {:>12} {:>12} {:>10}\n", "actions",
                             "labels", "labels ms", "semitied ms", "what-if ms", "surprise ms",
                             "peak MB");
    std::vector<std::array<double, 5>> rows;
    for (const int actions : {1000, 3000, 10000, 100000}) {
        const MadeBout bout(actions, kLabels);
        LabelTerm term;
        const double label =
            timed([&] { term = learnLabelTerm(*bout.graph, 0, LabelEstimator::Equ7); });
        TransitionModel model;
        const double training = timed([&] {
            model = learnTransitionModel(bout.graph, 0, LabelEstimator::Equ7, {}, bout.numbers[0]);
        });
        double sum = 0;
        const double query = timed([&] {
            for (int i = 0; i < kQueries; ++i) {
                const Eigen::VectorXd moment = model.numbers.row(i).head(24).transpose();
                sum += nextLabels(model, i % 20, i % 17, &moment).front().product;
            }
        });
        const double surprise = timed([&] { sum += surprises(model).front().both; });
        rows.push_back({static_cast<double>(actions), label, training, query / kQueries, surprise});
        std::cout << fmt::format("{:>8} {:>7} {:>12.2f} {:>12.1f} {:>12.3f} {:>12.1f} {:>10.0f}\n",
                                 actions, model.labels.nodeCount(), 1000 * label, 1000 * training,
                                 1000 * query / kQueries, 1000 * surprise, peakMegabytes());
        if (!(sum > 0)) std::cout << "unexpected\n";  // keeps the work from being left out
    }
    const auto& usual = rows[rows.size() - 2];
    const std::string size = fmt::format("{:.0f} actions, {} labels", usual[0], kLabels);
    bench::addRow({"learning the transition model, EQU7 and tied Gaussians", size,
                   bench::timeText(usual[2]), "labels alone: " + bench::timeText(usual[1])});
    bench::addRow({"what may follow a moment", size, bench::timeText(usual[3])});
    std::cout << "exponents from 10 000 to 100 000 actions:";
    const auto& a = rows[rows.size() - 2];
    const auto& b = rows.back();
    for (std::size_t i = 1; i < a.size(); ++i)
        std::cout << fmt::format(" {:.2f}", std::log(b[i] / a[i]) / std::log(b[0] / a[0]));
    std::cout << "\n";
}

// ---- edits -------------------------------------------------------------------------------------

/// A demo bout as a project with its true labels.
struct LabelledDemo {
    Project project;
    Analysis analysis;
    nlohmann::json truth;

    LabelledDemo(double seconds, std::uint64_t seed) {
        const auto folder = std::filesystem::temp_directory_path() / "kumite-model-figures";
        const DemoFiles files = writeDemoBout({seconds, 60, seed}, folder);
        project = loadProject(files.project()).project;
        analysis = analyse(project);
        const Vocabulary& vocabulary = *project.labelling.vocabulary;
        const auto matched =
            matchLabels(project, analysis, readLabels(files.truth(), vocabulary), 0);
        project = importLabels(project, analysis, matched.fighters)->project;
        truth = nlohmann::json::parse(FileBytes(files.truth()).bytes());
        std::filesystem::remove_all(folder);
    }
};

void edits(double minutes) {
    const LabelledDemo demo(60 * minutes, 1);
    Interaction first;
    const double whole = timed([&] { first = deriveInteraction(demo.project, demo.analysis); });
    std::cout << fmt::format("{} minutes, {} and {} transitions, {} and {} labels: {:.0f} ms\n",
                             minutes, first.graph->transitions[0].size(),
                             first.graph->transitions[1].size(), first.graph->nodeCount(0),
                             first.graph->nodeCount(1), 1000 * whole);
    const auto again = [&](const char* what, const Project& project) {
        Analysis analysis;
        Interaction next;
        const double cut = timed([&] { analysis = analyse(project, demo.analysis); });
        const double model = timed([&] { next = deriveInteraction(project, analysis, {}, first); });
        std::cout << fmt::format("{}: segmentation {:.0f} ms, graph and model {:.0f} ms\n", what,
                                 1000 * cut, 1000 * model);
        return model;
    };
    again("nothing changed", demo.project);
    const double label =
        again("one label",
              setLabel(demo.project, demo.analysis, {0, 0}, std::vector{100}, 0, 1)->project);
    const int frame = demo.analysis.at({0, 0}).segmentation->boundaries[100].frame;
    const double boundary =
        again("one boundary", removeBoundary(demo.project, demo.analysis, {0, 0}, frame)->project);
    for (const auto& [what, seconds] : {std::pair("label", label), std::pair("boundary", boundary)})
        bench::addRow({fmt::format("graph and model after one {} was edited", what),
                       fmt::format("made bout of {:.0f} minutes", minutes),
                       bench::timeText(seconds), "all anew: " + bench::timeText(whole),
                       bench::timesText(whole / seconds)});
}

// ---- law ---------------------------------------------------------------------------------------

using LawKey = std::tuple<int, std::string, std::string>;  // mover, own, opponent

/// The choreographer's law as a mover's label sees it: mixed over the ranges at which it chose.
struct Law {
    std::map<LawKey, std::map<std::string, double>> next;
    std::map<LawKey, double> weight;  ///< how often it was asked
    std::array<std::set<std::string>, 2> techniques;

    explicit Law(const nlohmann::json& truth) {
        std::map<std::tuple<int, std::string, std::string, std::string>, double> asked;
        for (int p = 0; p < 2; ++p) {
            for (const auto& action : truth["players"][static_cast<std::size_t>(p)]["actions"]) {
                if (!action.contains("chosen")) continue;
                const auto& chosen = action["chosen"];
                ++asked[{p, chosen["own"], chosen["opponent"], chosen["range"]}];
            }
        }
        for (const auto& row : truth["process"]) {
            const int mover = row["mover"].get<int>() - 1;
            const double count = asked[{mover, row["own"], row["opponent"], row["range"]}];
            const LawKey key{mover, row["own"], row["opponent"]};
            weight[key] += count;
            techniques[static_cast<std::size_t>(mover)].insert(row["own"]);
            techniques[static_cast<std::size_t>(1 - mover)].insert(row["opponent"]);
            for (const auto& [technique, p] : row["next"].items()) {
                next[key][technique] += count * p.get<double>();
                techniques[static_cast<std::size_t>(mover)].insert(technique);
            }
        }
        for (auto& [key, row] : next) {
            for (auto& [technique, p] : row)
                p /= std::max(1e-300, weight[key]);
        }
    }
};

/// The true actions that end before a moment, with the technique alone as their label.
LabelledTake takeUntil(const nlohmann::json& truth, double seconds) {
    const Vocabulary& vocabulary = kickboxing();
    const double rate = truth["rate"];
    LabelledTake take;
    for (const auto& player : truth["players"]) {
        LabelledStream stream{rate, 0, 0, {}, {}};
        for (const auto& action : player["actions"]) {
            if (action["end"].get<double>() > seconds * rate) break;
            Label label = othersLabel(vocabulary);
            for (const auto& [aspect, qualifier] : action["label"].items()) {
                if (aspect == "react" || aspect == "move") continue;
                const int a = *vocabulary.find(aspect);
                label[static_cast<std::size_t>(a)] =
                    *vocabulary[a].find(qualifier.get<std::string>());
            }
            stream.actions.push_back({action["begin"], action["end"], action["peak"]});
            stream.labels.push_back(label);
        }
        take.players.push_back(std::move(stream));
    }
    return take;
}

/// Mean Σ law · log(law / learnt) over the moments at which the law was asked.
double divergence(const Law& law, const CoupledGraph& graph, LabelEstimator estimator) {
    const Vocabulary& vocabulary = kickboxing();
    std::array<std::vector<Label>, 2> sets;
    std::array<std::map<std::string, int>, 2> index;
    for (const std::size_t p : {0, 1}) {
        for (const std::string& technique : law.techniques[p]) {
            index[p][technique] = static_cast<int>(sets[p].size());
            sets[p].push_back(parseLabel(vocabulary, technique));
        }
    }
    double sum = 0, weights = 0;
    for (const int mover : {0, 1}) {
        const auto m = static_cast<std::size_t>(mover);
        std::vector<LabelTriple> triples;
        for (const Transition& t : graph.transitionsOf(mover)) {
            const auto at = [&](std::size_t player, int node) {
                return index[player].at(graph.node(static_cast<int>(player), node).text);
            };
            triples.push_back({at(m, t.ownNode), at(1 - m, t.opponentNode), at(m, t.nextNode)});
        }
        const LabelTerm term(estimator, vocabulary, sets[m], sets[1 - m], triples);
        for (const auto& [key, row] : law.next) {
            const auto& [who, own, opponent] = key;
            const double weight = law.weight.at(key);
            if (who != mover || weight == 0) continue;
            const auto logs = term.logProbabilities(index[m].at(own), index[1 - m].at(opponent));
            for (const auto& [technique, p] : row) {
                if (p <= 0) continue;
                sum += weight * p *
                       (std::log(p) - logs[static_cast<std::size_t>(index[m].at(technique))]);
            }
            weights += weight;
        }
    }
    return sum / weights;
}

void law(double minutes, int seeds) {
    std::vector<double> steps;
    for (double m = 1; m <= minutes; m *= 2)
        steps.push_back(m);
    constexpr std::array kEstimators = {LabelEstimator::Equ5, LabelEstimator::Equ6,
                                        LabelEstimator::Equ7, LabelEstimator::Uniform};
    std::vector<std::array<double, kEstimators.size()>> means(steps.size());
    std::vector<double> transitions(steps.size());
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto folder = std::filesystem::temp_directory_path() / "kumite-model-figures";
        const DemoFiles files =
            writeDemoBout({60 * steps.back(), 60, static_cast<std::uint64_t>(seed)}, folder);
        const auto truth = nlohmann::json::parse(FileBytes(files.truth()).bytes());
        std::filesystem::remove_all(folder);
        const Law known(truth);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const CoupledGraph graph =
                coupledGraph(kickboxing(), std::vector{takeUntil(truth, 60 * steps[i])});
            transitions[i] +=
                0.5 / seeds *
                static_cast<double>(graph.transitions[0].size() + graph.transitions[1].size());
            for (std::size_t e = 0; e < kEstimators.size(); ++e)
                means[i][e] += divergence(known, graph, kEstimators[e]) / seeds;
        }
    }
    std::cout << "| minutes | transitions a player | EQU5 | EQU6 | EQU7 | even guess |\n"
                 "| ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (std::size_t i = 0; i < steps.size(); ++i) {
        std::cout << fmt::format("| {} | {:.0f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", steps[i],
                                 transitions[i], means[i][0], means[i][1], means[i][2],
                                 means[i][3]);
    }
    const auto& last = means.back();
    for (const std::size_t e : {0, 1, 2}) {
        bench::addRow({fmt::format("transitions learnt, divergence from their law, EQU{}", 5 + e),
                       fmt::format("{} made bouts of {:.0f} minutes", seeds, steps.back()),
                       fixed(last[e], 3), fmt::format("even guess: {:.3f}", last[3]),
                       bench::timesText(last[3] / last[e])});
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "growth";
    const double minutes = argc > 2 ? parseNumber(argv[2]).value_or(16) : 16;
    const int seeds = argc > 3 ? static_cast<int>(parseNumber(argv[3]).value_or(3)) : 3;
    if (what == "growth") growth();
    if (what == "edits") edits(minutes);
    if (what == "law") law(minutes, seeds);
    return 0;
}
