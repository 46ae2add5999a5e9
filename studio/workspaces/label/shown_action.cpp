#include "studio/workspaces/label/shown_action.h"

#include <algorithm>
#include <limits>

#include "core/labelling/answers.h"

namespace kumite::studio {

namespace {
/// As long as no probability is known: what is farther from the next class than half the
/// machine's margin is taken for sure.
constexpr double kSureMargin = 0.5;
}  // namespace

bool ShownAspect::isUncertain() const {
    if (standing == Standing::Hand || !value.known()) return false;
    const bool known = value.confidence > 0;
    if (known || value.source == LabelSource::Rule) {
        return static_cast<double>(value.confidence) < kSure;
    }
    return prediction.blind || prediction.margin < kSureMargin;
}

Label ShownAction::label() const {
    Label label;
    for (const ShownAspect& aspect : aspects)
        label.push_back(aspect.value.qualifier);
    return label;
}

Label ShownAction::byHand() const {
    Label label;
    for (const ShownAspect& aspect : aspects)
        label.push_back(aspect.value.byHand() ? aspect.value.qualifier : kUnknown);
    return label;
}

bool ShownAction::anyByHand() const {
    return std::any_of(aspects.begin(), aspects.end(),
                       [](const ShownAspect& a) { return a.standing == Standing::Hand; });
}

bool ShownAction::anyAccepted() const {
    return std::any_of(aspects.begin(), aspects.end(),
                       [](const ShownAspect& a) { return a.standing == Standing::Accepted; });
}

bool ShownAction::isSettled() const {
    return std::all_of(aspects.begin(), aspects.end(),
                       [](const ShownAspect& a) { return a.isKept(); });
}

bool ShownAction::isOpen(const Vocabulary& vocabulary) const {
    for (std::size_t a = 0; a < aspects.size(); ++a) {
        const bool learnt = vocabulary.aspects[a].classifier == Classifier::Msvm;
        if (learnt && !aspects[a].isKept()) return true;
    }
    return false;
}

double ShownAction::confidence() const {
    double least = 1;
    for (const ShownAspect& aspect : aspects) {
        if (aspect.standing == Standing::Hand || !aspect.value.known()) continue;
        least = std::min(least, static_cast<double>(aspect.value.confidence));
    }
    return least;
}

double ShownAction::margin() const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const ShownAspect& aspect : aspects) {
        if (!aspect.prediction.blind) smallest = std::min(smallest, aspect.prediction.margin);
    }
    return smallest;
}

Label secondBest(const Vocabulary& vocabulary, const ShownAction& action) {
    int least = -1;
    for (int a = 0; a < vocabulary.size(); ++a) {
        const Prediction& prediction = action.aspects[static_cast<std::size_t>(a)].prediction;
        if (prediction.blind || prediction.second == kUnknown) continue;
        const bool smaller =
            least < 0 ||
            prediction.margin < action.aspects[static_cast<std::size_t>(least)].prediction.margin;
        if (smaller) least = a;
    }
    const Label shown = action.label();
    if (least < 0) return Label(shown.size(), kUnknown);
    const Label nothingSaid(shown.size(), kUnknown);
    return answeredLabel(vocabulary, nothingSaid, shown, least,
                         action.aspects[static_cast<std::size_t>(least)].prediction.second);
}

std::optional<double> probabilityOf(const Vocabulary& vocabulary, const ShownAction& action,
                                    const Label& label) {
    std::optional<double> least;
    for (int a = 0; a < vocabulary.size(); ++a) {
        if (vocabulary[a].classifier != Classifier::Msvm) continue;
        const ShownAspect& shown = action.aspects[static_cast<std::size_t>(a)];
        const Prediction& said = shown.prediction;
        const int qualifier = label[static_cast<std::size_t>(a)];
        // One class seen says nothing about how sure the others are.
        if (shown.standing == Standing::Hand || said.blind || qualifier == kUnknown) continue;
        // Of what is neither best nor second best no more is known than what those leave.
        double own =
            std::clamp(1 - said.confidence - said.secondConfidence, 0.0, said.secondConfidence);
        if (qualifier == said.qualifier)
            own = said.confidence;
        else if (qualifier == said.second)
            own = said.secondConfidence;
        else if (shown.standing == Standing::Accepted && qualifier == shown.value.qualifier)
            own = static_cast<double>(shown.value.confidence);
        least = std::min(least.value_or(1), own);
    }
    return least;
}

}  // namespace kumite::studio
