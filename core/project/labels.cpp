#include "core/project/labels.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/base/error.h"

namespace kumite {
namespace {

double forceAt(const FighterAnalysis& values, int frame) {
    if (!values.force) return 0;
    const std::vector<double>& curve = values.force->force.curve;
    const auto index = static_cast<std::size_t>(frame);
    return frame >= 0 && index < curve.size() ? curve[index] : 0;
}

const Segmentation& segmentationOf(const FighterAnalysis& values) {
    if (values.segmentation) return *values.segmentation;
    throw Error(values.input.recording.path.string() +
                ": the recording is missing; its actions cannot be labelled.");
}

/// Stored labels that lie in an action. The last action holds its end frame as well.
std::span<const ActionLabel> storedIn(const LabelTrack& track, const Action& action, bool last) {
    const auto from = std::partition_point(
        track.begin(), track.end(), [&](const ActionLabel& l) { return l.peak < action.begin; });
    const auto to = std::partition_point(from, track.end(), [&](const ActionLabel& l) {
        return l.peak < action.end || (last && l.peak == action.end);
    });
    return {from, to};
}

/// One fighter's labels being edited.
class LabelEdit {
public:
    LabelEdit(const Project& project, const Analysis& analysis, FighterAddress address)
        : values_(analysis.at(address)),
          segmentation_(segmentationOf(values_)),
          before_(*fighterAt(project, address).labels),
          labels_(actionLabels(fighterAt(project, address), values_,
                               project.labelling.vocabulary->size())),
          touched_(labels_.size(), false) {}

    /// The label of an action, to be changed.
    ActionLabel& at(int action) {
        if (action < 0 || action >= static_cast<int>(labels_.size())) {
            throw Error(
                fmt::format("There is no action {}; the fighter has {}.", action, labels_.size()));
        }
        touched_[static_cast<std::size_t>(action)] = true;
        return labels_[static_cast<std::size_t>(action)];
    }
    std::size_t size() const { return labels_.size(); }

    /// The track with the changed labels at their actions' peaks. Where everything was taken back,
    /// what the action hid goes as well, or it would come to light.
    LabelTrack result() const {
        LabelTrack track = before_;
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            if (!touched_[i]) continue;
            const ActionLabel& label = labels_[i];
            if (!label.anyKnown()) {
                const Action& action = segmentation_.actions[i];
                const auto stored = storedIn(track, action, i + 1 == labels_.size());
                const auto from = track.begin() + (stored.data() - track.data());
                track.erase(from, from + static_cast<std::ptrdiff_t>(stored.size()));
                continue;
            }
            const auto place = std::partition_point(
                track.begin(), track.end(),
                [&](const ActionLabel& other) { return other.peak < label.peak; });
            if (place != track.end() && place->peak == label.peak) {
                *place = label;
            } else {
                track.insert(place, label);
            }
        }
        return track;
    }

private:
    const FighterAnalysis& values_;
    const Segmentation& segmentation_;
    const LabelTrack& before_;
    std::vector<ActionLabel> labels_;
    std::vector<bool> touched_;
};

AspectValue byHand(int qualifier) {
    return {static_cast<std::int8_t>(qualifier), LabelSource::Hand, 1.0f};
}

MaybeEdit withLabels(const Project& project, FighterAddress address, LabelTrack track,
                     std::string name) {
    if (track == *fighterAt(project, address).labels) return std::nullopt;
    Edit edit{project, std::move(name)};
    fighterAt(edit.project, address).labels = std::move(track);
    return edit;
}

void requireAspect(const Vocabulary& vocabulary, int aspect) {
    if (aspect < 0 || aspect >= vocabulary.size()) {
        throw Error(fmt::format("The vocabulary has no aspect {}.", aspect));
    }
}

void requireQualifier(const Aspect& aspect, int qualifier) {
    if (qualifier < 0 || qualifier >= static_cast<int>(aspect.qualifiers.size())) {
        throw Error(fmt::format("{} has no qualifier {}.", aspect.name, qualifier));
    }
}

std::string howMany(std::span<const int> actions, FighterAddress fighter) {
    return actions.size() == 1
               ? fmt::format("action {}, fighter {}", actions.front(), fighter.player + 1)
               : fmt::format("{} actions, fighter {}", actions.size(), fighter.player + 1);
}

/// "Label action 12, fighter 1: right punch forward"; what differs from answer to answer is left
/// out.
std::string nameOf(const Vocabulary& vocabulary, std::span<const ActionAnswer> answers,
                   std::size_t fighters) {
    std::vector<int> actions;
    bool same = true;
    for (const ActionAnswer& answer : answers) {
        actions.push_back(answer.action);
        same = same && answer.label == answers.front().label;
    }
    std::string name = "Label " + (fighters == 1 ? howMany(actions, answers.front().fighter)
                                                 : fmt::format("{} actions", answers.size()));
    if (same) name += ": " + spokenLabel(vocabulary, answers.front().label);
    return name;
}

/// Puts values of `proposals` into the project where `takes(old, new)` says so.
template <typename Takes>
MaybeEdit combine(const Project& project, const Analysis& analysis,
                  std::span<const FighterLabels> proposals, std::string name, const Takes& takes) {
    Edit edit{project, std::move(name)};
    bool changed = false;
    for (const FighterLabels& proposal : proposals) {
        LabelEdit labels(project, analysis, proposal.fighter);
        if (proposal.labels.size() != labels.size()) {
            throw Error("The labels belong to another segmentation.");
        }
        for (std::size_t i = 0; i < proposal.labels.size(); ++i) {
            ActionLabel& label = labels.at(static_cast<int>(i));
            for (std::size_t a = 0; a < label.aspects.size(); ++a) {
                const AspectValue& value = proposal.labels[i].aspects[a];
                if (value.known() && takes(label.aspects[a], value)) label.aspects[a] = value;
            }
        }
        LabelTrack track = labels.result();
        if (track == *fighterAt(project, proposal.fighter).labels) continue;
        fighterAt(edit.project, proposal.fighter).labels = std::move(track);
        changed = true;
    }
    return changed ? MaybeEdit(std::move(edit)) : std::nullopt;
}

template <typename T>
MaybeEdit changeSetting(const Project& project, T LabelSettings::*setting, const T& value,
                        std::string name) {
    if (project.labelling.*setting == value) return std::nullopt;
    Edit edit{project, std::move(name)};
    edit.project.labelling.*setting = value;
    return edit;
}

}  // namespace

