#include "core/project/label_source.h"

#include <algorithm>

namespace kumite {
namespace {

constexpr std::string_view kHandAndRule = "hand+rule";

bool isLearnt(const Vocabulary& vocabulary, std::size_t aspect) {
    return vocabulary.aspects[aspect].classifier == Classifier::Msvm;
}

}  // namespace

LabelOrigin originOf(const Vocabulary& vocabulary, const ActionLabel& label) {
    LabelSource least = LabelSource::Hand;
    LabelSource leastLearnt = LabelSource::Hand;
    bool learnt = false;
    LabelOrigin origin;
    for (std::size_t a = 0; a < label.aspects.size(); ++a) {
        const AspectValue& value = label.aspects[a];
        if (!value.known()) continue;
        least = std::max(least, value.source);
        origin.confidence = std::min(origin.confidence, value.confidence);
        if (!isLearnt(vocabulary, a)) continue;
        leastLearnt = std::max(leastLearnt, value.source);
        learnt = true;
    }
    const bool both = least == LabelSource::Rule && learnt && leastLearnt == LabelSource::Hand;
    origin.source = both ? kHandAndRule : sourceName(least);
    return origin;
}

std::optional<std::vector<AspectValue>> valuesOf(const Vocabulary& vocabulary, const Label& label,
                                                 std::string_view source, float confidence) {
    const bool both = source == kHandAndRule;
    const auto only = sourceFromName(source);
    if (!both && !only) return std::nullopt;
    const LabelSource learnt = both ? LabelSource::Hand : *only;
    const LabelSource rest = both || learnt == LabelSource::Machine ? LabelSource::Rule : learnt;
    std::vector<AspectValue> values(label.size());
    for (std::size_t a = 0; a < label.size(); ++a) {
        if (label[a] == kUnknown) continue;
        const LabelSource who = isLearnt(vocabulary, a) ? learnt : rest;
        values[a] = {static_cast<std::int8_t>(label[a]), who,
                     who == LabelSource::Hand ? 1.0f : confidence};
    }
    return values;
}

}  // namespace kumite
