#include <cmath>

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/cli/agreement.h"
#include "core/cli/command.h"
#include "core/cli/label_queries.h"
#include "core/project/label_files.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string project, take, out, differences;
    std::vector<std::string> compare;
    bool everybody = false, json = false;
    LabelQuery query;
};

Json numberOr(const std::optional<double>& value) {
    return value ? Json(std::round(1e6 * *value) / 1e6) : Json(nullptr);
}

std::string kappaText(const std::optional<double>& kappa) {
    return kappa ? fixed(*kappa, 3) : "–";
}

/// Labels of a table or of another project of the same recordings.
std::vector<FighterLabels> labelsOf(const std::string& file, const OpenProject& open,
                                    std::optional<int> take, const Streams& streams) {
    const Vocabulary& vocabulary = *open.project.labelling.vocabulary;
    Findings findings;
    std::vector<TimedLabel> labels;
    if (file.ends_with(".kumite")) {
        const OpenProject other = openProject(file, streams);
        labels = parseLabelsJson(labelsJson(other.project, other.analysis), file, vocabulary);
    } else {
        labels = readLabels(file, vocabulary, &findings);
    }
    MatchedLabels matched = matchLabels(open.project, open.analysis, labels, take);
    printFindings(findings, streams);
    printFindings(matched.unmatched, streams);
    return std::move(matched.fighters);
}

std::string counted(std::size_t number, const char* one, const char* many) {
    return fmt::format("{} {}", number, number == 1 ? one : many);
}

void compare(const OpenProject& open, const Options& o, std::optional<int> take,
             const Streams& streams) {
    const auto first = o.compare.size() > 1 ? labelsOf(o.compare[0], open, take, streams)
                                            : ownLabels(open.project, open.analysis, take);
    const auto second = labelsOf(o.compare.back(), open, take, streams);
    const Agreement agreement = compareLabels(open.project, open.analysis, first, second,
                                              o.everybody ? Compared::Anybody : Compared::ByHand);
    if (!o.differences.empty()) {
        writeFileAtomically(o.differences,
                            differencesCsv(open.project, open.analysis, agreement.differences));
    }
    if (!o.json) return printAgreement(open, agreement, streams);
    streams.out
        << agreementJson(open, agreement).dump(1, ' ', false, Json::error_handler_t::replace)
        << "\n";
}

}  // namespace

void printAgreement(const OpenProject& open, const Agreement& agreement, const Streams& streams) {
    const Vocabulary& vocabulary = *open.project.labelling.vocabulary;
    streams.out << fmt::format("aspect        both  the same  kappa\n");
    for (int a = 0; a < vocabulary.size(); ++a) {
        const AspectAgreement& aspect = agreement.aspects[static_cast<std::size_t>(a)];
        streams.out << fmt::format("{:12}  {:4}  {:8}  {:>5}\n", vocabulary[a].id, aspect.both,
                                   aspect.same, kappaText(aspect.kappa));
    }
    streams.out << fmt::format(
        "{} labelled by both, {} of them the same, kappa {}; {} by the first only, {} by "
        "the second; {}\n",
        counted(static_cast<std::size_t>(agreement.both), "action", "actions"), agreement.same,
        kappaText(agreement.kappa), agreement.onlyFirst, agreement.onlySecond,
        counted(agreement.differences.size(), "value differs", "values differ"));
}

