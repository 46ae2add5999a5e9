#include "core/segmentation/force_minima.h"

#include <random>

#include <gtest/gtest.h>

#include "core/segmentation/segmentation.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

/// The definition word for word, by plain search.
std::vector<ForceMinimum> minimaByDefinition(const std::vector<double>& x) {
    std::vector<ForceMinimum> minima;
    const int n = static_cast<int>(x.size());
    const auto at = [&](int i) { return x[static_cast<std::size_t>(i)]; };
    for (int first = 1; first < n; ++first) {
        int last = first;
        while (last + 1 < n && at(last + 1) == at(first))
            ++last;
        const bool isMinimum =
            last + 1 < n && at(first - 1) > at(first) && at(last + 1) > at(first);
        if (!isMinimum) continue;
        const int middle = (first + last) / 2;
        double side[2] = {at(middle), at(middle)};
        for (int i = middle; i >= 0 && at(i) >= at(middle); --i)
            side[0] = std::max(side[0], at(i));
        for (int i = middle; i < n && at(i) >= at(middle); ++i)
            side[1] = std::max(side[1], at(i));
        minima.push_back({middle, at(middle), std::min(side[0], side[1]) - at(middle)});
    }
    return minima;
}

TEST(FindMinima, AgreesWithTheDefinitionOnRandomCurves) {
    std::mt19937 random(11);
    for (int round = 0; round < 500; ++round) {
        // Few levels, so that ties and plateaus are common.
        std::uniform_int_distribution<int> level(0, 2 + round % 6);
        std::vector<double> curve;
        for (int i = 0, n = round % 40; i < n; ++i)
            curve.push_back(level(random));
        EXPECT_EQ(findMinima(curve), minimaByDefinition(curve)) << "round " << round;
    }
}

TEST(FindMinima, EdgesAndPlateaus) {
    EXPECT_TRUE(findMinima({}).empty());
    EXPECT_TRUE(findMinima(std::vector<double>{1}).empty());
    EXPECT_TRUE(findMinima(std::vector<double>{1, 0}).empty());
    EXPECT_TRUE(findMinima(std::vector<double>(10, 1.0)).empty());
    EXPECT_TRUE(findMinima(std::vector<double>{0, 0, 1, 0, 0}).empty());
    const std::vector<double> plateau = {2, 1, 1, 1, 1, 3};
    const auto minima = findMinima(plateau);
    ASSERT_EQ(minima.size(), 1u);
    EXPECT_EQ(minima[0], (ForceMinimum{2, 1.0, 1.0}));
}

TEST(FindMinima, KnownAnswers) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer("minima_curves");
    for (const auto& example : known["curves"]) {
        SCOPED_TRACE(example["what"].get<std::string>());
        const auto curve = example["curve"].get<std::vector<double>>();
        const auto minima = findMinima(curve);
        ASSERT_EQ(minima.size(), example["minima"].size());
        for (std::size_t i = 0; i < minima.size(); ++i) {
            EXPECT_EQ(minima[i].frame, example["minima"][i]);
            EXPECT_NEAR(minima[i].prominence, example["prominences"][i].get<double>(), 1e-9);
        }
        for (const auto& at : example["at"]) {
            const auto cut = segment(curve, minima, at["threshold"].get<double>() - 1e-9, {}, 6);
            std::vector<int> boundaries;
            for (const Boundary& b : cut.boundaries)
                boundaries.push_back(b.frame);
            EXPECT_EQ(boundaries, at["boundaries"].get<std::vector<int>>());
            ASSERT_EQ(cut.actions.size(), at["actions"].size());
            for (std::size_t i = 0; i < cut.actions.size(); ++i) {
                const auto& expected = at["actions"][i];
                EXPECT_EQ(cut.actions[i],
                          (Action{expected["begin"], expected["end"], expected["peak"]}));
                EXPECT_EQ(curve[static_cast<std::size_t>(cut.actions[i].peak)],
                          expected["peak_value"]);
            }
        }
    }
}

}  // namespace
}  // namespace kumite
