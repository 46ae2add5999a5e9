#include "studio/app/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include <algorithm>
#include <memory>

namespace kumite::studio {

namespace {

/// Letters that read as themselves and are none of English.
QChar strange(QChar letter) {
    static const QString from = QStringLiteral("aceinosuyACEINOSUY");
    static const QString to = QStringLiteral("áçéíñóšúýÁÇÉÍÑÓŠÚÝ");
    const auto at = from.indexOf(letter);
    return at < 0 ? letter : to[at];
}

class PseudoTranslator : public QTranslator {
public:
    bool isEmpty() const override { return false; }

    QString translate(const char*, const char* source, const char*, int) const override {
        const QString text = QString::fromUtf8(source);
        // Placeholders, marks of menus, tags and key names stay.
        static const QRegularExpression kept(
            QStringLiteral("%n|%L?\\d+|&\\w|<[^>]*>|\\{[^}]*\\}|&\\w+;"));
        QString made;
        qsizetype done = 0;
        auto all = kept.globalMatch(text);
        const auto take = [&](qsizetype end) {
            for (; done < end; ++done)
                made += strange(text[done]);
        };
        while (all.hasNext()) {
            const QRegularExpressionMatch match = all.next();
            take(match.capturedStart());
            made += match.captured();
            done = match.capturedEnd();
        }
        take(text.size());
        const auto more = std::max<qsizetype>(1, 2 * text.trimmed().size() / 5);
        qsizetype end = made.size();
        while (end > 0 && made[end - 1].isSpace())
            --end;
        return made.insert(end, QString(more, QLatin1Char('~')));
    }
};

struct Installed {
    QString code = QStringLiteral("en");
    std::vector<std::unique_ptr<QTranslator>> translators;
};

Installed& installed() {
    static Installed all;
    return all;
}

void install(std::unique_ptr<QTranslator> translator) {
    QCoreApplication::installTranslator(translator.get());
    installed().translators.push_back(std::move(translator));
}

void installFile(const QString& name, const QString& folder) {
    auto translator = std::make_unique<QTranslator>();
    if (translator->load(name, folder)) install(std::move(translator));
}

}  // namespace

const std::vector<Language>& languages() {
    static const std::vector<Language> all = {
        {QStringLiteral("en"), QStringLiteral("English")},
        {QStringLiteral("de"), QStringLiteral("Deutsch")},
        {QStringLiteral("fr"), QStringLiteral("Français")},
        {QStringLiteral("ja"), QStringLiteral("日本語")},
        {QStringLiteral("ko"), QStringLiteral("한국어")},
        {QStringLiteral("zh_TW"), QStringLiteral("繁體中文")}};
    return all;
}

QString systemLanguage() {
    // "zh-Hant-TW", "zh-TW" and "de-AT" all name one of ours.
    const QStringList wished = QLocale::system().uiLanguages();
    for (const QString& wish : wished) {
        const QString language = wish.section(QLatin1Char('-'), 0, 0);
        for (const Language& ours : languages()) {
            if (ours.code.section(QLatin1Char('_'), 0, 0) == language) return ours.code;
        }
    }
    return QStringLiteral("en");
}

void useLanguage(const QString& code) {
    for (const auto& translator : installed().translators)
        QCoreApplication::removeTranslator(translator.get());
    installed().translators.clear();
    const QString wanted = code.isEmpty() ? systemLanguage() : code;
    installed().code = wanted;
    // In English numbers stay as they are written in files, wherever the machine is.
    QLocale::setDefault(wanted == QLatin1String("en") || wanted == QLatin1String("pseudo")
                            ? QLocale::c()
                            : QLocale(wanted));
    if (wanted == QLatin1String("pseudo")) {
        install(std::make_unique<PseudoTranslator>());
        return;
    }
    // Qt's own texts (Open, Cancel, names of keys) first: ours win.
    installFile(QStringLiteral("qtbase_") + wanted,
                QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    installFile(QStringLiteral("kumite_") + wanted, QStringLiteral(":/translations"));
}

QString languageInUse() {
    return installed().code;
}

QLocale fieldLocale() {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    return locale;
}

QString withoutMnemonic(QString text) {
    static const QRegularExpression inBrackets(QStringLiteral("\\s?\\(&\\w\\)"));
    return text.remove(inBrackets).remove(QLatin1Char('&'));
}

}  // namespace kumite::studio
