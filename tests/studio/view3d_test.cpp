// The 3D view really draws: pictures are taken and looked at.

#include <QImage>
#include <QTest>

#include <functional>
#include <set>

#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

QImage pictureOf(QWidget& widget) {
    return widget.grab().toImage().convertToFormat(QImage::Format_ARGB32);
}

/// The picture of a 3D view once it shows what is wished; one that is being resized shows the last
/// picture stretched for a moment.
testing::AssertionResult soonShows(QWidget& view,
                                   const std::function<bool(const QImage&)>& wished) {
    if (QTest::qWaitFor([&] { return wished(pictureOf(view)); }, 5000))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not within five seconds";
}

/// Pixels whose hue is a fighter's.
struct FighterPixels {
    int vermilion = 0;
    int blue = 0;
    int holes = 0;  ///< not opaque
};

FighterPixels count(const QImage& image) {
    FighterPixels found;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor colour = image.pixelColor(x, y);
            if (colour.alpha() != 255) ++found.holes;
            if (colour.saturation() < 90 || colour.value() < 60) continue;
            if (colour.hue() > 10 && colour.hue() < 45) ++found.vermilion;
            if (colour.hue() > 185 && colour.hue() < 225) ++found.blue;
        }
    }
    return found;
}

TEST_F(WindowTest, BothFightersAreDrawnAndThePictureHasNoHoles) {
    openBout();
    const FighterPixels pixels = count(pictureOf(window_->stage()));
    EXPECT_GT(pixels.vermilion, 2000);
    EXPECT_GT(pixels.blue, 2000);
    EXPECT_EQ(pixels.holes, 0);
}

TEST_F(WindowTest, PictureFollowsThePlayhead) {
    openBout();
    session().transport().setPlayhead(1.0);
    const QImage first = pictureOf(window_->stage());
    session().transport().setPlayhead(1.4);
    const QImage second = pictureOf(window_->stage());
    EXPECT_NE(first, second);
    session().transport().setPlayhead(1.0);
    EXPECT_TRUE(soonShows(window_->stage(), [&](const QImage& p) { return p == first; }));
}

TEST_F(WindowTest, DrawingSurvivesResizing) {
    openBout();
    for (const QSize size : {QSize(1000, 640), QSize(1700, 1000), QSize(1280, 800)}) {
        window_->resize(size);
        EXPECT_TRUE(soonShows(window_->stage(), [&](const QImage& image) {
            const FighterPixels pixels = count(image);
            return image.size() == window_->stage().size() * window_->devicePixelRatio() &&
                   pixels.vermilion > 1000 && pixels.holes == 0;
        })) << size.width();
    }
}

TEST_F(WindowTest, DrawingSurvivesANewContext) {
    openBout();
    StageView* stage = &window_->stage();
    QWidget* home = stage->parentWidget();
    // A window of its own means another OpenGL context.
    stage->setParent(nullptr);
    stage->resize(700, 500);
    stage->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(stage));
    const auto bodies = [](const QImage& p) { return count(p).vermilion > 1000; };
    EXPECT_TRUE(soonShows(*stage, bodies));
    stage->setParent(home);
    stage->show();
    EXPECT_TRUE(soonShows(*stage, bodies));
}

TEST_F(WindowTest, MouseTurnsMovesAndZooms) {
    openBout();
    StageView& stage = window_->stage();
    const QImage before = pictureOf(stage);
    const QPoint middle = stage.rect().center();
    QTest::mousePress(&stage, Qt::LeftButton, {}, middle);
    QTest::mouseMove(&stage, middle + QPoint(30, 0));
    QTest::mouseMove(&stage, middle + QPoint(80, 10));
    QTest::mouseRelease(&stage, Qt::LeftButton, {}, middle + QPoint(80, 10));
    const QImage turned = pictureOf(stage);
    EXPECT_NE(before, turned);
    press(Qt::Key_3, Qt::AltModifier);
    EXPECT_NE(turned, pictureOf(stage));
    QTest::keyClick(&timeline(), Qt::Key_F);
    EXPECT_TRUE(soonShows(stage, [](const QImage& p) { return count(p).vermilion > 2000; }));
}

TEST_F(WindowTest, ThemeChangesTheBackground) {
    openBout();
    const auto corner = [](const QImage& image) { return image.pixelColor(20, 20).lightness(); };
    window_->setTheme(ThemeChoice::Light);
    EXPECT_TRUE(soonShows(window_->stage(), [&](const QImage& p) { return corner(p) > 200; }));
    window_->setTheme(ThemeChoice::Dark);
    EXPECT_TRUE(soonShows(window_->stage(), [&](const QImage& p) { return corner(p) < 80; }));
}

TEST_F(WindowTest, TimelineIsDrawnAtEveryZoom) {
    openBout();
    for (const double length : {10.0, 3.0, 0.5, 0.1}) {
        session().setVisible({4.0, 4.0 + length});
        const QImage image = pictureOf(timeline());
        std::set<QRgb> shades;
        for (int x = 0; x < image.width(); x += 2)
            shades.insert(image.pixel(x, image.height() / 3));
        EXPECT_GT(shades.size(), 3U) << length;
    }
}

}  // namespace
}  // namespace kumite::studio
