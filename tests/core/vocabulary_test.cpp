#include "core/labelling/vocabulary.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/labelling/answers.h"

namespace kumite {
namespace {

TEST(Kickboxing, IsThePapersTableOne) {
    const Vocabulary& v = kickboxing();
    const std::map<std::string, std::vector<std::string>> table = {
        {"left_punch", {"fwd", "bwd", "bwdfwd", "fwdbwd", "others"}},
        {"right_punch", {"fwd", "bwd", "bwdfwd", "fwdbwd", "others"}},
        {"left_kick", {"up", "down", "downup", "others"}},
        {"right_kick", {"up", "down", "downup", "others"}},
        {"jump", {"up", "down", "others"}},
        {"react", {"kick", "punch", "others"}},
        {"move", {"L-L", "L-R", "L-F", "R-L", "R-R", "R-F", "F-L", "F-R", "F-F"}}};
    ASSERT_EQ(v.aspects.size(), table.size());
    for (const Aspect& aspect : v.aspects) {
        std::vector<std::string> ids;
        for (const Qualifier& qualifier : aspect.qualifiers)
            ids.push_back(qualifier.id);
        EXPECT_EQ(ids, table.at(aspect.id)) << aspect.id;
        const bool rule = aspect.id == "react" || aspect.id == "move";
        EXPECT_EQ(aspect.classifier != Classifier::Msvm, rule) << aspect.id;
        EXPECT_EQ(aspect.fallback.has_value(), aspect.id != "move");
    }
    EXPECT_EQ(v[*v.find("left_kick")].mirror, *v.find("right_kick"));
    EXPECT_EQ(v[*v.find("jump")].mirror, *v.find("jump"));
}

TEST(Kickboxing, AttacksAreThoseThatTheReactRuleCounts) {
    std::set<std::string> attacks;
    for (const Aspect& aspect : kickboxing().aspects) {
        for (const Qualifier& qualifier : aspect.qualifiers) {
            if (qualifier.attack) attacks.insert(aspect.strike + " " + qualifier.id);
        }
    }
    EXPECT_EQ(attacks, (std::set<std::string>{"kick up", "kick downup", "punch fwd", "punch bwdfwd",
                                              "punch fwdbwd"}));
}

TEST(Vocabulary, WrittenAndReadBackIsTheSame) {
    Findings findings;
    EXPECT_EQ(parseVocabulary(vocabularyText(kickboxing()), "x", &findings), kickboxing());
    EXPECT_TRUE(findings.empty()) << findings.front().text;
}

const char* kTennis = R"({"vocabulary": 1, "name": "Tennis", "aspects": [
  {"id": "forehand", "classifier": "msvm", "fallback": "none",
   "qualifiers": [{"id": "swing", "key": "1"}, {"id": "none"}]},
  {"id": "serve", "classifier": "msvm", "fallback": "none", "excludes": ["forehand"],
   "qualifiers": [{"id": "toss"}, {"id": "hit"}, {"id": "none"}]}]})";

TEST(Vocabulary, OfAnotherSport) {
    const Vocabulary tennis = parseVocabulary(kTennis, "tennis.json");
    EXPECT_EQ(labelText(tennis, parseLabel(tennis, "serve:hit")), "serve:hit");
    EXPECT_EQ(conflicts(tennis, parseLabel(tennis, "serve:hit+forehand:swing")),
              std::vector<std::string>{"serve and forehand exclude each other."});
    EXPECT_EQ(parseVocabulary(vocabularyText(tennis), "again"), tennis);
}

/// The message for a vocabulary in which `what` became `instead`.
std::string messageFor(const std::string& what, const std::string& instead) {
    std::string text = kTennis;
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), instead);
    try {
        parseVocabulary(text, "t.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "read";
}

TEST(Vocabulary, SaysWhereAndWhatIsWrong) {
    EXPECT_EQ(messageFor("\"serve\"", "\"forehand\""),
              "t.json: aspects[1].id: is the id of two aspects.");
    EXPECT_EQ(messageFor("\"toss\"", "\"to:ss\""),
              "t.json: aspects[1].qualifiers[0].id: an id is made of letters, digits, _ and -, not "
              "\"to:ss\".");
    EXPECT_EQ(messageFor("[\"forehand\"]", "[\"backhand\"]"),
              "t.json: aspects[1].excludes[0]: there is no aspect \"backhand\".");
    EXPECT_EQ(messageFor("\"msvm\"", "\"magic\""),
              "t.json: aspects[0].classifier: expected \"msvm\" or \"rule\".");
    EXPECT_EQ(messageFor("\"fallback\": \"none\"", "\"fallback\": \"nil\""),
              "t.json: aspects[0].fallback: is none of the qualifiers.");
    EXPECT_EQ(messageFor("\"swing\"", "\"none\""),
              "t.json: aspects[0].qualifiers[1].id: is the id of two qualifiers.");
    EXPECT_EQ(messageFor("\"id\": \"hit\"", "\"id\": \"hit\", \"colour\": \"red\""),
              "t.json: aspects[1].qualifiers[1].colour: expected a colour like #3a86d8.");
    EXPECT_EQ(messageFor("\"vocabulary\": 1", "\"vocabulary\": 2"),
              "t.json: vocabulary: this Kumite reads version 1.");
    EXPECT_EQ(messageFor("\"classifier\": \"msvm\"", "\"classifier\": \"rule\""),
              "t.json: aspects[0]: \"rule\" is missing.");
}

TEST(Vocabulary, TwoQualifiersOnOneKeyAreReported) {
    std::string text = kTennis;
    text.replace(text.find("{\"id\": \"none\"}"), 14, "{\"id\": \"none\", \"key\": \"1\"}");
    Findings findings;
    parseVocabulary(text, "t.json", &findings);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].text, "In forehand the key 1 stands for both swing and none.");
}

