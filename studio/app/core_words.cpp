#include "studio/app/core_words.h"

#include <QCoreApplication>
#include <QHash>
#include <QMap>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <vector>

#include "studio/app/core_texts.h"
#include "studio/app/language.h"

namespace kumite::studio {

namespace {

struct Pattern {
    CoreText text;
    QString begin;  ///< what precedes the first place
    QRegularExpression expression;
    QList<int> places;        ///< which %N each group of the expression is
    QList<qsizetype> quoted;  ///< groups in quotes: names, which stay
    qsizetype letters;        ///< of its own
};

const QRegularExpression& placeExpression() {
    static const QRegularExpression place(QStringLiteral("%(\\d)"));
    return place;
}

Pattern patternOf(const CoreText& of) {
    const QString text = QString::fromUtf8(of.source);
    Pattern pattern{of, {}, {}, {}, {}, 0};
    QString expression;
    qsizetype done = 0;
    for (auto all = placeExpression().globalMatch(text); all.hasNext();) {
        const QRegularExpressionMatch match = all.next();
        expression += QRegularExpression::escape(text.mid(done, match.capturedStart() - done));
        expression += QStringLiteral("(.+?)");
        if (pattern.places.isEmpty()) pattern.begin = text.left(match.capturedStart());
        if (match.capturedStart() > 0 && text[match.capturedStart() - 1] == QLatin1Char('"'))
            pattern.quoted.append(pattern.places.size());
        pattern.places.append(match.captured(1).toInt());
        done = match.capturedEnd();
    }
    if (pattern.places.isEmpty()) pattern.begin = text;
    expression += QRegularExpression::escape(text.mid(done));
    pattern.expression.setPattern(QRegularExpression::anchoredPattern(expression));
    pattern.letters = text.size() - 4 * pattern.places.size();
    return pattern;
}

using Patterns = std::vector<Pattern>;

/// Those with most letters of their own first: they say most.
Patterns patternsOf(std::span<const CoreText> texts) {
    Patterns made;
    for (const CoreText& text : texts)
        made.push_back(patternOf(text));
    std::stable_sort(made.begin(), made.end(),
                     [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
    return made;
}

const Patterns& editPatterns() {
    static const Patterns all = patternsOf(editTexts());
    return all;
}

const Patterns& sentencePatterns() {
    static const Patterns all = patternsOf(sentenceTexts());
    return all;
}

QString nameWords(const QString& name) {
    return QCoreApplication::translate("Vocabulary", name.toUtf8().constData());
}

bool isName(const QString& text) {
    const auto names = vocabularyNames();
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return text == QLatin1String(name); });
}

/// "left punch forward, jump up" as `spokenLabel` makes it.
QString labelWords(const QString& text) {
    if (isName(text)) return nameWords(text);
    QStringList parts;
    for (const QString& part : text.split(QStringLiteral(", "))) {
        for (const char* name : vocabularyNames()) {
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

QString translated(const QString& text);
QString partWords(const QString& part);

std::optional<QString> matched(const Patterns& patterns, const QString& text) {
    for (const Pattern& pattern : patterns) {
        if (!text.startsWith(pattern.begin)) continue;
        const QRegularExpressionMatch match = pattern.expression.match(text);
        if (!match.hasMatch()) continue;
        QMap<int, QString> parts;
        for (qsizetype i = 0; i < pattern.places.size(); ++i) {
            const QString part = match.captured(static_cast<int>(i) + 1);
            parts[pattern.places[i]] = pattern.text.holdsTexts      ? translated(part)
                                       : pattern.quoted.contains(i) ? part
                                                                    : partWords(part);
        }
        // In one pass: what is put in may itself hold a "%1".
        const QString words = QCoreApplication::translate("Core", pattern.text.source);
        QString said;
        qsizetype done = 0;
        for (auto all = placeExpression().globalMatch(words); all.hasNext();) {
            const QRegularExpressionMatch place = all.next();
            said += words.mid(done, place.capturedStart() - done) +
                    parts.value(place.captured(1).toInt());
            done = place.capturedEnd();
        }
        return said + words.mid(done);
    }
    return std::nullopt;
}

/// "bout.bvh:12:4: found …": what precedes a known sentence stays.
std::optional<QString> matchedBehindPlace(const QString& text) {
    static const QString colon = QStringLiteral(": ");
    for (qsizetype at = text.indexOf(colon); at >= 0; at = text.indexOf(colon, at + 1)) {
        const qsizetype begin = at + colon.size();
        if (const auto words = matched(sentencePatterns(), text.mid(begin)))
            return text.left(begin) + *words;
    }
    return std::nullopt;
}

/// "left_wrist, right_wrist": ids of roles. A single word may as well be a joint's own name.
std::optional<QString> rolesOf(const QString& text) {
    if (!text.contains(QLatin1Char('_')) && !text.contains(QLatin1String(", ")))
        return std::nullopt;
    QStringList words;
    for (const QString& id : text.split(QStringLiteral(", "))) {
        const auto role = roleFromName(id.toStdString());
        if (!role) return std::nullopt;
        words.append(roleWords(*role));
    }
    return words.join(QStringLiteral(", "));
}

/// What is put into a sentence: another sentence, roles, or names that stay.
QString partWords(const QString& part) {
    if (const auto words = matched(sentencePatterns(), part)) return *words;
    if (const auto words = matchedBehindPlace(part)) return *words;
    return rolesOf(part).value_or(part);
}

QString translated(const QString& text) {
    if (const auto words = matched(editPatterns(), text)) return *words;
    if (const auto words = matched(sentencePatterns(), text)) return *words;
    if (const auto words = matchedBehindPlace(text)) return *words;
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

QString shortWords(const Qualifier& qualifier) {
    return QCoreApplication::translate("ShortLabel", qualifier.id.c_str());
}

QString roleWords(Role role) {
    std::string name(roleName(role));
    std::replace(name.begin(), name.end(), '_', ' ');
    return QCoreApplication::translate("Role", name.c_str());
}

}  // namespace kumite::studio
