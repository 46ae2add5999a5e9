// What is shown: labels, proposals, progress and the queue. Choice and edits stand in
// label_session_edits.cpp.

#include "studio/workspaces/label/label_session.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace kumite::studio {

LabelSession::LabelSession(Session& session, QObject* parent)
    : QObject(parent), session_(session), learning_(session.document()) {
    Document& document = session_.document();
    connect(&document, &Document::opened, this, [this] {
        learning_.reset();
        actions_.clear();
        begins_.clear();
        queue_.clear();
        batch_.clear();
        curve_.clear();
        chosen_.clear();
    });
    connect(&document, &Document::changed, this, &LabelSession::refresh);
    connect(&document, &Document::stepped, this, &LabelSession::followHistory);
    connect(&session_, &Session::takeChanged, this, [this] {
        chosen_.clear();
        if (isActive()) rebuild();
        Q_EMIT changed();
        Q_EMIT choiceChanged();
    });
    connect(&session_, &Session::selectionChanged, this, &LabelSession::followSelection);
    connect(&session_, &Session::activePlayerChanged, this, &LabelSession::choiceChanged);
    connect(&learning_, &LabelLearning::updated, this, [this] {
        notePoint();
        rebuild();
        Q_EMIT changed();
    });
    connect(&learning_, &LabelLearning::busyChanged, this, &LabelSession::learningChanged);
    connect(&learning_, &LabelLearning::failed, &session_, &Session::hinted);
}

void LabelSession::setActive(bool active) {
    if (active == isActive()) return;
    learning_.setActive(active);
    refresh();
}

const Vocabulary& LabelSession::vocabulary() const {
    return *session_.document().project().labelling.vocabulary;
}

void LabelSession::refresh() {
    const Document& document = session_.document();
    // Values of an earlier project are no ground to stand on; the next signal is near.
    if (!isActive() || !document.isOpen() || !document.isCurrent()) return;
    learning_.follow();
    rebuild();
    aspect_ = std::clamp(aspect_, 0, std::max(0, vocabulary().size() - 1));
    Q_EMIT changed();
}

void LabelSession::rebuild() {
    const Document& document = session_.document();
    if (!document.isCurrent()) return;
    const Project& project = document.project();
    const Analysis& analysis = document.analysis();
    const auto aspects = static_cast<std::size_t>(vocabulary().size());
    const LearntLabels* learnt = learning_.learnt().get();
    if (learnt && !(learnt->vocabulary == project.labelling.vocabulary)) learnt = nullptr;
    actions_.clear();
    begins_.clear();
    for (std::size_t t = 0; t < project.takes.size(); ++t) {
        for (std::size_t p = 0; p < project.takes[t].fighters.size(); ++p) {
            const FighterAddress address{static_cast<int>(t), static_cast<int>(p)};
            if (!analysis.at(address).available()) continue;
            begins_.push_back(actions_.size());
            const bool known = learnt && learnt->ground->knows(analysis, address);
            const auto* proposals = known ? proposalsOf(address, nullptr) : nullptr;
            std::size_t next = 0;  // proposal
            int index = 0;
            for (const ActionLabel& label : actionLabels(
                     fighterAt(project, address), analysis.at(address), vocabulary().size())) {
                ShownAction action{address, index++, label.peak, -1, {}};
                action.aspects.resize(aspects);
                if (known) action.row = learnt->ground->rowOf(address, label.peak).value_or(-1);
                while (proposals && next < proposals->size() &&
                       (*proposals)[next].peak < label.peak)
                    ++next;
                const bool proposed =
                    proposals && next < proposals->size() && (*proposals)[next].peak == label.peak;
                for (std::size_t a = 0; a < aspects; ++a) {
                    ShownAspect& shown = action.aspects[a];
                    shown.value = label.aspects[a];
                    if (shown.value.known()) {
                        shown.standing = shown.value.byHand() ? Standing::Hand : Standing::Accepted;
                    } else if (proposed && !(*proposals)[next].aspects[a].byHand()) {
                        // A hand's word there is one that was taken back meanwhile.
                        shown.value = (*proposals)[next].aspects[a];
                        if (shown.value.known()) shown.standing = Standing::Proposed;
                    }
                    if (action.row >= 0)
                        shown.prediction = learnt->predictions.at(action.row, static_cast<int>(a));
                }
                actions_.push_back(std::move(action));
            }
        }
    }
    rebuildQueue();
    count();
}

