#include <algorithm>
#include <cctype>
#include <map>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/formats/eaf.h"
#include "core/project/label_files.h"
#include "core/project/label_source.h"

namespace kumite {
namespace {

/// Words as people write them: lower case, `_` and `-` as spaces, single spaces.
std::string plain(std::string_view text) {
    std::string out;
    for (char c : lowerCase(text)) {
        if (c == '_' || c == '-' || c == '\t') c = ' ';
        if (c == ' ' && (out.empty() || out.back() == ' ')) continue;
        out += c;
    }
    while (out.ends_with(' '))
        out.pop_back();
    return out;
}

/// "fighter 2", "player 2", "p2", "2": the number; nothing for anything else.
std::optional<int> playerNamed(std::string_view words) {
    for (const std::string_view prefix : {"fighter", "player", "p"}) {
        if (!words.starts_with(prefix)) continue;
        words.remove_prefix(prefix.size());
        break;
    }
    const auto number = parseInteger(trimmed(words));
    return number == 1 || number == 2 ? number : std::nullopt;
}

/// What a tier is about.
struct Subject {
    int player = 1;
    std::optional<int> aspect;  ///< nothing: whole labels
};

/// What is left of a tier's name without the fighter at its front or, behind "@", at its end.
std::string withoutPlayer(std::string name, std::optional<int>& player) {
    if (const auto at = name.rfind('@'); at != std::string::npos) {
        const auto found = playerNamed(trimmed(std::string_view(name).substr(at + 1)));
        if (found) {
            player = found;
            return std::string(trimmed(name.substr(0, at)));
        }
    }
    for (std::size_t end = 1; end <= name.size(); ++end) {
        if (end < name.size() && name[end] != ' ') continue;
        const auto found = playerNamed(std::string_view(name).substr(0, end));
        if (!found) continue;
        player = found;
        return std::string(trimmed(name.substr(end)));
    }
    return name;
}

std::optional<Subject> subjectOf(const EafTier& tier, const Vocabulary& vocabulary) {
    std::optional<int> player;
    const std::string words = withoutPlayer(plain(tier.id), player);
    const bool named = player.has_value();
    if (!player) player = playerNamed(plain(tier.participant));
    if (words == "label" || words == "labels" || (named && words.empty())) {
        return Subject{player.value_or(1), std::nullopt};
    }
    for (int a = 0; a < vocabulary.size(); ++a) {
        if (words == plain(vocabulary[a].id) || words == plain(vocabulary[a].name)) {
            return Subject{player.value_or(1), a};
        }
    }
    return std::nullopt;
}

std::optional<int> qualifierNamed(const Aspect& aspect, std::string_view word) {
    for (std::size_t q = 0; q < aspect.qualifiers.size(); ++q) {
        const Qualifier& each = aspect.qualifiers[q];
        if (equalsIgnoringCase(each.id, word) || equalsIgnoringCase(each.name, word)) {
            return static_cast<int>(q);
        }
    }
    return std::nullopt;
}

/// Labels of one fighter being put together from its tiers. Annotations of the same milliseconds
/// are about the same action.
class Gathering {
public:
    Gathering(const Vocabulary& vocabulary, const std::string& file, Findings& findings)
        : vocabulary_(vocabulary), file_(file), findings_(findings) {}

    /// A whole label, `right_punch:fwd (machine 0.83)`; nothing in parentheses: said by a hand.
    void addWhole(int player, const EafAnnotation& annotation) {
        std::string_view text = annotation.value;
        std::string source = "hand";
        double confidence = 1;
        if (const auto open = text.rfind('('); open != text.npos && text.ends_with(')')) {
            const auto words = split(text.substr(open + 1, text.size() - open - 2), ' ');
            source = words.front();
            if (words.size() > 1) confidence = parseNumber(words[1]).value_or(0);
            text = trimmed(text.substr(0, open));
        }
        if (text.empty()) return;
        try {
            const auto values = valuesOf(vocabulary_, parseLabel(vocabulary_, text), source,
                                         static_cast<float>(std::clamp(confidence, 0.0, 1.0)));
            if (!values) throw Error("\"" + source + "\" is no source.");
            Entry& entry = at(player, annotation);
            entry.label.aspects = *values;
            entry.whole = true;
        } catch (const Error& error) {
            report(annotation.line, error.what());
        }
    }

    void addAspect(int player, int aspect, const EafAnnotation& annotation) {
        if (annotation.value.empty()) return;
        const auto qualifier = qualifierNamed(vocabulary_[aspect], annotation.value);
        if (!qualifier) {
            report(annotation.line, fmt::format("\"{}\" is no qualifier of {}.", annotation.value,
                                                vocabulary_[aspect].id));
            return;
        }
        Entry& entry = at(player, annotation);
        const auto index = static_cast<std::size_t>(aspect);
        entry.spoken.resize(vocabulary_.aspects.size());
        entry.spoken[index] = true;
        AspectValue& value = entry.label.aspects[index];
        if (value.qualifier == *qualifier) return;  // as the whole label has it
        value = byHand(*qualifier);
    }

    /// A tier that is silent means "nothing of it" where another tier of the fighter speaks; where
    /// the whole label said something else, a hand has taken that away.
    std::vector<TimedLabel> finish(const std::map<int, std::vector<bool>>& tiers) {
        std::vector<TimedLabel> labels;
        for (auto& [key, entry] : entries_) {
            entry.spoken.resize(vocabulary_.aspects.size());
            for (std::size_t a = 0; a < vocabulary_.aspects.size(); ++a) {
                const std::optional<int> fallback = vocabulary_.aspects[a].fallback;
                const bool silent = tiers.at(entry.label.player)[a] && !entry.spoken[a];
                AspectValue& value = entry.label.aspects[a];
                if (!silent || value.qualifier == fallback) continue;
                if (entry.whole && !value.known()) continue;  // left open on purpose
                value = fallback ? byHand(*fallback) : AspectValue();
            }
            labels.push_back(std::move(entry.label));
        }
        return labels;
    }

