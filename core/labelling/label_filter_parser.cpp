#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/labelling/filter_words.h"
#include "core/labelling/label_filter.h"
#include "core/labelling/label_phrase.h"

namespace kumite {
namespace {

using Kind = FilterAtom::Kind;
using Words = std::vector<std::string>;

constexpr double kEver = std::numeric_limits<double>::infinity();

/// One word for several: what people also type.
struct Synonym {
    std::string_view typed;
    std::string_view meant;
};
constexpr std::array kComparisons = {Synonym{"below", "<"}, Synonym{"under", "<"},
                                     Synonym{"above", ">"}, Synonym{"over", ">"},
                                     Synonym{"<", "<"},     Synonym{">", ">"}};
constexpr std::array kLengths = {Synonym{"longer", ">"}, Synonym{"shorter", "<"}};
constexpr std::array kSourceWords = {Synonym{"hand", "hand"},       Synonym{"mine", "hand"},
                                     Synonym{"rule", "rule"},       Synonym{"rules", "rule"},
                                     Synonym{"machine", "machine"}, Synonym{"learnt", "machine"}};
constexpr std::array kSkipped = {std::string_view("and"), std::string_view("with"),
                                 std::string_view("the"), std::string_view("by"),
                                 std::string_view("is"),  std::string_view("confidence")};
template <typename List>
std::optional<std::string_view> meaning(const List& list, std::string_view word) {
    for (const Synonym& each : list) {
        if (each.typed == word) return each.meant;
    }
    return std::nullopt;
}

std::string quoted(std::string_view word) {
    return "\"" + std::string(word) + "\"";
}

class Parser {
public:
    Parser(const FilterWords& known, std::string_view typed)
        : known_(known), vocabulary_(known.vocabulary), words_(wordsOf(typed)) {}

    LabelFilter parse() {
        while (at_ < words_.size()) {
            if (take(kFilterBreak) || takeAny(kSkipped)) continue;
            const bool joined = take("or");
            if (joined && allOf_.empty()) throw Error("Nothing stands before \"or\".");
            if (joined && at_ == words_.size()) throw Error("Nothing stands after \"or\".");
            FilterAtom atom = part();
            if (joined) {
                allOf_.back().push_back(std::move(atom));
            } else {
                allOf_.push_back({std::move(atom)});
            }
        }
        return LabelFilter(std::move(allOf_));
    }

private:
    bool is(std::string_view word) const { return at_ < words_.size() && words_[at_] == word; }
    bool take(std::string_view word) {
        if (!is(word)) return false;
        ++at_;
        return true;
    }
    template <typename List>
    bool takeAny(const List& list) {
        if (at_ == words_.size() || !contains(list, words_[at_])) return false;
        ++at_;
        return true;
    }
    std::string next() { return at_ < words_.size() ? words_[at_++] : std::string(); }

    FilterAtom part() {
        bool negated = false;
        while (at_ < words_.size()) {
            if (is("not") || is("no") || is("without")) {
                negated = !negated;
                ++at_;
            } else if (!takeAny(kSkipped)) {
                break;
            }
        }
        if (at_ == words_.size() || is(kFilterBreak))
            throw Error("Something is missing after \"not\".");
        for (const auto& reader : {&Parser::label, &Parser::source, &Parser::confidence,
                                   &Parser::time, &Parser::place, &Parser::state}) {
            if (auto atom = (this->*reader)()) {
                atom->negated = atom->negated != negated;
                return std::move(*atom);
            }
        }
        throw unknown(words_[at_]);
    }

    // ---- labels ----

    std::optional<FilterAtom> label() {
        LabelPhrase phrase = longestLabelPhrase(vocabulary_, words_, at_);
        if (phrase.length == 0) return std::nullopt;
        at_ += phrase.length;
        return std::move(phrase.atom);
    }

    // ---- who said it, and how surely ----

    std::optional<FilterAtom> source() {
        const auto meant = meaning(kSourceWords, words_[at_]);
        if (!meant) return std::nullopt;
        ++at_;
        FilterAtom atom;
        atom.kind = Kind::Sources;
        atom.sources = {*sourceFromName(*meant)};
        atom.words = "by " + std::string(*meant);
        return atom;
    }

