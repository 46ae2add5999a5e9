#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/labelling/features.h"
#include "core/labelling/learning_settings.h"

namespace kumite {

/// A kernel over training rows, made once per γ and shared by all aspects, folds and values of C.
class MsvmKernel {
public:
    /// `squaredDistances` of the training rows among each other (square).
    MsvmKernel(const FeatureMatrix& squaredDistances, double gamma);
    ~MsvmKernel();
    MsvmKernel(const MsvmKernel&) = delete;
    MsvmKernel& operator=(const MsvmKernel&) = delete;

    int size() const;
    double gamma() const;

private:
    friend class Msvm;
    struct Nodes;
    std::unique_ptr<Nodes> nodes_;
};

/// A trained multiclass support vector machine: LIBSVM's C-SVC, one against one, classes weighted
/// inversely to their frequency. The only place that knows LIBSVM. Values may be moved, not copied;
/// predictions may run side by side.
class Msvm {
public:
    struct Answer {
        int choice = 0;     ///< the class with the most votes
        double margin = 0;  ///< its smallest decision value against another class; below 0 where
                            ///< the votes go round in a circle
        double probability = 0;  ///< of `choice`, no other class's is above it; 0 if trained
                                 ///< without probabilities
        int second = 0;          ///< the class that comes next: the likeliest of the others, or
                                 ///< without probabilities the one that `margin` is against
        double secondProbability = 0;
    };

    /// Trains on the kernel's rows at `rows`, whose classes are `classes` (any numbers, at least
    /// two different ones). Probabilities (by LIBSVM's inner cross-validation) draw from the C
    /// library's generator, which `seed` sets: such fits wait for each other and are repeatable.
    Msvm(const MsvmKernel& kernel, std::span<const int> rows, std::span<const int> classes,
         double c, bool probabilities = false, std::uint32_t seed = 1);
    ~Msvm();
    Msvm(Msvm&&) noexcept;
    Msvm& operator=(Msvm&&) noexcept;

    /// Squared distances of one row to all rows of the kernel.
    Answer predict(std::span<const float> squaredDistances) const;
    /// The same for a row of the kernel itself.
    Answer predictRow(const MsvmKernel& kernel, int row) const;

private:
    struct Model;
    std::unique_ptr<Model> model_;
};

}  // namespace kumite
