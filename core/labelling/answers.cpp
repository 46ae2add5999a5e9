#include "core/labelling/answers.h"

#include <array>

namespace kumite {
namespace {

/// Keys that are free beside those of playing, stepping and editing.
constexpr std::array<std::string_view, 2> kPairRows = {"QWER", "ZXC"};
constexpr std::string_view kSingleRow = "DP";
constexpr const char* kNothingKey = "B";

bool isLearnt(const Aspect& aspect) {
    return aspect.classifier == Classifier::Msvm;
}

Label nothingOf(const Vocabulary& vocabulary) {
    Label label;
    for (const Aspect& aspect : vocabulary.aspects) {
        label.push_back(isLearnt(aspect) ? aspect.fallback.value_or(kUnknown) : kUnknown);
    }
    return label;
}

}  // namespace

Label agreedLabel(const Vocabulary& vocabulary, const Label& said, const Label& proposed) {
    Label label = said;
    for (int a = 0; a < vocabulary.size(); ++a) {
        int& qualifier = label[static_cast<std::size_t>(a)];
        if (qualifier != kUnknown || !isLearnt(vocabulary[a])) continue;
        qualifier = proposed[static_cast<std::size_t>(a)];
        if (qualifier == kUnknown) qualifier = vocabulary[a].fallback.value_or(kUnknown);
    }
    return label;
}

Label answeredLabel(const Vocabulary& vocabulary, const Label& said, const Label& proposed,
                    int aspect, int qualifier, Naming naming) {
    const Aspect& named = vocabulary[aspect];
    Label label = isLearnt(named) ? agreedLabel(vocabulary, said, proposed) : said;
    const auto clear = [&](int a) {
        if (vocabulary[a].fallback) label[static_cast<std::size_t>(a)] = *vocabulary[a].fallback;
    };
    if (qualifier != named.fallback) {
        for (int a = 0; a < vocabulary.size(); ++a) {
            if (naming == Naming::Instead && named.limb && vocabulary[a].limb) clear(a);
        }
        for (const int excluded : named.excludes)
            clear(excluded);
    }
    label[static_cast<std::size_t>(aspect)] = qualifier;
    return label;
}

std::vector<QuickLabel> quickLabels(const Vocabulary& vocabulary) {
    std::vector<QuickLabel> quick;
    const auto add = [&](int aspect, std::size_t qualifier, std::string key) {
        QuickLabel entry{nothingOf(vocabulary), std::move(key)};
        entry.label[static_cast<std::size_t>(aspect)] = static_cast<int>(qualifier);
        quick.push_back(std::move(entry));
    };
    std::size_t pairs = 0;
    std::size_t singles = 0;
    for (int a = 0; a < vocabulary.size(); ++a) {
        const Aspect& aspect = vocabulary[a];
        if (!isLearnt(aspect) || aspect.mirror < a) continue;  // that came beside its mirror
        const bool pair = aspect.mirror > a;
        const std::string_view row =
            pair && pairs < kPairRows.size() ? kPairRows[pairs] : std::string_view();
        std::size_t place = 0;
        for (std::size_t q = 0; q < aspect.qualifiers.size(); ++q) {
            if (static_cast<int>(q) == aspect.fallback) continue;
            if (pair) {
                const std::string key =
                    place < row.size() ? std::string(1, row[place]) : std::string();
                add(a, q, key);
                add(aspect.mirror, static_cast<std::size_t>(aspect.qualifiers[q].mirror),
                    key.empty() ? key : "Shift+" + key);
            } else {
                // A single aspect has one key, with Shift for its second qualifier.
                const bool free = singles < kSingleRow.size() && place < 2;
                const std::string key = free ? std::string(1, kSingleRow[singles]) : std::string();
                add(a, q, place == 0 || key.empty() ? key : "Shift+" + key);
            }
            ++place;
        }
        ++(pair ? pairs : singles);
    }
    quick.push_back({nothingOf(vocabulary), kNothingKey});
    return quick;
}

}  // namespace kumite
