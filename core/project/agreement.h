#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/labelling/scores.h"
#include "core/project/labels.h"

namespace kumite {

/// Which values of two label sets are held against each other.
enum class Compared {
    ByHand,   ///< what people said: the agreement of two people
    Anybody,  ///< rules and machine as well
};

/// How far two people agree on one aspect, over the actions of which both said something about it.
struct AspectAgreement {
    int both = 0;  ///< actions that both judged
    int same = 0;
    /// Cohen's κ; nothing where no action was judged by both. 1 where both always said the same
    /// single thing.
    std::optional<double> kappa;
    JudgementTable counts;  ///< over the aspect's qualifiers
};

/// A value on which the two differ.
struct LabelDifference {
    FighterAddress fighter;
    int action = 0;
    int aspect = 0;
    int first = kUnknown;  ///< qualifier; kUnknown: only the other one said something
    int second = kUnknown;

    bool conflict() const { return first != kUnknown && second != kUnknown; }
    bool operator==(const LabelDifference&) const = default;
};

/// Two label sets of the same project held against each other.
struct Agreement {
    std::vector<AspectAgreement> aspects;  ///< one per aspect of the vocabulary
    int both = 0;                          ///< actions that both labelled
    int same = 0;                          ///< … and agree on every aspect that both judged
    int onlyFirst = 0;                     ///< actions that one of them alone labelled
    int onlySecond = 0;
    /// Pooled κ over all aspects; nothing where no value was judged by both.
    std::optional<double> kappa;
    /// Where the two differ on an action that both labelled, by fighter, action and aspect.
    std::vector<LabelDifference> differences;
    /// What the second said of the `onlySecond` actions, in the same order; `first` is unknown.
    std::vector<LabelDifference> additions;
};

/// Both sets are labels per action as actionLabels and matchLabels give them, for `project` as it
/// is cut now; a fighter that one of them leaves out has no labels there. Throws Error where a set
/// belongs to another segmentation.
Agreement compareLabels(const Project& project, const Analysis& analysis,
                        std::span<const FighterLabels> first, std::span<const FighterLabels> second,
                        Compared compared = Compared::ByHand);

/// The project's own labels, of one take or of all, in the form that is compared.
std::vector<FighterLabels> ownLabels(const Project& project, const Analysis& analysis,
                                     std::optional<int> take = {});

/// Takes over the second value of every difference, as said by a hand, in one step. Where the
/// second said nothing, the first value stays.
MaybeEdit takeOverLabels(const Project& project, const Analysis& analysis,
                         std::span<const LabelDifference> chosen);

/// The differences as a table: take,player,action,begin_s,end_s,aspect,first,second. Actions count
/// from 0; an empty value was not given.
std::string differencesCsv(const Project& project, const Analysis& analysis,
                           std::span<const LabelDifference> differences);

}  // namespace kumite
