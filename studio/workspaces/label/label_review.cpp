#include "studio/workspaces/label/label_review.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QSettings>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/core_words.h"
#include "studio/workspaces/label/label_words.h"

namespace kumite::studio {

namespace {
constexpr const char* kAdvance = "label/advance";
constexpr std::size_t kMostVisited = 200;
}  // namespace

LabelReview::LabelReview(LabelSession& labels, QObject* parent)
    : QObject(parent),
      labels_(labels),
      advancing_(QSettings().value(QLatin1String(kAdvance), true).toBool()) {
    connect(&labels_, &LabelSession::stepped, this,
            [this](int action) { show(labels_.actions()[static_cast<std::size_t>(action)]); });
    connect(&labels_, &LabelSession::changed, this, [this] {
        if (sureWanted_ && labels_.isCurrent(true)) {
            tellAccepted(*std::exchange(sureWanted_, std::nullopt));
        }
    });
    connect(&labels_.session().transport(), &Transport::moved, this, &LabelReview::paintAtPlayhead);
    qApp->installEventFilter(this);
}

void LabelReview::setAdvancing(bool advancing) {
    advancing_ = advancing;
    QSettings().setValue(QLatin1String(kAdvance), advancing);
    Q_EMIT switched();
}

void LabelReview::show(const ShownAction& action) {
    // What was announced was meant for the action that was shown.
    if (composite_) setComposite(false);
    labels_.goTo(action);
    if (!isMotionReduced()) labels_.session().transport().setPlaying(true);
    Q_EMIT shown();
}

void LabelReview::next() {
    const std::vector<int>& queue = labels_.queue();
    if (queue.empty() && labels_.progress().settled > 0 &&
        labels_.progress().settled == labels_.progress().actions)
        return lookAtLeastSure();
    if (queue.empty()) {
        Q_EMIT labels_.session().hinted(
            labels_.actions().empty()
                ? tr("There is no action to label.")
                : tr("No question is left. Accept what rules and machine say of the rest."));
        return;
    }
    // Where nobody has chosen an action the queue begins at its beginning.
    const ShownAction* current = labels_.session().selectedAction() ? labels_.current() : nullptr;
    const int now = current ? labels_.indexOf(current->fighter, current->peak) : -1;
    const auto here = std::find(queue.begin(), queue.end(), now);
    auto to = here == queue.end() || here + 1 == queue.end() ? queue.begin() : here + 1;
    if (here == queue.end() && current && labels_.order() == QueueOrder::Time) {
        const double seconds = labels_.timeOf(*current);
        to = std::find_if(queue.begin(), queue.end(), [&](int index) {
            const ShownAction& each = labels_.actions()[static_cast<std::size_t>(index)];
            return each.fighter.take == current->fighter.take && labels_.timeOf(each) > seconds;
        });
        if (to == queue.end()) to = queue.begin();
    }
    if (current) {
        visited_.emplace_back(current->fighter, current->peak);
        if (visited_.size() > kMostVisited) visited_.erase(visited_.begin());
    }
    show(labels_.actions()[static_cast<std::size_t>(*to)]);
}

/// Every action has its label: those of the machine, the least sure first.
void LabelReview::lookAtLeastSure() {
    std::vector<int> given;
    const auto& actions = labels_.actions();
    for (std::size_t i = 0; i < actions.size(); ++i) {
        if (!actions[i].anyByHand()) given.push_back(static_cast<int>(i));
    }
    if (given.empty()) {
        Q_EMIT labels_.session().hinted(tr("Every action is labelled, all of them by hand."));
        return;
    }
    const auto confidence = [&](int index) {
        return actions[static_cast<std::size_t>(index)].confidence();
    };
    std::stable_sort(given.begin(), given.end(),
                     [&](int a, int b) { return confidence(a) < confidence(b); });
    const ShownAction* current = labels_.session().selectedAction() ? labels_.current() : nullptr;
    const int now = current ? labels_.indexOf(current->fighter, current->peak) : -1;
    const auto here = std::find(given.begin(), given.end(), now);
    const auto to = here == given.end() || here + 1 == given.end() ? given.begin() : here + 1;
    if (current) visited_.emplace_back(current->fighter, current->peak);
    show(actions[static_cast<std::size_t>(*to)]);
    Q_EMIT labels_.session().hinted(
        tr("Every action is labelled; of these the machine was least sure. Return says that it is "
           "right."));
}

void LabelReview::previous() {
    while (!visited_.empty()) {
        const auto [fighter, peak] = visited_.back();
        visited_.pop_back();
        const int index = labels_.indexOf(fighter, peak);
        if (index >= 0) return show(labels_.actions()[static_cast<std::size_t>(index)]);
    }
    Q_EMIT labels_.session().hinted(tr("No question was shown before."));
}

bool LabelReview::isFirstOfTwo() const {
    const ShownAction* action = labels_.current();
    return composite_ && action != nullptr && !action->anyByHand();
}

void LabelReview::answered(bool changed, bool firstOfTwo) {
    if (firstOfTwo) {
        const ShownAction* action = labels_.current();
        Q_EMIT labels_.session().hinted(
            tr("Said: %1. Now the class beside it.")
                .arg(action ? labelWords(labels_.vocabulary(), action->label()) : QString()));
        return;
    }
    const bool several = labels_.chosen().size() > 1;
    if (composite_) setComposite(false);
    // Agreeing with what a hand has said already goes on, too.
    if (advancing_ && !several) {
        const ShownAction* before = labels_.current();
        const QString said = before ? labelWords(labels_.vocabulary(), before->label()) : QString();
        next();
        if (changed && !labels_.queue().empty()) {
            Q_EMIT labels_.session().hinted(tr("Said: %1. This is the next question.").arg(said));
        }
    }
    if (!changed && !advancing_) {
        Q_EMIT labels_.session().hinted(tr("That is what a hand has said already."));
    }
}

void LabelReview::accept() {
    const std::vector<int> chosen = labels_.chosen();
    if (chosen.empty()) return next();
    // Where nothing is proposed there is nothing to agree with.
    for (const int index : chosen) {
        const ShownAction& action = labels_.actions()[static_cast<std::size_t>(index)];
        const bool proposed = std::any_of(
            action.aspects.begin(), action.aspects.end(), [](const ShownAspect& aspect) {
                return aspect.value.known() && aspect.value.source != LabelSource::Rule;
            });
        if (proposed) continue;
        Q_EMIT labels_.session().hinted(
            tr("The machine proposes nothing yet: say what it is by a class key."));
        return;
    }
    answered(labels_.agree(chosen));
}

void LabelReview::reject() {
    const std::vector<int> chosen = labels_.chosen();
    if (chosen.empty()) return;
    const ShownAction& action = labels_.actions()[static_cast<std::size_t>(chosen.front())];
    if (chosen.size() > 1 || action.anyByHand()) {
        labels_.clear(chosen);
        return;
    }
    const Label second = secondBest(labels_.vocabulary(), action);
    if (std::all_of(second.begin(), second.end(), [](int q) { return q == kUnknown; })) {
        Q_EMIT labels_.session().hinted(
            tr("There is no second best: say what it is by a class key."));
        return;
    }
    answered(labels_.say(chosen, second));
}

void LabelReview::clear() {
    labels_.clear(labels_.chosen());
}

void LabelReview::stepLane(int direction) {
    const int count = labels_.vocabulary().size();
    if (count > 0) labels_.setAspect((labels_.aspect() + direction + count) % count);
}

std::optional<int> LabelReview::qualifierOf(int digit) const {
    const Aspect& aspect = labels_.vocabulary()[labels_.aspect()];
    const std::string key = std::to_string(digit);
    for (std::size_t q = 0; q < aspect.qualifiers.size(); ++q) {
        if (aspect.qualifiers[q].key == key) return static_cast<int>(q);
    }
    return std::nullopt;
}

void LabelReview::nameClass(int digit) {
    if (labels_.vocabulary().size() == 0) return;
    const auto qualifier = qualifierOf(digit);
    if (!qualifier) {
        Q_EMIT labels_.session().hinted(
            tr("%1 has no class %2.")
                .arg(vocabularyWords(labels_.vocabulary()[labels_.aspect()].name))
                .arg(digit));
        return;
    }
    const bool paints = !advancing_ && !composite_ && !brush_ && labels_.chosen().size() == 1;
    if (!paints) return nameQualifier(*qualifier);
    // Held down it goes on painting what the playhead passes, in one step.
    held_ = Brush{labels_.aspect(), *qualifier};
    labels_.paint(labels_.chosen().front(), held_->aspect, held_->qualifier);
}

void LabelReview::nameQualifier(int qualifier) {
    if (brush_) return setBrush(Brush{labels_.aspect(), qualifier});
    const std::vector<int> chosen = labels_.chosen();
    if (chosen.empty()) return;
    const bool first = isFirstOfTwo();
    const bool besides = composite_ && !first;
    answered(labels_.name(chosen, labels_.aspect(), qualifier,
                          besides ? Naming::Besides : Naming::Instead),
             first);
}

void LabelReview::quick(int index) {
    const std::vector<QuickLabel> all = quickLabels(labels_.vocabulary());
    if (index < 0 || index >= static_cast<int>(all.size())) return;
    const std::vector<int> chosen = labels_.chosen();
    if (chosen.empty()) return;
    const Label& label = all[static_cast<std::size_t>(index)].label;
    const bool first = isFirstOfTwo();
    if (!composite_ || first) return answered(labels_.say(chosen, label), first);
    // Beside what is said already: of the new label only what it says itself.
    const Vocabulary& vocabulary = labels_.vocabulary();
    std::vector<std::pair<int, Label>> both;
    for (const int each : chosen) {
        Label said = labels_.actions()[static_cast<std::size_t>(each)].byHand();
        for (int a = 0; a < vocabulary.size(); ++a) {
            const int qualifier = label[static_cast<std::size_t>(a)];
            if (qualifier == kUnknown || qualifier == vocabulary[a].fallback) continue;
            said = answeredLabel(vocabulary, said, said, a, qualifier, Naming::Besides);
        }
        both.emplace_back(each, std::move(said));
    }
    answered(labels_.sayEach(both));
}

void LabelReview::setComposite(bool composite) {
    composite_ = composite;
    labels_.setTogether(composite);
    if (composite) {
        Q_EMIT labels_.session().hinted(tr("The next class key adds to the label."));
    }
    Q_EMIT switched();
}

void LabelReview::announceBesides() {
    const ShownAction* action = labels_.current();
    setComposite(!composite_ || (action != nullptr && action->anyByHand()));
}

void LabelReview::extend(int direction) {
    const auto current = labels_.session().currentAction();
    if (!current) return;
    const auto actions = labels_.actionsOf(current->player);
    const ShownAction* shown = labels_.find(*current);
    if (shown == nullptr) return;
    const int next = shown->index + direction;
    if (next < 0 || next >= static_cast<int>(actions.size())) return;
    std::vector<ActionRef> refs = labels_.chosenRefs();
    const ActionRef added{current->player, actions[static_cast<std::size_t>(next)].peak};
    // Led back over what is chosen, the end is taken away again.
    const bool back = std::find(refs.begin(), refs.end(), added) != refs.end();
    std::erase(refs, back ? *current : added);
    std::erase(refs, added);
    refs.push_back(added);
    labels_.choose(std::move(refs));
    labels_.session().reveal(labels_.timeOf(*labels_.find(added)));
}

void LabelReview::extendTo(const ActionRef& action) {
    const std::vector<ActionRef> before = labels_.chosenRefs();
    const ShownAction* from = before.empty() ? nullptr : labels_.find(before.front());
    const ShownAction* end = labels_.find(action);
    if (end == nullptr) return;
    if (from == nullptr || from->fighter.player != action.player) return labels_.choose({action});
    const auto actions = labels_.actionsOf(action.player);
    std::vector<ActionRef> refs;
    const int step = end->index < from->index ? -1 : 1;
    for (int i = from->index; i != end->index + step; i += step)
        refs.push_back({action.player, actions[static_cast<std::size_t>(i)].peak});
    labels_.choose(std::move(refs));
}

void LabelReview::toggle(const ActionRef& action) {
    std::vector<ActionRef> refs = labels_.chosenRefs();
    const bool was = std::find(refs.begin(), refs.end(), action) != refs.end();
    std::erase(refs, action);
    if (!was || refs.empty()) refs.push_back(action);
    labels_.choose(std::move(refs));
}

void LabelReview::setBrush(std::optional<Brush> brush) {
    if (brush == brush_) return;
    brush_ = brush;
    Q_EMIT switched();
}

bool LabelReview::paint(const ActionRef& action) {
    const auto& with = brush_ ? brush_ : held_;
    const ShownAction* shown = with ? labels_.find(action) : nullptr;
    if (shown == nullptr) return false;
    labels_.paint(labels_.indexOf(shown->fighter, shown->peak), with->aspect, with->qualifier);
    return true;
}

void LabelReview::endPainting() {
    labels_.endPainting();
}

void LabelReview::paintAtPlayhead() {
    Session& session = labels_.session();
    if (!held_ || !session.transport().isPlaying()) return;
    if (const auto action =
            session.actionAt(session.activePlayer(), session.shownFrame(session.activePlayer()))) {
        paint(*action);
    }
}

bool LabelReview::eventFilter(QObject* watched, QEvent* event) {
    if (held_ && event->type() == QEvent::KeyRelease &&
        !static_cast<QKeyEvent*>(event)->isAutoRepeat()) {
        held_.reset();
        endPainting();
    }
    return QObject::eventFilter(watched, event);
}

void LabelReview::tellAccepted(double leastConfidence) {
    const int count = labels_.countSure(leastConfidence);
    if (!labels_.acceptSure(leastConfidence)) return;
    Q_EMIT labels_.session().hinted(
        count > 0 ? tr("Accepted: %n action(s). Ctrl+Z takes all of it back.", nullptr, count)
                  : tr("Accepted what rules say."));
}

void LabelReview::acceptSure(double leastConfidence) {
    if (labels_.isCurrent(true)) {
        tellAccepted(leastConfidence);
    } else {
        sureWanted_ = leastConfidence;
        Q_EMIT labels_.session().hinted(
            tr("Accepted as soon as the machine knows how sure it is."));
    }
}

}  // namespace kumite::studio
