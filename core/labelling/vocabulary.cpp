#include "core/labelling/vocabulary.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/formats/json_text.h"
#include "core/labelling/kickboxing_json.h"
#include "core/labelling/label.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVocabularyVersion = 1;

struct ClassifierName {
    Classifier classifier;
    const char* kind;
    const char* rule;
};
constexpr std::array<ClassifierName, 3> kClassifiers = {{{Classifier::Msvm, "msvm", ""},
                                                         {Classifier::ReactRule, "rule", "react"},
                                                         {Classifier::MoveRule, "rule", "move"}}};

std::string optionalText(const JsonReader& json, const std::string& key) {
    return json.has(key) ? json[key].text() : std::string();
}

/// An id is a word of a label's spelling: `:` and `+` would break it apart.
std::string readId(const JsonReader& json) {
    const std::string id = json.text();
    const bool fits = !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    });
    if (!fits) throw json.error("an id is made of letters, digits, _ and -, not \"" + id + "\"");
    return id;
}

std::string readColour(const JsonReader& json) {
    if (!json.has("colour")) return "#808080";
    const std::string colour = json["colour"].text();
    const bool fits = colour.size() == 7 && colour[0] == '#' &&
                      colour.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!fits) throw json["colour"].error("expected a colour like #3a86d8");
    return colour;
}

Classifier readClassifier(const JsonReader& json) {
    const std::string kind = json["classifier"].text();
    const std::string rule = kind == "rule" ? json["rule"].text() : std::string();
    for (const ClassifierName& known : kClassifiers) {
        if (kind == known.kind && rule == known.rule) return known.classifier;
    }
    throw kind == "rule" ? json["rule"].error("expected \"react\" or \"move\"")
                         : json["classifier"].error("expected \"msvm\" or \"rule\"");
}

Aspect readAspect(const JsonReader& json) {
    Aspect aspect;
    aspect.id = readId(json["id"]);
    aspect.name = json.has("name") ? json["name"].text() : aspect.id;
    aspect.colour = readColour(json);
    aspect.key = optionalText(json, "key");
    aspect.classifier = readClassifier(json);
    aspect.strike = optionalText(json, "strike");
    if (json.has("limb")) {
        aspect.limb = roleFromName(json["limb"].text());
        if (!aspect.limb) throw json["limb"].error("is no joint role");
    }
    const JsonReader qualifiers = json["qualifiers"];
    for (std::size_t i = 0; i < qualifiers.size(); ++i) {
        const JsonReader entry = qualifiers.at(i);
        Qualifier qualifier;
        qualifier.id = readId(entry["id"]);
        qualifier.name = entry.has("name") ? entry["name"].text() : qualifier.id;
        qualifier.colour = readColour(entry);
        qualifier.key = optionalText(entry, "key");
        qualifier.attack = entry.has("attack") && entry["attack"].boolean();
        if (aspect.find(qualifier.id)) throw entry["id"].error("is the id of two qualifiers");
        aspect.qualifiers.push_back(std::move(qualifier));
    }
    if (aspect.qualifiers.size() < 2)
        throw qualifiers.error("an aspect has two qualifiers or more");
    if (aspect.qualifiers.size() > 100)
        throw qualifiers.error("an aspect has at most 100 qualifiers");
    if (json.has("fallback")) {
        aspect.fallback = aspect.find(json["fallback"].text());
        if (!aspect.fallback) throw json["fallback"].error("is none of the qualifiers");
    } else if (aspect.classifier != Classifier::MoveRule) {
        throw json.error("\"fallback\" is missing: the qualifier that means \"nothing of it\"");
    }
    return aspect;
}

/// Fills in what refers to other aspects: mirrors and exclusions.
void connect(const JsonReader& json, std::size_t index, Vocabulary& vocabulary) {
    Aspect& aspect = vocabulary.aspects[index];
    const auto named = [&](const JsonReader& entry) {
        const auto found = vocabulary.find(entry.text());
        if (!found) throw entry.error("there is no aspect \"" + entry.text() + "\"");
        return *found;
    };
    aspect.mirror = json.has("mirror") ? named(json["mirror"]) : static_cast<int>(index);
    const Aspect& other = vocabulary[aspect.mirror];
    for (std::size_t i = 0; i < aspect.qualifiers.size(); ++i) {
        Qualifier& qualifier = aspect.qualifiers[i];
        const JsonReader entry = json["qualifiers"].at(i);
        const std::string mirror = entry.has("mirror") ? entry["mirror"].text() : qualifier.id;
        const auto found = other.find(mirror);
        if (!found) throw entry.error("its mirror \"" + mirror + "\" is not in " + other.id);
        qualifier.mirror = *found;
    }
    if (!json.has("excludes")) return;
    for (std::size_t i = 0; i < json["excludes"].size(); ++i) {
        const JsonReader entry = json["excludes"].at(i);
        const int excluded = named(entry);
        if (excluded == static_cast<int>(index)) throw entry.error("an aspect excludes itself");
        if (!vocabulary[excluded].fallback) throw entry.error("has no fallback to go back to");
        aspect.excludes.push_back(excluded);
    }
}

