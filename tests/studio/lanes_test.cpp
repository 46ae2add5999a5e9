// Lanes of labels: how a value looks, how much room they take.

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "core/labelling/label.h"
#include "studio/timeline/lane_painter.h"
#include "studio/workspaces/label/label_lanes.h"

namespace kumite::studio {
namespace {

ShownAspect shown(int qualifier, Standing standing, LabelSource source, float confidence,
                  double margin = 1) {
    ShownAspect aspect;
    aspect.value = {static_cast<std::int8_t>(qualifier), source, confidence};
    aspect.standing = standing;
    aspect.prediction.margin = margin;
    aspect.prediction.blind = false;
    return aspect;
}

TEST(LaneCells, LookAsWhoeverSpoke) {
    const Aspect& punch = kickboxing()[0];
    const auto lookOf = [&](const ShownAspect& aspect) { return laneCell(punch, aspect).look; };
    EXPECT_EQ(lookOf({}), LaneLook::Open);
    EXPECT_EQ(lookOf(shown(0, Standing::Hand, LabelSource::Hand, 1)), LaneLook::Hand);
    EXPECT_EQ(lookOf(shown(0, Standing::Accepted, LabelSource::Machine, 0.9f)), LaneLook::Accepted);
    EXPECT_EQ(lookOf(shown(0, Standing::Proposed, LabelSource::Machine, 0.9f)), LaneLook::Proposed);
    EXPECT_EQ(lookOf(shown(0, Standing::Proposed, LabelSource::Rule, 1)), LaneLook::Rule);
    EXPECT_EQ(lookOf(shown(*punch.fallback, Standing::Hand, LabelSource::Hand, 1)),
              LaneLook::Nothing);
}

TEST(LaneCells, AreHatchedWhereAMachineIsNotSure) {
    const Aspect& punch = kickboxing()[0];
    const auto hatched = [&](Standing standing, LabelSource source, float confidence,
                             double margin) {
        return laneCell(punch, shown(0, standing, source, confidence, margin)).uncertain;
    };
    EXPECT_TRUE(hatched(Standing::Proposed, LabelSource::Machine, 0.6f, 2));
    EXPECT_FALSE(hatched(Standing::Proposed, LabelSource::Machine, 0.95f, 0.1));
    EXPECT_TRUE(hatched(Standing::Accepted, LabelSource::Machine, 0.6f, 2));
    EXPECT_FALSE(hatched(Standing::Hand, LabelSource::Hand, 1, 0));
    EXPECT_TRUE(hatched(Standing::Proposed, LabelSource::Rule, 0.4f, 0));
    // Before probabilities are known the margin decides.
    EXPECT_TRUE(hatched(Standing::Proposed, LabelSource::Machine, 0, 0.2));
    EXPECT_FALSE(hatched(Standing::Proposed, LabelSource::Machine, 0, 0.9));
}

TEST(Lanes, GetLowerAndThenOneStripWhereThereIsLittleRoom) {
    EXPECT_EQ(laneHeight(300, 7), 14);
    EXPECT_EQ(laneHeight(70, 7), 10);
    EXPECT_EQ(laneHeight(40, 7), 0) << "collapsed";
    const LanePlace place{QRectF(100, 50, 400, 70), 10, false};
    EXPECT_EQ(place.laneAt(50, 7), 0);
    EXPECT_EQ(place.laneAt(119.9, 7), 6);
    EXPECT_EQ(place.laneAt(120, 7), -1);
    EXPECT_EQ((LanePlace{QRectF(100, 50, 400, 14), 0, true}.laneAt(55, 7)), -1);
}

TEST(Lanes, ColoursOfClassesAreSeenOnBothGrounds) {
    for (const bool dark : {false, true}) {
        const Colours& c = colours(dark);
        for (const Aspect& aspect : kickboxing().aspects) {
            for (const Qualifier& qualifier : aspect.qualifiers) {
                const QColor seen =
                    classColour(QColor(QString::fromStdString(qualifier.colour)), c);
                EXPECT_GE(contrastOf(seen, c.ground), 2.0)
                    << aspect.id << ' ' << qualifier.id << (dark ? " dark" : " light");
            }
        }
    }
}

}  // namespace
}  // namespace kumite::studio