    void report(int line, const std::string& sentence) {
        findings_.push_back(warning(fmt::format("{}:{}: {}", file_, line, sentence)));
    }

private:
    struct Entry {
        TimedLabel label;
        bool whole = false;
        std::vector<bool> spoken;  ///< aspects with an annotation of their own
    };

    static AspectValue byHand(int qualifier) {
        return {static_cast<std::int8_t>(qualifier), LabelSource::Hand, 1.0f};
    }

    Entry& at(int player, const EafAnnotation& annotation) {
        const auto ms = [](double seconds) { return std::llround(1000 * seconds); };
        Entry& entry = entries_[{player, ms(annotation.begin), ms(annotation.end)}];
        if (entry.label.aspects.empty()) {
            entry.label.player = player;
            entry.label.begin = annotation.begin;
            entry.label.end = annotation.end;
            entry.label.onEafClock = true;
            entry.label.aspects.resize(vocabulary_.aspects.size());
            entry.label.place = fmt::format("line {}", annotation.line);
        }
        return entry;
    }

    const Vocabulary& vocabulary_;
    const std::string& file_;
    Findings& findings_;
    std::map<std::tuple<int, long long, long long>, Entry> entries_;
};

/// The tier of one fighter with all its actions, and those of its aspects.
void addTiers(const Project& project, const Analysis& analysis, FighterAddress address,
              double clockStart, EafDocument& document) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    const Fighter& fighter = fighterAt(project, address);
    EafTier whole;
    whole.id = fmt::format("fighter {}", address.player + 1);
    whole.participant = whole.id;
    std::vector<EafTier> aspects;
    for (const Aspect& aspect : vocabulary.aspects)
        aspects.push_back({whole.id + " " + aspect.id, whole.id, whole.id, aspect.id, {}, 0});
    const auto labels = actionLabels(fighter, analysis.at(address), vocabulary.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Action& action = analysis.at(address).segmentation->actions[i];
        EafAnnotation annotation{timeOfFrame(fighter, action.begin) - clockStart,
                                 timeOfFrame(fighter, action.end) - clockStart, "", 0};
        for (std::size_t a = 0; a < aspects.size(); ++a) {
            const int value = labels[i].aspects[a].qualifier;
            const Aspect& aspect = vocabulary.aspects[a];
            if (value == kUnknown || value == aspect.fallback) continue;
            annotation.value = aspect.qualifiers[static_cast<std::size_t>(value)].id;
            aspects[a].annotations.push_back(annotation);
        }
        annotation.value.clear();
        if (labels[i].anyKnown()) {
            annotation.value = labelText(vocabulary, labels[i].label(), true);
            const LabelOrigin origin = originOf(vocabulary, labels[i]);
            if (origin.confidence < 1) {
                annotation.value += fmt::format(" ({} {})", origin.source,
                                                fixed(static_cast<double>(origin.confidence), 3));
            } else if (origin.source != sourceName(LabelSource::Hand)) {
                annotation.value += fmt::format(" ({})", origin.source);
            }
        }
        whole.annotations.push_back(std::move(annotation));
    }
    document.tiers.push_back(std::move(whole));
    std::move(aspects.begin(), aspects.end(), std::back_inserter(document.tiers));
}

}  // namespace

double eafClockStart(const Take& take) {
    return std::min(0.0, timeSpan(take).begin);
}

std::string labelsEaf(const Project& project, const Analysis& analysis, int take) {
    EafDocument document;
    const Take& shown = project.takes[static_cast<std::size_t>(take)];
    for (int p = 0; p < static_cast<int>(shown.fighters.size()); ++p)
        addTiers(project, analysis, {take, p}, eafClockStart(shown), document);
    for (const Aspect& aspect : project.labelling.vocabulary->aspects) {
        EafVocabulary words{aspect.id, {}};
        for (const Qualifier& qualifier : aspect.qualifiers)
            words.entries.emplace_back(qualifier.id, qualifier.name);
        document.vocabularies.push_back(std::move(words));
    }
    return eafText(document);
}

std::vector<TimedLabel> parseLabelsEaf(std::string_view text, const std::string& file,
                                       const Vocabulary& vocabulary, Findings* findings) {
    Findings ignored;
    Findings& report = findings ? *findings : ignored;
    const EafDocument document = parseEaf(text, file, &report);
    Gathering labels(vocabulary, file, report);
    std::map<int, std::vector<bool>> tiers;  // by player: aspects that have one
    for (const int player : {1, 2})
        tiers[player].resize(vocabulary.aspects.size());
    // Whole labels first: the aspects' tiers say where they were changed.
    for (const bool whole : {true, false}) {
        for (const EafTier& tier : document.tiers) {
            const auto subject = subjectOf(tier, vocabulary);
            if (!subject && whole) {
                labels.report(tier.line,
                              fmt::format("the tier \"{}\" is about no aspect of {}; {} "
                                          "annotations are left out.",
                                          tier.id, vocabulary.name, tier.annotations.size()));
            }
            if (!subject || subject->aspect.has_value() == whole) continue;
            if (subject->aspect) {
                tiers[subject->player][static_cast<std::size_t>(*subject->aspect)] = true;
            }
            for (const EafAnnotation& annotation : tier.annotations) {
                if (whole) {
                    labels.addWhole(subject->player, annotation);
                } else {
                    labels.addAspect(subject->player, *subject->aspect, annotation);
                }
            }
        }
    }
    return labels.finish(tiers);
}

}  // namespace kumite
