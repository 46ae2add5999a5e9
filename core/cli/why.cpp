#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/formats/json_text.h"
#include "core/interaction/surprise.h"
#include "core/project/interaction.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string project, take, own, opponent;
    std::optional<int> frame;
    int mover = 1;
    int top = 10;
    bool json = false;
};

/// What is asked about: both current labels, and where they come from.
struct Question {
    Moment moment;
    std::optional<int> take;
    std::string own, opponent;    ///< labels as spelt; "?" not labelled, "any" left open
    std::optional<int> observed;  ///< node of the action that really came next
};

int nodeNamed(const CoupledGraph& graph, int player, const std::string& spelling) {
    if (spelling.empty()) return kAnyNode;
    const auto node = graph.find(player, parseLabel(*graph.vocabulary, spelling));
    if (!node) {
        throw Error(fmt::format("Player {} never shows the label \"{}\".", player + 1, spelling));
    }
    return *node;
}

std::string nodeText(const CoupledGraph& graph, int player, int node, const char* none) {
    return node == kAnyNode ? none : graph.node(player, node).text;
}

Question askedByLabels(const Interaction& interaction, const Options& o, int mover) {
    const CoupledGraph& graph = *interaction.graph;
    Question question;
    question.moment.own = nodeNamed(graph, mover, o.own);
    question.moment.opponent = nodeNamed(graph, 1 - mover, o.opponent);
    question.own = nodeText(graph, mover, question.moment.own, "any");
    question.opponent = nodeText(graph, 1 - mover, question.moment.opponent, "any");
    return question;
}

Question askedByFrame(const OpenProject& open, const Interaction& interaction, const Options& o,
                      int mover) {
    const CoupledGraph& graph = *interaction.graph;
    const FighterAddress address = fighterNamed(open.project, o.take, o.mover);
    const int frames = open.analysis.at(address).frameCount();
    if (*o.frame < 0 || *o.frame >= frames) {
        throw Error(fmt::format("The take has frames 0 to {}.", frames - 1));
    }
    Question question;
    question.take = address.take;
    question.moment = momentAt(open.analysis, interaction, address.take, *o.frame, mover);
    if (question.moment.ownAction < 0 || question.moment.opponentAction < 0) {
        throw Error("At that frame one of the two fighters is not there.");
    }
    question.own = nodeText(graph, mover, question.moment.own, "?");
    question.opponent = nodeText(graph, 1 - mover, question.moment.opponent, "?");
    const int next = graph.action(mover, question.moment.ownAction).next;
    if (next >= 0 && graph.action(mover, next).node >= 0)
        question.observed = graph.action(mover, next).node;
    return question;
}

Json exampleJson(const CoupledGraph& graph, int mover, int transition) {
    const TransitionPlace place =
        placeOf(graph, mover, graph.transitionsOf(mover)[static_cast<std::size_t>(transition)]);
    return {{"take", graph.takes[static_cast<std::size_t>(place.take)]},
            {"frame", place.frame},
            {"begin", place.mover.begin},
            {"end", place.mover.end}};
}

void printJson(const Interaction& interaction, const Question& question, const Options& o,
               const std::vector<NextLabel>& ranked, const std::optional<Surprise>& surprise,
               const Streams& streams) {
    const CoupledGraph& graph = *interaction.graph;
    const int mover = o.mover - 1;
    const bool geometry = question.moment.numbers.size() > 0;
    Json json = {{"mover", o.mover}, {"own", question.own}, {"opponent", question.opponent}};
    if (o.frame) {
        json["take"] = graph.takes[static_cast<std::size_t>(*question.take)];
        json["frame"] = *o.frame;
        json["observed"] =
            question.observed ? Json(graph.node(mover, *question.observed).text) : Json(nullptr);
    }
    if (surprise) {
        json["surprise"] = {{"label", rounded(surprise->label)},
                            {"geometry", rounded(surprise->geometry)},
                            {"both", rounded(surprise->both)}};
    }
    Json& next = json["next"] = Json::array();
    for (const NextLabel& each : ranked) {
        Json entry = {{"label", graph.node(mover, each.node).text},
                      {"product", rounded(each.product)},
                      {"label_term", rounded(each.label)}};
        if (geometry) {
            entry["geometry_term"] = rounded(each.geometry);
            entry["log_density"] =
                each.bestTransition ? Json(rounded(each.logDensity)) : Json(nullptr);
        }
        entry["examples"] = each.examples;
        entry["own_examples"] = each.ownExamples;
        entry["opponent_examples"] = each.opponentExamples;
        if (each.bestTransition) entry["best"] = exampleJson(graph, mover, *each.bestTransition);
        next.push_back(std::move(entry));
    }
    streams.out << json.dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
}

