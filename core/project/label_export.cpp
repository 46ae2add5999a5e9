#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/tables.h"
#include "core/project/label_files.h"
#include "core/project/label_json.h"

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

/// The least sure source of a label and its confidence.
AspectValue weakest(const ActionLabel& label) {
    AspectValue least{0, LabelSource::Hand, 1.0f};
    for (const AspectValue& value : label.aspects) {
        if (!value.known()) continue;
        least.source = std::max(least.source, value.source);
        least.confidence = std::min(least.confidence, value.confidence);
    }
    return least;
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                // Control characters have no place in XML.
                out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

struct Annotation {
    int begin = 0;  ///< milliseconds
    int end = 0;
    std::string value;
};

}  // namespace

std::string labelsCsv(const Project& project, const Analysis& analysis, std::optional<int> take) {
    std::string text = "take,player,begin_s,end_s,peak_s,label,source,confidence\n";
    forFighters(project, take, [&](FighterAddress address) {
        const std::string name =
            csvField(project.takes[static_cast<std::size_t>(address.take)].name);
        forLabels(project, analysis, address,
                  [&](const Fighter& fighter, const Action& action, const ActionLabel& label) {
                      const AspectValue least = weakest(label);
                      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", name,
                                     address.player + 1, fixed(action.begin / fighter.rate, 6),
                                     fixed(action.end / fighter.rate, 6),
                                     fixed(action.peak / fighter.rate, 6),
                                     labelText(*project.labelling.vocabulary, label.label(), true),
                                     sourceName(least.source),
                                     fixed(static_cast<double>(least.confidence), 3));
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

std::string labelsEaf(const Project& project, const Analysis& analysis, int take) {
    const Vocabulary& vocabulary = *project.labelling.vocabulary;
    // ELAN's clock begins at 0; a take's may begin before.
    const double start =
        std::min(0.0, timeSpan(project.takes[static_cast<std::size_t>(take)]).begin);
    std::map<int, int> slots;  // milliseconds to number
    std::string tiers;
    int annotations = 0;
    std::vector<std::pair<std::string, std::vector<Annotation>>> all;
    forFighters(project, take, [&](FighterAddress address) {
        for (int a = 0; a < vocabulary.size(); ++a) {
            std::vector<Annotation> tier;
            const Aspect& aspect = vocabulary[a];
            forLabels(project, analysis, address,
                      [&](const Fighter& fighter, const Action& action, const ActionLabel& label) {
                          const int value = label.aspects[static_cast<std::size_t>(a)].qualifier;
                          if (value == kUnknown || value == aspect.fallback) return;
                          const auto at = [&](int frame) {
                              return static_cast<int>(
                                  std::lround(1000 * (timeOfFrame(fighter, frame) - start)));
                          };
                          tier.push_back({at(action.begin), at(action.end),
                                          aspect.qualifiers[static_cast<std::size_t>(value)].id});
                          slots[tier.back().begin];
                          slots[tier.back().end];
                      });
            all.emplace_back(fmt::format("fighter {} {}", address.player + 1, aspect.id),
                             std::move(tier));
        }
    });
    std::string times;
    int number = 0;
    for (auto& [time, slot] : slots) {
        slot = ++number;
        times +=
            fmt::format("    <TIME_SLOT TIME_SLOT_ID=\"ts{}\" TIME_VALUE=\"{}\"/>\n", slot, time);
    }
    for (const auto& [name, tier] : all) {
        tiers += fmt::format("  <TIER LINGUISTIC_TYPE_REF=\"qualifier\" TIER_ID=\"{}\">\n",
                             escaped(name));
        for (const Annotation& annotation : tier) {
            tiers += fmt::format(
                "    <ANNOTATION>\n"
                "      <ALIGNABLE_ANNOTATION ANNOTATION_ID=\"a{}\" TIME_SLOT_REF1=\"ts{}\" "
                "TIME_SLOT_REF2=\"ts{}\">\n"
                "        <ANNOTATION_VALUE>{}</ANNOTATION_VALUE>\n"
                "      </ALIGNABLE_ANNOTATION>\n"
                "    </ANNOTATION>\n",
                ++annotations, slots[annotation.begin], slots[annotation.end],
                escaped(annotation.value));
        }
        tiers += "  </TIER>\n";
    }
    // The date is fixed, so that equal labels give equal files.
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<ANNOTATION_DOCUMENT AUTHOR=\"\" DATE=\"2000-01-01T00:00:00+00:00\" FORMAT=\"3.0\" "
        "VERSION=\"3.0\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
        "xsi:noNamespaceSchemaLocation=\"http://www.mpi.nl/tools/elan/EAFv3.0.xsd\">\n"
        "  <HEADER MEDIA_FILE=\"\" TIME_UNITS=\"milliseconds\">\n"
        "    <PROPERTY NAME=\"lastUsedAnnotationId\">{}</PROPERTY>\n"
        "  </HEADER>\n"
        "  <TIME_ORDER>\n{}  </TIME_ORDER>\n"
        "{}"
        "  <LINGUISTIC_TYPE GRAPHIC_REFERENCES=\"false\" LINGUISTIC_TYPE_ID=\"qualifier\" "
        "TIME_ALIGNABLE=\"true\"/>\n"
        "</ANNOTATION_DOCUMENT>\n",
        annotations, times, tiers);
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