    double share(std::string_view after) {
        std::string word = next();
        const bool percent = word.ends_with('%');
        if (percent) word.pop_back();
        auto value = parseNumber(word);
        const bool percentApart = value && take("%");
        if (value && (percent || percentApart)) *value /= 100;
        if (!value || *value < 0 || *value > 1) {
            throw Error("After " + quoted(after) +
                        " a confidence is expected, such as 0.6 or 60 %" +
                        (word.empty() ? "." : ", not " + quoted(word) + "."));
        }
        return *value;
    }

    static FilterAtom confidenceIn(double low, double high, std::string words) {
        FilterAtom atom;
        atom.kind = Kind::Confidence;
        atom.low = low;
        atom.high = high;
        atom.words = std::move(words);
        return atom;
    }

    std::optional<FilterAtom> confidence() {
        const std::string word = words_[at_];
        if (word == "uncertain" || word == "unsure") {
            ++at_;
            return confidenceIn(0, kSure, "uncertain");
        }
        if (word == "sure" || word == "certain") {
            ++at_;
            return confidenceIn(kSure, kEver, "sure");
        }
        const auto comparison = meaning(kComparisons, word);
        if (!comparison) {
            if (const auto number = parseNumber(word)) {
                throw Error("Say whether the confidence is \"below " + word + "\" or \"above " +
                            word + "\".");
            }
            return std::nullopt;
        }
        ++at_;
        const double limit = share(word);
        return *comparison == "<"
                   ? confidenceIn(0, limit, "confidence below " + fixed(limit, 2))
                   : confidenceIn(limit, kEver, "confidence above " + fixed(limit, 2));
    }

    // ---- when ----

    double seconds(std::string_view after, const char* example = "1:20 or 80 s") {
        const std::string word = next();
        const bool milliseconds = word.ends_with("ms");
        auto value = milliseconds ? parseNumber(std::string_view(word).substr(0, word.size() - 2))
                                  : secondsOf(word);
        if (!value) {
            throw Error("After " + quoted(after) + " a time is expected, such as " + example +
                        (word.empty() ? "." : ", not " + quoted(word) + "."));
        }
        const bool apart = !milliseconds && take("ms");
        if (milliseconds || apart) return *value / 1000;
        for (const char* unit : {"s", "sec", "second", "seconds"}) {
            if (take(unit)) return *value;
        }
        return take("min") || take("minutes") ? 60 * *value : *value;
    }

    std::optional<FilterAtom> time() {
        const std::string word = words_[at_];
        FilterAtom atom;
        atom.kind = Kind::Begins;
        atom.high = kEver;
        if (take("after")) {
            atom.low = seconds(word);
            atom.words = "after " + timeWords(atom.low);
        } else if (take("before")) {
            atom.high = seconds(word);
            atom.words = "before " + timeWords(atom.high);
        } else if (take("at")) {
            atom.kind = Kind::Contains;
            atom.low = seconds(word);
            atom.words = "at " + timeWords(atom.low);
        } else if (take("from") || take("between")) {
            atom.low = seconds(word);
            if (!take("to") && !take("and") && !take("-")) {
                throw Error("After " + quoted(word) +
                            " two times are expected, such as 0:30 to "
                            "1:00.");
            }
            atom.high = seconds("to");
            if (atom.high < atom.low) std::swap(atom.low, atom.high);
            atom.words = "from " + timeWords(atom.low) + " to " + timeWords(atom.high);
        } else if (const auto length = meaning(kLengths, word)) {
            ++at_;
            take("than");
            atom.kind = Kind::Lasts;
            const double limit = seconds(word, "0.5 s or 300 ms");
            (*length == "<" ? atom.high : atom.low) = limit;
            atom.words = word + " than " + fixed(limit, 2) + " s";
        } else {
            return std::nullopt;
        }
        return atom;
    }

    // ---- where ----

