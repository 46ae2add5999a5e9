#include "core/project/labelling.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/motion/feet.h"

namespace kumite {
namespace {

/// Confidences are kept to a thousandth, so that files stay readable and read back the same.
float storedConfidence(double confidence) {
    return static_cast<float>(std::round(1000 * std::clamp(confidence, 0.0, 1.0)) / 1000);
}

/// A fighter as the rules see it. Refers to its analysis.
FighterView viewOf(const FighterAnalysis& values) {
    const Fighter& fighter = values.input;
    const Skeleton& skeleton = *fighter.motion->skeleton;
    FighterView view;
    view.actions = values.segmentation->actions;
    view.rate = fighter.rate;
    view.offset = fighter.offset;
    view.frameCount = values.frameCount();
    const auto at = [&values](int frame, int joint) -> Eigen::Vector3d {
        return placed(values.input, values.body->floor,
                      values.motion->positions.at(frame, joint).cast<double>());
    };
    view.limbEnd = [&skeleton, &fighter, at](int frame,
                                             Role limb) -> std::optional<Eigen::Vector3d> {
        auto joint = fighter.roles[limb];
        if (limb == Role::LeftToe || limb == Role::RightToe) {
            joint = footPoint(skeleton, fighter.roles, limb == Role::LeftToe);
        }
        if (!joint) return std::nullopt;
        return at(frame, *joint);
    };
    const auto jointOr = [&fighter](Role role, Role other) {
        return fighter.roles[role] ? fighter.roles[role] : fighter.roles[other];
    };
    const auto left = jointOr(Role::LeftHip, Role::Pelvis);
    const auto right = jointOr(Role::RightHip, Role::Pelvis);
    const auto neck = jointOr(Role::Neck, Role::Chest);
    const auto head = jointOr(Role::Head, Role::Neck);
    if (!left || !right || !neck || !head) return view;
    view.body = [=](int frame) -> std::array<Eigen::Vector3d, 3> {
        return {0.5 * (at(frame, *left) + at(frame, *right)), at(frame, *neck), at(frame, *head)};
    };
    return view;
}

std::optional<int> aspectOf(const Vocabulary& vocabulary, Classifier classifier) {
    for (int i = 0; i < vocabulary.size(); ++i) {
        if (vocabulary[i].classifier == classifier) return i;
    }
    return std::nullopt;
}

void fill(AspectValue& value, std::optional<int> qualifier, LabelSource source, float confidence) {
    if (value.byHand() || !qualifier) return;
    value = {static_cast<std::int8_t>(*qualifier), source, confidence};
}

void applyMove(const Vocabulary& vocabulary, const FighterAnalysis& values,
               std::vector<ActionLabel>& labels, std::vector<RuleReasons>& reasons) {
    const auto index = aspectOf(vocabulary, Classifier::MoveRule);
    const std::vector<Stance> stand = stances(values.body->contacts);
    if (!index || stand.empty()) return;
    const Aspect& aspect = vocabulary[*index];
    for (std::size_t i = 0; i < labels.size(); ++i) {
        reasons[i].move = moveOf(values.segmentation->actions[i], stand);
        reasons[i].moves = moveText(reasons[i].move);
        fill(labels[i].aspects[static_cast<std::size_t>(*index)],
             aspect.find(reasons[i].move.symbol()), LabelSource::Rule, 1.0f);
    }
}

/// The least sure of the values that a reaction rests on.
float confidenceOf(const ActionLabel& opponent, const Vocabulary& vocabulary) {
    float least = 1;
    for (std::size_t a = 0; a < opponent.aspects.size(); ++a) {
        if (vocabulary.aspects[a].strike.empty()) continue;
        const AspectValue& value = opponent.aspects[a];
        least = std::min(least, value.known() ? value.confidence : 0.0f);
    }
    return least;
}

void applyReact(const Vocabulary& vocabulary, const RuleSettings& settings,
                const FighterAnalysis& player, const FighterAnalysis* opponent,
                const std::vector<ActionLabel>* opponentLabels, std::vector<ActionLabel>& labels,
                std::vector<RuleReasons>& reasons) {
    const auto index = aspectOf(vocabulary, Classifier::ReactRule);
    if (!index) return;
    const Aspect& aspect = vocabulary[*index];
    const auto slot = static_cast<std::size_t>(*index);
    const FighterView own = viewOf(player);
    const FighterView theirs = opponent ? viewOf(*opponent) : FighterView();
    std::vector<Label> attacks;
    if (opponentLabels) {
        for (const ActionLabel& label : *opponentLabels)
            attacks.push_back(label.label());
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!opponent || !own.body) {
            reasons[i].react = opponent ? "no trunk to be hit" : "no opponent";
            fill(labels[i].aspects[slot], aspect.fallback, LabelSource::Rule, 1.0f);
            continue;
        }
        const Reaction reaction =
            reactionOf(vocabulary, aspect, own, static_cast<int>(i), theirs, attacks, settings);
        reasons[i].reaction = reaction;
        reasons[i].react = reactionText(vocabulary, reaction);
        const auto qualifier =
            reaction.qualifier.empty() ? aspect.fallback : aspect.find(reaction.qualifier);
        const float confidence =
            reaction.opponentAction
                ? confidenceOf(
                      (*opponentLabels)[static_cast<std::size_t>(*reaction.opponentAction)],
                      vocabulary)
                : 1.0f;
        fill(labels[i].aspects[slot], qualifier, LabelSource::Rule, confidence);
    }
}

/// Fills the rules' aspects that labels leave open; nothing is computed where none does.
void fillByRules(const Project& project, const Analysis& analysis, const FighterLabels& said,
                 const FighterLabels* opponent, std::vector<ActionLabel>& filled) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    const auto open = [&](const ActionLabel& label, int aspect) {
        return vocabulary[aspect].classifier != Classifier::Msvm && label.anyKnown() &&
               !label.aspects[static_cast<std::size_t>(aspect)].known();
    };
    const bool needed = std::any_of(said.labels.begin(), said.labels.end(), [&](const auto& label) {
        for (int a = 0; a < vocabulary.size(); ++a) {
            if (open(label, a)) return true;
        }
        return false;
    });
    if (!needed) return;
    std::vector<ActionLabel> byRules = said.labels;
    std::vector<RuleReasons> reasons(byRules.size());
    const FighterAnalysis& values = analysis.at(said.fighter);
    applyMove(vocabulary, values, byRules, reasons);
    applyReact(vocabulary, project.labelling.rules, values,
               opponent ? &analysis.at(opponent->fighter) : nullptr,
               opponent ? &opponent->labels : nullptr, byRules, reasons);
    for (std::size_t i = 0; i < filled.size(); ++i) {
        for (int a = 0; a < vocabulary.size(); ++a) {
            const auto slot = static_cast<std::size_t>(a);
            if (open(said.labels[i], a)) filled[i].aspects[slot] = byRules[i].aspects[slot];
        }
    }
}

}  // namespace

