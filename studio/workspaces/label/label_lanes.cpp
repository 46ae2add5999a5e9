#include "studio/workspaces/label/label_lanes.h"

#include "studio/app/core_words.h"
#include "studio/app/words.h"
#include "studio/workspaces/label/label_words.h"

namespace kumite::studio {

LaneCell laneCell(const Aspect& aspect, const ShownAspect& shown) {
    LaneCell cell;
    if (!shown.value.known()) return cell;
    cell.value = shown.value.qualifier;
    cell.byHand = shown.standing == Standing::Hand;
    const bool nothing = cell.value == aspect.fallback;
    const bool rule = shown.value.source == LabelSource::Rule;
    // That a rule finds nothing is no question to anybody.
    cell.uncertain = shown.isUncertain() && !(rule && nothing);
    if (nothing) {
        cell.look = LaneLook::Nothing;
    } else if (cell.byHand) {
        cell.look = LaneLook::Hand;
    } else if (rule) {
        cell.look = LaneLook::Rule;
    } else {
        cell.look = shown.standing == Standing::Accepted ? LaneLook::Accepted : LaneLook::Proposed;
    }
    return cell;
}

LabelLanes::LabelLanes(LabelSession& labels, LabelReview& review, QObject* parent)
    : LaneSource(parent), labels_(labels), review_(review) {
    connect(&labels_, &LabelSession::changed, this, &LabelLanes::fill);
    connect(&labels_, &LabelSession::choiceChanged, this, &LaneSource::changed);
}

void LabelLanes::fill() {
    const Vocabulary& vocabulary = labels_.vocabulary();
    for (int player = 0; player < 2; ++player) {
        std::vector<LaneCell>& cells = cells_[static_cast<std::size_t>(player)];
        cells.clear();
        for (const ShownAction& action : labels_.actionsOf(player)) {
            for (int a = 0; a < vocabulary.size(); ++a)
                cells.push_back(
                    laneCell(vocabulary[a], action.aspects[static_cast<std::size_t>(a)]));
        }
    }
    Q_EMIT changed();
}

int LabelLanes::laneCount() const {
    return labels_.vocabulary().size();
}

QString LabelLanes::laneName(int lane) const {
    return vocabularyWords(labels_.vocabulary()[lane].name);
}

int LabelLanes::chosenLane() const {
    return labels_.aspect();
}

QString LabelLanes::valueText(int lane, int value) const {
    const Aspect& aspect = labels_.vocabulary()[lane];
    const Qualifier& qualifier = aspect.qualifiers[static_cast<std::size_t>(value)];
    return value == aspect.fallback ? vocabularyWords(qualifier.name) : shortWords(qualifier);
}

QColor LabelLanes::valueColour(int lane, int value) const {
    const Qualifier& qualifier =
        labels_.vocabulary()[lane].qualifiers[static_cast<std::size_t>(value)];
    return QColor(QString::fromStdString(qualifier.colour));
}

std::span<const LaneCell> LabelLanes::cells(int player) const {
    return player >= 0 && player < 2 ? std::span(cells_[static_cast<std::size_t>(player)])
                                     : std::span<const LaneCell>();
}

std::vector<ActionRef> LabelLanes::chosen() const {
    return labels_.session().selectedAction() ? labels_.chosenRefs() : std::vector<ActionRef>();
}

QString LabelLanes::describe(const ActionRef& ref, int lane) const {
    const ShownAction* action = labels_.find(ref);
    if (action == nullptr) return {};
    const Vocabulary& vocabulary = labels_.vocabulary();
    QStringList parts = {tr("%1 · action %2").arg(fighterText(ref.player)).arg(action->index)};
    if (lane < 0) {
        parts.append(labelWords(vocabulary, action->label(), true));
        const QString note = labels_.session().noteOf(ref);
        if (!note.isEmpty()) parts.append(tr("note: %1").arg(note));
    } else {
        const ShownAspect& shown = action->aspects[static_cast<std::size_t>(lane)];
        parts.append(aspectWords(vocabulary, lane, shown.value.qualifier));
        parts.append(standingWords(shown));
        const QString reason = reasonWords(labels_, *action, lane);
        if (!reason.isEmpty()) parts.append(reason);
        const Prediction& machine = shown.prediction;
        const bool differs = shown.standing == Standing::Hand && !machine.blind &&
                             machine.qualifier != kUnknown &&
                             machine.qualifier != shown.value.qualifier;
        if (differs) {
            parts.append(tr("the machine would say %1")
                             .arg(aspectWords(vocabulary, lane, machine.qualifier)));
        }
    }
    return parts.join(QStringLiteral(" · "));
}

bool LabelLanes::pressed(const ActionRef& action, int lane, Qt::KeyboardModifiers modifiers) {
    if (review_.brush()) {
        painting_ = review_.paint(action);
        return false;
    }
    if (lane >= 0) labels_.setAspect(lane);
    if (modifiers & Qt::ShiftModifier) {
        review_.extendTo(action);
    } else if (modifiers & Qt::ControlModifier) {
        review_.toggle(action);
    } else {
        labels_.choose({action});
        return true;
    }
    return false;
}

void LabelLanes::dragged(const ActionRef& action) {
    if (painting_) {
        review_.paint(action);
    } else if (!review_.paint(action)) {  // a held class key paints, too
        review_.extendTo(action);
    }
}

void LabelLanes::released() {
    painting_ = false;
    review_.endPainting();
}

}  // namespace kumite::studio
