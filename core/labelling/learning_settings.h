#pragma once

#include <cstdint>
#include <vector>

namespace kumite {

/// How the aspects that are not left to rules are learnt (method A4).
struct LearningSettings {
    bool mirrored = true;    ///< every example also counts as its mirror image
    bool limbFirst = false;  ///< first which limbs strike, then what each of them does
    int folds = 5;           ///< of every cross-validation
    std::uint32_t seed = 1;

    bool operator==(const LearningSettings&) const = default;
};

/// Parameters of a C-SVC with the kernel exp(−γ d²).
struct MsvmParameters {
    double c = 16.0;
    double gamma = 0.5 / 540;  ///< half of LIBSVM's default for 540 numbers

    bool operator==(const MsvmParameters&) const = default;
};

/// C and γ per aspect of the vocabulary, and one more for "which limbs" (limb first).
using ParameterSet = std::vector<MsvmParameters>;

}  // namespace kumite
