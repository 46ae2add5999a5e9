#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/project/labels.h"

namespace kumite {

/// A label that stands in a file: bound to time, not to a segmentation, so that it finds its action
/// again after another one.
struct TimedLabel {
    std::string take;  ///< empty: the only take, or the one that is asked for
    int player = 1;    ///< 1 or 2
    double begin = 0;  ///< seconds from frame 0 of the fighter
    double end = 0;
    /// ELAN's times count from the take's first moment instead, see eafClockStart.
    bool onEafClock = false;
    std::vector<AspectValue> aspects;
    std::string place;  ///< where it stands, for messages: "line 12"
};

/// Labels of a `.csv`, `.json` or `.eaf` file (schemas: core/project/README.md), or of a demo
/// bout's `truth.json`, whose labels count as said by a hand. Throws InputError; what had to be
/// left out goes to `findings`.
std::vector<TimedLabel> readLabels(const std::filesystem::path& path, const Vocabulary& vocabulary,
                                   Findings* findings = nullptr);
std::vector<TimedLabel> parseLabelsCsv(std::string_view text, const std::string& file,
                                       const Vocabulary& vocabulary);
std::vector<TimedLabel> parseLabelsJson(std::string_view text, const std::string& file,
                                        const Vocabulary& vocabulary);

/// Labels of an ELAN document. A tier is meant for an aspect or for whole labels by its name:
/// "fighter 1 left_punch", "left punch@2", "fighter 2"; without a number PARTICIPANT says who, else
/// it is fighter 1. Tiers and words that mean nothing here go to `findings`.
std::vector<TimedLabel> parseLabelsEaf(std::string_view text, const std::string& file,
                                       const Vocabulary& vocabulary, Findings* findings = nullptr);

/// Seconds on the take's clock of an ELAN document's time 0: the first moment of the take, which
/// may lie before 0.
double eafClockStart(const Take& take);

/// When a label begins and ends, in seconds from frame 0 of the fighter.
struct Span {
    double begin = 0;
    double end = 0;
};
Span spanOn(const Project& project, FighterAddress fighter, const TimedLabel& label);

/// Timed labels brought to the actions that they overlap most.
struct MatchedLabels {
    std::vector<FighterLabels> fighters;  ///< ready for importLabels
    int matched = 0;
    Findings unmatched;  ///< one sentence for every label without an action of its own
};
/// A label needs an action with which it shares at least half of the shorter one's time; for every
/// aspect an action takes the label that overlaps it longest. `take`: for labels that name none.
MatchedLabels matchLabels(const Project& project, const Analysis& analysis,
                          const std::vector<TimedLabel>& labels, std::optional<int> take = {});

/// All labelled actions as text, of one take or of all.
std::string labelsCsv(const Project& project, const Analysis& analysis,
                      std::optional<int> take = {});
std::string labelsJson(const Project& project, const Analysis& analysis,
                       std::optional<int> take = {});
/// A take's labels for ELAN (EAF 3.0): a tier per fighter with all its actions and their spelled
/// labels, below it a tier per aspect that offers the qualifiers. What is at its fallback is not
/// annotated on an aspect's tier.
std::string labelsEaf(const Project& project, const Analysis& analysis, int take);

/// Writes labels by the file's suffix: .csv, .json, .eaf (which holds one take). Throws Error.
void writeLabels(const Project& project, const Analysis& analysis, std::optional<int> take,
                 const std::filesystem::path& file);

}  // namespace kumite
