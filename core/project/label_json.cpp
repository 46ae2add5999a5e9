#include "core/project/label_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/labelling/learner.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<LabelSource, 3> kSources = {LabelSource::Hand, LabelSource::Rule,
                                                 LabelSource::Machine};

/// A confidence as people wrote it down: floats have no 0.93.
double asWritten(float confidence) {
    return std::round(1e4 * static_cast<double>(confidence)) / 1e4;
}

AspectValue readValue(const JsonReader& json, const Aspect& aspect, LabelSource source) {
    AspectValue value{kUnknown, source, 1.0f};
    const bool plain = source == LabelSource::Hand;
    const JsonReader name = plain ? json : json.at(0);
    const auto qualifier = aspect.find(name.text());
    if (!qualifier) throw name.error("\"" + name.text() + "\" is no qualifier of " + aspect.id);
    value.qualifier = static_cast<std::int8_t>(*qualifier);
    if (plain) return value;
    const double confidence = json.at(1).number();
    if (confidence < 0 || confidence > 1) throw json.at(1).error("expected 0 to 1");
    value.confidence = static_cast<float>(confidence);
    return value;
}

double atLeastZero(const JsonReader& json) {
    const double value = json.number();
    if (value < 0) throw json.error("expected 0 or more");
    return value;
}

RuleSettings readRules(const JsonReader& json) {
    RuleSettings rules;
    rules.contacts.height = atLeastZero(json["contact_height_m"]);
    rules.contacts.speed = atLeastZero(json["contact_speed_mps"]);
    rules.contacts.releaseHeight = atLeastZero(json["release_height_m"]);
    rules.contacts.releaseSpeed = atLeastZero(json["release_speed_mps"]);
    rules.contacts.shortest = atLeastZero(json["shortest_contact_s"]);
    rules.closingSpeed = atLeastZero(json["closing_speed_mps"]);
    return rules;
}

LearningSettings readLearning(const JsonReader& json) {
    LearningSettings learning;
    learning.mirrored = json["mirrored"].boolean();
    learning.limbFirst = json["limb_first"].boolean();
    learning.folds = json["folds"].integer();
    if (learning.folds < 2) throw json["folds"].error("expected 2 or more");
    const double seed = json["seed"].number();
    if (seed < 0 || seed > 4294967295.0 || seed != std::floor(seed)) {
        throw json["seed"].error("expected a whole number from 0 on");
    }
    learning.seed = static_cast<std::uint32_t>(seed);
    return learning;
}

}  // namespace

Json aspectValuesJson(const std::vector<AspectValue>& values, const Vocabulary& vocabulary) {
    Json json = Json::object();
    for (const LabelSource source : kSources) {
        Json group = Json::object();
        for (std::size_t a = 0; a < values.size(); ++a) {
            const AspectValue& value = values[a];
            if (!value.known() || value.source != source) continue;
            const Aspect& aspect = vocabulary.aspects[a];
            const std::string& name =
                aspect.qualifiers[static_cast<std::size_t>(value.qualifier)].id;
            if (source == LabelSource::Hand) {
                group[aspect.id] = name;
            } else {
                group[aspect.id] = {name, asWritten(value.confidence)};
            }
        }
        if (!group.empty()) json[std::string(sourceName(source))] = std::move(group);
    }
    return json;
}

std::vector<AspectValue> readAspectValues(const JsonReader& json, const Vocabulary& vocabulary) {
    std::vector<AspectValue> values(vocabulary.aspects.size());
    for (const LabelSource source : kSources) {
        const std::string group(sourceName(source));
        if (!json.has(group)) continue;
        for (const std::string& key : json[group].keys()) {
            const auto aspect = vocabulary.find(key);
            if (!aspect) {
                throw json[group].error("\"" + key + "\" is no aspect of the vocabulary " +
                                        vocabulary.name);
            }
            values[static_cast<std::size_t>(*aspect)] =
                readValue(json[group][key], vocabulary[*aspect], source);
        }
    }
    return values;
}

Json labelTrackJson(const LabelTrack& track, const Vocabulary& vocabulary) {
    Json json = Json::array();
    for (const ActionLabel& label : track) {
        Json entry = {{"peak", label.peak}};
        entry.update(aspectValuesJson(label.aspects, vocabulary));
        json.push_back(std::move(entry));
    }
    return json;
}

LabelTrack readLabelTrack(const JsonReader& json, const Vocabulary& vocabulary) {
    LabelTrack track;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const JsonReader entry = json.at(i);
        ActionLabel label{entry["peak"].integer(), readAspectValues(entry, vocabulary)};
        if (label.peak < 0) throw entry["peak"].error("a frame cannot be negative");
        track.push_back(std::move(label));
    }
    std::stable_sort(track.begin(), track.end(),
                     [](const ActionLabel& a, const ActionLabel& b) { return a.peak < b.peak; });
    const auto twice = std::adjacent_find(
        track.begin(), track.end(),
        [](const ActionLabel& a, const ActionLabel& b) { return a.peak == b.peak; });
    if (twice != track.end()) {
        throw json.error("the peak " + std::to_string(twice->peak) + " is labelled twice");
    }
    return track;
}

Json labelSettingsJson(const LabelSettings& settings) {
    const Vocabulary& vocabulary = *settings.vocabulary;
    const ContactSettings& contacts = settings.rules.contacts;
    Json json = Json::object();
    if (vocabulary != kickboxing()) {
        json["vocabulary"] = parseJson(vocabularyText(vocabulary), "vocabulary");
    }
    json["rules"] = {{"contact_height_m", contacts.height},
                     {"contact_speed_mps", contacts.speed},
                     {"release_height_m", contacts.releaseHeight},
                     {"release_speed_mps", contacts.releaseSpeed},
                     {"shortest_contact_s", contacts.shortest},
                     {"closing_speed_mps", settings.rules.closingSpeed}};
    json["learning"] = {{"mirrored", settings.learning.mirrored},
                        {"limb_first", settings.learning.limbFirst},
                        {"folds", settings.learning.folds},
                        {"seed", settings.learning.seed}};
    if (!settings.model) return json;
    Json parameters = Json::array();
    for (const MsvmParameters& each : settings.model->parameters)
        parameters.push_back({{"c", each.c}, {"gamma", each.gamma}});
    json["model"] = {{"training_sha256", settings.model->trainingHash},
                     {"parameters", std::move(parameters)}};
    return json;
}

LabelSettings readLabelSettings(const JsonReader& json) {
    LabelSettings settings;
    if (json.has("vocabulary")) settings.vocabulary = readVocabulary(json["vocabulary"]);
    settings.rules = readRules(json["rules"]);
    settings.learning = readLearning(json["learning"]);
    if (!json.has("model")) return settings;
    const JsonReader model = json["model"];
    ModelRecord record;
    record.trainingHash = model["training_sha256"].text();
    const JsonReader parameters = model["parameters"];
    if (parameters.size() != defaultParameters(*settings.vocabulary).size()) {
        throw parameters.error("expected one entry per aspect and one more");
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        record.parameters.push_back(
            {parameters.at(i)["c"].positive(), parameters.at(i)["gamma"].positive()});
    }
    settings.model = std::move(record);
    return settings;
}

}  // namespace kumite
