#include "studio/workspaces/label/label_words.h"

#include <QCoreApplication>

#include "studio/workspaces/label/label_session.h"

namespace kumite::studio {

namespace {

QString text(const char* source) {
    return QCoreApplication::translate("kumite::studio::LabelWords", source);
}

QString lower(const std::string& name) {
    return QString::fromStdString(name).toLower();
}

}  // namespace

QString aspectWords(const Vocabulary& vocabulary, int aspect, int qualifier) {
    const Aspect& named = vocabulary[aspect];
    if (qualifier == kUnknown) return text("%1 open").arg(lower(named.name));
    if (qualifier == named.fallback) return text("no %1").arg(lower(named.name));
    const Qualifier& value = named.qualifiers[static_cast<std::size_t>(qualifier)];
    return lower(named.name) + QLatin1Char(' ') + QString::fromStdString(value.name);
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
    return anyKnown ? text("nothing") : text("open");
}

QString probabilityWords(double confidence) {
    return confidence > 0 ? QStringLiteral("p\u00a0%1").arg(confidence, 0, 'f', 2)
                          : QStringLiteral("p\u00a0…");
}

QString sourceWords(LabelSource source) {
    switch (source) {
        case LabelSource::Hand:
            return text("hand");
        case LabelSource::Rule:
            return text("rule");
        case LabelSource::Machine:
            break;
    }
    return text("machine");
}

QString standingWords(const ShownAspect& aspect) {
    const bool rule = aspect.value.source == LabelSource::Rule;
    const auto confidence = static_cast<double>(aspect.value.confidence);
    switch (aspect.standing) {
        case Standing::Open:
            return text("open");
        case Standing::Hand:
            return text("by hand");
        case Standing::Accepted:
            return rule ? text("accepted from a rule")
                        : text("accepted from the machine, %1").arg(probabilityWords(confidence));
        case Standing::Proposed:
            break;
    }
    if (rule && confidence >= 1) return text("proposed by a rule");
    if (rule) return text("proposed by a rule, %1").arg(probabilityWords(confidence));
    if (aspect.prediction.blind) return text("proposed: the only one seen so far");
    return text("proposed by the machine, %1").arg(probabilityWords(confidence));
}

QString reasonWords(const LabelSession& labels, const ShownAction& action, int aspect) {
    const RuleReasons* reasons = labels.reasonsOf(action);
    if (reasons == nullptr) return {};
    const Classifier classifier = labels.vocabulary()[aspect].classifier;
    if (classifier == Classifier::ReactRule) return QString::fromStdString(reasons->react);
    if (classifier == Classifier::MoveRule) return QString::fromStdString(reasons->moves);
    return {};
}

}  // namespace kumite::studio
