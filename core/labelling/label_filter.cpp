#include "core/labelling/label_filter.h"

#include <algorithm>

namespace kumite {
namespace {

using Kind = FilterAtom::Kind;

int qualifierOf(const FilterSubject& action, int aspect) {
    return action.values[static_cast<std::size_t>(aspect)].qualifier;
}

bool among(double value, const FilterAtom& atom) {
    return value >= atom.low && value < atom.high;
}

/// Whether the action has what the atom says, leaving `negated` aside. `about`: the aspects whose
/// source and confidence count.
bool has(const FilterAtom& atom, const FilterSubject& action, const std::vector<int>& about) {
    const auto value = [&](int aspect) -> const AspectValue& {
        return action.values[static_cast<std::size_t>(aspect)];
    };
    switch (atom.kind) {
        case Kind::Values:
        case Kind::Nothing: {
            const auto holds = [&](const std::pair<int, int>& each) {
                return qualifierOf(action, each.first) == each.second;
            };
            return atom.kind == Kind::Values
                       ? std::any_of(atom.values.begin(), atom.values.end(), holds)
                       : std::all_of(atom.values.begin(), atom.values.end(), holds);
        }
        case Kind::Sources:
            return std::any_of(about.begin(), about.end(), [&](int aspect) {
                return std::find(atom.sources.begin(), atom.sources.end(), value(aspect).source) !=
                       atom.sources.end();
            });
        case Kind::Confidence: {
            if (about.empty()) return false;
            double least = 1;
            for (const int aspect : about)
                least = std::min(least, static_cast<double>(value(aspect).confidence));
            return among(least, atom);
        }
        case Kind::Player:
            return action.player == atom.index;
        case Kind::Take:
            return action.take == atom.index;
        case Kind::Begins:
            return among(action.begin, atom);
        case Kind::Contains:
            return action.begin <= atom.low && atom.low < action.end;
        case Kind::Lasts:
            return among(action.end - action.begin, atom);
        case Kind::Labelled:
            return action.labelled == (atom.index == 1);
    }
    return false;
}

bool isAbout(const std::vector<FilterAtom>& anyOf, Kind kind) {
    return std::all_of(anyOf.begin(), anyOf.end(),
                       [&](const FilterAtom& atom) { return atom.kind == kind; });
}

}  // namespace

std::optional<LabelFilter::Match> LabelFilter::match(const FilterSubject& action) const {
    Match match;
    // The aspects that are named and found; where none is named, all that are known.
    bool named = false;
    for (const auto& anyOf : allOf_) {
        for (const FilterAtom& atom : anyOf) {
            if (atom.negated || (atom.kind != Kind::Values && atom.kind != Kind::Nothing)) continue;
            named = true;
            for (const auto& [aspect, qualifier] : atom.values) {
                if (qualifier != kUnknown && qualifierOf(action, aspect) == qualifier)
                    match.aspects.push_back(aspect);
            }
        }
    }
    for (std::size_t a = 0; !named && a < action.values.size(); ++a) {
        if (action.values[a].known()) match.aspects.push_back(static_cast<int>(a));
    }
    std::sort(match.aspects.begin(), match.aspects.end());
    match.aspects.erase(std::unique(match.aspects.begin(), match.aspects.end()),
                        match.aspects.end());
    const auto passes = [&](const std::vector<FilterAtom>& anyOf) {
        return std::any_of(anyOf.begin(), anyOf.end(), [&](const FilterAtom& atom) {
            return has(atom, action, match.aspects) != atom.negated;
        });
    };
    // What is asked of the source first: it narrows down whose confidence counts.
    for (const auto& anyOf : allOf_) {
        if (!isAbout(anyOf, Kind::Sources)) continue;
        if (!passes(anyOf)) return std::nullopt;
        std::erase_if(match.aspects, [&](int aspect) {
            return std::none_of(anyOf.begin(), anyOf.end(), [&](const FilterAtom& atom) {
                return has(atom, action, {aspect}) != atom.negated;
            });
        });
    }
    for (const auto& anyOf : allOf_) {
        if (!isAbout(anyOf, Kind::Sources) && !passes(anyOf)) return std::nullopt;
    }
    for (const int aspect : match.aspects) {
        const AspectValue& value = action.values[static_cast<std::size_t>(aspect)];
        match.source = std::max(match.source, value.source);
        match.confidence = std::min(match.confidence, static_cast<double>(value.confidence));
    }
    return match;
}

std::string LabelFilter::text() const {
    std::string text;
    for (const auto& anyOf : allOf_) {
        if (!text.empty()) text += " · ";
        for (std::size_t i = 0; i < anyOf.size(); ++i) {
            text += (i > 0 ? " or " : "") + std::string(anyOf[i].negated ? "not " : "") +
                    anyOf[i].words;
        }
    }
    return text;
}

}  // namespace kumite