TEST(Kickboxing, HasAQuickLabelForEveryStrikeOnAKeyOfItsOwn) {
    const Vocabulary& v = kickboxing();
    std::set<std::string> keys;
    std::set<Label> labels;
    for (const QuickLabel& quick : quickLabels(v)) {
        EXPECT_TRUE(!quick.key.empty() && keys.insert(quick.key).second) << quick.key;
        labels.insert(quick.label);
        EXPECT_EQ(quick.label[static_cast<std::size_t>(*v.find("react"))], kUnknown)
            << "left to the rules";
        EXPECT_EQ(quick.label[static_cast<std::size_t>(*v.find("move"))], kUnknown);
    }
    for (int a = 0; a < v.size(); ++a) {
        if (!v[a].limb) continue;
        for (std::size_t q = 0; q < v[a].qualifiers.size(); ++q) {
            Label label = parseLabel(v, v[a].id + ":" + v[a].qualifiers[q].id);
            label[static_cast<std::size_t>(*v.find("react"))] = kUnknown;
            EXPECT_TRUE(labels.contains(label)) << labelText(v, label);
        }
    }
}

TEST(Answers, OneKeyLabelsAWholeAction) {
    const Vocabulary& v = kickboxing();
    const Label nothing(v.aspects.size(), kUnknown);
    const auto answered = [&](const Label& said, const char* proposed, const char* aspect,
                              const char* qualifier, Naming naming = Naming::Instead) {
        const Label proposal = *proposed ? parseLabel(v, proposed) : nothing;
        const int a = *v.find(aspect);
        return labelText(v, answeredLabel(v, said, proposal, a, *v[a].find(qualifier), naming),
                         true);
    };
    // What nobody says or proposes is nothing; rules are left alone.
    EXPECT_EQ(answered(nothing, "", "right_punch", "fwd"), "right_punch:fwd+react:?");
    // A strike takes the place of the proposed one; a jump stays.
    EXPECT_EQ(answered(nothing, "left_punch:bwd+jump:up", "right_punch", "fwd"),
              "right_punch:fwd+jump:up+react:?");
    EXPECT_EQ(answered(nothing, "left_punch:bwd", "right_punch", "others"),
              "left_punch:bwd+react:?");
    // Besides: a composite, but for what excludes it.
    const Label kick = parseLabel(v, "left_kick:up");
    EXPECT_EQ(answered(kick, "", "right_punch", "fwd", Naming::Besides),
              "right_punch:fwd+left_kick:up");
    EXPECT_EQ(answered(kick, "", "right_kick", "down", Naming::Besides), "right_kick:down");
    EXPECT_EQ(answered(kick, "", "right_punch", "fwd"), "right_punch:fwd");
    // To name what a rule decides says nothing else.
    EXPECT_EQ(answered(nothing, "left_punch:bwd", "react", "kick"),
              "left_punch:?+right_punch:?+left_kick:?+right_kick:?+jump:?+react:kick");
    // Agreeing.
    EXPECT_EQ(labelText(v, agreedLabel(v, nothing, parseLabel(v, "jump:up+move:L-R")), true),
              "jump:up+react:?");
    EXPECT_EQ(labelText(v, agreedLabel(v, kick, parseLabel(v, "jump:up")), true), "left_kick:up");
}

TEST(Labels, AreSpeltByWhatIsNotOthers) {
    const Vocabulary& v = kickboxing();
    const Label label = parseLabel(v, "right_punch:fwd+move:L-R");
    EXPECT_EQ(labelText(v, label), "right_punch:fwd+move:L-R");
    EXPECT_EQ(label[0], 4) << "others";
    EXPECT_EQ(labelText(v, parseLabel(v, "move:L-R")), "move:L-R");
    EXPECT_EQ(labelText(v, parseLabel(v, "others")), "others");
    EXPECT_EQ(parseLabel(v, "others")[6], kUnknown) << "move has no fallback";
    const Label open = parseLabel(v, "jump:?+move:L-R");
    EXPECT_EQ(open[4], kUnknown);
    EXPECT_EQ(parseLabel(v, labelText(v, open, true)), open);
}

TEST(Labels, SayWhichWordIsUnknown) {
    const Vocabulary& v = kickboxing();
    for (const char* bad : {"", "left_foot:up", "left_kick:sideways", "left_kick",
                            "jump:up+jump:up", "left_kick:up+", "left_kick:up:up"}) {
        EXPECT_THROW(parseLabel(v, bad), Error) << bad;
    }
}

TEST(Labels, InTheMirror) {
    const Vocabulary& v = kickboxing();
    const Label label =
        parseLabel(v, "left_punch:fwdbwd+right_kick:up+jump:up+react:kick+move:L-F");
    const Label mirror = mirroredLabel(v, label);
    EXPECT_EQ(labelText(v, mirror), "right_punch:fwdbwd+left_kick:up+jump:up+react:kick+move:R-F");
    EXPECT_EQ(mirroredLabel(v, mirror), label);
}

}  // namespace
}  // namespace kumite
