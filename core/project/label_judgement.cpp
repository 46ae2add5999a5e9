#include "core/project/label_judgement.h"

#include <algorithm>

namespace kumite {
namespace {

/// What the rules say of an action, by hand or not.
void answerByRules(const Vocabulary& vocabulary, const RuleReasons& reasons, Label& answer) {
    for (std::size_t a = 0; a < answer.size(); ++a) {
        const Aspect& aspect = vocabulary.aspects[a];
        if (aspect.classifier == Classifier::MoveRule && !reasons.moves.empty()) {
            answer[a] = aspect.find(reasons.move.symbol()).value_or(kUnknown);
        } else if (aspect.classifier == Classifier::ReactRule && !reasons.react.empty()) {
            const auto& said = reasons.reaction.qualifier;
            answer[a] = (said.empty() ? aspect.fallback : aspect.find(said)).value_or(kUnknown);
        }
    }
}

}  // namespace

std::vector<std::size_t> HandJudgement::cell(int aspect, int hand, int answer) const {
    std::vector<std::size_t> in;
    const auto a = static_cast<std::size_t>(aspect);
    for (std::size_t i = 0; i < actions.size(); ++i) {
        if (actions[i].hand[a] == hand && actions[i].answer[a] == answer) in.push_back(i);
    }
    return in;
}

HandJudgement judgeHandLabels(const Project& project, const Analysis& analysis,
                              const ActionTable& table, const ParameterSet& parameters,
                              const Proposals& proposals, const Progress& progress) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    const TrainingSet set(vocabulary, table.features, handExamples(project, analysis, table),
                          project.labelling.learning);
    std::vector<Label> answers = set.crossValidate(parameters, progress);
    HandJudgement result;
    std::vector<Label> truth;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Example& example = set.examples()[i];
        const auto& [fighter, action] = table.rows[static_cast<std::size_t>(example.row)];
        for (std::size_t f = 0; f < proposals.fighters.size(); ++f) {
            if (proposals.fighters[f].fighter != fighter) continue;
            answerByRules(vocabulary, proposals.reasons[f][static_cast<std::size_t>(action)],
                          answers[i]);
        }
        truth.push_back(example.label);
        result.actions.push_back({fighter, action, example.label, answers[i]});
    }
    result.scores = judge(vocabulary, truth, answers);
    return result;
}

std::vector<RuleChange> ruleChanges(const Vocabulary& vocabulary, const Proposals& before,
                                    const Proposals& after) {
    std::vector<RuleChange> changes;
    for (int a = 0; a < vocabulary.size(); ++a) {
        if (vocabulary[a].classifier == Classifier::Msvm) continue;
        RuleChange change{a, 0, 0};
        for (const FighterLabels& now : after.fighters) {
            const auto was = std::find_if(
                before.fighters.begin(), before.fighters.end(),
                [&](const FighterLabels& each) { return each.fighter == now.fighter; });
            if (was == before.fighters.end() || was->labels.size() != now.labels.size()) continue;
            for (std::size_t i = 0; i < now.labels.size(); ++i) {
                const auto slot = static_cast<std::size_t>(a);
                change.changed +=
                    now.labels[i].aspects[slot].qualifier != was->labels[i].aspects[slot].qualifier;
                ++change.actions;
            }
        }
        changes.push_back(change);
    }
    return changes;
}

}  // namespace kumite
