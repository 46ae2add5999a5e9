#include "core/project/vocabulary_change.h"

#include <fmt/format.h>

namespace kumite {
namespace {

/// Counts the labels of one aspect that have this qualifier (kUnknown: any).
void count(const Project& project, std::size_t aspect, int qualifier, VocabularyLoss& loss) {
    for (const Take& take : project.takes) {
        for (const Fighter& fighter : take.fighters) {
            for (const ActionLabel& label : *fighter.labels) {
                const AspectValue& value = label.aspects[aspect];
                if (!value.known() || (qualifier != kUnknown && value.qualifier != qualifier))
                    continue;
                ++(value.byHand() ? loss.byHand : loss.others);
            }
        }
    }
}

}  // namespace

std::vector<VocabularyLoss> lostBy(const Project& project, const Vocabulary& vocabulary) {
    const Vocabulary& old = *project.labelling.vocabulary;
    std::vector<VocabularyLoss> losses;
    const auto add = [&](std::size_t aspect, int qualifier, std::string name) {
        VocabularyLoss loss{old.aspects[aspect].name, std::move(name), 0, 0};
        count(project, aspect, qualifier, loss);
        if (loss.byHand + loss.others > 0) losses.push_back(std::move(loss));
    };
    for (std::size_t a = 0; a < old.aspects.size(); ++a) {
        const auto kept = vocabulary.find(old.aspects[a].id);
        if (!kept) {
            add(a, kUnknown, {});
            continue;
        }
        const auto& qualifiers = old.aspects[a].qualifiers;
        for (std::size_t q = 0; q < qualifiers.size(); ++q) {
            if (!vocabulary[*kept].find(qualifiers[q].id))
                add(a, static_cast<int>(q), qualifiers[q].name);
        }
    }
    return losses;
}

std::string lossText(const VocabularyLoss& loss) {
    const auto labels = [](int count) { return count == 1 ? "label" : "labels"; };
    std::string text = loss.aspect + (loss.qualifier.empty() ? "" : " " + loss.qualifier) + ": ";
    if (loss.byHand > 0) text += fmt::format("{} {} by hand", loss.byHand, labels(loss.byHand));
    if (loss.others > 0) {
        text += loss.byHand > 0 ? fmt::format(", {} accepted", loss.others)
                                : fmt::format("{} accepted {}", loss.others, labels(loss.others));
    }
    return text;
}

}  // namespace kumite