std::vector<ActionLabel> actionLabels(const Fighter& fighter, const FighterAnalysis& values,
                                      int aspectCount) {
    std::vector<ActionLabel> labels;
    if (!values.segmentation) return labels;
    const std::vector<Action>& actions = values.segmentation->actions;
    for (std::size_t i = 0; i < actions.size(); ++i) {
        ActionLabel label;
        const auto stored = storedIn(*fighter.labels, actions[i], i + 1 == actions.size());
        const auto highest = std::max_element(
            stored.begin(), stored.end(), [&](const ActionLabel& a, const ActionLabel& b) {
                return forceAt(values, a.peak) < forceAt(values, b.peak);
            });
        if (highest != stored.end()) label = *highest;
        label.peak = actions[i].peak;
        label.aspects.resize(static_cast<std::size_t>(aspectCount));
        labels.push_back(std::move(label));
    }
    return labels;
}

MaybeEdit setLabel(const Project& project, const Analysis& analysis, FighterAddress address,
                   std::span<const int> actions, int aspect, int qualifier) {
    requireAspect(*project.labelling.vocabulary, aspect);
    Label label(static_cast<std::size_t>(project.labelling.vocabulary->size()), kUnknown);
    requireQualifier((*project.labelling.vocabulary)[aspect], qualifier);
    label[static_cast<std::size_t>(aspect)] = qualifier;
    return setWholeLabel(project, analysis, address, actions, label);
}

MaybeEdit setWholeLabel(const Project& project, const Analysis& analysis, FighterAddress address,
                        std::span<const int> actions, const Label& label) {
    std::vector<ActionAnswer> answers;
    for (const int action : actions)
        answers.push_back({address, action, label});
    return setLabels(project, analysis, answers);
}

MaybeEdit setLabels(const Project& project, const Analysis& analysis,
                    std::span<const ActionAnswer> answers) {
    if (answers.empty()) return std::nullopt;
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    std::map<std::pair<int, int>, LabelEdit> edits;  // by take and player
    for (const ActionAnswer& answer : answers) {
        if (static_cast<int>(answer.label.size()) != vocabulary.size()) {
            throw Error("The label belongs to another vocabulary.");
        }
        LabelEdit& edit = edits
                              .try_emplace({answer.fighter.take, answer.fighter.player}, project,
                                           analysis, answer.fighter)
                              .first->second;
        ActionLabel& changed = edit.at(answer.action);
        for (int a = 0; a < vocabulary.size(); ++a) {
            const int qualifier = answer.label[static_cast<std::size_t>(a)];
            if (qualifier == kUnknown) continue;
            requireQualifier(vocabulary[a], qualifier);
            changed.aspects[static_cast<std::size_t>(a)] = byHand(qualifier);
        }
    }
    Edit edit{project, nameOf(vocabulary, answers, edits.size())};
    bool changed = false;
    for (const auto& [key, labels] : edits) {
        const FighterAddress address{key.first, key.second};
        LabelTrack track = labels.result();
        if (track == *fighterAt(project, address).labels) continue;
        fighterAt(edit.project, address).labels = std::move(track);
        changed = true;
    }
    return changed ? MaybeEdit(std::move(edit)) : std::nullopt;
}

