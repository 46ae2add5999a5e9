#include "core/labelling/label_phrase.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/labelling/filter_words.h"

namespace kumite {
namespace {

using Words = std::vector<std::string>;

constexpr std::array kNoneWords = {std::string_view("none"), std::string_view("others")};
constexpr std::array kOpenWords = {std::string_view("open"), std::string_view("unknown"),
                                   std::string_view("?")};

Words wordsOfBoth(const std::string& name, const std::string& id) {
    Words words = wordsOf(name);
    for (std::string& word : wordsOf(id))
        words.push_back(std::move(word));
    return words;
}

class Reader {
public:
    Reader(const Vocabulary& vocabulary, const Words& words, std::size_t at)
        : vocabulary_(vocabulary), words_(words), at_(at) {}

    LabelPhrase longest() const {
        std::vector<int> all;
        for (int a = 0; a < vocabulary_.size(); ++a)
            all.push_back(a);
        LabelPhrase best = ofAspects();
        for (const LabelPhrase& alone : {general(), qualifierOf(all, at_)}) {
            if (alone.length > best.length) best = alone;
        }
        return best;
    }

private:
    /// How many words from `from` on spell the qualifier by name or by id; 0: they do not.
    std::size_t spells(std::size_t from, const Qualifier& qualifier) const {
        std::size_t longest = 0;
        for (const std::string& spelling : {qualifier.name, qualifier.id}) {
            const Words words = wordsOf(spelling);
            if (words.size() <= longest || from + words.size() > words_.size()) continue;
            if (std::equal(words.begin(), words.end(),
                           words_.begin() + static_cast<std::ptrdiff_t>(from)))
                longest = words.size();
        }
        return longest;
    }

    /// The longest qualifier from `from` on, of any of these aspects.
    LabelPhrase qualifierOf(const std::vector<int>& aspects, std::size_t from) const {
        LabelPhrase phrase;
        for (const int a : aspects) {
            const auto& qualifiers = vocabulary_[a].qualifiers;
            for (std::size_t q = 0; q < qualifiers.size(); ++q) {
                const std::size_t length = spells(from, qualifiers[q]);
                if (length == 0 || length < phrase.length) continue;
                if (length > phrase.length) phrase.atom.values.clear();
                phrase.length = length;
                phrase.atom.values.emplace_back(a, static_cast<int>(q));
                phrase.atom.words = lowerCase(qualifiers[q].name);
            }
        }
        return phrase;
    }

    /// "right kick", "kick up", "jump none", "react ?": aspects, then what they are.
    LabelPhrase ofAspects() const {
        LabelPhrase phrase;
        std::vector<int> aspects(vocabulary_.aspects.size());
        for (std::size_t a = 0; a < aspects.size(); ++a)
            aspects[a] = static_cast<int>(a);
        std::size_t at = at_;
        for (; at < words_.size(); ++at) {
            std::vector<int> fewer;
            for (const int a : aspects) {
                if (contains(wordsOfBoth(vocabulary_[a].name, vocabulary_[a].id), words_[at]))
                    fewer.push_back(a);
            }
            if (fewer.empty()) break;
            aspects = std::move(fewer);
            phrase.atom.words += (phrase.atom.words.empty() ? "" : " ") + words_[at];
        }
        if (at == at_) return phrase;
        const bool named = at < words_.size();
        if (named && (contains(kOpenWords, words_[at]) || contains(kNoneWords, words_[at]))) {
            const bool open = contains(kOpenWords, words_[at]);
            for (const int a : aspects) {
                if (open || vocabulary_[a].fallback)
                    phrase.atom.values.emplace_back(a, open ? kUnknown : *vocabulary_[a].fallback);
            }
            phrase.atom.words += open ? " open" : " none";
            // "kick none": neither the left nor the right.
            if (!open && !phrase.atom.values.empty()) phrase.atom.kind = FilterAtom::Kind::Nothing;
            phrase.length = at + 1 - at_;
            return phrase;
        }
        if (LabelPhrase said = qualifierOf(aspects, at); said.length > 0) {
            said.atom.words = phrase.atom.words + " " + said.atom.words;
            said.length += at - at_;
            return said;
        }
        for (const int a : aspects)
            addSaid(a, phrase.atom.values);
        phrase.length = at - at_;
        return phrase;
    }

    /// All that an aspect can be but for its fallback.
    void addSaid(int aspect, std::vector<std::pair<int, int>>& values) const {
        for (std::size_t q = 0; q < vocabulary_[aspect].qualifiers.size(); ++q) {
            if (static_cast<int>(q) != vocabulary_[aspect].fallback)
                values.emplace_back(aspect, static_cast<int>(q));
        }
    }

    /// "strike": a limb does something; "attack": toward the opponent; "others": nothing at all.
    LabelPhrase general() const {
        LabelPhrase phrase;
        const std::string& word = words_[at_];
        const bool nothing = contains(kNoneWords, word);
        for (int a = 0; a < vocabulary_.size(); ++a) {
            const Aspect& aspect = vocabulary_[a];
            if (nothing && aspect.fallback) phrase.atom.values.emplace_back(a, *aspect.fallback);
            if (word == "strike" && aspect.limb) addSaid(a, phrase.atom.values);
            for (std::size_t q = 0; word == "attack" && q < aspect.qualifiers.size(); ++q) {
                if (aspect.qualifiers[q].attack)
                    phrase.atom.values.emplace_back(a, static_cast<int>(q));
            }
        }
        if (phrase.atom.values.empty()) return phrase;
        phrase.length = 1;
        phrase.atom.kind = nothing ? FilterAtom::Kind::Nothing : FilterAtom::Kind::Values;
        phrase.atom.words = nothing ? "others" : word;
        return phrase;
    }

    const Vocabulary& vocabulary_;
    const Words& words_;
    std::size_t at_;
};

}  // namespace

LabelPhrase longestLabelPhrase(const Vocabulary& vocabulary, const std::vector<std::string>& words,
                               std::size_t at) {
    return Reader(vocabulary, words, at).longest();
}

}  // namespace kumite
