#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/labelling/vocabulary.h"

namespace kumite {

/// What an action is: the index of a qualifier per aspect of the vocabulary; kUnknown where nobody
/// has said anything yet. Orders and compares element by element.
using Label = std::vector<int>;
inline constexpr int kUnknown = -1;

/// Nothing of anything: every aspect at its fallback, those without one unknown.
Label othersLabel(const Vocabulary& vocabulary);

/// A label as people spell it: the aspects that are not at their fallback (and known), joined by
/// `+`: `right_punch:fwd+move:L-R`. "others" if none is left. With `openToo` unknown aspects that
/// have a fallback are spelled `jump:?`, so that parseLabel gives back the same label.
std::string labelText(const Vocabulary& vocabulary, const Label& label, bool openToo = false);
/// The same in the words that people read: "left punch forward, right kick up"; "nothing".
std::string spokenLabel(const Vocabulary& vocabulary, const Label& label);

/// The label that a spelling means; aspects that it leaves out are at their fallback, `jump:?` is
/// unknown. Throws Error that says which word is not in the vocabulary.
Label parseLabel(const Vocabulary& vocabulary, std::string_view text);

/// The label of the same action seen in a mirror.
Label mirroredLabel(const Vocabulary& vocabulary, const Label& label);

/// Pairs of aspects that exclude each other and are both not at their fallback, as sentences.
std::vector<std::string> conflicts(const Vocabulary& vocabulary, const Label& label);

/// Who said it. A hand is never overruled by a rule or a machine.
enum class LabelSource : std::uint8_t { Hand, Rule, Machine };
std::string_view sourceName(LabelSource source);
std::optional<LabelSource> sourceFromName(std::string_view name);

/// One aspect of an action's label, with its source.
struct AspectValue {
    std::int8_t qualifier = kUnknown;
    LabelSource source = LabelSource::Machine;
    float confidence = 0;  ///< 0 … 1; 1 where a hand said it

    bool known() const { return qualifier != kUnknown; }
    bool byHand() const { return known() && source == LabelSource::Hand; }
    bool operator==(const AspectValue&) const = default;
};

/// What is said about the action whose force peak is at frame `peak` (of the take): one value per
/// aspect of the vocabulary.
struct ActionLabel {
    int peak = 0;
    std::vector<AspectValue> aspects;

    Label label() const;
    bool anyKnown() const;
    bool anyByHand() const;
    bool operator==(const ActionLabel&) const = default;
};

/// All labels of a fighter, in order of their peaks, no two with the same one. Labels stay where
/// they are when boundaries move.
using LabelTrack = std::vector<ActionLabel>;

}  // namespace kumite
