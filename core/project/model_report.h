#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/interaction/cross_validation.h"
#include "core/project/interaction.h"

namespace kumite {

/// Tables 4 to 6 of paper A for one player: what there is, and how it was labelled.
struct PlayerSummary {
    int takes = 0;
    int frames = 0;
    double seconds = 0;
    int actions = 0;  ///< segments
    int labels = 0;   ///< groups
    int transitions = 0;
    int labelled = 0;  ///< actions that have a label
    int byHand = 0;    ///< of these, with an aspect that a hand said
    int minima = 0;    ///< that cut, or that a hand took away
    int corrections = 0;
    /// Per aspect of the vocabulary, actions that are not at its fallback.
    std::vector<int> perAspect;

    double handShare() const { return actions > 0 ? static_cast<double>(byHand) / actions : 0; }
    double correctedShare() const {
        return minima > 0 ? static_cast<double>(corrections) / minima : 0;
    }
};

/// All that `kumite model` says.
struct ModelReport {
    std::string name;  ///< of the project
    std::array<PlayerSummary, 2> players;
    ValidationSettings settings;
    ValidationResult validation;
    double covered = 0;  ///< share of all poses' variance in the k components of the model
    std::vector<std::pair<std::string, double>> seconds;  ///< per stage, in order
    Findings findings;
};

PlayerSummary playerSummary(const Project& project, const Analysis& analysis,
                            const Interaction& interaction, int player);

/// Tables 2 and 3 and Fig. 11 of a project's model, by cross-validation.
ValidationResult validateModel(const Analysis& analysis, const Interaction& interaction,
                               const ValidationSettings& settings, const Progress& progress = {});

/// Whether what the paper found holds here: a sentence each, with the figures it rests on.
struct PaperCheck {
    std::string claim;
    bool holds = false;
    std::string figures;
};
std::vector<PaperCheck> checkPaper(const ValidationResult& result);

/// One JSON object; keys as the command line's contract names them.
std::string modelJson(const ModelReport& report);
/// For people, as Markdown; names the pictures that writeModelReport puts beside it.
std::string modelMarkdown(const ModelReport& report, const Vocabulary& vocabulary);
/// Writes report.md, model.json, table2.csv, table3.csv, fig11.csv, the pictures table2.svg,
/// table3.svg, fig11.svg, next_player1.svg and next_player2.svg (P(l' | l1)), and the graph as
/// graph.csv, graph.json and graph.graphml. Makes the folder. Throws Error.
void writeModelReport(const ModelReport& report, const Interaction& interaction,
                      const std::filesystem::path& folder);

}  // namespace kumite
