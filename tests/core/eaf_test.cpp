// ELAN documents: as we write them, and as people and hostile programs do.
#include "core/formats/eaf.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/label_files.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

std::string document(const std::string& slots, const std::string& tiers,
                     const std::string& rest = "") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<ANNOTATION_DOCUMENT FORMAT=\"3.0\">\n"
           "<HEADER MEDIA_FILE=\"\" TIME_UNITS=\"milliseconds\"/>\n"
           "<TIME_ORDER>" +
           slots + "</TIME_ORDER>\n" + tiers + rest + "</ANNOTATION_DOCUMENT>\n";
}
std::string slot(const std::string& id, const std::string& time = "") {
    return "<TIME_SLOT TIME_SLOT_ID=\"" + id + "\"" +
           (time.empty() ? "" : " TIME_VALUE=\"" + time + "\"") + "/>";
}
std::string aligned(const std::string& id, const std::string& from, const std::string& to,
                    const std::string& value, const std::string& more = "") {
    return "<ANNOTATION><ALIGNABLE_ANNOTATION ANNOTATION_ID=\"" + id + "\" TIME_SLOT_REF1=\"" +
           from + "\" TIME_SLOT_REF2=\"" + to + "\" " + more + "><ANNOTATION_VALUE>" + value +
           "</ANNOTATION_VALUE></ALIGNABLE_ANNOTATION></ANNOTATION>\n";
}
std::string dependent(const std::string& id, const std::string& on, const std::string& value,
                      const std::string& previous = "") {
    return "<ANNOTATION><REF_ANNOTATION ANNOTATION_ID=\"" + id + "\" ANNOTATION_REF=\"" + on +
           "\"" + (previous.empty() ? "" : " PREVIOUS_ANNOTATION=\"" + previous + "\"") +
           "><ANNOTATION_VALUE>" + value + "</ANNOTATION_VALUE></REF_ANNOTATION></ANNOTATION>\n";
}
std::string tier(const std::string& id, const std::string& annotations,
                 const std::string& more = "") {
    return "<TIER TIER_ID=\"" + id + "\" " + more + ">\n" + annotations + "</TIER>\n";
}

struct Stretch {
    double begin, end;
    std::string value;
};
void expectStretches(const EafTier& tier, const std::vector<Stretch>& expected) {
    ASSERT_EQ(tier.annotations.size(), expected.size()) << tier.id;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(tier.annotations[i].begin, expected[i].begin, 1e-9) << tier.id << " " << i;
        EXPECT_NEAR(tier.annotations[i].end, expected[i].end, 1e-9) << tier.id << " " << i;
        EXPECT_EQ(tier.annotations[i].value, expected[i].value);
    }
}

TEST(Eaf, EveryAnnotationGetsATime) {
    // b1…b3 divide 1–4 s by slots without times; c1 and c2 follow each other below b2, against
    // their order in the file; d1 hangs on c2.
    const std::string text = document(
        slot("ts1", "1000") + slot("ts2") + slot("ts3") + slot("ts4", "4000"),
        tier("a", aligned("a1", "ts1", "ts4", " whole\n")) +
            tier("b", aligned("b1", "ts1", "ts2", "one") + aligned("b2", "ts2", "ts3", "two") +
                          aligned("b3", "ts3", "ts4", "three")) +
            tier("d", dependent("d1", "c2", "deep")) +
            tier("c", dependent("c2", "b2", "second", "c1") + dependent("c1", "b2", "first")));
    Findings findings;
    const EafDocument eaf = parseEaf(text, "x.eaf", &findings);
    ASSERT_EQ(eaf.tiers.size(), 4u);
    expectStretches(eaf.tiers[0], {{1, 4, "whole"}});
    expectStretches(eaf.tiers[1], {{1, 2, "one"}, {2, 3, "two"}, {3, 4, "three"}});
    expectStretches(eaf.tiers[2], {{2.5, 3, "deep"}});
    expectStretches(eaf.tiers[3], {{2, 2.5, "first"}, {2.5, 3, "second"}});
    EXPECT_TRUE(findings.empty());
}

TEST(Eaf, WhatNeverGetsATimeIsReported) {
    Findings findings;
    const EafDocument eaf = parseEaf(
        document(slot("ts1", "0") + slot("ts2") + slot("ts3"),
                 tier("a", aligned("a1", "ts1", "ts2", "lost") + aligned("a2", "ts2", "ts3", "x"))),
        "x.eaf", &findings);
    EXPECT_TRUE(eaf.tiers[0].annotations.empty());
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].text, "x.eaf:6: the annotation \"lost\" has no time and is left out.");
}

