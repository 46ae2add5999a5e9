#include "studio/app/core_words.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <vector>

#include "studio/app/language.h"

namespace kumite::studio {

namespace {

/// As the core makes them; %1, %2 … stand for what is put in.
constexpr const char* kTexts[] = {
    QT_TRANSLATE_NOOP("Core", "Open"),
    QT_TRANSLATE_NOOP("Core", "Recover"),
    QT_TRANSLATE_NOOP("Core", "Take over labels"),
    QT_TRANSLATE_NOOP("Core", "Take over labels of %1"),
    QT_TRANSLATE_NOOP("Core", "Remove boundary %1"),
    QT_TRANSLATE_NOOP("Core", "Restore boundary %1"),
    QT_TRANSLATE_NOOP("Core", "Add boundary %1"),
    QT_TRANSLATE_NOOP("Core", "Move boundary %1"),
    QT_TRANSLATE_NOOP("Core", "Accept boundary %1"),
    QT_TRANSLATE_NOOP("Core", "Change segmentation settings"),
    QT_TRANSLATE_NOOP("Core", "Change body model to %1"),
    QT_TRANSLATE_NOOP("Core", "Restore the version of %1"),
    QT_TRANSLATE_NOOP("Core", "Add clips"),
    QT_TRANSLATE_NOOP("Core", "Remove clips"),
    QT_TRANSLATE_NOOP("Core", "Add take %1"),
    QT_TRANSLATE_NOOP("Core", "Remove take %1"),
    QT_TRANSLATE_NOOP("Core", "Rename take to %1"),
    QT_TRANSLATE_NOOP("Core", "Move take %1 to place %2"),
    QT_TRANSLATE_NOOP("Core", "Swap fighters"),
    QT_TRANSLATE_NOOP("Core", "Change time offset, fighter %1"),
    QT_TRANSLATE_NOOP("Core", "Change floor, fighter %1"),
    QT_TRANSLATE_NOOP("Core", "Change role %1, fighter %2"),
    QT_TRANSLATE_NOOP("Core", "Relink recording, fighter %1"),
    QT_TRANSLATE_NOOP("Core", "Keep bout as take %1"),
    QT_TRANSLATE_NOOP("Core", "Keep motion as take %1"),
    QT_TRANSLATE_NOOP("Core", "Label action %1, fighter %2: %3"),
    QT_TRANSLATE_NOOP("Core", "Label action %1, fighter %2"),
    QT_TRANSLATE_NOOP("Core", "Label %1 actions, fighter %2: %3"),
    QT_TRANSLATE_NOOP("Core", "Label %1 actions, fighter %2"),
    QT_TRANSLATE_NOOP("Core", "Label %1 actions: %2"),
    QT_TRANSLATE_NOOP("Core", "Label %1 actions"),
    QT_TRANSLATE_NOOP("Core", "Clear label, action %1, fighter %2"),
    QT_TRANSLATE_NOOP("Core", "Clear label, %1 actions, fighter %2"),
    QT_TRANSLATE_NOOP("Core", "Accept labels"),
    QT_TRANSLATE_NOOP("Core", "Import labels"),
    QT_TRANSLATE_NOOP("Core", "Merge labels"),
    QT_TRANSLATE_NOOP("Core", "Change vocabulary to %1"),
    QT_TRANSLATE_NOOP("Core", "Change rules"),
    QT_TRANSLATE_NOOP("Core", "Change learning settings"),
    QT_TRANSLATE_NOOP("Core", "Keep model"),
    QT_TRANSLATE_NOOP("Core", "Remove note %1"),
    QT_TRANSLATE_NOOP("Core", "Note %1"),
    QT_TRANSLATE_NOOP("Core", "Accept what rules say"),
    QT_TRANSLATE_NOOP("Core", "Accept 1 label"),
    QT_TRANSLATE_NOOP("Core", "Accept %1 labels"),
    QT_TRANSLATE_NOOP("Core", "at %1, fighter %2"),
    QT_TRANSLATE_NOOP("Core", "A model of two fighters needs a take with two of them."),
    QT_TRANSLATE_NOOP("Core",
                      "No action is labelled yet: label some by hand and let the machine do the "
                      "rest, or import labels."),
    QT_TRANSLATE_NOOP(
        "Core",
        "No transition has the labels of all its three actions: label more of both fighters."),
};

constexpr const char* kNames[] = {
    QT_TRANSLATE_NOOP("Vocabulary", "Left punch"),
    QT_TRANSLATE_NOOP("Vocabulary", "forward"),
    QT_TRANSLATE_NOOP("Vocabulary", "back"),
    QT_TRANSLATE_NOOP("Vocabulary", "back and forward"),
    QT_TRANSLATE_NOOP("Vocabulary", "forward and back"),
    QT_TRANSLATE_NOOP("Vocabulary", "none"),
    QT_TRANSLATE_NOOP("Vocabulary", "Right punch"),
    QT_TRANSLATE_NOOP("Vocabulary", "Left kick"),
    QT_TRANSLATE_NOOP("Vocabulary", "up"),
    QT_TRANSLATE_NOOP("Vocabulary", "down"),
    QT_TRANSLATE_NOOP("Vocabulary", "down and up"),
    QT_TRANSLATE_NOOP("Vocabulary", "Right kick"),
    QT_TRANSLATE_NOOP("Vocabulary", "Jump"),
    QT_TRANSLATE_NOOP("Vocabulary", "React"),
    QT_TRANSLATE_NOOP("Vocabulary", "to a kick"),
    QT_TRANSLATE_NOOP("Vocabulary", "to a punch"),
    QT_TRANSLATE_NOOP("Vocabulary", "Move"),
    QT_TRANSLATE_NOOP("Vocabulary", "left to left"),
    QT_TRANSLATE_NOOP("Vocabulary", "left to right"),
    QT_TRANSLATE_NOOP("Vocabulary", "left to flight"),
    QT_TRANSLATE_NOOP("Vocabulary", "right to left"),
    QT_TRANSLATE_NOOP("Vocabulary", "right to right"),
    QT_TRANSLATE_NOOP("Vocabulary", "right to flight"),
    QT_TRANSLATE_NOOP("Vocabulary", "flight to left"),
    QT_TRANSLATE_NOOP("Vocabulary", "flight to right"),
    QT_TRANSLATE_NOOP("Vocabulary", "flight to flight"),
    QT_TRANSLATE_NOOP("Vocabulary", "nothing"),
};

struct Pattern {
    const char* source;
    QRegularExpression expression;
    QList<int> places;  ///< which %N each group of the expression is
};

Pattern patternOf(const char* source) {
    static const QRegularExpression place(QStringLiteral("%(\\d)"));
    const QString text = QString::fromUtf8(source);
    Pattern pattern{source, {}, {}};
    QString expression;
    qsizetype done = 0;
    for (auto all = place.globalMatch(text); all.hasNext();) {
        const QRegularExpressionMatch match = all.next();
        expression += QRegularExpression::escape(text.mid(done, match.capturedStart() - done));
        expression += QStringLiteral("(.+?)");
        pattern.places.append(match.captured(1).toInt());
        done = match.capturedEnd();
    }
    expression += QRegularExpression::escape(text.mid(done));
    pattern.expression.setPattern(QRegularExpression::anchoredPattern(expression));
    return pattern;
}

/// Those with most letters of their own first: they say most.
const std::vector<Pattern>& patterns() {
    static const std::vector<Pattern> all = [] {
        std::vector<Pattern> made;
        for (const char* text : kTexts)
            made.push_back(patternOf(text));
        std::stable_sort(made.begin(), made.end(), [](const Pattern& a, const Pattern& b) {
            return QString::fromUtf8(a.source).size() - 2 * a.places.size() >
                   QString::fromUtf8(b.source).size() - 2 * b.places.size();
        });
        return made;
    }();
    return all;
}

QString nameWords(const QString& name) {
    return QCoreApplication::translate("Vocabulary", name.toUtf8().constData());
}

bool isName(const QString& text) {
    return std::any_of(std::begin(kNames), std::end(kNames),
                       [&](const char* name) { return text == QLatin1String(name); });
}

/// "left punch forward, jump up" as `spokenLabel` makes it.
QString labelWords(const QString& text) {
    if (isName(text)) return nameWords(text);
    QStringList parts;
    for (const QString& part : text.split(QStringLiteral(", "))) {
        for (const char* name : kNames) {
            const QString aspect = QString::fromUtf8(name);
            const QString rest = part.mid(aspect.size() + 1);
            if (!part.startsWith(aspect + QLatin1Char(' '), Qt::CaseInsensitive) || !isName(rest))
                continue;
            parts.append(vocabularyInText(name) + QLatin1Char(' ') + nameWords(rest));
            break;
        }
    }
    return parts.isEmpty() ? text : parts.join(QStringLiteral(", "));
}

/// Whether what is put in is a text of the core's, too, and no name that a user gave.
bool holdsTexts(const char* source) {
    const QString text = QString::fromUtf8(source);
    return text.startsWith(QLatin1String("Label ")) ||
           text.contains(QLatin1String("boundary %1")) || text.contains(QLatin1String("ote %1"));
}

QString translated(const QString& text) {
    for (const Pattern& pattern : patterns()) {
        const QRegularExpressionMatch match = pattern.expression.match(text);
        if (!match.hasMatch()) continue;
        QString words = QCoreApplication::translate("Core", pattern.source);
        // From the last, so that what is put in is not taken for a place.
        for (qsizetype i = pattern.places.size(); i > 0; --i) {
            const QString part = match.captured(static_cast<int>(i));
            words.replace(QStringLiteral("%%1").arg(pattern.places[i - 1]),
                          holdsTexts(pattern.source) ? translated(part) : part);
        }
        return words;
    }
    return labelWords(text);
}

}  // namespace

QString coreWords(const std::string& text) {
    const QString english = QString::fromStdString(text);
    const QString language = languageInUse();
    if (language == QLatin1String("en")) return english;
    // Lists ask for the same few texts again and again, and jobs beside the window ask, too.
    thread_local QHash<QString, QString> known;
    thread_local QString knownIn;
    if (knownIn != language) known.clear();
    knownIn = language;
    const auto found = known.constFind(english);
    if (found != known.constEnd()) return *found;
    return known[english] = translated(english);
}

QString vocabularyInText(const std::string& name) {
    const QString words = vocabularyWords(name);
    return languageInUse() == QLatin1String("de") ? words : words.toLower();
}

QString vocabularyWords(const std::string& name) {
    return nameWords(QString::fromStdString(name));
}

}  // namespace kumite::studio
