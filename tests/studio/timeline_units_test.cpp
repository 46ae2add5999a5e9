#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "studio/app/words.h"
#include "studio/timeline/curve_pyramid.h"
#include "studio/timeline/time_mapping.h"

namespace kumite::studio {
namespace {

TEST(TimeMapping, GoesThereAndBack) {
    const TimeMapping map{2.0, 6.0, 100, 800};
    EXPECT_DOUBLE_EQ(map.xOf(2.0), 100);
    EXPECT_DOUBLE_EQ(map.xOf(6.0), 900);
    EXPECT_DOUBLE_EQ(map.timeAt(map.xOf(3.7)), 3.7);
    EXPECT_DOUBLE_EQ(map.pixelsPerSecond(), 200);
}

TEST(TimeMapping, ZoomKeepsTheMomentUnderThePointer) {
    const TimeMapping map{0.0, 10.0, 50, 1000};
    const TimeMapping zoomed = map.zoomedAbout(300, 2.5);
    EXPECT_NEAR(zoomed.timeAt(300), map.timeAt(300), 1e-12);
    EXPECT_NEAR(zoomed.end - zoomed.begin, 4.0, 1e-12);
    const TimeMapping back = zoomed.zoomedAbout(300, 1 / 2.5);
    EXPECT_NEAR(back.begin, map.begin, 1e-12);
}

TEST(TimeMapping, PanMovesByPixels) {
    const TimeMapping map{0.0, 10.0, 0, 1000};
    EXPECT_NEAR(map.panned(100).xOf(3.0), map.xOf(3.0) + 100, 1e-9);
}

TEST(TimeMapping, RulerLabelsKeepTheirDistance) {
    for (double pixelsPerSecond : {0.05, 0.7, 3.0, 31.0, 240.0, 5000.0}) {
        const double step = rulerStep(pixelsPerSecond, 90);
        EXPECT_GE(step * pixelsPerSecond, 90 - 1e-9) << pixelsPerSecond;
    }
    EXPECT_DOUBLE_EQ(rulerStep(100, 90), 1);
}

TEST(CurvePyramid, ExtentOfEveryStretchIsThatOfItsSamples) {
    std::mt19937 random(3);
    for (const std::size_t size : {1U, 2U, 3U, 7U, 64U, 101U}) {
        std::vector<double> samples(size);
        for (double& sample : samples)
            sample = std::uniform_real_distribution<>(-1, 3)(random);
        const CurvePyramid curve(samples);
        ASSERT_EQ(curve.size(), size);
        for (std::size_t begin = 0; begin < size; ++begin) {
            for (std::size_t end = begin + 1; end <= size; ++end) {
                const auto [low, high] =
                    std::minmax_element(samples.begin() + static_cast<long>(begin),
                                        samples.begin() + static_cast<long>(end));
                const CurveExtent extent = curve.extent(begin, end);
                ASSERT_FLOAT_EQ(extent.low, static_cast<float>(*low)) << begin << ' ' << end;
                ASSERT_FLOAT_EQ(extent.high, static_cast<float>(*high)) << begin << ' ' << end;
            }
        }
    }
}

TEST(CurvePyramid, OnePeakInAMillionIsNeverLost) {
    std::vector<double> samples(1'000'000, 1.0);
    samples[654'321] = 4.0;
    const CurvePyramid curve(samples);
    EXPECT_FLOAT_EQ(curve.extent().high, 4.0F);
    EXPECT_FLOAT_EQ(curve.extent(654'000, 655'000).high, 4.0F);
    EXPECT_FLOAT_EQ(curve.extent(0, 654'321).high, 1.0F);
}

TEST(CurvePyramid, EmptyIsEmpty) {
    EXPECT_EQ(CurvePyramid().size(), 0U);
    EXPECT_FLOAT_EQ(CurvePyramid().extent().high, 0.0F);
}

TEST(Words, TimesReadAlikeEverywhere) {
    EXPECT_EQ(timeText(0).toStdString(), "0:00.000");
    EXPECT_EQ(timeText(64.25).toStdString(), "1:04.250");
    EXPECT_EQ(timeText(59.9996).toStdString(), "1:00.000");
    EXPECT_EQ(timeText(-0.5).toStdString(), "−0:00.500");
    EXPECT_EQ(timeText(64.25, 5).toStdString(), "1:04");
    EXPECT_EQ(timeText(64.2, 0.2).toStdString(), "1:04.2");
}

TEST(Words, NumbersCarryUnits) {
    EXPECT_EQ(bodyWeightsText(0.7249).toStdString(), "0.72 BW");
    EXPECT_EQ(percentText(0.123).toStdString(), "12 %");
}

}  // namespace
}  // namespace kumite::studio
