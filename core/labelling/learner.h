#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/labelling/features.h"
#include "core/labelling/label.h"
#include "core/labelling/learning_settings.h"
#include "core/labelling/msvm.h"

namespace kumite {

/// What a hand said about the action in a row of the feature matrix. Unknown aspects do not train.
struct Example {
    int row = 0;
    Label label;

    bool operator==(const Example&) const = default;
};

/// What the machine says about one aspect of one action.
struct Prediction {
    int qualifier = kUnknown;  ///< kUnknown: the aspect has no example
    double margin = 0;         ///< distance to the next best, in units of the machine's margin
    double confidence = 0;     ///< calibrated probability; where only one class has been seen, how
                               ///< rare others must be (rule of three); 0 if not asked for
    bool blind = true;         ///< fewer than two classes seen: nothing was learnt
    int second = kUnknown;     ///< the qualifier that comes next; kUnknown: none
    double secondConfidence = 0;  ///< its probability, as `confidence`; never above that
};

/// Predictions of all rows, row by row, one per aspect of the vocabulary (rule aspects stay blind).
struct Predictions {
    int aspects = 0;
    std::vector<Prediction> values;

    const Prediction& at(int row, int aspect) const {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(aspects) +
                      static_cast<std::size_t>(aspect)];
    }
    Prediction& at(int row, int aspect) {
        return const_cast<Prediction&>(std::as_const(*this).at(row, aspect));
    }
};

/// The smallest margin of a row over the aspects that were learnt.
double smallestMargin(const Predictions& predictions, int row);

/// The examples in standardised form with their distances, shared by every aspect, every fold and
/// every C and γ: what makes a round quick. Of more than 2000 examples so many take part, every
/// label by its share. Refers to the vocabulary and the features.
class TrainingSet {
public:
    TrainingSet(const Vocabulary& vocabulary, const FeatureMatrix& features,
                std::vector<Example> examples, const LearningSettings& settings);
    ~TrainingSet();
    TrainingSet(TrainingSet&&) noexcept;

    /// Those that take part.
    const std::vector<Example>& examples() const;

    /// C and γ of every learnt aspect by stratified cross-validation on a grid; an example and its
    /// mirror image are never on both sides of a fold. Aspects with fewer than two classes keep
    /// the defaults. At most 300 examples take part. Cancellable.
    ParameterSet searchParameters(const Progress& progress = {}) const;

    /// Trains every aspect and predicts every row of the features. With `probabilities`,
    /// confidences are calibrated (slower); without, they are 0 and only margins count.
    Predictions predict(const ParameterSet& parameters, bool probabilities,
                        const Progress& progress = {}) const;

    /// What machines that had not seen them say of the examples, one label each (stratified
    /// cross-validation); aspects that are not learnt are unknown. With fewer than two examples
    /// all is unknown.
    std::vector<Label> crossValidate(const ParameterSet& parameters,
                                     const Progress& progress = {}) const;

    /// Share of the rows that no hand labelled whose learnt aspects should all be right. Stratified
    /// cross-validation tells how often answers are right at a margin (`Reliability`); the
    /// `predictions` for these rows are taken to be right as often as those at their margins. The
    /// examples alone would say too little: they were asked for because they are hard. With no such
    /// row the share of the examples; 0 with fewer than two.
    double expectedAccuracy(const ParameterSet& parameters, const Predictions& predictions,
                            const Progress& progress = {}) const;

private:
    /// What machines that had not seen them say of the examples, one row each.
    Predictions unseen(const ParameterSet& parameters, const Progress& progress) const;

    struct Data;
    std::unique_ptr<Data> data_;
};

/// Whether every learnt aspect that is known in the truth was answered so.
bool learntAspectsMatch(const Vocabulary& vocabulary, const Label& truth, const Label& answer);

ParameterSet defaultParameters(const Vocabulary& vocabulary);

/// SHA-256 of everything that training depends on: features of the examples, labels, settings and
/// parameters. Equal hashes train equal machines.
std::string trainingHash(const FeatureMatrix& features, const std::vector<Example>& examples,
                         const LearningSettings& settings, const ParameterSet& parameters);

/// Deals `classes.size()` items into folds so that every class is spread as evenly as it can be;
/// the order within a class is drawn by `seed`. Fold of each item.
std::vector<int> stratifiedFolds(std::span<const int> classes, int folds, std::uint32_t seed);

}  // namespace kumite
