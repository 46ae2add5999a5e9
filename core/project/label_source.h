#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/labelling/label.h"

namespace kumite {

/// Who said a label, in one word for a table's row: `hand`, `rule`, `machine`, or `hand+rule`: a
/// hand what is learnt, rules the rest. Where a label mixes more than that, the least sure source
/// stands for all. `confidence`: the least.
struct LabelOrigin {
    std::string source = "hand";
    float confidence = 1;
};
LabelOrigin originOf(const Vocabulary& vocabulary, const ActionLabel& label);

/// The values of a whole label of that origin; nothing where `source` is none of those words. Rules
/// are credited for what they decide, also beside `machine`.
std::optional<std::vector<AspectValue>> valuesOf(const Vocabulary& vocabulary, const Label& label,
                                                 std::string_view source, float confidence);

}  // namespace kumite
