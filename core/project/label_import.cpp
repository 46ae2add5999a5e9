#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/json_text.h"
#include "core/formats/tables.h"
#include "core/project/label_files.h"
#include "core/project/label_json.h"
#include "core/project/label_source.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

/// A column's number in the header of a table.
std::optional<std::size_t> columnOf(const std::vector<std::string>& header, std::string_view name) {
    for (std::size_t i = 0; i < header.size(); ++i) {
        if (trimmed(header[i]) == name) return i;
    }
    return std::nullopt;
}

class CsvRow {
public:
    CsvRow(const std::vector<std::string>& header, const CsvLine& line, const std::string& file)
        : header_(header), line_(line), file_(file) {}

    std::optional<std::string> text(std::string_view column) const {
        const auto index = columnOf(header_, column);
        if (!index || *index >= line_.fields.size()) return std::nullopt;
        return std::string(trimmed(line_.fields[*index]));
    }
    double number(std::string_view column) const {
        const auto value = parseNumber(text(column).value_or(""));
        if (!value) throw error(fmt::format("{} is not a number", column));
        return *value;
    }
    InputError error(const std::string& what) const {
        return InputError(file_, line_.number, 0, what + ".");
    }

private:
    const std::vector<std::string>& header_;
    const CsvLine& line_;
    const std::string& file_;
};

TimedLabel readRow(const CsvRow& row, const Vocabulary& vocabulary) {
    TimedLabel label;
    label.take = row.text("take").value_or("");
    label.player = parseInteger(row.text("player").value_or("1")).value_or(0);
    if (label.player < 1 || label.player > 2) throw row.error("player is 1 or 2");
    label.begin = row.number("begin_s");
    label.end = row.number("end_s");
    if (label.end < label.begin) throw row.error("end_s lies before begin_s");
    const std::string sourceText = row.text("source").value_or("hand");
    const std::string confidenceText = row.text("confidence").value_or("");
    const auto confidence = confidenceText.empty() ? 1.0 : parseNumber(confidenceText);
    if (!confidence || *confidence < 0 || *confidence > 1) {
        throw row.error("confidence is a number from 0 to 1");
    }
    try {
        const auto values =
            valuesOf(vocabulary, parseLabel(vocabulary, row.text("label").value_or("")),
                     sourceText.empty() ? "hand" : sourceText, static_cast<float>(*confidence));
        if (!values) throw row.error("source is hand, rule, machine or hand+rule");
        label.aspects = *values;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        std::string what = error.what();
        throw row.error(what.substr(0, what.size() - 1));
    }
    return label;
}

/// {aspect: qualifier}; aspects left out are at their fallback.
Label readTrueLabel(const JsonReader& json, const Vocabulary& vocabulary) {
    Label label = othersLabel(vocabulary);
    for (const std::string& key : json.keys()) {
        const auto aspect = vocabulary.find(key);
        if (!aspect) throw json.error("\"" + key + "\" is no aspect of " + vocabulary.name);
        const auto qualifier = vocabulary[*aspect].find(json[key].text());
        if (!qualifier) throw json[key].error("is no qualifier of " + key);
        label[static_cast<std::size_t>(*aspect)] = *qualifier;
    }
    return label;
}

/// One entry per fighter, of which there are two at most.
JsonReader playersOf(const JsonReader& json) {
    const JsonReader players = json["players"];
    if (players.size() > 2) throw players.error("expected 1 or 2 fighters");
    return players;
}

void checkSpan(const TimedLabel& label, const JsonReader& entry, const std::string& begin,
               const std::string& end) {
    if (!std::isfinite(label.begin) || !std::isfinite(label.end)) {
        throw entry.error(fmt::format("{} and {} are too large for this rate", begin, end));
    }
    if (label.end < label.begin) throw entry.error(fmt::format("{} lies before {}", end, begin));
}

