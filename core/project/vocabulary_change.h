#pragma once

#include <string>
#include <vector>

#include "core/project/project.h"

namespace kumite {

/// Values of one aspect that another vocabulary has no word for.
struct VocabularyLoss {
    std::string aspect;     ///< name in the old vocabulary
    std::string qualifier;  ///< name; empty: the whole aspect goes
    int byHand = 0;         ///< actions of which a hand said it
    int others = 0;         ///< actions of which rule or machine did, and it was accepted

    bool operator==(const VocabularyLoss&) const = default;
};

/// What setVocabulary would drop of the project's labels, in the old vocabulary's order. Labels
/// that boundaries hide at the moment count as well.
std::vector<VocabularyLoss> lostBy(const Project& project, const Vocabulary& vocabulary);
/// "Right kick: 3 labels by hand, 5 accepted ones"
std::string lossText(const VocabularyLoss& loss);

}  // namespace kumite