TEST(Eaf, ValuesComeFromTheControlledVocabularyEntitiesAndAnyLanguage) {
    const std::string rest =
        "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\" CONTROLLED_VOCABULARY_REF=\"two\"/>\n"
        "<CONTROLLED_VOCABULARY CV_ID=\"one\"><CV_ENTRY_ML CVE_ID=\"c0\"><CVE_VALUE>wrong"
        "</CVE_VALUE></CV_ENTRY_ML></CONTROLLED_VOCABULARY>\n"
        "<CONTROLLED_VOCABULARY CV_ID=\"two\"><CV_ENTRY_ML CVE_ID=\"c0\"><CVE_VALUE "
        "DESCRIPTION=\"to the front\">fwd</CVE_VALUE></CV_ENTRY_ML></CONTROLLED_VOCABULARY>\n"
        "<CONTROLLED_VOCABULARY CV_ID=\"old\"><CV_ENTRY DESCRIPTION=\"d\">v</CV_ENTRY>"
        "</CONTROLLED_VOCABULARY>\n";
    const EafDocument eaf = parseEaf(
        "\xEF\xBB\xBF" + document(slot("ts1", "0") + slot("ts2", "1"),
                                  tier("a",
                                       aligned("a1", "ts1", "ts2", "", "CVE_REF=\"c0\"") +
                                           aligned("a2", "ts1", "ts2", "<![CDATA[a<b]]>") +
                                           aligned("a3", "ts1", "ts2", "&lt;蹴り&gt; &#x00e9;"),
                                       "LINGUISTIC_TYPE_REF=\"t\""),
                                  rest),
        "x.eaf");
    expectStretches(eaf.tiers[0], {{0, 0.001, "fwd"}, {0, 0.001, "a<b"}, {0, 0.001, "<蹴り> é"}});
    EXPECT_EQ(eaf.vocabularies[1].entries[0].second, "to the front");
    EXPECT_EQ(eaf.vocabularies[2].entries[0].first, "v");
}

TEST(Eaf, HostileDocumentsGetOneSentenceWithALine) {
    const auto messageFor = [](const std::string& text) -> std::string {
        try {
            parseEaf(text, "x.eaf");
        } catch (const InputError& error) {
            return error.what();
        }
        return "read";
    };
    const std::string slots = slot("ts1", "5") + slot("ts2", "9");
    EXPECT_EQ(messageFor(""), "x.eaf:1: is no XML: no document element found.");
    EXPECT_EQ(messageFor("<a>\n<b></a>"), "x.eaf:2: is no XML: start-end tags mismatch.");
    EXPECT_EQ(messageFor("<html>\n</html>"),
              "x.eaf:1: is no ELAN document: expected ANNOTATION_DOCUMENT, found html.");
    EXPECT_EQ(messageFor(std::string("<a>\n\0</a>", 9)), "x.eaf:2: a zero byte is no text.");
    EXPECT_EQ(messageFor("\xFF\xFE<"), "x.eaf: is UTF-16; ELAN documents are UTF-8.");
    const std::string whole = document(slots, tier("a", aligned("a1", "ts1", "ts2", "v")));
    EXPECT_EQ(messageFor(whole), "read");
    for (std::size_t length = 0; length < whole.size() - 2; length += 7) {
        EXPECT_NE(messageFor(whole.substr(0, length)), "read") << "cut after " << length;
    }
    EXPECT_EQ(messageFor(document(slot("ts1", "-5"), "")),
              "x.eaf:4: TIME_VALUE \"-5\" is no time.");
    EXPECT_EQ(messageFor(document(slot("ts1", "5") + slot("ts1", "6"), "")),
              "x.eaf:4: there are two time slots \"ts1\".");
    EXPECT_EQ(messageFor(document(slots, "<TIER/>")), "x.eaf:5: TIER has no TIER_ID.");
    EXPECT_EQ(messageFor(document(slots, tier("a", aligned("a1", "ts1", "ts3", "v")))),
              "x.eaf:6: there is no time slot \"ts3\".");
    EXPECT_EQ(messageFor(document(slots, tier("a", aligned("a1", "ts2", "ts1", "v")))),
              "x.eaf:6: the annotation ends before it begins.");
    EXPECT_EQ(messageFor(document(slots, tier("a", dependent("a1", "a9", "v")))),
              "x.eaf:6: there is no annotation \"a9\".");
    EXPECT_EQ(messageFor(document(
                  slots, tier("a", dependent("a1", "a2", "v") + dependent("a2", "a1", "v")))),
              "x.eaf:6: the annotation refers to itself in the end.");
    // Two that follow each other, and a chain of slots that bites its tail.
    EXPECT_EQ(messageFor(document(slots, tier("a", aligned("a1", "ts1", "ts2", "v")) +
                                             tier("b", dependent("b1", "a1", "v", "b2") +
                                                           dependent("b2", "a1", "v", "b1")))),
              "read");
    EXPECT_EQ(messageFor(document(
                  slot("ts1", "1") + slot("ts2") + slot("ts3"),
                  tier("a", aligned("a1", "ts1", "ts2", "v") + aligned("a2", "ts2", "ts3", "v") +
                                aligned("a3", "ts3", "ts2", "v")))),
              "read");
    std::string deep;
    for (int i = 0; i < 100000; ++i)
        deep += "<x>";
    EXPECT_NE(messageFor(deep), "read");
}

