#include "core/project/agreement.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/formats/tables.h"

namespace kumite {
namespace {

/// What counts of a label: all that is known, or what a hand said.
Label countedOf(const ActionLabel& label, Compared compared) {
    Label counted;
    for (const AspectValue& value : label.aspects) {
        const bool counts = compared == Compared::Anybody || value.byHand();
        counted.push_back(counts ? value.qualifier : kUnknown);
    }
    return counted;
}

bool saysSomething(const Label& label) {
    return std::any_of(label.begin(), label.end(), [](int value) { return value != kUnknown; });
}

/// A fighter's labels in a set; nothing where the set leaves it out.
const std::vector<ActionLabel>* findIn(std::span<const FighterLabels> set, FighterAddress fighter) {
    for (const FighterLabels& each : set) {
        if (each.fighter == fighter) return &each.labels;
    }
    return nullptr;
}

AspectAgreement agreementOf(JudgementTable table) {
    AspectAgreement agreement;
    for (std::size_t i = 0; i < table.size(); ++i) {
        agreement.both += std::accumulate(table[i].begin(), table[i].end(), 0);
        agreement.same += table[i][i];
    }
    agreement.kappa = cohensKappa({&table, 1});
    agreement.counts = std::move(table);
    return agreement;
}

/// Compares one action.
void compareAction(FighterAddress fighter, int action, const Label& first, const Label& second,
                   Agreement& result, std::vector<JudgementTable>& tables) {
    const bool one = saysSomething(first);
    const bool other = saysSomething(second);
    result.onlyFirst += one && !other;
    result.onlySecond += other && !one;
    for (std::size_t a = 0; !one && a < second.size(); ++a) {
        if (second[a] == kUnknown) continue;
        result.additions.push_back({fighter, action, static_cast<int>(a), kUnknown, second[a]});
    }
    if (!one || !other) return;
    ++result.both;
    bool same = true;
    for (std::size_t a = 0; a < first.size(); ++a) {
        if (first[a] != kUnknown && second[a] != kUnknown) {
            ++tables[a][static_cast<std::size_t>(first[a])][static_cast<std::size_t>(second[a])];
            same = same && first[a] == second[a];
        }
        if (first[a] == second[a]) continue;
        result.differences.push_back({fighter, action, static_cast<int>(a), first[a], second[a]});
    }
    result.same += same;
}

}  // namespace

Agreement compareLabels(const Project& project, const Analysis& analysis,
                        std::span<const FighterLabels> first, std::span<const FighterLabels> second,
                        Compared compared) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    Agreement result;
    std::vector<JudgementTable> tables;
    for (const Aspect& aspect : vocabulary.aspects)
        tables.emplace_back(aspect.qualifiers.size(), std::vector<int>(aspect.qualifiers.size()));
    for (int t = 0; t < static_cast<int>(project.takes.size()); ++t) {
        const auto& fighters = project.takes[static_cast<std::size_t>(t)].fighters;
        for (int p = 0; p < static_cast<int>(fighters.size()); ++p) {
            const FighterAddress address{t, p};
            if (!analysis.at(address).segmentation) continue;
            const std::size_t actions = analysis.at(address).segmentation->actions.size();
            const std::vector<ActionLabel>* ones = findIn(first, address);
            const std::vector<ActionLabel>* others = findIn(second, address);
            if ((ones && ones->size() != actions) || (others && others->size() != actions)) {
                throw Error("The labels belong to another segmentation.");
            }
            const Label nothing(vocabulary.aspects.size(), kUnknown);
            for (std::size_t i = 0; i < actions; ++i) {
                compareAction(address, static_cast<int>(i),
                              ones ? countedOf((*ones)[i], compared) : nothing,
                              others ? countedOf((*others)[i], compared) : nothing, result, tables);
            }
        }
    }
    result.kappa = cohensKappa(tables);
    for (JudgementTable& table : tables)
        result.aspects.push_back(agreementOf(std::move(table)));
    return result;
}

std::vector<FighterLabels> ownLabels(const Project& project, const Analysis& analysis,
                                     std::optional<int> take) {
    std::vector<FighterLabels> labels;
    for (int t = 0; t < static_cast<int>(project.takes.size()); ++t) {
        if (take && *take != t) continue;
        const auto& fighters = project.takes[static_cast<std::size_t>(t)].fighters;
        for (int p = 0; p < static_cast<int>(fighters.size()); ++p) {
            const FighterAddress address{t, p};
            labels.push_back(
                {address, actionLabels(fighterAt(project, address), analysis.at(address),
                                       project.labelling.vocabulary->size())});
        }
    }
    return labels;
}

MaybeEdit takeOverLabels(const Project& project, const Analysis& analysis,
                         std::span<const LabelDifference> chosen) {
    const int aspects = project.labelling.vocabulary->size();
    std::vector<FighterLabels> labels;
    for (const LabelDifference& difference : chosen) {
        if (difference.second == kUnknown) continue;
        auto place = std::find_if(labels.begin(), labels.end(), [&](const FighterLabels& each) {
            return each.fighter == difference.fighter;
        });
        if (place == labels.end()) {
            std::vector<ActionLabel> open = actionLabels(fighterAt(project, difference.fighter),
                                                         analysis.at(difference.fighter), aspects);
            for (ActionLabel& label : open)
                label.aspects.assign(static_cast<std::size_t>(aspects), {});
            place = labels.insert(place, {difference.fighter, std::move(open)});
        }
        const auto action = static_cast<std::size_t>(difference.action);
        const auto aspect = static_cast<std::size_t>(difference.aspect);
        if (difference.action < 0 || action >= place->labels.size() || difference.aspect < 0 ||
            difference.aspect >= aspects) {
            throw Error("The differences belong to another segmentation or vocabulary.");
        }
        place->labels[action].aspects[aspect] = {static_cast<std::int8_t>(difference.second),
                                                 LabelSource::Hand, 1.0f};
    }
    MaybeEdit edit = importLabels(project, analysis, labels);
    if (edit) edit->name = "Take over labels";
    return edit;
}

std::string differencesCsv(const Project& project, const Analysis& analysis,
                           std::span<const LabelDifference> differences) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    std::string text = "take,player,action,begin_s,end_s,aspect,first,second\n";
    for (const LabelDifference& each : differences) {
        const Aspect& aspect = vocabulary[each.aspect];
        const auto word = [&](int qualifier) {
            return qualifier == kUnknown
                       ? std::string()
                       : csvField(aspect.qualifiers[static_cast<std::size_t>(qualifier)].id);
        };
        const Action& action =
            analysis.at(each.fighter).segmentation->actions[static_cast<std::size_t>(each.action)];
        const double rate = fighterAt(project, each.fighter).rate;
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n",
                       csvField(project.takes[static_cast<std::size_t>(each.fighter.take)].name),
                       each.fighter.player + 1, each.action, fixed(action.begin / rate, 3),
                       fixed(action.end / rate, 3), aspect.id, word(each.first), word(each.second));
    }
    return text;
}

}  // namespace kumite
