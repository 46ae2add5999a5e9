#pragma once

#include <QLocale>
#include <QString>

#include <vector>

namespace kumite::studio {

/// A language that the window speaks.
struct Language {
    QString code;  ///< "de", "zh_TW": as in translations/kumite_de.ts
    QString name;  ///< in itself: "Deutsch"
};

/// English first.
const std::vector<Language>& languages();
/// The one that suits the system best; "en" where none does.
QString systemLanguage();

/// From now on texts are made in this language, with its numbers and dates; what is shown already
/// stays as it is. Empty: the system's. "pseudo" is no language: every text in strange letters and
/// two fifths longer, to find texts that nobody can translate and places that are too narrow.
void useLanguage(const QString& code);
/// The code in force.
QString languageInUse();

/// For fields of numbers: the language's decimal sign, and no sign between thousands, which would
/// make fifteen of "1.5" where the decimal sign is a comma.
QLocale fieldLocale();

/// "Drücken" of "&Drücken" or "開く" of "開く(&O)": a menu's text without its mark.
QString withoutMnemonic(QString text);

}  // namespace kumite::studio
