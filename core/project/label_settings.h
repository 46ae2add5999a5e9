#pragma once

#include <optional>
#include <string>

#include "core/base/shared_value.h"
#include "core/labelling/label.h"
#include "core/labelling/learning_settings.h"
#include "core/labelling/rules.h"
#include "core/labelling/vocabulary.h"

namespace kumite {

/// What the last parameter search found, kept so that the same labels train the same machines.
struct ModelRecord {
    ParameterSet parameters;
    std::string trainingHash;  ///< of what it was made from, see trainingHash

    bool operator==(const ModelRecord&) const = default;
};

/// How a project is labelled (method A3 to A5).
struct LabelSettings {
    SharedValue<Vocabulary> vocabulary = [] {
        static const SharedValue<Vocabulary> builtIn(kickboxing());
        return builtIn;
    }();
    RuleSettings rules;
    LearningSettings learning;
    std::optional<ModelRecord> model;

    bool operator==(const LabelSettings&) const = default;
};

}  // namespace kumite
