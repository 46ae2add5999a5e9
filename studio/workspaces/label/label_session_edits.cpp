// Which actions are chosen, and what hands say about them.

#include <algorithm>
#include <map>

#include "studio/workspaces/label/label_session.h"

namespace kumite::studio {

namespace {
/// Played before and after an action that is looked at, seconds.
constexpr double kAir = 0.3;
/// Shown of the time around it, seconds; who is nearer already stays so.
constexpr double kNear = 8;
}  // namespace

void LabelSession::goTo(const ShownAction& action) {
    const ActionRef ref{action.fighter.player, action.peak};
    if (action.fighter.take != session_.take()) session_.setTake(action.fighter.take);
    session_.setActivePlayer(ref.player);
    session_.selectAction(ref);
    const TimeSpan span = session_.spanOf(ref);
    Transport& transport = session_.transport();
    transport.setLoop(std::max(transport.span().begin, span.begin - kAir),
                      std::min(transport.span().end, span.end + kAir));
    transport.setLooping(true);
    transport.setPlayhead(std::max(transport.span().begin, span.begin - kAir));
    const double length = std::min(kNear, session_.visible().end - session_.visible().begin);
    const double middle = 0.5 * (span.begin + span.end);
    session_.setVisible({middle - length / 2, middle + length / 2});
}

void LabelSession::followSelection() {
    const auto& selected = session_.selectedAction();
    const bool among =
        selected && std::find(chosen_.begin(), chosen_.end(), *selected) != chosen_.end();
    if (!among) chosen_.clear();
    Q_EMIT choiceChanged();
}

std::vector<ActionRef> LabelSession::chosenRefs() const {
    std::vector<ActionRef> refs = chosen_;
    const auto action = session_.currentAction();
    if (action && std::find(refs.begin(), refs.end(), *action) == refs.end()) {
        refs.push_back(*action);
    }
    return refs;
}

std::vector<int> LabelSession::chosen() const {
    std::vector<int> indices;
    for (const ActionRef& action : chosenRefs()) {
        const int index = indexOf({session_.take(), action.player}, action.peak);
        if (index >= 0) indices.push_back(index);
    }
    std::sort(indices.begin(), indices.end());
    return indices;
}

void LabelSession::choose(std::vector<ActionRef> actions) {
    chosen_ = std::move(actions);
    if (chosen_.empty()) return session_.selectAction(std::nullopt);
    const ActionRef last = chosen_.back();
    if (session_.selectedAction() == last) {
        Q_EMIT choiceChanged();
    } else {
        session_.setActivePlayer(last.player);
        session_.selectAction(last);
    }
}

void LabelSession::setAspect(int aspect) {
    if (aspect == aspect_ || aspect < 0 || aspect >= vocabulary().size()) return;
    aspect_ = aspect;
    Q_EMIT choiceChanged();
}

bool LabelSession::edit(const std::function<MaybeEdit(const Project&, const Analysis&)>& function) {
    return session_.document().apply(function);
}

bool LabelSession::answer(std::span<const int> actions,
                          const std::function<Label(const ShownAction&)>& labelOf) {
    std::vector<ActionAnswer> answers;
    for (const int index : actions) {
        const ShownAction& action = actions_.at(static_cast<std::size_t>(index));
        answers.push_back({action.fighter, action.index, labelOf(action)});
    }
    return set(answers);
}

bool LabelSession::set(const std::vector<ActionAnswer>& answers) {
    Document& document = session_.document();
    if (!together_ || !document.isCurrent()) {
        return edit([&](const Project& project, const Analysis& analysis) {
            return setLabels(project, analysis, answers);
        });
    }
    // Only what is said of the same actions is one step: it takes the place of what was said first.
    QString gesture = QStringLiteral("two classes");
    for (const ActionAnswer& answer : answers) {
        gesture += QStringLiteral(" %1.%2.%3")
                       .arg(answer.fighter.take)
                       .arg(answer.fighter.player)
                       .arg(answer.action);
    }
    // Labels change no derived value: the analysis is that of the project before, too.
    return document.applyLive(gesture, [&](const Project& project) {
        return setLabels(project, document.analysis(), answers);
    });
}

void LabelSession::setTogether(bool together) {
    if (together_ && !together) session_.document().endGesture();
    together_ = together;
}

bool LabelSession::name(std::span<const int> actions, int aspect, int qualifier, Naming naming) {
    return answer(actions, [&](const ShownAction& action) {
        return answeredLabel(vocabulary(), action.byHand(), action.label(), aspect, qualifier,
                             naming);
    });
}

void LabelSession::paint(int action, int aspect, int qualifier) {
    const ShownAction& shown = actions_.at(static_cast<std::size_t>(action));
    const bool known =
        std::any_of(painted_.begin(), painted_.end(), [&](const ActionAnswer& answer) {
            return answer.fighter == shown.fighter && answer.action == shown.index;
        });
    if (known) return;
    painted_.push_back(
        {shown.fighter, shown.index,
         answeredLabel(vocabulary(), shown.byHand(), shown.label(), aspect, qualifier)});
    Document& document = session_.document();
    // Labels change no derived value: the analysis is that of the project before, too.
    document.applyLive(QStringLiteral("paint labels"), [&](const Project& project) {
        return setLabels(project, document.analysis(), painted_);
    });
}

void LabelSession::endPainting() {
    if (painted_.empty()) return;
    painted_.clear();
    session_.document().endGesture();
}

bool LabelSession::say(std::span<const int> actions, const Label& label) {
    return answer(actions, [&](const ShownAction&) { return label; });
}

bool LabelSession::sayEach(std::span<const std::pair<int, Label>> answers) {
    std::vector<ActionAnswer> all;
    for (const auto& [index, label] : answers) {
        const ShownAction& action = actions_.at(static_cast<std::size_t>(index));
        all.push_back({action.fighter, action.index, label});
    }
    return set(all);
}

bool LabelSession::agree(std::span<const int> actions) {
    return answer(actions, [&](const ShownAction& action) {
        return agreedLabel(vocabulary(), action.byHand(), action.label());
    });
}

bool LabelSession::clear(std::span<const int> actions, std::optional<int> aspect) {
    std::map<std::pair<int, int>, std::vector<int>> byFighter;
    for (const int index : actions) {
        const ShownAction& action = actions_.at(static_cast<std::size_t>(index));
        byFighter[{action.fighter.take, action.fighter.player}].push_back(action.index);
    }
    return edit([&](const Project& project, const Analysis& analysis) {
        MaybeEdit result;
        for (const auto& [key, indices] : byFighter) {
            const Project& last = result ? result->project : project;
            if (auto next = clearLabel(last, analysis, {key.first, key.second}, indices, aspect)) {
                result = std::move(next);
            }
        }
        return result;
    });
}

int LabelSession::countSure(double leastConfidence) const {
    return static_cast<int>(
        std::count_if(actions_.begin(), actions_.end(), [&](const ShownAction& action) {
            const bool speaks =
                std::all_of(action.aspects.begin(), action.aspects.end(),
                            [](const ShownAspect& aspect) { return aspect.value.known(); });
            return speaks && !action.anyByHand() && !action.isSettled() &&
                   action.confidence() >= leastConfidence;
        }));
}

std::vector<FighterLabels> LabelSession::sureProposals(double leastConfidence) const {
    std::vector<FighterLabels> sure = learnt()->proposals.fighters;
    for (FighterLabels& fighter : sure) {
        for (ActionLabel& label : fighter.labels) {
            const int index = indexOf(fighter.fighter, label.peak);
            const ShownAction& action = actions_.at(static_cast<std::size_t>(index));
            const bool whole = action.anyByHand() || action.confidence() >= leastConfidence;
            for (std::size_t a = 0; a < label.aspects.size(); ++a) {
                // What was accepted before stays as it is.
                const bool settled = action.aspects[a].standing == Standing::Accepted;
                if (!whole || settled) label.aspects[a] = {};
            }
        }
    }
    return sure;
}

bool LabelSession::acceptSure(double leastConfidence) {
    if (!isCurrent(true)) return false;
    const int count = countSure(leastConfidence);
    const std::vector<FighterLabels> sure = sureProposals(leastConfidence);
    return edit([&](const Project& project, const Analysis& analysis) {
        MaybeEdit result = acceptLabels(project, analysis, sure, leastConfidence);
        if (!result) return result;
        // The model by which they were found belongs to them.
        const ModelRecord model{learnt()->parameters,
                                trainingHash(learnt()->ground->table.features, learnt()->examples,
                                             project.labelling.learning, learnt()->parameters)};
        if (auto kept = setModel(result->project, model)) result->project = kept->project;
        result->name = count == 0   ? std::string("Accept what rules say")
                       : count == 1 ? std::string("Accept 1 label")
                                    : "Accept " + std::to_string(count) + " labels";
        return result;
    });
}

}  // namespace kumite::studio