MaybeEdit clearLabel(const Project& project, const Analysis& analysis, FighterAddress address,
                     std::span<const int> actions, std::optional<int> aspect) {
    if (aspect) requireAspect(*project.labelling.vocabulary, *aspect);
    LabelEdit edit(project, analysis, address);
    for (const int action : actions) {
        std::vector<AspectValue>& values = edit.at(action).aspects;
        if (aspect) {
            values[static_cast<std::size_t>(*aspect)] = {};
        } else {
            std::fill(values.begin(), values.end(), AspectValue());
        }
    }
    return withLabels(project, address, edit.result(), "Clear label, " + howMany(actions, address));
}

MaybeEdit acceptLabels(const Project& project, const Analysis& analysis,
                       std::span<const FighterLabels> proposals, double leastConfidence) {
    return combine(project, analysis, proposals, "Accept labels",
                   [&](const AspectValue& old, const AspectValue& value) {
                       return !old.byHand() && !value.byHand() &&
                              static_cast<double>(value.confidence) >= leastConfidence;
                   });
}

MaybeEdit importLabels(const Project& project, const Analysis& analysis,
                       std::span<const FighterLabels> labels) {
    return combine(project, analysis, labels, "Import labels",
                   [](const AspectValue& old, const AspectValue& value) {
                       return !old.byHand() || value.byHand();
                   });
}

MaybeEdit mergeLabels(const Project& project, const Analysis& analysis,
                      std::span<const FighterLabels> labels) {
    return combine(project, analysis, labels, "Merge labels",
                   [](const AspectValue& old, const AspectValue& value) {
                       return !old.byHand() && (value.byHand() || !old.known());
                   });
}

MaybeEdit setVocabulary(const Project& project, const Vocabulary& vocabulary) {
    const Vocabulary& old = *project.labelling.vocabulary;
    if (vocabulary == old) return std::nullopt;
    Edit edit{project, "Change vocabulary to " + vocabulary.name};
    edit.project.labelling.vocabulary = vocabulary;
    edit.project.labelling.model.reset();
    for (Take& take : edit.project.takes) {
        for (Fighter& fighter : take.fighters) {
            LabelTrack track;
            for (const ActionLabel& label : *fighter.labels) {
                ActionLabel kept{label.peak, {}};
                for (const Aspect& aspect : vocabulary.aspects) {
                    AspectValue& value = kept.aspects.emplace_back();
                    const auto from = old.find(aspect.id);
                    if (!from) continue;
                    const AspectValue& was = label.aspects[static_cast<std::size_t>(*from)];
                    if (!was.known()) continue;
                    const auto to = aspect.find(
                        old[*from].qualifiers[static_cast<std::size_t>(was.qualifier)].id);
                    if (!to) continue;
                    value = was;
                    value.qualifier = static_cast<std::int8_t>(*to);
                }
                if (kept.anyKnown()) track.push_back(std::move(kept));
            }
            fighter.labels = std::move(track);
        }
    }
    return edit;
}

MaybeEdit setRules(const Project& project, const RuleSettings& rules) {
    const ContactSettings& contacts = rules.contacts;
    for (const double value : {contacts.height, contacts.speed, contacts.releaseHeight,
                               contacts.releaseSpeed, contacts.shortest, rules.closingSpeed}) {
        if (!std::isfinite(value) || value < 0) {
            throw Error("The thresholds of the rules must be numbers, 0 or more.");
        }
    }
    return changeSetting(project, &LabelSettings::rules, rules, "Change rules");
}

MaybeEdit setLearning(const Project& project, const LearningSettings& learning) {
    if (learning.folds < 2) throw Error("A cross-validation has two folds or more.");
    return changeSetting(project, &LabelSettings::learning, learning, "Change learning settings");
}

MaybeEdit setModel(const Project& project, const std::optional<ModelRecord>& model) {
    return changeSetting(project, &LabelSettings::model, model, "Keep model");
}

}  // namespace kumite
