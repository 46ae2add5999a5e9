#include "core/project/film_strip.h"

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "core/motion/blend.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

Clip standing(const GroundTransform& place) {
    const auto motion = test::bobbing(1, 60, [](double) { return 0.0; });
    const Fighter fighter = test::makeFighter(motion, 60);
    return moved(clipOf(*motion, motion->frames(), fighter.space, fighter.roles), place);
}

/// All lines of a picture as (x1, y1, x2, y2, stroke width).
struct Line {
    double x1, y1, x2, y2, width;
};
std::vector<Line> linesOf(const pugi::xml_node& picture) {
    std::vector<Line> lines;
    for (const auto& node : picture.select_nodes("./g/line[2]")) {
        const auto value = [&](const char* name) {
            return node.node().attribute(name).as_double();
        };
        lines.push_back(
            {value("x1"), value("y1"), value("x2"), value("y2"), value("stroke-width")});
    }
    return lines;
}

pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    return document;
}

TEST(FilmStrip, TheSecondFighterStandsToTheRight) {
    const Clip first = standing({0.3, 1, 1}), second = standing({-2, 1, -1});
    FilmPicture picture{"now", {{&first, 0}, {&second, 0}}, {}};
    const auto document = parsed(filmStripSvg("A & B", {{"", {picture}}}));
    const auto pictures = document.select_nodes("//g[@class='picture']");
    ASSERT_EQ(pictures.size(), 1U);
    const auto lines = linesOf(pictures[0].node());
    EXPECT_EQ(lines.size(), 28U);  // 14 capsules each
    double low = 1e9, high = -1e9, top = 1e9;
    for (const Line& line : lines) {
        low = std::min({low, line.x1, line.x2});
        high = std::max({high, line.x1, line.x2});
        top = std::min({top, line.y1, line.y2});
    }
    // Two metres apart at 90 pixels a metre, and their arms' reach beyond.
    EXPECT_GT(high - low, 180);
    EXPECT_LT(high - low, 180 + 2 * 90 * 0.8);
    // The skull's upper end is 1.62 m over the floor line.
    const double floor = pictures[0].node().child("line").attribute("y1").as_double();
    EXPECT_NEAR(floor - top, 90 * 1.62, 0.2);
    EXPECT_STREQ(document.select_node("/svg/text[1]").node().text().get(), "A & B");
}

TEST(FilmStrip, RowsAndColumnsStandInAGrid) {
    const Clip clip = standing({});
    FilmPicture picture{"t", {{&clip, 0}}, {{Eigen::Vector3d(0, 1, 0.5)}}};
    const auto document =
        parsed(filmStripSvg("", {{"made", {picture, picture, picture}}, {"recorded", {picture}}},
                            {.view = FilmView::ThreeQuarter}));
    const auto pictures = document.select_nodes("//g[@class='picture']");
    ASSERT_EQ(pictures.size(), 4U);
    const auto place = [&](std::size_t i, const char* name) {
        return pictures[i].node().child("rect").attribute(name).as_double();
    };
    EXPECT_EQ(place(0, "y"), place(2, "y"));
    EXPECT_EQ(place(0, "x"), place(3, "x"));
    EXPECT_LT(place(0, "x") + place(0, "width"), place(1, "x"));
    EXPECT_LT(place(0, "y") + place(0, "height"), place(3, "y"));
    const auto root = document.document_element();
    EXPECT_LE(place(2, "x") + place(2, "width"), root.attribute("width").as_double());
    EXPECT_LE(place(3, "y") + place(3, "height"), root.attribute("height").as_double());
    EXPECT_EQ(document.select_nodes("//circle").size(), 4U);
}

// A lone fighter is seen from its side: what is ahead lies to the right, and the same for any
// heading.
TEST(FilmStrip, ALoneFighterFacesRight) {
    for (const double yaw : {0.0, 2.0}) {
        const Clip clip = standing({yaw, 3, -1});
        const Eigen::Vector3d ahead = GroundTransform{yaw, 3, -1} * Eigen::Vector3d(0, 1, 1);
        FilmPicture picture{"", {{&clip, 0}}, {{ahead}}};
        const auto document = parsed(filmStripSvg("", {{"", {picture}}}));
        const auto lines = linesOf(document.select_nodes("//g[@class='picture']")[0].node());
        const double mark = document.select_node("//circle").node().attribute("cx").as_double();
        double mean = 0;
        for (const Line& line : lines)
            mean += 0.5 * (line.x1 + line.x2) / static_cast<double>(lines.size());
        EXPECT_NEAR(mark - mean, 90, 5);
    }
}

TEST(FilmStrip, EvenFramesHoldBothEnds) {
    EXPECT_EQ(evenFrames({10, 21}, 3), (std::vector<int>{10, 15, 20}));
    EXPECT_EQ(evenFrames({4, 5}, 2), (std::vector<int>{4, 4}));
    EXPECT_EQ(evenFrames({4, 9}, 1), (std::vector<int>{4}));
    EXPECT_TRUE(evenFrames({3, 3}, 4).empty());
}

TEST(FilmStrip, NothingIsStillAPicture) {
    const auto document = parsed(filmStripSvg("empty", {{"row", {{"none", {}, {}}}}, {}}));
    EXPECT_EQ(document.select_nodes("//g[@class='picture']").size(), 1U);
}

}  // namespace
}  // namespace kumite