TEST(Eaf, WhatIsWrittenIsReadBack) {
    EafDocument made;
    made.tiers.push_back(
        {"fighter \"1\" <&>", "p1", "", "", {{0.5, 1.25, "", 0}, {1.25, 2, "b\n", 0}}});
    made.tiers.push_back(
        {"child", "", made.tiers[0].id, "words", {{1.25, 2, "\"蹴\" & <'>\x01\xFF", 0}}});
    made.vocabularies = {{"words", {{"fwd", "to the front"}, {"bwd", ""}}}};
    const std::string text = eafText(made);
    EXPECT_EQ(eafText(made), text);
    const EafDocument read = parseEaf(text, "x.eaf");
    ASSERT_EQ(read.tiers.size(), 2u);
    EXPECT_EQ(read.tiers[0].id, made.tiers[0].id);
    EXPECT_EQ(read.tiers[0].participant, "p1");
    EXPECT_EQ(read.tiers[1].parent, made.tiers[0].id);
    EXPECT_EQ(read.tiers[1].vocabulary, "words");
    expectStretches(read.tiers[0], {{0.5, 1.25, ""}, {1.25, 2, "b"}});
    expectStretches(read.tiers[1], {{1.25, 2, "\"蹴\" & <'> \xEF\xBF\xBD"}});
    EXPECT_EQ(read.vocabularies[0].entries, made.vocabularies[0].entries);
}

// ---- labels ------------------------------------------------------------------------------------

std::map<std::string, std::string> labelsIn(const std::string& tiers, Findings* findings) {
    const std::string text =
        document(slot("ts1", "0") + slot("ts2", "500") + slot("ts3", "900"), tiers);
    std::map<std::string, std::string> labels;
    for (const TimedLabel& each : parseLabelsEaf(text, "x.eaf", kickboxing(), findings)) {
        labels[std::to_string(each.player) + "@" + std::to_string(std::lround(1000 * each.begin))] =
            labelText(kickboxing(), ActionLabel{0, each.aspects}.label(), true);
        for (const AspectValue& value : each.aspects)
            EXPECT_TRUE(!value.known() || value.byHand());
    }
    return labels;
}

TEST(EafLabels, TiersAreNamedAsPeopleNameThem) {
    Findings findings;
    const auto labels = labelsIn(
        tier("Left Punch", aligned("a1", "ts1", "ts2", "Forward"), "PARTICIPANT=\"Fighter 2\"") +
            tier("right_kick@1", aligned("a2", "ts1", "ts2", "downup")) +
            tier("player 1 right-punch", aligned("a3", "ts2", "ts3", "bwd")) +
            tier("jump", aligned("a4", "ts2", "ts3", "UP") + aligned("a5", "ts1", "ts2", "")) +
            tier("fighter 2", aligned("a6", "ts2", "ts3", "left_kick:up+jump:?")) +
            tier("gaze", aligned("a7", "ts1", "ts2", "left") + aligned("a8", "ts2", "ts3", "x")) +
            tier("P2 Jump", aligned("a9", "ts1", "ts2", "sideways")),
        &findings);
    // Of fighter 1 right_kick, right_punch and jump have tiers, of fighter 2 left_punch and jump.
    EXPECT_EQ(labels, (std::map<std::string, std::string>{
                          {"1@0", "left_punch:?+left_kick:?+right_kick:downup+react:?"},
                          {"1@500", "left_punch:?+right_punch:bwd+left_kick:?+jump:up+react:?"},
                          {"2@0", "left_punch:fwd+right_punch:?+left_kick:?+right_kick:?+react:?"},
                          {"2@500", "left_kick:up+jump:?"}}));
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(
        findings[0].text,
        "x.eaf:21: the tier \"gaze\" is about no aspect of Kickboxing; 2 annotations are left "
        "out.");
    EXPECT_EQ(findings[1].text, "x.eaf:26: \"sideways\" is no qualifier of jump.");
}

TEST(EafLabels, AnAspectsTierSaysWhatAHandChanged) {
    const std::string text =
        document(slot("ts1", "0") + slot("ts2", "500"),
                 tier("fighter 1",
                      aligned("a1", "ts1", "ts2", "left_punch:fwd+right_kick:up (machine 0.8)")) +
                     tier("fighter 1 left_punch", dependent("a2", "a1", "fwd")) +
                     tier("fighter 1 jump", dependent("a3", "a1", "down")) +
                     tier("fighter 1 right_kick", ""));
    const auto labels = parseLabelsEaf(text, "x.eaf", kickboxing());
    ASSERT_EQ(labels.size(), 1u);
    const auto& values = labels[0].aspects;
    const auto is = [&](const char* aspect, const char* qualifier, LabelSource source) {
        const int a = *kickboxing().find(aspect);
        const AspectValue& value = values[static_cast<std::size_t>(a)];
        EXPECT_EQ(value.qualifier, *kickboxing()[a].find(qualifier)) << aspect;
        EXPECT_EQ(value.source, source) << aspect;
    };
    is("left_punch", "fwd", LabelSource::Machine);
    is("right_punch", "others", LabelSource::Machine);
    is("jump", "down", LabelSource::Hand);
    is("right_kick", "others", LabelSource::Hand);
}

}  // namespace
}  // namespace kumite