ActionTable actionTable(const Project& project, const Analysis& analysis,
                        const Progress& progress) {
    ActionTable table;
    std::vector<FeatureMatrix> parts;
    for (std::size_t t = 0; t < project.takes.size(); ++t) {
        progress.update(static_cast<double>(t) / static_cast<double>(project.takes.size()));
        for (std::size_t p = 0; p < project.takes[t].fighters.size(); ++p) {
            const FighterAddress address{static_cast<int>(t), static_cast<int>(p)};
            const FighterAnalysis& values = analysis.at(address);
            const Fighter& fighter = fighterAt(project, address);
            if (!values.available()) continue;
            if (!fighter.roles.has(Role::Pelvis)) {
                table.findings.push_back(
                    warning(fighter.recording.path.filename().string() +
                            ": no joint has the role pelvis, so its actions cannot be compared."));
                continue;
            }
            const auto& actions = values.segmentation->actions;
            Findings findings;
            parts.push_back(actionFeatures(*fighter.motion->skeleton, fighter.roles,
                                           values.motion->positions, values.body->heading, actions,
                                           &findings));
            for (Finding& finding : findings) {
                finding.text = fighter.recording.path.filename().string() + ": " + finding.text;
                table.findings.push_back(std::move(finding));
            }
            for (std::size_t i = 0; i < actions.size(); ++i)
                table.rows.push_back({address, static_cast<int>(i)});
        }
    }
    table.features.resize(static_cast<Eigen::Index>(table.rows.size()), kFeatureCount);
    Eigen::Index row = 0;
    for (const FeatureMatrix& part : parts) {
        table.features.middleRows(row, part.rows()) = part;
        row += part.rows();
    }
    progress.update(1.0);
    return table;
}

std::vector<Example> handExamples(const Project& project, const Analysis& analysis,
                                  const ActionTable& table) {
    std::vector<Example> examples;
    std::vector<ActionLabel> labels;
    FighterAddress current{-1, -1};
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto& [fighter, action] = table.rows[row];
        if (fighter != current) {
            labels = actionLabels(fighterAt(project, fighter), analysis.at(fighter),
                                  project.labelling.vocabulary->size());
            current = fighter;
        }
        const ActionLabel& label = labels[static_cast<std::size_t>(action)];
        if (!label.anyByHand()) continue;
        Example example{static_cast<int>(row), {}};
        for (const AspectValue& value : label.aspects)
            example.label.push_back(value.byHand() ? value.qualifier : kUnknown);
        examples.push_back(std::move(example));
    }
    return examples;
}

