#include "studio/app/fuzzy_match.h"

#include <QStringList>

#include <algorithm>

namespace kumite::studio {

namespace {

constexpr int kLetter = 1;
constexpr int kRun = 9;        ///< follows the letter before
constexpr int kWordBegin = 8;  ///< begins a word
constexpr int kNone = -1'000'000;

/// The best way to find one word's letters, by dynamic programming over (letter, place).
std::optional<FuzzyMatch> matchWord(const QString& word, const QString& text) {
    const auto letters = static_cast<std::size_t>(word.size());
    const auto places = static_cast<std::size_t>(text.size());
    if (letters > places) return std::nullopt;
    // best[i][j]: letters 0..i found, letter i at place j; from[i][j]: place of letter i − 1.
    std::vector<std::vector<int>> best(letters, std::vector<int>(places, kNone));
    std::vector<std::vector<int>> from(letters, std::vector<int>(places, -1));
    for (std::size_t i = 0; i < letters; ++i) {
        int before = kNone;  // the best of the letter before, further left than one place
        int beforeAt = -1;
        for (std::size_t j = i; j < places; ++j) {
            if (i > 0 && j >= 2 && best[i - 1][j - 2] > before) {
                before = best[i - 1][j - 2];
                beforeAt = static_cast<int>(j) - 2;
            }
            const auto at = static_cast<qsizetype>(j);
            if (text[at] != word[static_cast<qsizetype>(i)]) continue;
            const bool begins = j == 0 || !text[at - 1].isLetterOrNumber();
            const int own = kLetter + (begins ? kWordBegin : 0);
            if (i == 0) {
                best[i][j] = own;
                continue;
            }
            const int run = j > 0 ? best[i - 1][j - 1] + kRun : kNone;
            if (std::max(run, before) < 0) continue;
            best[i][j] = own + std::max(run, before);
            from[i][j] = run >= before ? static_cast<int>(j) - 1 : beforeAt;
        }
    }
    const auto& last = best.back();
    const auto top = std::max_element(last.begin(), last.end());
    if (*top < 0) return std::nullopt;
    FuzzyMatch match{*top, {}};
    auto place = static_cast<int>(top - last.begin());
    for (std::size_t i = letters; i-- > 0;) {
        match.positions.push_back(place);
        place = from[i][static_cast<std::size_t>(place)];
    }
    std::reverse(match.positions.begin(), match.positions.end());
    return match;
}

}  // namespace

std::optional<FuzzyMatch> fuzzyMatch(const QString& typed, const QString& text) {
    FuzzyMatch whole;
    const QString lower = text.toLower();
    for (const QString& word : typed.toLower().split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        const auto match = matchWord(word, lower);
        if (!match) return std::nullopt;
        whole.score += match->score;
        whole.positions.insert(whole.positions.end(), match->positions.begin(),
                               match->positions.end());
    }
    std::sort(whole.positions.begin(), whole.positions.end());
    whole.positions.erase(std::unique(whole.positions.begin(), whole.positions.end()),
                          whole.positions.end());
    return whole;
}

}  // namespace kumite::studio
