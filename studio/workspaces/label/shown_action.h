#pragma once

#include <optional>

#include "core/labelling/label_filter.h"
#include "core/labelling/learner.h"
#include "core/project/project.h"

namespace kumite::studio {

/// How a value of an aspect stands: nobody spoke, the machine or a rule proposes it, it was
/// accepted from them, a hand said it.
enum class Standing { Open, Proposed, Accepted, Hand };

/// One aspect of an action as it is shown: by hand, else as accepted, else as proposed.
struct ShownAspect {
    AspectValue value;
    Standing standing = Standing::Open;
    /// What the machine says of it now, whoever else spoke, with its two best qualifiers. Unknown
    /// where it has learnt nothing, and of aspects that rules decide.
    Prediction prediction;

    /// A value of machine or rule that deserves a look: its confidence is low, or not known yet
    /// and the margin is small.
    bool isUncertain() const;
    /// The document knows it.
    bool isKept() const { return standing == Standing::Hand || standing == Standing::Accepted; }
};

/// An action as the Label workspace shows it.
struct ShownAction {
    FighterAddress fighter;
    int index = 0;  ///< among the fighter's actions
    int peak = 0;
    int row = -1;                      ///< of the learnt ground's table; -1: not known to it
    std::vector<ShownAspect> aspects;  ///< one per aspect of the vocabulary

    Label label() const;   ///< as shown
    Label byHand() const;  ///< what a hand said; else unknown
    bool anyByHand() const;
    bool anyAccepted() const;
    bool isSettled() const;  ///< the document knows every aspect
    /// Some learnt aspect is neither said by a hand nor accepted: to be asked about.
    bool isOpen(const Vocabulary& vocabulary) const;
    /// The smallest confidence among the values that no hand said; 1 where there is none.
    double confidence() const;
    /// The smallest margin over what the machine has learnt; infinity where that is nothing.
    double margin() const;
};

/// The whole label that comes next: with the second best qualifier where the margin is smallest.
/// All unknown where the machine has learnt nothing.
Label secondBest(const Vocabulary& vocabulary, const ShownAction& action);

/// How probable the machine holds a whole label: the least over the learnt aspects that no hand
/// named. Of the shown label it is never below that of the second best. 0 as long as it is not
/// known; nothing where the machine has seen a single class of each: it cannot tell.
std::optional<double> probabilityOf(const Vocabulary& vocabulary, const ShownAction& action,
                                    const Label& label);

}  // namespace kumite::studio
