// The page on which people rate motions: what it holds, and what it does not tell.
#include "core/project/rating_page.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

TEST(WilsonInterval, IsThatOfTheTables) {
    // Newcombe 1998, Statistics in Medicine 17, table I, method 3: 81 of 263, 15 of 148, 1 of 29.
    EXPECT_NEAR(wilsonInterval(81, 263).first, 0.2553, 5e-5);
    EXPECT_NEAR(wilsonInterval(81, 263).second, 0.3662, 5e-5);
    EXPECT_NEAR(wilsonInterval(15, 148).first, 0.0624, 5e-5);
    EXPECT_NEAR(wilsonInterval(15, 148).second, 0.1605, 5e-5);
    EXPECT_NEAR(wilsonInterval(0, 20).first, 0, 1e-12);
    EXPECT_NEAR(wilsonInterval(0, 20).second, 0.1611, 5e-5);
    EXPECT_NEAR(wilsonInterval(1, 29).second, 0.1718, 5e-5);
    EXPECT_EQ(wilsonInterval(0, 0), std::pair(0.0, 1.0));
}

Clip clipOfLength(int frames) {
    auto rig = std::make_shared<Rig>();
    for (int joint = 0; joint < 2; ++joint) {
        Rig::Joint each;
        each.name = joint == 0 ? "Hips" : "LeftLeg";
        each.parent = joint - 1;
        each.offset = {0, joint == 0 ? 0.0 : -0.5, 0};
        rig->joints.push_back(each);
    }
    Clip clip{rig, 60, {}};
    for (int f = 0; f < frames; ++f) {
        Pose pose;
        pose.root = {0.01 * f, 1, 0};
        pose.turns.assign(2, Eigen::Quaterniond::Identity());
        clip.frames.push_back(pose);
    }
    return clip;
}

nlohmann::json dataOf(const std::string& page) {
    const std::string before = "const data = ";
    const auto begin = page.find(before) + before.size();
    return nlohmann::json::parse(page.substr(begin, page.find(";\nconst answers") - begin));
}

TEST(RatingPage, HoldsAllClipsInADrawnOrderAndHidesWhichIsWhich) {
    std::vector<RatedClip> clips;
    for (int i = 0; i < 12; ++i) {
        clips.push_back({i % 2 == 0 ? "captured" : "key poses", "clip-" + std::to_string(i),
                         clipOfLength(31 + 2 * i)});
    }
    const std::string page = ratingPage(clips, "Punches & <kicks>", 7);
    for (const char* secret : {"captured", "key poses", "clip-3"})
        EXPECT_EQ(page.find(secret), std::string::npos) << secret;
    EXPECT_NE(page.find("<h1>Punches &amp; &lt;kicks></h1>"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos) << "everything is in the page";
    const auto data = dataOf(page);
    ASSERT_EQ(data["clips"].size(), 12U);
    std::vector<std::size_t> lengths;
    for (const auto& clip : data["clips"])
        lengths.push_back(clip["frames"].size());
    EXPECT_FALSE(std::is_sorted(lengths.begin(), lengths.end())) << "the order is drawn";
    std::sort(lengths.begin(), lengths.end());
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_EQ(lengths[i], 16 + i) << "30 a second of 60";
    EXPECT_EQ(data["bones"], nlohmann::json::parse("[[0, 1, 1]]"));
    EXPECT_EQ(data["clips"][0]["frames"][3], nlohmann::json::parse("[6, 100, 0, 6, 50, 0]"));
    EXPECT_EQ(ratingPage(clips, "Punches & <kicks>", 7), page);
    EXPECT_NE(ratingPage(clips, "Punches & <kicks>", 8), page);
    EXPECT_THROW(ratingPage({}, "Nothing", 1), Error);
}

}  // namespace
}  // namespace kumite
