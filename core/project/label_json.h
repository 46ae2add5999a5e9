#pragma once

#include "core/formats/json_text.h"
#include "core/project/label_settings.h"

namespace kumite {

/// How labels and their settings stand in a project file (core/project/README.md).
nlohmann::ordered_json labelTrackJson(const LabelTrack& track, const Vocabulary& vocabulary);
LabelTrack readLabelTrack(const JsonReader& json, const Vocabulary& vocabulary);

nlohmann::ordered_json labelSettingsJson(const LabelSettings& settings);
LabelSettings readLabelSettings(const JsonReader& json);

/// The values of one action, by source: {"hand": {aspect: qualifier}, "machine": {aspect:
/// [qualifier, confidence]}}.
nlohmann::ordered_json aspectValuesJson(const std::vector<AspectValue>& values,
                                        const Vocabulary& vocabulary);
std::vector<AspectValue> readAspectValues(const JsonReader& json, const Vocabulary& vocabulary);

}  // namespace kumite
