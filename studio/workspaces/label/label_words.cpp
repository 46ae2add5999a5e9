#include "studio/workspaces/label/label_words.h"

#include <QCoreApplication>

#include "studio/app/core_words.h"
#include "studio/app/words.h"
#include "studio/workspaces/label/label_session.h"

namespace kumite::studio {

namespace {

/// Translations of this file.
struct LabelWords {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::LabelWords)
};

}  // namespace

QString aspectWords(const Vocabulary& vocabulary, int aspect, int qualifier) {
    const Aspect& named = vocabulary[aspect];
    if (qualifier == kUnknown) return LabelWords::tr("%1 open").arg(vocabularyInText(named.name));
    if (qualifier == named.fallback)
        return LabelWords::tr("no %1").arg(vocabularyInText(named.name));
    const Qualifier& value = named.qualifiers[static_cast<std::size_t>(qualifier)];
    return vocabularyInText(named.name) + QLatin1Char(' ') + vocabularyWords(value.name);
}

QString labelWords(const Vocabulary& vocabulary, const Label& label, bool withRules) {
    QStringList parts;
    bool anyKnown = false;
    for (int a = 0; a < vocabulary.size(); ++a) {
        if (!withRules && vocabulary[a].classifier != Classifier::Msvm) continue;
        const int qualifier = label[static_cast<std::size_t>(a)];
        if (qualifier == kUnknown) continue;
        anyKnown = true;
        if (qualifier != vocabulary[a].fallback)
            parts.append(aspectWords(vocabulary, a, qualifier));
    }
    if (!parts.isEmpty()) return parts.join(QStringLiteral(", "));
    return anyKnown ? LabelWords::tr("nothing") : LabelWords::tr("open");
}

QString probabilityWords(double confidence) {
    return confidence > 0 ? QStringLiteral("p\u00a0%1").arg(numberText(confidence, 2))
                          : QStringLiteral("p\u00a0…");
}

QString sourceWords(LabelSource source) {
    switch (source) {
        case LabelSource::Hand:
            return LabelWords::tr("hand");
        case LabelSource::Rule:
            return LabelWords::tr("rule");
        case LabelSource::Machine:
            break;
    }
    return LabelWords::tr("machine");
}

QString standingWords(const ShownAspect& aspect) {
    const bool rule = aspect.value.source == LabelSource::Rule;
    const auto confidence = static_cast<double>(aspect.value.confidence);
    switch (aspect.standing) {
        case Standing::Open:
            return LabelWords::tr("open");
        case Standing::Hand:
            return LabelWords::tr("by hand");
        case Standing::Accepted:
            return rule ? LabelWords::tr("accepted from a rule")
                        : LabelWords::tr("accepted from the machine, %1")
                              .arg(probabilityWords(confidence));
        case Standing::Proposed:
            break;
    }
    if (rule && confidence >= 1) return LabelWords::tr("proposed by a rule");
    if (rule) return LabelWords::tr("proposed by a rule, %1").arg(probabilityWords(confidence));
    if (aspect.prediction.blind) return LabelWords::tr("proposed: the only one seen so far");
    return LabelWords::tr("proposed by the machine, %1").arg(probabilityWords(confidence));
}

QString reasonWords(const LabelSession& labels, const ShownAction& action, int aspect) {
    const RuleReasons* reasons = labels.reasonsOf(action);
    if (reasons == nullptr) return {};
    const Classifier classifier = labels.vocabulary()[aspect].classifier;
    if (classifier == Classifier::ReactRule) return coreWords(reasons->react);
    if (classifier == Classifier::MoveRule) return coreWords(reasons->moves);
    return {};
}

}  // namespace kumite::studio
