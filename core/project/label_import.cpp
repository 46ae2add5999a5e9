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

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

/// Values of a whole label that one source said; rules are credited for what they decide.
std::vector<AspectValue> valuesOf(const Vocabulary& vocabulary, const Label& label,
                                  LabelSource source, float confidence) {
    std::vector<AspectValue> values(label.size());
    for (std::size_t a = 0; a < label.size(); ++a) {
        if (label[a] == kUnknown) continue;
        const bool byRule =
            source == LabelSource::Machine && vocabulary.aspects[a].classifier != Classifier::Msvm;
        values[a] = {static_cast<std::int8_t>(label[a]), byRule ? LabelSource::Rule : source,
                     source == LabelSource::Hand ? 1.0f : confidence};
    }
    return values;
}

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
    const auto source = sourceFromName(sourceText.empty() ? "hand" : sourceText);
    if (!source) throw row.error("source is hand, rule or machine");
    const std::string confidenceText = row.text("confidence").value_or("");
    const auto confidence = confidenceText.empty() ? 1.0 : parseNumber(confidenceText);
    if (!confidence || *confidence < 0 || *confidence > 1) {
        throw row.error("confidence is a number from 0 to 1");
    }
    try {
        label.aspects = valuesOf(vocabulary, parseLabel(vocabulary, row.text("label").value_or("")),
                                 *source, static_cast<float>(*confidence));
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

/// The truth of a made bout: frames at `rate`.
std::vector<TimedLabel> readTruth(const JsonReader& json, const Vocabulary& vocabulary) {
    const double rate = json["rate"].positive();
    std::vector<TimedLabel> labels;
    for (std::size_t p = 0; p < json["players"].size(); ++p) {
        const JsonReader actions = json["players"].at(p)["actions"];
        for (std::size_t i = 0; i < actions.size(); ++i) {
            const JsonReader entry = actions.at(i);
            TimedLabel label;
            label.player = static_cast<int>(p) + 1;
            label.begin = entry["begin"].integer() / rate;
            label.end = entry["end"].integer() / rate;
            label.aspects = valuesOf(vocabulary, readTrueLabel(entry["label"], vocabulary),
                                     LabelSource::Hand, 1.0f);
            label.place = fmt::format("player {}, action {}", p + 1, i);
            labels.push_back(std::move(label));
        }
    }
    return labels;
}

double overlapOf(const TimedLabel& label, const Action& action, double rate) {
    return std::min(label.end, action.end / rate) - std::max(label.begin, action.begin / rate);
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
        for (std::size_t p = 0; p < take["players"].size(); ++p) {
            const JsonReader entries = take["players"].at(p)["labels"];
            for (std::size_t i = 0; i < entries.size(); ++i) {
                const JsonReader entry = entries.at(i);
                TimedLabel label;
                label.take = take["name"].text();
                label.player = static_cast<int>(p) + 1;
                label.begin = entry["begin_s"].number();
                label.end = entry["end_s"].number();
                if (label.end < label.begin) throw entry.error("end_s lies before begin_s");
                label.aspects = readAspectValues(entry, vocabulary);
                label.place = fmt::format("takes[{}].players[{}].labels[{}]", t, p, i);
                labels.push_back(std::move(label));
            }
        }
    }
    return labels;
}

std::vector<TimedLabel> readLabels(const std::filesystem::path& path,
                                   const Vocabulary& vocabulary) {
    const std::string suffix = lowerCase(path.extension().string());
    if (suffix != ".csv" && suffix != ".json") {
        throw Error(path.string() + ": labels are read from .csv and .json files.");
    }
    const MappedFile file(path);
    return suffix == ".csv" ? parseLabelsCsv(file.bytes(), path.string(), vocabulary)
                            : parseLabelsJson(file.bytes(), path.string(), vocabulary);
}

MatchedLabels matchLabels(const Project& project, const Analysis& analysis,
                          const std::vector<TimedLabel>& labels, std::optional<int> take) {
    const int aspects = project.labelling.vocabulary->size();
    MatchedLabels result;
    std::vector<std::vector<const TimedLabel*>> owners;  // per fighter and action
    const auto fighterOf = [&](FighterAddress address) {
        for (std::size_t i = 0; i < result.fighters.size(); ++i) {
            if (result.fighters[i].fighter == address) return i;
        }
        // Nothing is known yet: only what the file says is handed on.
        std::vector<ActionLabel> open =
            actionLabels(fighterAt(project, address), analysis.at(address), aspects);
        for (ActionLabel& label : open)
            label.aspects.assign(static_cast<std::size_t>(aspects), {});
        owners.emplace_back(open.size(), nullptr);
        result.fighters.push_back({address, std::move(open)});
        return result.fighters.size() - 1;
    };
    const auto refuse = [&](const TimedLabel& label, const std::string& why) {
        result.unmatched.push_back(
            warning(fmt::format("{} ({}–{} s, fighter {}): {}", label.place, fixed(label.begin, 2),
                                fixed(label.end, 2), label.player, why)));
    };
    if (!take && project.takes.size() == 1) take = 0;
    for (const TimedLabel& label : labels) {
        const auto named = std::find_if(project.takes.begin(), project.takes.end(),
                                        [&](const Take& each) { return each.name == label.take; });
        std::optional<int> index = take;
        if (named != project.takes.end()) index = static_cast<int>(named - project.takes.begin());
        if (!index ||
            (!label.take.empty() && named == project.takes.end() && project.takes.size() > 1)) {
            refuse(label, "the project has no take \"" + label.take + "\".");
            continue;
        }
        const FighterAddress address{*index, label.player - 1};
        const auto players = project.takes[static_cast<std::size_t>(*index)].fighters.size();
        if (address.player >= static_cast<int>(players) || !analysis.at(address).segmentation) {
            refuse(label, "the take has no such fighter.");
            continue;
        }
        const double rate = fighterAt(project, address).rate;
        const std::vector<Action>& actions = analysis.at(address).segmentation->actions;
        const auto best =
            std::max_element(actions.begin(), actions.end(), [&](const Action& a, const Action& b) {
                return overlapOf(label, a, rate) < overlapOf(label, b, rate);
            });
        const double least =
            best == actions.end()
                ? 0
                : 0.5 * std::min(label.end - label.begin, (best->end - best->begin) / rate);
        if (best == actions.end() || overlapOf(label, *best, rate) < least - 1e-6) {
            refuse(label, "no action there.");
            continue;
        }
        const std::size_t fighter = fighterOf(address);
        const auto action = static_cast<std::size_t>(best - actions.begin());
        const TimedLabel*& owner = owners[fighter][action];
        if (owner && overlapOf(*owner, *best, rate) >= overlapOf(label, *best, rate)) {
            refuse(label, "its action takes the label of " + owner->place + ".");
            continue;
        }
        if (owner) refuse(*owner, "its action takes the label of " + label.place + ".");
        result.matched += owner == nullptr;
        owner = &label;
        result.fighters[fighter].labels[action].aspects = label.aspects;
    }
    return result;
}

}  // namespace kumite
