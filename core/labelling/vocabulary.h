#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/finding.h"
#include "core/motion/roles.h"

namespace kumite {

/// A value that an aspect can take: "fwd" of the right punch.
struct Qualifier {
    std::string id;
    std::string name;
    std::string colour;   ///< "#rrggbb"
    std::string key;      ///< default key
    bool attack = false;  ///< brings the aspect's limb toward the opponent
    int mirror = 0;       ///< the qualifier seen in a mirror, of the aspect's mirror

    bool operator==(const Qualifier&) const = default;
};

/// Who finds an aspect's qualifier: a multiclass support vector machine, or a rule (method A5).
enum class Classifier { Msvm, ReactRule, MoveRule };

/// One element of a label.
struct Aspect {
    std::string id;
    std::string name;
    std::string colour;  ///< "#rrggbb"
    std::string key;     ///< default key of the aspect's lane
    Classifier classifier = Classifier::Msvm;
    std::vector<Qualifier> qualifiers;
    std::optional<int> fallback;  ///< the qualifier that means "nothing of it"; not spelled out
    int mirror = 0;               ///< the aspect of the other side; the own index in the middle
    std::vector<int> excludes;    ///< aspects that must be at their fallback where this is not
    std::optional<Role> limb;     ///< what strikes; for the react rule
    std::string strike;           ///< react qualifier that an attack of this aspect calls for

    /// Index of a qualifier by its id.
    std::optional<int> find(std::string_view qualifier) const;
    bool operator==(const Aspect&) const = default;
};

class JsonReader;

/// A whole label that one key says: "right punch forward".
struct QuickLabel {
    std::vector<int> label;  ///< a Label; unknown where rules decide
    std::string key;         ///< default key; may be empty

    bool operator==(const QuickLabel&) const = default;
};

/// What can be said about an action (method A3): data, so that users can label other sports.
struct Vocabulary {
    std::string name;
    std::vector<Aspect> aspects;
    std::vector<QuickLabel> quick;  ///< what is said most often, in the order of a palette

    /// Index of an aspect by its id.
    std::optional<int> find(std::string_view aspect) const;
    const Aspect& operator[](int aspect) const { return aspects[static_cast<std::size_t>(aspect)]; }
    int size() const { return static_cast<int>(aspects.size()); }
    bool operator==(const Vocabulary&) const = default;
};

/// The paper's vocabulary (resources/vocabulary/kickboxing.json, built in).
const Vocabulary& kickboxing();

/// Reads a vocabulary (schema: core/labelling/README.md). Throws InputError that names the place
/// for what cannot be used; what is usable but odd (two qualifiers on one key) goes to `findings`.
Vocabulary parseVocabulary(std::string_view text, const std::string& file,
                           Findings* findings = nullptr);

/// The same from a document that is open already (a project file).
Vocabulary readVocabulary(const JsonReader& json, Findings* findings = nullptr);

/// The vocabulary as such a file: parseVocabulary gives back the same.
std::string vocabularyText(const Vocabulary& vocabulary);

}  // namespace kumite
