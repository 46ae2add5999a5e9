#include "studio/workspaces/label/label_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace kumite::studio {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("kumite::studio::LabelWords", text);
}

}  // namespace

QString aspectWords(const Vocabulary& vocabulary, int aspect, int qualifier) {
    const Aspect& of = vocabulary[aspect];
    const QString name = QString::fromStdString(of.name).toLower();
    if (qualifier == kUnknown) return tr("%1 open").arg(name);
    const auto& said = of.qualifiers[static_cast<std::size_t>(qualifier)];
    return name + QLatin1Char(' ') + QString::fromStdString(said.name).toLower();
}

QString labelWords(const Vocabulary& vocabulary, const Label& label) {
    QStringList said, moves;
    bool known = false;
    for (int a = 0; a < static_cast<int>(label.size()); ++a) {
        const int qualifier = label[static_cast<std::size_t>(a)];
        if (qualifier == kUnknown) continue;
        known = true;
        if (qualifier == vocabulary[a].fallback) continue;
        (vocabulary[a].fallback ? said : moves).append(aspectWords(vocabulary, a, qualifier));
    }
    if (said.isEmpty()) said = moves;
    if (said.isEmpty()) return known ? tr("nothing") : tr("open");
    return said.join(QStringLiteral(", "));
}

QString sourceWords(LabelSource source) {
    switch (source) {
        case LabelSource::Hand:
            return tr("hand");
        case LabelSource::Rule:
            return tr("rule");
        case LabelSource::Machine:
            break;
    }
    return tr("machine");
}

}  // namespace kumite::studio