/// The truth of a made bout: frames at `rate`.
std::vector<TimedLabel> readTruth(const JsonReader& json, const Vocabulary& vocabulary) {
    const double rate = json["rate"].positive();
    std::vector<TimedLabel> labels;
    const JsonReader players = playersOf(json);
    for (std::size_t p = 0; p < players.size(); ++p) {
        const JsonReader actions = players.at(p)["actions"];
        for (std::size_t i = 0; i < actions.size(); ++i) {
            const JsonReader entry = actions.at(i);
            TimedLabel label;
            label.player = static_cast<int>(p) + 1;
            label.begin = entry["begin"].integer() / rate;
            label.end = entry["end"].integer() / rate;
            checkSpan(label, entry, "begin", "end");
            label.aspects =
                *valuesOf(vocabulary, readTrueLabel(entry["label"], vocabulary), "hand", 1.0f);
            label.place = fmt::format("player {}, action {}", p + 1, i);
            labels.push_back(std::move(label));
        }
    }
    return labels;
}

}  // namespace

std::vector<TimedLabel> parseLabelsCsv(std::string_view text, const std::string& file,
                                       const Vocabulary& vocabulary) {
    const std::vector<CsvLine> lines = parseCsv(text, file);
    if (lines.empty()) throw InputError(file, 0, 0, "is empty.");
    const std::vector<std::string>& header = lines.front().fields;
    for (const char* needed : {"begin_s", "end_s", "label"}) {
        if (!columnOf(header, needed)) {
            throw InputError(file, lines.front().number, 0,
                             fmt::format("has no column {}; a label table needs begin_s, end_s "
                                         "and label.",
                                         needed));
        }
    }
    std::vector<TimedLabel> labels;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        labels.push_back(readRow({header, lines[i], file}, vocabulary));
        labels.back().place = fmt::format("line {}", lines[i].number);
    }
    return labels;
}

std::vector<TimedLabel> parseLabelsJson(std::string_view text, const std::string& file,
                                        const Vocabulary& vocabulary) {
    const Json document = parseJson(text, file);
    const JsonReader json(document, file, "");
    if (json.has("players") && json.has("rate")) return readTruth(json, vocabulary);
    if (!json.has("kumite_labels")) {
        throw InputError(file, 0, 0,
                         "holds no labels: it has neither \"kumite_labels\" nor \"players\".");
    }
    if (json["kumite_labels"].integer() != 1) {
        throw json["kumite_labels"].error("this Kumite reads version 1");
    }
    std::vector<TimedLabel> labels;
    for (std::size_t t = 0; t < json["takes"].size(); ++t) {
        const JsonReader take = json["takes"].at(t);
        const JsonReader players = playersOf(take);
        for (std::size_t p = 0; p < players.size(); ++p) {
            const JsonReader entries = players.at(p)["labels"];
            for (std::size_t i = 0; i < entries.size(); ++i) {
                const JsonReader entry = entries.at(i);
                TimedLabel label;
                label.take = take["name"].text();
                label.player = static_cast<int>(p) + 1;
                label.begin = entry["begin_s"].number();
                label.end = entry["end_s"].number();
                checkSpan(label, entry, "begin_s", "end_s");
                label.aspects = readAspectValues(entry, vocabulary);
                label.place = fmt::format("takes[{}].players[{}].labels[{}]", t, p, i);
                labels.push_back(std::move(label));
            }
        }
    }
    return labels;
}

std::vector<TimedLabel> readLabels(const std::filesystem::path& path, const Vocabulary& vocabulary,
                                   Findings* findings) {
    const std::string suffix = lowerCase(path.extension().string());
    if (suffix != ".csv" && suffix != ".json" && suffix != ".eaf") {
        throw Error(path.string() + ": labels are read from .csv, .json and .eaf files.");
    }
    const FileBytes file(path);
    if (suffix == ".csv") return parseLabelsCsv(file.bytes(), path.string(), vocabulary);
    if (suffix == ".eaf") return parseLabelsEaf(file.bytes(), path.string(), vocabulary, findings);
    return parseLabelsJson(file.bytes(), path.string(), vocabulary);
}

}  // namespace kumite