void printText(const Interaction& interaction, const Question& question, const Options& o,
               const std::vector<NextLabel>& ranked, const std::optional<Surprise>& surprise,
               const Streams& streams) {
    const CoupledGraph& graph = *interaction.graph;
    const int mover = o.mover - 1;
    const bool geometry = question.moment.numbers.size() > 0;
    streams.out << fmt::format("player {} after {}, opponent in {}\n", o.mover, question.own,
                               question.opponent);
    if (surprise) {
        streams.out << fmt::format(
            "what came next, to a model that had not seen it: label {:.2f} nats (P {:.3f}), label "
            "seen the motion {:.2f} nats (P {:.3f}), an even guess {:.2f} nats; geometry {:+.1f} "
            "nats from the mean\n",
            surprise->label, std::exp(-surprise->label), surprise->both, std::exp(-surprise->both),
            uniformSurprise(*interaction.models[static_cast<std::size_t>(mover)]),
            surprise->geometry);
    }
    streams.out << (geometry ? "product  label  geometry  examples  next\n"
                             : "  label  examples  next\n");
    for (std::size_t i = 0; i < ranked.size(); ++i) {
        const NextLabel& each = ranked[i];
        const bool happened = question.observed == each.node;
        if (static_cast<int>(i) >= o.top && !happened) continue;
        const std::string label = graph.node(mover, each.node).text;
        streams.out << (geometry ? fmt::format("{:7.3f}{:7.3f}{:10.3f}", each.product, each.label,
                                               each.geometry)
                                 : fmt::format("{:7.3f}", each.label))
                    << fmt::format("{:10}  {}{}\n", each.examples, label,
                                   happened ? "  <- what came next" : "");
    }
}

void runWhy(const Options& o, const Streams& streams) {
    const bool byLabels = !o.own.empty() || !o.opponent.empty();
    if (byLabels == o.frame.has_value()) {
        throw UsageError("Say what is meant: --frame F, or --own LABEL and --opponent LABEL.");
    }
    const OpenProject open = openProject(o.project, streams);
    const Interaction interaction =
        deriveInteraction(open.project, open.analysis, {}, {}, streams.progress("training"));
    if (const auto why = whyNoModel(open.project, interaction)) throw Error(*why);
    printFindings(interaction.findings, streams);
    const int mover = o.mover - 1;
    const Question question =
        byLabels ? askedByLabels(interaction, o, mover) : askedByFrame(open, interaction, o, mover);
    const std::vector<NextLabel> ranked = nextLabels(interaction, mover, question.moment);
    std::optional<Surprise> surprise;
    if (question.moment.transition) {
        surprise = surprises(*interaction.models[static_cast<std::size_t>(
            mover)])[static_cast<std::size_t>(*question.moment.transition)];
    }
    if (o.json) {
        printJson(interaction, question, o, ranked, surprise, streams);
    } else {
        printText(interaction, question, o, ranked, surprise, streams);
    }
}

}  // namespace

void addWhy(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "why", "What a fighter would do next at a moment, and why: every label with both terms.");
    command->add_option("PROJECT", o->project, "a .kumite file with labels")->required();
    command->add_option("--take", o->take, "name of the take; needed if there are several");
    command->add_option("--frame", o->frame,
                        "moment, a frame of the mover's take: as if the mover went on then");
    command->add_option("--mover", o->mover, "who goes on: 1 or 2")->check(CLI::Range(1, 2));
    command->add_option("--own", o->own, "the mover's label instead of a moment: label term alone");
    command->add_option("--opponent", o->opponent, "the opponent's label in progress");
    command->add_option("--top", o->top, "how many labels are printed")
        ->check(CLI::Range(1, 100000));
    command->add_flag("--json", o->json, "one JSON object on standard output, all labels");
    command->footer(
        "At a frame where an action begins, the one that ends there is the own label, and the\n"
        "transition that was observed is judged by a model that had not seen it.\n"
        "Examples: kumite why bout.kumite --take demo --frame 312 --mover 1\n"
        "          kumite why bout.kumite --mover 2 --own move:L-R --opponent "
        "right_kick:up+move:L-L");
    command->callback(
        [o, &action] { action = [o](const Streams& streams) { runWhy(*o, streams); }; });
}

}  // namespace kumite::cli
