#include "core/labelling/label.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/text.h"

namespace kumite {
namespace {

constexpr std::array<std::string_view, 3> kSources = {"hand", "rule", "machine"};
constexpr std::string_view kOthers = "others";
constexpr std::string_view kOpen = "?";

bool isSaid(const Aspect& aspect, int qualifier) {
    return qualifier != kUnknown && qualifier != aspect.fallback.value_or(kUnknown);
}

}  // namespace

Label othersLabel(const Vocabulary& vocabulary) {
    Label label;
    for (const Aspect& aspect : vocabulary.aspects)
        label.push_back(aspect.fallback.value_or(kUnknown));
    return label;
}

std::string labelText(const Vocabulary& vocabulary, const Label& label, bool openToo) {
    std::string text;
    for (std::size_t i = 0; i < label.size(); ++i) {
        const Aspect& aspect = vocabulary.aspects[i];
        const bool open = openToo && label[i] == kUnknown && aspect.fallback;
        if (!open && !isSaid(aspect, label[i])) continue;
        text +=
            (text.empty() ? "" : "+") + aspect.id + ":" +
            (open ? std::string(kOpen) : aspect.qualifiers[static_cast<std::size_t>(label[i])].id);
    }
    return text.empty() ? std::string(kOthers) : text;
}

std::string spokenLabel(const Vocabulary& vocabulary, const Label& label) {
    std::string text;
    for (std::size_t i = 0; i < label.size(); ++i) {
        const Aspect& aspect = vocabulary.aspects[i];
        if (!isSaid(aspect, label[i])) continue;
        std::string name =
            aspect.name + ' ' + aspect.qualifiers[static_cast<std::size_t>(label[i])].name;
        if (name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
        text += (text.empty() ? "" : ", ") + name;
    }
    return text.empty() ? "nothing" : text;
}

Label parseLabel(const Vocabulary& vocabulary, std::string_view text) {
    Label label = othersLabel(vocabulary);
    text = trimmed(text);
    if (text == kOthers) return label;
    std::vector<bool> seen(label.size(), false);
    for (const std::string_view word : split(text, '+')) {
        const auto parts = split(trimmed(word), ':');
        const auto aspect = vocabulary.find(parts[0]);
        if (!aspect) {
            throw Error("\"" + std::string(word) + "\" names no aspect of the vocabulary " +
                        vocabulary.name + ".");
        }
        const bool open = parts.size() == 2 && parts[1] == kOpen;
        const auto qualifier = open                ? std::optional<int>(kUnknown)
                               : parts.size() == 2 ? vocabulary[*aspect].find(parts[1])
                                                   : std::nullopt;
        if (!qualifier) {
            throw Error("\"" + std::string(word) + "\" names no qualifier of " +
                        vocabulary[*aspect].id + ".");
        }
        const auto index = static_cast<std::size_t>(*aspect);
        if (seen[index]) throw Error("\"" + std::string(text) + "\" names an aspect twice.");
        seen[index] = true;
        label[index] = *qualifier;
    }
    return label;
}

Label mirroredLabel(const Vocabulary& vocabulary, const Label& label) {
    Label mirrored(label.size(), kUnknown);
    for (std::size_t i = 0; i < label.size(); ++i) {
        if (label[i] == kUnknown) continue;
        const Aspect& aspect = vocabulary.aspects[i];
        mirrored[static_cast<std::size_t>(aspect.mirror)] =
            aspect.qualifiers[static_cast<std::size_t>(label[i])].mirror;
    }
    return mirrored;
}

std::vector<std::string> conflicts(const Vocabulary& vocabulary, const Label& label) {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < label.size(); ++i) {
        if (!isSaid(vocabulary.aspects[i], label[i])) continue;
        for (const int other : vocabulary.aspects[i].excludes) {
            const auto j = static_cast<std::size_t>(other);
            const bool listedBefore =
                j < i && std::count(vocabulary.aspects[j].excludes.begin(),
                                    vocabulary.aspects[j].excludes.end(), static_cast<int>(i)) > 0;
            if (listedBefore || !isSaid(vocabulary.aspects[j], label[j])) continue;
            found.push_back(vocabulary.aspects[i].name + " and " + vocabulary.aspects[j].name +
                            " exclude each other.");
        }
    }
    return found;
}

std::string_view sourceName(LabelSource source) {
    return kSources[static_cast<std::size_t>(source)];
}

std::optional<LabelSource> sourceFromName(std::string_view name) {
    const auto found = std::find(kSources.begin(), kSources.end(), name);
    if (found == kSources.end()) return std::nullopt;
    return static_cast<LabelSource>(found - kSources.begin());
}

Label ActionLabel::label() const {
    Label label;
    for (const AspectValue& value : aspects)
        label.push_back(value.qualifier);
    return label;
}

bool ActionLabel::anyKnown() const {
    return std::any_of(aspects.begin(), aspects.end(),
                       [](const AspectValue& value) { return value.known(); });
}

bool ActionLabel::anyByHand() const {
    return std::any_of(aspects.begin(), aspects.end(),
                       [](const AspectValue& value) { return value.byHand(); });
}

}  // namespace kumite
