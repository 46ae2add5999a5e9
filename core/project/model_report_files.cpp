// The report as files: Markdown, tables and pictures.
#include <cmath>

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/project/chart_svg.h"
#include "core/project/graph_export.h"
#include "core/project/model_report.h"

namespace kumite {
namespace {

constexpr const char* kTrainColour = "#9db7d5";
constexpr const char* kValidationColour = "#1f5fa8";

struct NamedAverages {
    std::string name;
    Averages averages;
};

std::vector<NamedAverages> labelRows(const ValidationResult& result) {
    std::vector<NamedAverages> rows;
    for (const auto estimator : {LabelEstimator::Equ5, LabelEstimator::Equ6, LabelEstimator::Equ7,
                                 LabelEstimator::Uniform}) {
        rows.push_back({std::string(estimatorName(estimator)),
                        result.labelTerm[static_cast<std::size_t>(estimator)]});
    }
    return rows;
}

std::vector<NamedAverages> geometryRows(const ValidationResult& result) {
    std::vector<NamedAverages> rows;
    for (const auto kind : {CovarianceKind::Full, CovarianceKind::FullRaw, CovarianceKind::Diagonal,
                            CovarianceKind::SemiTied}) {
        rows.push_back({std::string(covarianceName(kind)),
                        result.geometryTerm[static_cast<std::size_t>(kind)]});
    }
    rows.push_back({"one Gaussian", result.pooled});
    return rows;
}

std::string averagesCsv(const std::string& first, const std::vector<NamedAverages>& rows) {
    std::string text = first + ",train,validation,validation_sd\n";
    for (const NamedAverages& row : rows) {
        text += fmt::format("{},{},{},{}\n", row.name, fixed(row.averages.train, 6),
                            fixed(row.averages.validation, 6), fixed(row.averages.deviation, 6));
    }
    return text;
}

std::string componentsCsv(const ValidationResult& result) {
    std::string text =
        "k,variance_covered,train,validation,validation_sd,gain_train,gain_validation,"
        "gain_validation_sd\n";
    for (const auto& row : result.components) {
        text += fmt::format("{},{},{},{},{},{},{},{}\n", row.k, fixed(row.covered, 6),
                            fixed(row.density.train, 6), fixed(row.density.validation, 6),
                            fixed(row.density.deviation, 6), fixed(row.gain.train, 6),
                            fixed(row.gain.validation, 6), fixed(row.gain.deviation, 6));
    }
    return text;
}

/// Nats with two digits; a density that collapsed (no shrinkage, few samples) by its size alone.
std::string nats(double value) {
    return std::abs(value) < 1e5 ? fixed(value, 2) : fmt::format("{:.0e}", value);
}

std::string averagesMarkdown(const std::string& first, const std::vector<NamedAverages>& rows) {
    std::string text =
        "| " + first + " | training | validation | ± |\n| --- | ---: | ---: | ---: |\n";
    for (const NamedAverages& row : rows) {
        text += fmt::format("| {} | {} | {} | {} |\n", row.name, nats(row.averages.train),
                            nats(row.averages.validation), nats(row.averages.deviation));
    }
    return text;
}

std::string bars(const std::string& title, const std::vector<NamedAverages>& rows) {
    std::vector<std::string> groups;
    ChartSeries train{"training", kTrainColour, {}};
    ChartSeries validation{"validation", kValidationColour, {}};
    for (const NamedAverages& row : rows) {
        const auto x = static_cast<double>(groups.size());
        groups.push_back(row.name);
        train.points.push_back({x, row.averages.train, 0});
        validation.points.push_back({x, row.averages.validation, row.averages.deviation});
    }
    return barChartSvg(title, "nats per transition", groups, {train, validation});
}

std::string componentsChart(const ValidationResult& result) {
    ChartSeries train{"training", kTrainColour, {}};
    ChartSeries validation{"validation", kValidationColour, {}};
    for (const auto& row : result.components) {
        train.points.push_back({static_cast<double>(row.k), row.gain.train, 0});
        validation.points.push_back(
            {static_cast<double>(row.k), row.gain.validation, row.gain.deviation});
    }
    return lineChartSvg("Gain of SEMITIED over one Gaussian for all labels",
                        "k, principal components of the pose", "nats per transition",
                        {train, validation});
}

/// P(l' | l1) of a mover, for labels that were left at least once.
std::string nextChart(const TransitionModel& model) {
    std::vector<std::string> rows, columns;
    std::vector<std::vector<double>> values;
    for (int own = 0; own < model.labels.nodeCount(); ++own) {
        columns.push_back(model.graph->node(model.mover, own).text);
        if (model.counts.own.row(own).sum() == 0) continue;
        rows.push_back(columns.back());
        values.push_back(model.labels.probabilities(own, kAnyNode));
    }
    Eigen::MatrixXd matrix(values.size(), columns.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t j = 0; j < columns.size(); ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = values[i][j];
    }
    return heatMapSvg(fmt::format("Player {}: P(next | own)", model.mover + 1), rows, columns,
                      matrix);
}

std::string summaryMarkdown(const ModelReport& report) {
    const auto& players = report.players;
    std::string text = "| | player 1 | player 2 |\n| --- | ---: | ---: |\n";
    const auto row = [&](const std::string& name, const auto& value) {
        text += fmt::format("| {} | {} | {} |\n", name, value(players[0]), value(players[1]));
    };
    row("takes", [](const PlayerSummary& p) { return std::to_string(p.takes); });
    row("frames", [](const PlayerSummary& p) { return std::to_string(p.frames); });
    row("seconds", [](const PlayerSummary& p) { return fixed(p.seconds, 1); });
    row("actions (segments)", [](const PlayerSummary& p) { return std::to_string(p.actions); });
    row("labels (groups)", [](const PlayerSummary& p) { return std::to_string(p.labels); });
    row("transitions", [](const PlayerSummary& p) { return std::to_string(p.transitions); });
    row("actions labelled", [](const PlayerSummary& p) { return std::to_string(p.labelled); });
    row("labelled by hand",
        [](const PlayerSummary& p) { return fixed(100 * p.handShare(), 1) + " %"; });
    row("minima corrected by hand",
        [](const PlayerSummary& p) { return fixed(100 * p.correctedShare(), 1) + " %"; });
    return text;
}

std::string aspectsMarkdown(const ModelReport& report, const Vocabulary& vocabulary) {
    std::string text = "| aspect, not \"others\" | player 1 | player 2 |\n| --- | ---: | ---: |\n";
    for (int a = 0; a < vocabulary.size(); ++a) {
        const auto slot = static_cast<std::size_t>(a);
        text += fmt::format("| {} | {} | {} |\n", vocabulary[a].id,
                            report.players[0].perAspect[slot], report.players[1].perAspect[slot]);
    }
    return text;
}

}  // namespace

std::string modelMarkdown(const ModelReport& report, const Vocabulary& vocabulary) {
    const ValidationResult& r = report.validation;
    std::string text = "# Transition model of " + report.name + "\n\n";
    text += "## Data and labels (as Tables 4 to 6 of the paper)\n\n" + summaryMarkdown(report) +
            "\n" + aspectsMarkdown(report, vocabulary) + "\n| stage | seconds |\n| --- | ---: |\n";
    for (const auto& [stage, seconds] : report.seconds)
        text += fmt::format("| {} | {} |\n", stage, fixed(seconds, 2));
    text += fmt::format(
        "\n## How it was judged\n\n{} splits by {}, two thirds to learn from (on average {} "
        "transitions a player), the rest to judge by ({}); held-out transitions that share an "
        "action with the training part are left out. Principal components, standardisation, counts "
        "and Gaussians come from the training part alone. Figures are mean natural logarithms per "
        "transition over both players; ± is the standard deviation over the splits.\n",
        r.seeds, report.settings.split == SplitBy::Takes ? "takes" : "blocks of time",
        fixed(r.transitions[0], 0), fixed(r.transitions[1], 0));
    text += "\n## Table 2: label term\n\n" + averagesMarkdown("estimator", labelRows(r)) +
            "\n![Table 2](table2.svg)\n";
    text += fmt::format(
                "\n## Table 3: geometry term, k = {}, {} % of the variance, {} dimensions, "
                "τ = {}\n\n",
                report.settings.components, fixed(100 * report.covered, 1),
                report.settings.dimensions(), shortest(report.settings.geometry.shrinkage)) +
            averagesMarkdown("covariance", geometryRows(r)) + "\n![Table 3](table3.svg)\n";
    text += "\nSEMITIED by shrinkage τ:\n\n";
    std::vector<NamedAverages> taus;
    for (const auto& row : r.shrinkage)
        taus.push_back({shortest(row.tau), row.density});
    text += averagesMarkdown("τ", taus);
    text +=
        "\n## Fig. 11: principal components\n\n| k | variance | gain, training | gain, "
        "validation | ± |\n| ---: | ---: | ---: | ---: | ---: |\n";
    for (const auto& row : r.components) {
        text += fmt::format("| {} | {} % | {} | {} | {} |\n", row.k, fixed(100 * row.covered, 1),
                            fixed(row.gain.train, 2), fixed(row.gain.validation, 2),
                            fixed(row.gain.deviation, 2));
    }
    text +=
        "\n![Fig. 11](fig11.svg)\n\n## What the paper found, here\n\n| | holds | figures |\n| "
        "--- | --- | --- |\n";
    for (const PaperCheck& check : checkPaper(r)) {
        text += fmt::format("| {} | {} | {} |\n", check.claim, check.holds ? "yes" : "no",
                            check.figures);
    }
    text +=
        "\n## What comes next\n\n![Player 1](next_player1.svg)\n\n![Player "
        "2](next_player2.svg)\n";
    for (const Finding& finding : report.findings)
        text += "\n- " + finding.text;
    return text + (report.findings.empty() ? "" : "\n");
}

void writeModelReport(const ModelReport& report, const Interaction& interaction,
                      const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw Error(folder.string() + ": " + failed.message() + ".");
    const auto write = [&](const char* name, const std::string& text) {
        writeFileAtomically(folder / name, text);
    };
    const std::vector<NamedAverages> labels = labelRows(report.validation);
    const std::vector<NamedAverages> geometry = geometryRows(report.validation);
    write("report.md", modelMarkdown(report, *interaction.graph->vocabulary));
    write("model.json", modelJson(report));
    write("table2.csv", averagesCsv("estimator", labels));
    write("table3.csv", averagesCsv("covariance", geometry));
    write("fig11.csv", componentsCsv(report.validation));
    write("table2.svg", bars("Label term, mean log P(next | own, opponent)", labels));
    write("table3.svg", bars("Geometry term, mean log density", geometry));
    write("fig11.svg", componentsChart(report.validation));
    for (const auto& model : interaction.models) {
        write(model->mover == 0 ? "next_player1.svg" : "next_player2.svg", nextChart(*model));
    }
    for (const char* name : {"graph.csv", "graph.json", "graph.graphml"})
        writeGraph(interaction, folder / name);
}

}  // namespace kumite
