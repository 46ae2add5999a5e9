// Pure functions of the timeline, as properties over made curves, zooms and marks.

#include "studio/timeline/level_of_detail.h"

#include <gtest/gtest.h>

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <random>

#include "studio/timeline/curve_painter.h"
#include "studio/timeline/loop_handles.h"
#include "studio/timeline/snapping.h"
#include "studio/timeline/time_mapping.h"
#include "studio/workspaces/segment/value_field.h"

namespace kumite::studio {
namespace {

std::vector<double> noise(std::size_t size, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<double> samples(size);
    for (double& sample : samples)
        sample = std::normal_distribution<>(1, 0.3)(random);
    return samples;
}

/// On the line that joins the samples.
float valueAt(const std::vector<double>& samples, double sample) {
    const auto before = std::min(static_cast<std::size_t>(sample), samples.size() - 2);
    const double share = sample - static_cast<double>(before);
    return static_cast<float>(samples[before] + share * (samples[before + 1] - samples[before]));
}

TEST(CurveColumns, LoseNoPeakAtAnyZoomAndAnyScroll) {
    std::mt19937 random(11);
    for (const std::size_t size : {1U, 2U, 37U, 1000U, 20'000U}) {
        const std::vector<double> samples = noise(size, static_cast<unsigned>(size));
        const CurvePyramid curve(samples);
        for (int trial = 0; trial < 60; ++trial) {
            const double step = std::pow(10.0, std::uniform_real_distribution<>(-3, 1.5)(random));
            const double left = 118, right = 118 + 900;
            const SampleAxis axis{std::uniform_real_distribution<>(
                                      right - static_cast<double>(size) * step - 50, right)(random),
                                  step};
            const auto columns = curveColumns(curve, axis, left, right);
            std::size_t column = 0;
            for (std::size_t i = 0; i < size; ++i) {
                const double x = axis.xOf(static_cast<double>(i));
                if (x < left + 1e-6 || x > right - 1 - 1e-6) continue;
                // A sample that stands on an edge may be in either column.
                while (column + 1 < columns.size() && columns[column].x + 1 <= x - 1e-9)
                    ++column;
                bool held = false;
                for (std::size_t c = column > 0 ? column - 1 : 0;
                     c < std::min(columns.size(), column + 2); ++c) {
                    const auto value = static_cast<float>(samples[i]);
                    held |= std::abs(columns[c].x + 0.5 - x) <= 0.5 + 1e-6 &&
                            columns[c].low <= value && value <= columns[c].high;
                }
                ASSERT_TRUE(held) << "sample " << i << " of " << size << ", step " << step;
            }
        }
    }
}

TEST(CurveColumns, TouchEachOtherAndHoldNothingThatIsElsewhere) {
    const std::vector<double> samples = noise(5000, 3);
    const CurvePyramid curve(samples);
    const SampleAxis axis{-40.3, 0.13};
    const auto columns = curveColumns(curve, axis, 0, 400);
    ASSERT_EQ(columns.size(), 400U);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (i > 0) {
            EXPECT_LE(columns[i].low, columns[i - 1].high);
            EXPECT_GE(columns[i].high, columns[i - 1].low);
        }
        // The line from edge to edge and every sample between.
        const double from = axis.sampleAt(columns[i].x);
        const double to = axis.sampleAt(columns[i].x + 1);
        float low = std::min(valueAt(samples, from), valueAt(samples, to));
        float high = std::max(valueAt(samples, from), valueAt(samples, to));
        for (double sample = std::ceil(from); sample <= to; ++sample) {
            low = std::min(low, valueAt(samples, sample));
            high = std::max(high, valueAt(samples, sample));
        }
        ASSERT_NEAR(columns[i].low, low, 1e-5) << i;
        ASSERT_NEAR(columns[i].high, high, 1e-5) << i;
    }
    EXPECT_TRUE(curveColumns(curve, {1000, 0.1}, 0, 400).empty()) << "the curve is elsewhere";
    EXPECT_TRUE(curveColumns(CurvePyramid(), axis, 0, 400).empty());
}

TEST(CurveColumns, BetweenSamplesFollowTheLineThatJoinsThem) {
    const CurvePyramid curve(std::vector<double>{1, 3, 2});
    const auto columns = curveColumns(curve, {10, 20}, 0, 100);
    ASSERT_EQ(columns.size(), 41U) << "from the first sample to the last";
    EXPECT_EQ(columns.front().x, 10);
    EXPECT_FLOAT_EQ(columns[5].low, 1.5F);
    EXPECT_FLOAT_EQ(columns[5].high, 1.6F);
    EXPECT_FLOAT_EQ(columns[19].high, 3) << "the peak is not cut";
    EXPECT_FLOAT_EQ(columns[40].low, 2);
}

TEST(CurvePicture, ShowsEveryPeakAtAnyZoomScrollAndScreen) {
    std::mt19937 random(5);
    const QRectF plot(20, 10, 300, 80);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<double> samples(1 + trial * 37U % 4000, 0.2);
        const std::size_t peak = random() % samples.size();
        samples[peak] = std::uniform_real_distribution<>(0.3, 1)(random);
        const double ratio = trial % 3 == 0 ? 2 : trial % 3 == 1 ? 1.5 : 1;
        const double step = std::pow(10.0, std::uniform_real_distribution<>(-2, 1.5)(random));
        const double x = std::uniform_real_distribution<>(22, 318)(random);
        const SampleAxis axis{x - step * static_cast<double>(peak), step};
        CurvePicture picture(QRectF(20, 5, 300, 95), ratio);
        const ValueAxis values{0, 1};
        picture.draw(CurvePyramid(samples), axis, values, plot, Qt::red,
                     trial % 2 == 0 ? 1.0 : 1.4);
        QImage image(QSize(340, 110) * ratio, QImage::Format_ARGB32_Premultiplied);
        image.setDevicePixelRatio(ratio);
        image.fill(Qt::black);
        QPainter painter(&image);
        picture.paintOnto(painter);
        painter.end();
        // Something of it lies within a pixel of where the peak belongs, and nothing above.
        const QPointF at = QPointF(x, values.yOf(samples[peak], plot)) * ratio;
        int ink = 0, above = 0;
        for (int column = int(at.x()) - 1; column <= int(at.x()) + 1; ++column) {
            for (int row = 0; row <= int(at.y()) + 1; ++row)
                (row < int(at.y()) - 2 ? above : ink) += qRed(image.pixel(column, row));
        }
        ASSERT_GT(ink, 60) << "trial " << trial << ", step " << step;
        ASSERT_EQ(above, 0) << "trial " << trial << ", step " << step;
    }
}

TEST(CurvePicture, StaysInItsPlotAndIsEvenWhereTheCurveIs) {
    CurvePicture picture(QRectF(0, 0, 100, 60), 1);
    const QRectF plot(0, 20, 100, 20);
    // Far above, far below, level.
    picture.draw(CurvePyramid(std::vector<double>{9, 9, -9, -9, 0.5, 0.5}), {0, 20}, {0, 1}, plot,
                 Qt::white, 1);
    QImage image(100, 60, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    picture.paintOnto(painter);
    painter.end();
    for (int x = 0; x < 100; ++x) {
        for (int y = 0; y < 60; ++y) {
            if (y >= 19 && y <= 40) continue;
            ASSERT_EQ(qRed(image.pixel(x, y)), 0) << x << " " << y;
        }
    }
    // A level line of one pixel, wherever it falls between two rows.
    for (int x = 82; x < 98; ++x)
        EXPECT_NEAR(qRed(image.pixel(x, 29)) + qRed(image.pixel(x, 30)), 255, 3) << x;
}

TEST(HeaviestPerCell, KeepsTheHeaviestOfEveryCellInOrder) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> xs(80), weights(80);
        for (double& x : xs)
            x = std::uniform_real_distribution<>(-20, 60)(random);
        for (double& weight : weights)
            weight = std::uniform_int_distribution<>(0, 5)(random);
        std::sort(xs.begin(), xs.end());
        const auto kept = heaviestPerCell(xs, weights, 2);
        EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
        for (std::size_t i = 0; i < xs.size(); ++i) {
            const auto owner = std::find_if(kept.begin(), kept.end(), [&](std::size_t k) {
                return std::floor(xs[k] / 2) == std::floor(xs[i] / 2);
            });
            ASSERT_NE(owner, kept.end());
            ASSERT_GE(weights[*owner], weights[i]);
        }
    }
}

