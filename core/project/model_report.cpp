#include "core/project/model_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/formats/json_text.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

Json averagesJson(const Averages& averages) {
    return {{"train", rounded(averages.train)},
            {"validation", rounded(averages.validation)},
            {"validation_sd", rounded(averages.deviation)}};
}

const Averages& of(const ValidationResult& result, LabelEstimator estimator) {
    return result.labelTerm[static_cast<std::size_t>(estimator)];
}
const Averages& of(const ValidationResult& result, CovarianceKind kind) {
    return result.geometryTerm[static_cast<std::size_t>(kind)];
}

Json summaryJson(const PlayerSummary& player) {
    return {{"takes", player.takes},
            {"frames", player.frames},
            {"seconds", rounded(player.seconds)},
            {"actions", player.actions},
            {"labels", player.labels},
            {"transitions", player.transitions},
            {"labelled", player.labelled},
            {"by_hand", player.byHand},
            {"share_by_hand", rounded(player.handShare())},
            {"minima", player.minima},
            {"corrections", player.corrections},
            {"share_of_minima_corrected", rounded(player.correctedShare())}};
}

}  // namespace

PlayerSummary playerSummary(const Project& project, const Analysis& analysis,
                            const Interaction& interaction, int player) {
    const CoupledGraph& graph = *interaction.graph;
    const Vocabulary& vocabulary = *graph.vocabulary;
    PlayerSummary summary;
    summary.labels = graph.nodeCount(player);
    summary.transitions = static_cast<int>(graph.transitionsOf(player).size());
    summary.perAspect.assign(static_cast<std::size_t>(vocabulary.size()), 0);
    for (std::size_t t = 0; t < project.takes.size(); ++t) {
        const auto slot = static_cast<std::size_t>(player);
        if (slot >= analysis.takes[t].size()) continue;
        const FighterAnalysis& values = analysis.takes[t][slot];
        if (!values.available()) continue;
        ++summary.takes;
        summary.frames += values.frameCount();
        summary.seconds += values.frameCount() / values.input.rate;
        const Segmentation& cut = *values.segmentation;
        summary.actions += static_cast<int>(cut.actions.size());
        const auto minima = std::count_if(cut.boundaries.begin(), cut.boundaries.end(),
                                          [](const Boundary& b) { return b.minimum.has_value(); });
        summary.minima += static_cast<int>(minima) + static_cast<int>(cut.removed.size());
        for (const Correction& correction : values.input.corrections)
            summary.corrections += correction.kind != Correction::Kind::Keep;
        for (const ActionLabel& label : actionLabels(values.input, values, vocabulary.size()))
            summary.byHand += label.anyByHand();
    }
    for (const GraphNode& node : graph.nodes[static_cast<std::size_t>(player)]) {
        summary.labelled += static_cast<int>(node.actions.size());
        for (std::size_t a = 0; a < summary.perAspect.size(); ++a) {
            const Aspect& aspect = vocabulary.aspects[a];
            if (node.label[a] != kUnknown && node.label[a] != aspect.fallback)
                summary.perAspect[a] += static_cast<int>(node.actions.size());
        }
    }
    return summary;
}

ValidationResult validateModel(const Analysis& analysis, const Interaction& interaction,
                               const ValidationSettings& settings, const Progress& progress) {
    const BoutTracks tracks = boutTracks(analysis);
    const PoseSource poses = [&](int take, int player, FrameRange frames) {
        const FighterTrack* track =
            tracks.takes[static_cast<std::size_t>(take)][static_cast<std::size_t>(player)];
        return track ? poseMoments(*track, frames) : PoseMoments();
    };
    return crossValidate(*interaction.graph, *interaction.numbers, poses, settings, progress);
}

