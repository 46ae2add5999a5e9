#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/labelling/learner.h"

namespace kumite::test {

inline const char* const kKinds[] = {"others",         "left_punch:fwd",        "right_punch:fwd",
                                     "left_punch:bwd", "right_punch:bwd",       "left_kick:up",
                                     "right_kick:up",  "left_kick:down",        "right_kick:down",
                                     "jump:up",        "left_punch:fwd+jump:up"};

/// Made actions: each kind has a pattern of its own, mirrored for the other side, plus noise. Every
/// second action is of the first kind.
struct MadeActions {
    FeatureMatrix features;
    std::vector<Label> truth;

    explicit MadeActions(int count, float noise = 1.0f, std::uint32_t seed = 7,
                         std::vector<std::string> kinds = {std::begin(kKinds), std::end(kKinds)}) {
        std::mt19937 random(seed);
        const auto uniform = [&] { return static_cast<float>(random()) / 4294967296.0f - 0.5f; };
        features.resize(count, kFeatureCount);
        for (int i = 0; i < count; ++i) {
            const std::string& kind = kinds[i % 2 == 0 ? 0 : (random() % kinds.size())];
            truth.push_back(parseLabel(kickboxing(), kind));
            features.row(i) = pattern(kind);
            for (int j = 0; j < kFeatureCount; ++j)
                features(i, j) += noise * 2 * uniform();
        }
    }
    static std::uint32_t seedOf(const std::string& text) {
        std::uint32_t seed = 17;
        for (const char c : text)
            seed = 31 * seed + static_cast<std::uint32_t>(c);
        return seed;
    }
    /// Patterns of mirrored kinds are mirror images.
    static Eigen::RowVectorXf pattern(const std::string& kind) {
        const Vocabulary& v = kickboxing();
        const std::string mirror = labelText(v, mirroredLabel(v, parseLabel(v, kind)));
        FeatureMatrix row(2, kFeatureCount);
        for (int side = 0; side < 2; ++side) {
            std::mt19937 random(seedOf(side == 0 ? kind : mirror));
            FeatureMatrix own(1, kFeatureCount);
            for (int j = 0; j < kFeatureCount; ++j)
                own(0, j) = static_cast<float>(random()) / 4294967296.0f - 0.5f;
            if (side == 0) {
                row.row(0) = own.row(0);
            } else {
                mirrorFeatures({own.data(), kFeatureCount}, {row.row(1).data(), kFeatureCount});
            }
        }
        return row.row(0) + row.row(1);
    }
    std::vector<Example> examples(int from, int to) const {
        std::vector<Example> list;
        for (int i = from; i < to; ++i)
            list.push_back({i, truth[static_cast<std::size_t>(i)]});
        return list;
    }
    /// Share of rows from `from` on with every learnt aspect right.
    double accuracy(const Predictions& predictions, int from) const {
        int right = 0;
        const int count = static_cast<int>(truth.size());
        for (int i = from; i < count; ++i) {
            bool same = true;
            for (int a = 0; a < 5; ++a)
                same = same && predictions.at(i, a).qualifier ==
                                   truth[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)];
            right += same;
        }
        return static_cast<double>(right) / (count - from);
    }
};

}  // namespace kumite::test