void checkMirrors(const JsonReader& json, const Vocabulary& vocabulary) {
    for (int i = 0; i < vocabulary.size(); ++i) {
        const Aspect& aspect = vocabulary[i];
        const Aspect& other = vocabulary[aspect.mirror];
        const auto place = json.at(static_cast<std::size_t>(i));
        if (other.mirror != i) throw place.error("its mirror's mirror is another aspect");
        for (std::size_t q = 0; q < aspect.qualifiers.size(); ++q) {
            const auto back = static_cast<std::size_t>(aspect.qualifiers[q].mirror);
            if (other.qualifiers[back].mirror != static_cast<int>(q)) {
                throw place.error("the mirror of the mirror of \"" + aspect.qualifiers[q].id +
                                  "\" is another qualifier");
            }
        }
    }
}

void checkStrikes(const JsonReader& json, const Vocabulary& vocabulary, Findings* findings) {
    const auto react = std::find_if(
        vocabulary.aspects.begin(), vocabulary.aspects.end(),
        [](const Aspect& aspect) { return aspect.classifier == Classifier::ReactRule; });
    bool anyStrike = false;
    for (std::size_t i = 0; i < vocabulary.aspects.size(); ++i) {
        const Aspect& aspect = vocabulary.aspects[i];
        if (aspect.strike.empty()) continue;
        anyStrike = true;
        if (!aspect.limb) throw json.at(i).error("\"strike\" needs a \"limb\" that strikes");
        if (react != vocabulary.aspects.end() && !react->find(aspect.strike)) {
            throw json.at(i)["strike"].error("is no qualifier of " + react->id);
        }
    }
    if (react != vocabulary.aspects.end() && !anyStrike && findings) {
        findings->push_back(warning("No aspect has a \"strike\": " + react->id +
                                    " will never find anything to react to."));
    }
}

void checkKeys(const Vocabulary& vocabulary, Findings& findings) {
    std::map<std::string, std::string> lanes;
    for (const Aspect& aspect : vocabulary.aspects) {
        const auto [other, isNew] = lanes.try_emplace(aspect.key, aspect.name);
        if (!isNew && !aspect.key.empty()) {
            findings.push_back(warning("The key " + aspect.key + " stands for both " +
                                       other->second + " and " + aspect.name + "."));
        }
        std::map<std::string, std::string> keys;
        for (const Qualifier& qualifier : aspect.qualifiers) {
            const auto [first, fresh] = keys.try_emplace(qualifier.key, qualifier.name);
            if (!fresh && !qualifier.key.empty()) {
                findings.push_back(warning("In " + aspect.name + " the key " + qualifier.key +
                                           " stands for both " + first->second + " and " +
                                           qualifier.name + "."));
            }
        }
    }
    std::map<std::string, std::string> quick;
    for (const QuickLabel& each : vocabulary.quick) {
        const std::string text = labelText(vocabulary, each.label);
        const auto [other, isNew] = quick.try_emplace(each.key, text);
        if (!isNew && !each.key.empty()) {
            findings.push_back(warning("The key " + each.key + " stands for both " + other->second +
                                       " and " + text + "."));
        }
    }
}

QuickLabel readQuickLabel(const JsonReader& json, const Vocabulary& vocabulary) {
    QuickLabel quick;
    quick.key = optionalText(json, "key");
    const std::string text = json["label"].text();
    try {
        quick.label = parseLabel(vocabulary, text);
    } catch (const Error& error) {
        throw json["label"].error(error.what());
    }
    for (int a = 0; a < vocabulary.size(); ++a) {
        int& qualifier = quick.label[static_cast<std::size_t>(a)];
        const bool ruled = vocabulary[a].classifier != Classifier::Msvm;
        if (ruled && qualifier == vocabulary[a].fallback) qualifier = kUnknown;
    }
    const std::vector<std::string> excluded = conflicts(vocabulary, quick.label);
    if (!excluded.empty()) throw json["label"].error(excluded.front());
    return quick;
}