Proposals propose(const Project& project, const Analysis& analysis, const ActionTable& table,
                  const Predictions& predictions) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    Proposals proposals;
    for (std::size_t t = 0; t < project.takes.size(); ++t) {
        for (std::size_t p = 0; p < project.takes[t].fighters.size(); ++p) {
            const FighterAddress address{static_cast<int>(t), static_cast<int>(p)};
            if (!analysis.at(address).available()) continue;
            FighterLabels fighter{address, actionLabels(fighterAt(project, address),
                                                        analysis.at(address), vocabulary.size())};
            // What was accepted before gives way to what is known now.
            for (ActionLabel& label : fighter.labels) {
                for (AspectValue& value : label.aspects) {
                    if (!value.byHand()) value = {};
                }
            }
            proposals.reasons.emplace_back(fighter.labels.size());
            proposals.fighters.push_back(std::move(fighter));
        }
    }
    const auto find = [&](FighterAddress address) -> FighterLabels* {
        const auto found =
            std::find_if(proposals.fighters.begin(), proposals.fighters.end(),
                         [&](const FighterLabels& each) { return each.fighter == address; });
        return found == proposals.fighters.end() ? nullptr : &*found;
    };
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        ActionLabel& label =
            find(table.rows[row].fighter)->labels[static_cast<std::size_t>(table.rows[row].action)];
        for (int a = 0; a < vocabulary.size(); ++a) {
            const Prediction& prediction = predictions.at(static_cast<int>(row), a);
            if (prediction.qualifier == kUnknown) continue;
            fill(label.aspects[static_cast<std::size_t>(a)], prediction.qualifier,
                 LabelSource::Machine, storedConfidence(prediction.confidence));
        }
    }
    for (std::size_t i = 0; i < proposals.fighters.size(); ++i) {
        FighterLabels& fighter = proposals.fighters[i];
        const FighterAnalysis& values = analysis.at(fighter.fighter);
        FighterLabels* opponent = find({fighter.fighter.take, 1 - fighter.fighter.player});
        applyMove(vocabulary, values, fighter.labels, proposals.reasons[i]);
        applyReact(vocabulary, project.labelling.rules, values,
                   opponent ? &analysis.at(opponent->fighter) : nullptr,
                   opponent ? &opponent->labels : nullptr, fighter.labels, proposals.reasons[i]);
    }
    return proposals;
}

std::vector<FighterLabels> effectiveLabels(const Project& project, const Analysis& analysis) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    std::vector<FighterLabels> all;
    for (std::size_t t = 0; t < project.takes.size(); ++t) {
        const std::size_t first = all.size();
        for (std::size_t p = 0; p < project.takes[t].fighters.size(); ++p) {
            const FighterAddress address{static_cast<int>(t), static_cast<int>(p)};
            if (!analysis.at(address).available()) continue;
            all.push_back({address, actionLabels(fighterAt(project, address), analysis.at(address),
                                                 vocabulary.size())});
        }
        const std::vector<FighterLabels> said(all.begin() + static_cast<std::ptrdiff_t>(first),
                                              all.end());
        for (std::size_t i = 0; i < said.size(); ++i) {
            const FighterLabels* opponent = said.size() == 2 ? &said[1 - i] : nullptr;
            fillByRules(project, analysis, said[i], opponent, all[first + i].labels);
        }
    }
    return all;
}

AutoLabels labelAutomatically(const Project& project, const Analysis& analysis,
                              const Progress& progress) {
    const LabelSettings& settings = project.labelling;
    const ActionTable table = actionTable(project, analysis, progress.part(0, 0.05));
    const std::vector<Example> examples = handExamples(project, analysis, table);
    const TrainingSet set(*settings.vocabulary, table.features, examples, settings.learning);
    AutoLabels result;
    result.examples = static_cast<int>(examples.size());
    const auto hashWith = [&](const ParameterSet& parameters) {
        return trainingHash(table.features, examples, settings.learning, parameters);
    };
    if (settings.model && settings.model->trainingHash == hashWith(settings.model->parameters)) {
        result.model = *settings.model;
    } else {
        result.model.parameters = set.searchParameters(progress.part(0.05, 0.6));
        result.model.trainingHash = hashWith(result.model.parameters);
    }
    const Predictions predictions =
        set.predict(result.model.parameters, true, progress.part(0.6, 0.9));
    result.expectedAccuracy =
        set.expectedAccuracy(result.model.parameters, predictions, progress.part(0.9, 1.0));
    result.proposals = propose(project, analysis, table, predictions);
    return result;
}

}  // namespace kumite