    std::optional<FilterAtom> place() {
        FilterAtom atom;
        std::string word = words_[at_];
        if (word == "p1" || word == "p2") {
            ++at_;
            atom.index = word == "p1" ? 0 : 1;
        } else if (take("player") || take("fighter")) {
            const std::string number = next();
            const auto value = parseInteger(number);
            if (!value || *value < 1 || *value > 2) {
                throw Error("After " + quoted(word) + " 1 or 2 is expected" +
                            (number.empty() ? "." : ", not " + quoted(number) + "."));
            }
            atom.index = *value - 1;
        } else if (take("take")) {
            return takeNamed();
        } else {
            return std::nullopt;
        }
        atom.kind = Kind::Player;
        atom.words = "fighter " + std::to_string(atom.index + 1);
        return atom;
    }

    FilterAtom takeNamed() {
        FilterAtom atom;
        atom.kind = Kind::Take;
        std::size_t longest = 0;
        const auto compare = [&](std::size_t t, const Words& name) {
            if (name.size() <= longest || at_ + name.size() > words_.size()) return;
            if (!std::equal(name.begin(), name.end(),
                            words_.begin() + static_cast<std::ptrdiff_t>(at_)))
                return;
            longest = name.size();
            atom.index = static_cast<int>(t);
        };
        for (std::size_t t = 0; t < known_.takes.size(); ++t) {
            compare(t, wordsOf(known_.takes[t]));
            compare(t, {lowerCase(known_.takes[t])});
        }
        for (std::size_t t = 0; longest == 0 && t < known_.takes.size(); ++t)
            compare(t, {std::to_string(t + 1)});
        if (longest == 0) {
            std::string names;
            for (const std::string& name : known_.takes)
                names += (names.empty() ? "" : ", ") + name;
            throw Error((at_ < words_.size() ? "There is no take " + quoted(words_[at_])
                                             : std::string("Say which take")) +
                        "; the takes are " + names + ".");
        }
        at_ += longest;
        atom.words = "take " + known_.takes[static_cast<std::size_t>(atom.index)];
        return atom;
    }

    std::optional<FilterAtom> state() {
        FilterAtom atom;
        atom.kind = Kind::Labelled;
        atom.words = "labelled";
        atom.index = 1;
        if (take("labelled") || take("labeled") || take("label")) return atom;
        atom.words = "unlabelled";
        atom.index = 0;
        if (take("unlabelled") || take("unlabeled") || take("open")) return atom;
        return std::nullopt;
    }

    /// All single words that mean something, for "did you mean".
    std::set<std::string> dictionary() const {
        std::set<std::string> all;
        const auto add = [&](const std::string& text) {
            for (std::string& word : wordsOf(text)) {
                if (word.size() > 1 && !(word.front() >= '0' && word.front() <= '9'))
                    all.insert(std::move(word));
            }
        };
        for (const Aspect& aspect : vocabulary_.aspects) {
            add(aspect.name);
            add(aspect.id);
            for (const Qualifier& qualifier : aspect.qualifiers) {
                add(qualifier.name);
                add(qualifier.id);
            }
        }
        for (const char* part : kFilterParts)
            add(part);
        all.insert({"take", "or", "not", "fighter", "between", "under", "over"});
        return all;
    }

    Error unknown(const std::string& word) const {
        std::string nearest;
        int least = word.size() > 4 ? 3 : 2;
        for (const std::string& each : dictionary()) {
            const int distance = editDistance(word, each);
            if (distance >= least) continue;
            least = distance;
            nearest = each;
        }
        std::string text = quoted(word) + " is no word that the filter knows";
        text += nearest.empty() ? ": it knows aspects and qualifiers, sources, confidences, "
                                  "fighters, takes and times."
                                : "; did you mean " + quoted(nearest) + "?";
        return Error(text);
    }

    const FilterWords& known_;
    const Vocabulary& vocabulary_;
    Words words_;
    std::size_t at_ = 0;
    std::vector<std::vector<FilterAtom>> allOf_;
};

}  // namespace

LabelFilter parseLabelFilter(const FilterWords& words, std::string_view typed) {
    return Parser(words, typed).parse();
}

}  // namespace kumite
