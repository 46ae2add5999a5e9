#include "core/labelling/filter_words.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/labelling/label_filter.h"

namespace kumite {
namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

std::vector<std::string> wordsOf(std::string_view typed) {
    std::vector<std::string> words;
    std::string word;
    bool quoted = false;
    const auto end = [&] {
        if (!word.empty()) words.push_back(lowerCase(word));
        word.clear();
    };
    for (std::size_t i = 0; i < typed.size(); ++i) {
        const char c = typed[i];
        const bool betweenDigits =
            i > 0 && isDigit(typed[i - 1]) && i + 1 < typed.size() && isDigit(typed[i + 1]);
        if (c == '"') {
            quoted = !quoted;
            end();
        } else if (quoted) {
            word += c;
        } else if (c == ',' || c == ';' || c == '+') {
            end();
            words.emplace_back(kFilterBreak);
        } else if (c == ' ' || c == '\t' || c == '_' || (c == ':' && !betweenDigits)) {
            end();
        } else if (c == '<' || c == '>') {
            end();
            words.emplace_back(1, c);
        } else if (c != '=') {
            word += c;
        }
    }
    end();
    return words;
}

int editDistance(std::string_view a, std::string_view b) {
    std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = static_cast<int>(i + j);
                continue;
            }
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1,
                                d[i - 1][j - 1] + (a[i - 1] != b[j - 1] ? 1 : 0)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

std::optional<double> secondsOf(std::string_view text) {
    double seconds = 0;
    if (text.ends_with('s')) text.remove_suffix(1);
    const auto parts = split(text, ':');
    if (parts.size() > 3) return std::nullopt;
    for (const std::string_view part : parts) {
        const auto number = parseNumber(part);
        if (!number || *number < 0) return std::nullopt;
        seconds = 60 * seconds + *number;
    }
    return seconds;
}

std::string timeWords(double seconds) {
    const int minutes = static_cast<int>(seconds / 60);
    std::string rest = fixed(seconds - 60 * minutes, 2);
    while (rest.back() == '0')
        rest.pop_back();
    if (rest.back() == '.') rest.pop_back();
    if (rest.size() < 2 || rest[1] == '.') rest.insert(0, "0");
    return std::to_string(minutes) + ":" + rest;
}

std::vector<std::string> completeLabelFilter(const FilterWords& words, std::string_view typed,
                                             int most) {
    const auto comma = typed.rfind(',');
    const std::string_view tail =
        trimmed(comma == std::string_view::npos ? typed : typed.substr(comma + 1));
    std::string before(comma == std::string_view::npos ? std::string_view()
                                                       : typed.substr(0, comma + 1));
    if (!before.empty()) before += " ";
    std::vector<std::string> parts;
    for (const Aspect& aspect : words.vocabulary.aspects) {
        parts.push_back(lowerCase(aspect.name));
        for (const Qualifier& qualifier : aspect.qualifiers)
            parts.push_back(lowerCase(aspect.name + " " + qualifier.name));
    }
    parts.insert(parts.end(), kFilterParts.begin(), kFilterParts.end());
    if (words.takes.size() > 1) {
        for (const std::string& take : words.takes)
            parts.push_back("take " + take);
    }
    const std::string wanted = lowerCase(tail);
    std::vector<std::string> found;
    // First what begins so, then what has a word that does.
    for (const bool within : {false, true}) {
        for (const std::string& part : parts) {
            const bool begins = lowerCase(part).starts_with(wanted);
            const bool has = lowerCase(part).find(" " + wanted) != std::string::npos;
            if (within ? begins || !has : !begins) continue;
            if (static_cast<int>(found.size()) < most) found.push_back(before + part);
        }
    }
    return found;
}

}  // namespace kumite
