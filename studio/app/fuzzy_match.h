#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace kumite::studio {

/// How well a text answers what was typed, and which of its characters did.
struct FuzzyMatch {
    int score = 0;               ///< higher is better; comparable between texts
    std::vector<int> positions;  ///< ascending
};

/// Every word of `typed` must appear in `text` in order of its letters, not necessarily side by
/// side; case does not matter. Beginnings of words and unbroken runs count more. Nothing typed
/// matches everything.
std::optional<FuzzyMatch> fuzzyMatch(const QString& typed, const QString& text);

}  // namespace kumite::studio