const std::vector<ActionLabel>* LabelSession::proposalsOf(
    FighterAddress fighter, const std::vector<RuleReasons>** reasons) const {
    if (!learnt()) return nullptr;
    const Proposals& proposals = learnt()->proposals;
    for (std::size_t i = 0; i < proposals.fighters.size(); ++i) {
        if (proposals.fighters[i].fighter != fighter) continue;
        if (reasons) *reasons = &proposals.reasons[i];
        return &proposals.fighters[i].labels;
    }
    return nullptr;
}

double LabelSession::timeOf(const ShownAction& action) const {
    return timeOfFrame(fighterAt(session_.document().project(), action.fighter), action.peak);
}

const RuleReasons* LabelSession::reasonsOf(const ShownAction& action) const {
    if (action.row < 0) return nullptr;
    const std::vector<RuleReasons>* reasons = nullptr;
    const auto* labels = proposalsOf(action.fighter, &reasons);
    if (labels == nullptr) return nullptr;
    const auto found =
        std::partition_point(labels->begin(), labels->end(),
                             [&](const ActionLabel& each) { return each.peak < action.peak; });
    if (found == labels->end() || found->peak != action.peak) return nullptr;
    return &(*reasons)[static_cast<std::size_t>(found - labels->begin())];
}

int LabelSession::indexOf(FighterAddress fighter, int peak) const {
    const auto key = [](FighterAddress address, int frame) {
        return std::tuple(address.take, address.player, frame);
    };
    const auto found = std::partition_point(
        actions_.begin(), actions_.end(),
        [&](const ShownAction& each) { return key(each.fighter, each.peak) < key(fighter, peak); });
    const bool here = found != actions_.end() && found->fighter == fighter && found->peak == peak;
    return here ? static_cast<int>(found - actions_.begin()) : -1;
}

const ShownAction* LabelSession::find(const ActionRef& action) const {
    const int index = indexOf({session_.take(), action.player}, action.peak);
    return index < 0 ? nullptr : &actions_[static_cast<std::size_t>(index)];
}

std::span<const ShownAction> LabelSession::actionsOf(int player) const {
    const FighterAddress address{session_.take(), player};
    for (std::size_t i = 0; i < begins_.size(); ++i) {
        const std::size_t end = i + 1 < begins_.size() ? begins_[i + 1] : actions_.size();
        if (begins_[i] == end || actions_[begins_[i]].fighter != address) continue;
        return {actions_.data() + begins_[i], end - begins_[i]};
    }
    return {};
}

const ShownAction* LabelSession::current() const {
    const auto action = session_.currentAction();
    return action ? find(*action) : nullptr;
}

void LabelSession::setOrder(QueueOrder order) {
    if (order == order_) return;
    order_ = order;
    rebuildQueue();
    Q_EMIT changed();
}

