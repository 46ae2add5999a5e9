#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/finding.h"

namespace kumite {

/// A stretch of time with a word: what stands on a tier of ELAN.
struct EafAnnotation {
    double begin = 0;  ///< seconds on the document's clock
    double end = 0;
    std::string value;  ///< without white space around it
    int line = 0;       ///< of the file it was read from, from 1
};

struct EafTier {
    std::string id;
    std::string participant;
    std::string parent;      ///< id of the tier that this one depends on; empty: none
    std::string vocabulary;  ///< id of its controlled vocabulary; empty: none
    std::vector<EafAnnotation> annotations;
    int line = 0;
};

/// The words that a tier offers, each with a description.
struct EafVocabulary {
    std::string id;
    std::vector<std::pair<std::string, std::string>> entries;
};

/// An annotation document of ELAN (EAF 2.x and 3.0), as far as tiers go: media, lexicons, comments
/// and search settings are left out.
struct EafDocument {
    std::vector<EafTier> tiers;
    std::vector<EafVocabulary> vocabularies;
};

/// Reads a document in UTF-8. Every annotation gets a time: dependent ones take that of the
/// annotation they refer to (several share it evenly, in their order), slots without a time are
/// spread evenly between those that have one. What still has no time goes to `findings`. A value
/// that is empty is taken from the controlled vocabulary's entry. Throws InputError with the line.
EafDocument parseEaf(std::string_view text, const std::string& file, Findings* findings = nullptr);

/// The document as ELAN reads it (EAF 3.0). Equal documents give equal bytes. A tier with a parent
/// must stand behind it and holds annotations with the times of annotations of the parent
/// (Symbolic_Association); times are rounded to milliseconds.
std::string eafText(const EafDocument& document);

}  // namespace kumite