TEST(NearestTarget, IsTheNearestWithinReachAndAMinimumAmongEquals) {
    const std::vector<SnapTarget> targets = {{SnapKind::Playhead, 100},
                                             {SnapKind::OtherFighter, 104},
                                             {SnapKind::Minimum, 108},
                                             {SnapKind::Contact, 108}};
    EXPECT_EQ(nearestTarget(targets, 101, 3), (SnapTarget{SnapKind::Playhead, 100}));
    EXPECT_EQ(nearestTarget(targets, 106, 5), (SnapTarget{SnapKind::Minimum, 108}));
    EXPECT_EQ(nearestTarget(targets, 108.4, 5), (SnapTarget{SnapKind::Minimum, 108}));
    EXPECT_FALSE(nearestTarget(targets, 120, 5));
    EXPECT_FALSE(nearestTarget({}, 120, 5));
}

TEST(DragLimits, AreStrictlyBetweenLiveNeighbours) {
    std::vector<BoundaryMark> marks(5);
    marks[0] = {0, MarkState::End, {}, 0};
    marks[1] = {40, MarkState::Detected, 0, 0};
    marks[2] = {60, MarkState::Removed, 1, 0};
    marks[3] = {80, MarkState::Added, {}, 0};
    marks[4] = {199, MarkState::End, {}, 0};
    EXPECT_EQ(dragLimits(marks, 40, 200).low, 1);
    EXPECT_EQ(dragLimits(marks, 40, 200).high, 79) << "what was removed is no border";
    EXPECT_EQ(dragLimits(marks, 80, 200).low, 41);
    EXPECT_EQ(dragLimits(marks, 80, 200).high, 198);
}

