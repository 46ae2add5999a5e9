#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/labelling/label.h"

namespace kumite {

/// From this confidence on a value of the machine deserves no look; below it is uncertain.
inline constexpr double kSure = 0.8;

/// An action as a filter sees it.
struct FilterSubject {
    int take = 0;      ///< index
    int player = 0;    ///< from 0
    double begin = 0;  ///< seconds on the take's clock
    double end = 0;
    /// One per aspect of the vocabulary: by hand where a hand spoke, else as accepted or proposed.
    std::span<const AspectValue> values;
    bool labelled = false;  ///< something about it stands in the project, said by whomever
};

/// What a filter's words can mean beside those that every filter knows.
struct FilterWords {
    const Vocabulary& vocabulary;
    std::vector<std::string> takes;  ///< names, in the project's order
};

/// One thing asked of an action.
struct FilterAtom {
    enum class Kind {
        Values,      ///< any of `values`
        Nothing,     ///< every aspect that has a fallback is at it
        Sources,     ///< said by one of `sources`
        Confidence,  ///< least confidence in [low, high)
        Player,      ///< `index`
        Take,        ///< `index`
        Begins,      ///< begins in [low, high), seconds
        Contains,    ///< holds the moment `low`
        Lasts,       ///< seconds in [low, high)
        Labelled,    ///< somebody has decided something (`index` 1), or nobody (0)
    };
    Kind kind = Kind::Values;
    bool negated = false;
    std::vector<std::pair<int, int>> values;  ///< aspect and qualifier (or kUnknown)
    std::vector<LabelSource> sources;
    int index = 0;
    double low = 0;
    double high = 0;
    std::string words;  ///< as people read it: "right kick up", "confidence below 0.60"
};

/// Which actions are meant, as people type it: "right kick up, machine, below 0.6", "player 2,
/// jump, uncertain", "kick or punch, not by hand, after 1:20". All parts must hold; commas may be
/// left out; "or" joins two parts, "not" turns the next one round. Source and confidence are those
/// of the aspects that are named, else of all that are known; of several the least counts.
class LabelFilter {
public:
    /// Lets every action through.
    LabelFilter() = default;
    /// `allOf`: all of these, of each any.
    explicit LabelFilter(std::vector<std::vector<FilterAtom>> allOf) : allOf_(std::move(allOf)) {}

    /// What of an action the filter was about.
    struct Match {
        std::vector<int> aspects;                ///< those named and found, else those known
        LabelSource source = LabelSource::Hand;  ///< the least sure of them
        double confidence = 1;                   ///< the least of them
    };
    /// Nothing where the action does not pass.
    std::optional<Match> match(const FilterSubject& action) const;

    bool isEmpty() const { return allOf_.empty(); }
    /// What was understood: "right kick up · by machine · confidence below 0.60".
    std::string text() const;

private:
    std::vector<std::vector<FilterAtom>> allOf_;
};

/// Reads what was typed. Throws Error: one sentence with the word that it does not know and the
/// one that may have been meant.
LabelFilter parseLabelFilter(const FilterWords& words, std::string_view typed);

/// What could stand instead of the part that is being typed, each with what stands before it: the
/// whole text to go on with. At most `most`.
std::vector<std::string> completeLabelFilter(const FilterWords& words, std::string_view typed,
                                             int most = 12);

}  // namespace kumite