void LabelSession::rebuildQueue() {
    const auto isOpen = [&](int index) {
        return index >= 0 && actions_[static_cast<std::size_t>(index)].isOpen(vocabulary());
    };
    // One batch is asked about to its end: its questions differ from each other.
    std::vector<int> first;
    const auto gather = [&] {
        for (const auto& [fighter, peak] : batch_) {
            const int index = indexOf(fighter, peak);
            if (isOpen(index)) first.push_back(index);
        }
    };
    gather();
    // A batch of before the last answers is stale; the next one is under way.
    if (first.empty() && learnt() && learning_.isCurrent()) {
        batch_.clear();
        for (const int row : learnt()->batch) {
            const auto at = static_cast<std::size_t>(row);
            batch_.emplace_back(learnt()->ground->table.rows[at].fighter,
                                learnt()->ground->peaks[at]);
        }
        gather();
    }
    struct Open {
        double weight = 0;
        int index = 0;
    };
    const auto weightOf = [&](const ShownAction& action) {
        if (order_ == QueueOrder::MostUseful) return action.margin();
        if (order_ == QueueOrder::LeastSure) return action.confidence();
        return timeOf(action);
    };
    std::vector<Open> open;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        if (isOpen(static_cast<int>(i)))
            open.push_back({weightOf(actions_[i]), static_cast<int>(i)});
    }
    std::stable_sort(open.begin(), open.end(), [&](const Open& a, const Open& b) {
        const int takeOfA = actions_[static_cast<std::size_t>(a.index)].fighter.take;
        const int takeOfB = actions_[static_cast<std::size_t>(b.index)].fighter.take;
        if (order_ == QueueOrder::Time && takeOfA != takeOfB) return takeOfA < takeOfB;
        return a.weight < b.weight;
    });
    queue_.clear();
    if (order_ == QueueOrder::MostUseful) queue_ = first;
    for (const Open& each : open) {
        if (std::find(first.begin(), first.end(), each.index) == first.end() ||
            order_ != QueueOrder::MostUseful) {
            queue_.push_back(each.index);
        }
    }
}

void LabelSession::count() {
    progress_ = {};
    for (const ShownAction& action : actions_) {
        ++progress_.actions;
        if (action.anyByHand()) {
            ++progress_.byHand;
        } else if (action.anyAccepted()) {
            ++progress_.accepted;
        }
        if (action.isSettled()) ++progress_.settled;
    }
    if (curve_.empty()) return;
    // One round's value trembles by some percent; those of far fewer labels say nothing of now.
    constexpr int kNear = 10;  // labels
    double sum = 0;
    int near = 0;
    for (const LearnedPoint& point : curve_) {
        if (point.labelled + kNear <= curve_.back().labelled) continue;
        sum += point.expectedAccuracy;
        ++near;
    }
    progress_.expectedAccuracy = sum / near;
    // A round of mayStop is a batch.
    std::vector<double> rounds;
    int labelled = 0;
    for (const LearnedPoint& point : curve_) {
        if (point.labelled < labelled + querySettings().batch) continue;
        labelled = point.labelled;
        rounds.push_back(point.expectedAccuracy);
    }
    // Once said it stays.
    progress_.mayStop = false;
    for (std::size_t count = 1; count <= rounds.size() && !progress_.mayStop; ++count)
        progress_.mayStop = kumite::mayStop(std::span(rounds).first(count));
}

void LabelSession::notePoint() {
    if (!learnt()->calibrated || !learnt()->expectedAccuracy) return;
    const int labelled = static_cast<int>(learnt()->examples.size());
    std::erase_if(curve_, [&](const LearnedPoint& point) { return point.labelled >= labelled; });
    if (labelled > 1) curve_.push_back({labelled, *learnt()->expectedAccuracy});
}

void LabelSession::followHistory(const Project& before) {
    const Project& now = session_.document().project();
    if (!isActive() || !session_.document().isCurrent() || before.takes.size() != now.takes.size())
        return;
    // Which action's label differs; of several none is meant.
    int changed = -1;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        const ShownAction& action = actions_[i];
        const auto& fighters = before.takes[static_cast<std::size_t>(action.fighter.take)].fighters;
        if (action.fighter.player >= static_cast<int>(fighters.size())) return;
        const LabelTrack& was = *fighterAt(before, action.fighter).labels;
        const LabelTrack& is = *fighterAt(now, action.fighter).labels;
        if (&was == &is) continue;
        const auto at = [&](const LabelTrack& track) {
            const auto found = std::partition_point(
                track.begin(), track.end(),
                [&](const ActionLabel& each) { return each.peak < action.peak; });
            return found != track.end() && found->peak == action.peak ? &*found : nullptr;
        };
        const ActionLabel* old = at(was);
        const ActionLabel* now = at(is);
        if ((old == nullptr) == (now == nullptr) && (old == nullptr || *old == *now)) continue;
        if (changed >= 0) return;
        changed = static_cast<int>(i);
    }
    if (changed >= 0) Q_EMIT stepped(changed);
}

}  // namespace kumite::studio