TEST(LoopEnds, AreFoundUnderThePointerAndNeverCross) {
    const TimeMapping map{0, 10, 100, 1000};
    const TimeSpan range{2, 4};
    EXPECT_EQ(loopEndAt(range, map, 303), LoopEnd::In);
    EXPECT_EQ(loopEndAt(range, map, 497), LoopEnd::Out);
    EXPECT_FALSE(loopEndAt(range, map, 400));
    EXPECT_FALSE(loopEndAt(std::nullopt, map, 300));
    const TimeSpan point{2, 2};
    EXPECT_EQ(loopEndAt(point, map, 298), LoopEnd::In);
    EXPECT_EQ(loopEndAt(point, map, 302), LoopEnd::Out);
    EXPECT_DOUBLE_EQ(withLoopEnd(range, LoopEnd::In, 9).begin, 4);
    EXPECT_DOUBLE_EQ(withLoopEnd(range, LoopEnd::Out, 1).end, 2);
    EXPECT_DOUBLE_EQ(withLoopEnd(range, LoopEnd::Out, 7).end, 7);
}

TEST(FrameStep, KeepsItsDistanceAndHasWholeFifths) {
    for (double pixelsPerFrame = 1e-4; pixelsPerFrame < 200; pixelsPerFrame *= 1.37) {
        const double step = frameStep(pixelsPerFrame, 104);
        EXPECT_GE(step * pixelsPerFrame, 104 - 1e-9);
        EXPECT_DOUBLE_EQ(step / 5, std::round(step / 5));
    }
}

TEST(SliderScale, GoesThereAndBack) {
    const SliderScale scale{0.5, 20, 390};
    for (int step = 0; step <= scale.steps; ++step)
        EXPECT_EQ(scale.stepOf(scale.valueAt(step)), step);
    EXPECT_DOUBLE_EQ(scale.valueAt(0), 0.5);
    EXPECT_DOUBLE_EQ(scale.valueAt(scale.steps), 20);
    EXPECT_EQ(scale.stepOf(1000), scale.steps);
    EXPECT_EQ(scale.stepOf(-3), 0);
}

}  // namespace
}  // namespace kumite::studio