std::vector<PaperCheck> checkPaper(const ValidationResult& r) {
    const double equ5 = of(r, LabelEstimator::Equ5).validation;
    const double equ6 = of(r, LabelEstimator::Equ6).validation;
    const double equ7 = of(r, LabelEstimator::Equ7).validation;
    const Averages& full = of(r, CovarianceKind::Full);
    const Averages& raw = of(r, CovarianceKind::FullRaw);
    const Averages& diagonal = of(r, CovarianceKind::Diagonal);
    const Averages& tied = of(r, CovarianceKind::SemiTied);
    std::vector<PaperCheck> checks;
    checks.push_back({"EQU7 is best on validation", equ7 > equ5 && equ7 > equ6,
                      fmt::format("EQU5 {:.2f}, EQU6 {:.2f}, EQU7 {:.2f}, even guess {:.2f}", equ5,
                                  equ6, equ7, of(r, LabelEstimator::Uniform).validation)});
    checks.push_back(
        {"EQU6 is worst on validation", equ6 < equ5 && equ6 < equ7, fmt::format("{:.2f}", equ6)});
    checks.push_back(
        {"SEMITIED is best on validation",
         tied.validation > full.validation && tied.validation > raw.validation &&
             tied.validation > diagonal.validation,
         fmt::format("FULL {:.2f}, FULL_RAW {:.2f}, DIAGONAL {:.2f}, SEMITIED {:.2f}",
                     full.validation, raw.validation, diagonal.validation, tied.validation)});
    checks.push_back(
        {"FULL without shrinkage overfits: best on training, worst on validation",
         raw.train > tied.train && raw.validation < tied.validation &&
             raw.validation < diagonal.validation,
         fmt::format("training {:.2f}, validation {:.2f}", raw.train, raw.validation)});
    checks.push_back(
        {"DIAGONAL underfits: below SEMITIED on training and on validation",
         diagonal.train < tied.train && diagonal.validation < tied.validation,
         fmt::format("training {:.2f} and {:.2f}, validation {:.2f} and {:.2f}", diagonal.train,
                     tied.train, diagonal.validation, tied.validation)});
    if (r.components.empty()) return checks;
    const auto best = std::max_element(
        r.components.begin(), r.components.end(),
        [](const auto& a, const auto& b) { return a.gain.validation < b.gain.validation; });
    checks.push_back({"There is a gain over one pooled Gaussian, greatest at a small k (up to 5)",
                      best->gain.validation > 0 && best->k <= 5,
                      fmt::format("at k = {}: {:.2f}", best->k, best->gain.validation)});
    return checks;
}

std::string modelJson(const ModelReport& report) {
    const ValidationResult& r = report.validation;
    Json json;
    json["labels"] = {report.players[0].labels, report.players[1].labels};
    json["transitions"] = {report.players[0].transitions, report.players[1].transitions};
    json["variance_covered"] = rounded(report.covered);
    json["dimensions"] = report.settings.dimensions();
    json["shrinkage_tau"] = rounded(report.settings.geometry.shrinkage);
    Json& labels = json["label_term"] = Json::object();
    for (const auto estimator : {LabelEstimator::Equ5, LabelEstimator::Equ6, LabelEstimator::Equ7,
                                 LabelEstimator::Uniform})
        labels[std::string(estimatorName(estimator))] = averagesJson(of(r, estimator));
    Json& geometry = json["geometry_term"] = Json::object();
    for (const auto kind : {CovarianceKind::Full, CovarianceKind::FullRaw, CovarianceKind::Diagonal,
                            CovarianceKind::SemiTied})
        geometry[std::string(covarianceName(kind))] = averagesJson(of(r, kind));
    json["one_gaussian"] = averagesJson(r.pooled);
    Json& pca = json["pca"] = Json::array();
    for (const auto& row : r.components) {
        Json entry = {{"k", row.k}, {"variance_covered", rounded(row.covered)}};
        entry.update(averagesJson(row.density));
        entry["gain"] = averagesJson(row.gain);
        pca.push_back(std::move(entry));
    }
    Json& shrinkage = json["shrinkage"] = Json::array();
    for (const auto& row : r.shrinkage) {
        Json entry = {{"tau", row.tau}};
        entry.update(averagesJson(row.density));
        shrinkage.push_back(std::move(entry));
    }
    json["split"] = {{"by", report.settings.split == SplitBy::Takes ? "takes" : "blocks"},
                     {"seeds", r.seeds},
                     {"train", rounded(r.transitions[0])},
                     {"validation", rounded(r.transitions[1])}};
    Json& checks = json["paper"] = Json::array();
    for (const PaperCheck& check : checkPaper(r))
        checks.push_back(
            {{"claim", check.claim}, {"holds", check.holds}, {"figures", check.figures}});
    json["players"] = {summaryJson(report.players[0]), summaryJson(report.players[1])};
    Json& findings = json["findings"] = Json::array();
    for (const Finding& finding : report.findings)
        findings.push_back(finding.text);
    Json& seconds = json["seconds"] = Json::object();
    for (const auto& [stage, value] : report.seconds)
        seconds[stage] = rounded(value);
    return prettyJson(json);
}

}  // namespace kumite
