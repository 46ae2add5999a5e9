#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/tables.h"
#include "core/project/label_files.h"
#include "core/project/label_json.h"
#include "core/project/label_source.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

/// Calls `use(address, fighter, action, label)` for every labelled action.
template <typename Use>
void forLabels(const Project& project, const Analysis& analysis, FighterAddress address,
               const Use& use) {
    const FighterAnalysis& values = analysis.at(address);
    const Fighter& fighter = fighterAt(project, address);
    const auto labels = actionLabels(fighter, values, project.labelling.vocabulary->size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i].anyKnown()) use(fighter, values.segmentation->actions[i], labels[i]);
    }
}

template <typename Use>
void forFighters(const Project& project, std::optional<int> only, const Use& use) {
    for (int t = 0; t < static_cast<int>(project.takes.size()); ++t) {
        if (only && *only != t) continue;
        const auto& fighters = project.takes[static_cast<std::size_t>(t)].fighters;
        for (int p = 0; p < static_cast<int>(fighters.size()); ++p)
            use(FighterAddress{t, p});
    }
}

}  // namespace

std::string labelsCsv(const Project& project, const Analysis& analysis, std::optional<int> take) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    std::string text = "take,player,begin_s,end_s,peak_s,label,source,confidence\n";
    forFighters(project, take, [&](FighterAddress address) {
        const std::string name =
            csvField(project.takes[static_cast<std::size_t>(address.take)].name);
        forLabels(project, analysis, address,
                  [&](const Fighter& fighter, const Action& action, const ActionLabel& label) {
                      const LabelOrigin origin = originOf(vocabulary, label);
                      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", name,
                                     address.player + 1, fixed(action.begin / fighter.rate, 6),
                                     fixed(action.end / fighter.rate, 6),
                                     fixed(action.peak / fighter.rate, 6),
                                     labelText(vocabulary, label.label(), true), origin.source,
                                     fixed(static_cast<double>(origin.confidence), 3));
                  });
    });
    return text;
}

std::string labelsJson(const Project& project, const Analysis& analysis, std::optional<int> take) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    Json takes = Json::array();
    forFighters(project, take, [&](FighterAddress address) {
        if (address.player == 0) {
            takes.push_back({{"name", project.takes[static_cast<std::size_t>(address.take)].name},
                             {"players", Json::array()}});
        }
        Json labels = Json::array();
        forLabels(project, analysis, address,
                  [&](const Fighter& fighter, const Action& action, const ActionLabel& label) {
                      const auto seconds = [&](int frame) {
                          return std::round(1e6 * frame / fighter.rate) / 1e6;
                      };
                      Json entry = {{"begin", action.begin},
                                    {"end", action.end},
                                    {"peak", action.peak},
                                    {"begin_s", seconds(action.begin)},
                                    {"end_s", seconds(action.end)},
                                    {"label", labelText(vocabulary, label.label())}};
                      entry.update(aspectValuesJson(label.aspects, vocabulary));
                      labels.push_back(std::move(entry));
                  });
        takes.back()["players"].push_back({{"labels", std::move(labels)}});
    });
    return prettyJson(
        {{"kumite_labels", 1}, {"vocabulary", vocabulary.name}, {"takes", std::move(takes)}});
}

void writeLabels(const Project& project, const Analysis& analysis, std::optional<int> take,
                 const std::filesystem::path& file) {
    const std::string suffix = lowerCase(file.extension().string());
    if (suffix == ".csv") {
        writeFileAtomically(file, labelsCsv(project, analysis, take));
    } else if (suffix == ".json") {
        writeFileAtomically(file, labelsJson(project, analysis, take));
    } else if (suffix == ".eaf") {
        if (!take && project.takes.size() != 1) {
            throw Error("An .eaf file holds one take: say which.");
        }
        writeFileAtomically(file, labelsEaf(project, analysis, take.value_or(0)));
    } else {
        throw Error(file.string() + ": labels are written as .csv, .json or .eaf.");
    }
}

}  // namespace kumite