Json qualifierJson(const Qualifier& qualifier, const Aspect& mirror) {
    Json json = {{"id", qualifier.id}, {"name", qualifier.name}, {"colour", qualifier.colour}};
    if (!qualifier.key.empty()) json["key"] = qualifier.key;
    if (qualifier.attack) json["attack"] = true;
    json["mirror"] = mirror.qualifiers[static_cast<std::size_t>(qualifier.mirror)].id;
    return json;
}

}  // namespace

std::optional<int> Aspect::find(std::string_view qualifier) const {
    for (std::size_t i = 0; i < qualifiers.size(); ++i) {
        if (qualifiers[i].id == qualifier) return static_cast<int>(i);
    }
    return std::nullopt;
}

std::optional<int> Vocabulary::find(std::string_view aspect) const {
    for (std::size_t i = 0; i < aspects.size(); ++i) {
        if (aspects[i].id == aspect) return static_cast<int>(i);
    }
    return std::nullopt;
}

const Vocabulary& kickboxing() {
    static const Vocabulary vocabulary = parseVocabulary(kKickboxingJson, "kickboxing.json");
    return vocabulary;
}

Vocabulary parseVocabulary(std::string_view text, const std::string& file, Findings* findings) {
    const Json json = parseJson(text, file);
    return readVocabulary({json, file, ""}, findings);
}

Vocabulary readVocabulary(const JsonReader& reader, Findings* findings) {
    if (!reader.has("vocabulary")) {
        throw reader.error("is no vocabulary: it has no \"vocabulary\" version");
    }
    if (reader["vocabulary"].integer() != kVocabularyVersion) {
        throw reader["vocabulary"].error("this Kumite reads version 1");
    }
    Vocabulary vocabulary;
    vocabulary.name = reader["name"].text();
    const JsonReader aspects = reader["aspects"];
    for (std::size_t i = 0; i < aspects.size(); ++i) {
        Aspect aspect = readAspect(aspects.at(i));
        if (vocabulary.find(aspect.id)) throw aspects.at(i)["id"].error("is the id of two aspects");
        vocabulary.aspects.push_back(std::move(aspect));
    }
    if (vocabulary.aspects.empty()) throw aspects.error("a vocabulary has one aspect or more");
    for (std::size_t i = 0; i < aspects.size(); ++i)
        connect(aspects.at(i), i, vocabulary);
    checkMirrors(aspects, vocabulary);
    checkStrikes(aspects, vocabulary, findings);
    if (reader.has("quick")) {
        for (std::size_t i = 0; i < reader["quick"].size(); ++i)
            vocabulary.quick.push_back(readQuickLabel(reader["quick"].at(i), vocabulary));
    }
    if (findings) checkKeys(vocabulary, *findings);
    return vocabulary;
}

std::string vocabularyText(const Vocabulary& vocabulary) {
    Json aspects = Json::array();
    for (const Aspect& aspect : vocabulary.aspects) {
        const auto known = std::find_if(
            kClassifiers.begin(), kClassifiers.end(),
            [&](const ClassifierName& name) { return name.classifier == aspect.classifier; });
        Json json = {{"id", aspect.id}, {"name", aspect.name}, {"colour", aspect.colour}};
        if (!aspect.key.empty()) json["key"] = aspect.key;
        json["classifier"] = known->kind;
        if (*known->rule) json["rule"] = known->rule;
        json["mirror"] = vocabulary[aspect.mirror].id;
        for (const int other : aspect.excludes)
            json["excludes"].push_back(vocabulary[other].id);
        if (aspect.limb) json["limb"] = roleName(*aspect.limb);
        if (!aspect.strike.empty()) json["strike"] = aspect.strike;
        for (const Qualifier& qualifier : aspect.qualifiers)
            json["qualifiers"].push_back(qualifierJson(qualifier, vocabulary[aspect.mirror]));
        if (aspect.fallback) {
            json["fallback"] = aspect.qualifiers[static_cast<std::size_t>(*aspect.fallback)].id;
        }
        aspects.push_back(std::move(json));
    }
    Json json = {{"vocabulary", kVocabularyVersion},
                 {"name", vocabulary.name},
                 {"aspects", std::move(aspects)}};
    for (const QuickLabel& quick : vocabulary.quick) {
        Json entry = {{"label", labelText(vocabulary, quick.label)}};
        if (!quick.key.empty()) entry["key"] = quick.key;
        json["quick"].push_back(std::move(entry));
    }
    return prettyJson(json);
}

}  // namespace kumite