Json agreementJson(const OpenProject& open, const Agreement& agreement) {
    const Vocabulary& vocabulary = *open.project.labelling.vocabulary;
    Json aspects = Json::object();
    for (int a = 0; a < vocabulary.size(); ++a) {
        const AspectAgreement& aspect = agreement.aspects[static_cast<std::size_t>(a)];
        aspects[vocabulary[a].id] = {{"both", aspect.both},
                                     {"same", aspect.same},
                                     {"kappa", numberOr(aspect.kappa)},
                                     {"counts", aspect.counts}};
    }
    Json differences = Json::array();
    for (const LabelDifference& each : agreement.differences) {
        const Aspect& aspect = vocabulary[each.aspect];
        const auto word = [&](int qualifier) {
            return qualifier == kUnknown
                       ? Json(nullptr)
                       : Json(aspect.qualifiers[static_cast<std::size_t>(qualifier)].id);
        };
        const auto& actions = open.analysis.at(each.fighter).segmentation->actions;
        const double rate = fighterAt(open.project, each.fighter).rate;
        const kumite::Action& action = actions[static_cast<std::size_t>(each.action)];
        differences.push_back(
            {{"take", open.project.takes[static_cast<std::size_t>(each.fighter.take)].name},
             {"player", each.fighter.player + 1},
             {"action", each.action},
             {"begin_s", numberOr(action.begin / rate)},
             {"end_s", numberOr(action.end / rate)},
             {"aspect", aspect.id},
             {"first", word(each.first)},
             {"second", word(each.second)}});
    }
    return {{"both", agreement.both},
            {"same", agreement.same},
            {"only_first", agreement.onlyFirst},
            {"only_second", agreement.onlySecond},
            {"kappa", numberOr(agreement.kappa)},
            {"aspects", std::move(aspects)},
            {"differences", std::move(differences)}};
}

void addLabels(CLI::App& app, Action& action) {
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "labels",
        "Writes labels, finds actions by them, says how well they are known, compares people.");
    command->add_option("PROJECT", o->project, "a .kumite file")->required();
    auto* out =
        command->add_option("--out", o->out, "file to write: .csv, .json or .eaf (ELAN, one take)");
    auto* compared =
        command
            ->add_option("--compare", o->compare,
                         "labels to hold against the project's (or, if two, against each other): "
                         ".csv, .json, .eaf or a .kumite of the same recordings")
            ->expected(1, 2);
    command->add_option("--differences", o->differences, "with --compare: a table of them, .csv")
        ->needs(compared);
    command
        ->add_flag("--everybody", o->everybody,
                   "with --compare: labels of rules and machine count as well")
        ->needs(compared);
    addLabelQueries(*command, o->query);
    command->add_flag("--json", o->json, "one JSON object on standard output")->excludes(out);
    command->add_option("--take", o->take, "only this take");
    out->excludes(compared);
    command->footer(
        "Examples: kumite labels bout.kumite --out labels.csv\n"
        "          kumite labels bout.kumite --compare colleague.csv --differences talk.csv\n"
        "          kumite labels bout.kumite --filter \"right kick up, machine, below 0.6\"\n"
        "          kumite labels bout.kumite --similar sparring:1:12\n"
        "A filter: aspects and qualifiers, by hand, machine or rule, below 0.6, uncertain, player\n"
        "2, take NAME, after 1:20, unlabelled; all must hold, \"or\" joins two, \"not\" turns one\n"
        "round (core/labelling/README.md). Actions count from 0.");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            const LabelQuery& query = o->query;
            const int asked = !o->out.empty() + !o->compare.empty() + !query.filter.empty() +
                              !query.similar.empty() + (query.judge || query.curve);
            if (asked != 1) {
                throw UsageError(
                    "Say one thing to do: --out FILE, --compare FILE, --filter TEXT, --similar "
                    "ACTION, --judge or --curve.");
            }
            const OpenProject open = openProject(o->project, streams);
            std::optional<int> take;
            if (!o->take.empty()) take = takeNamed(open.project, o->take);
            if (query.isAsked()) return answerLabelQuery(open, query, o->take, o->json, streams);
            std::vector<std::filesystem::path> sources = {o->project};
            sources.insert(sources.end(), o->compare.begin(), o->compare.end());
            if (!o->differences.empty()) refuseToOverwrite(o->differences, sources);
            if (!o->compare.empty()) return compare(open, *o, take, streams);
            refuseToOverwrite(o->out, sources);
            writeLabels(open.project, open.analysis, take, o->out);
        };
    });
}

}  // namespace kumite::cli
