#include "core/labelling/label_filter.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace kumite {
namespace {

/// "left_punch:fwd@machine 0.55": an aspect with its source and confidence; others unknown.
struct Made {
    std::string label;
    LabelSource source = LabelSource::Hand;
    double confidence = 1;
    int player = 0;
    int take = 0;
    double begin = 10;
    double end = 10.5;
    bool labelled = true;
};

/// The actions that the table below picks from, by name.
const std::vector<std::pair<std::string, Made>>& actions() {
    static const std::vector<std::pair<std::string, Made>> all = {
        {"kick", {"right_kick:up", LabelSource::Machine, 0.55}},
        {"sure", {"right_kick:up", LabelSource::Machine, 0.95, 1}},
        {"hand", {"right_kick:downup", LabelSource::Hand, 1, 0, 1, 95, 96.5}},
        {"punch", {"left_punch:bwdfwd", LabelSource::Hand, 1, 1}},
        {"jump", {"jump:up+left_punch:fwd", LabelSource::Machine, 0.65, 1, 0, 80, 80.2}},
        {"nothing", {"others", LabelSource::Machine, 0.9}},
        {"react", {"react:kick+move:L-R", LabelSource::Rule, 0.8}},
        {"open", {"", LabelSource::Machine, 0, 0, 0, 5, 6, false}},
    };
    return all;
}

FilterWords words() {
    return {kickboxing(), {"sparring", "Second Round"}};
}

std::string passing(const std::string& typed) {
    const LabelFilter filter = parseLabelFilter(words(), typed);
    std::string names;
    for (const auto& [name, made] : actions()) {
        std::vector<AspectValue> values(7);
        if (!made.label.empty()) {
            const Label label = parseLabel(kickboxing(), made.label);
            for (std::size_t a = 0; a < label.size(); ++a) {
                values[a] = {static_cast<std::int8_t>(label[a]), made.source,
                             static_cast<float>(made.confidence)};
            }
        }
        const FilterSubject subject{made.take, made.player, made.begin,
                                    made.end,  values,      made.labelled};
        if (filter.match(subject)) names += (names.empty() ? "" : " ") + name;
    }
    return names;
}

TEST(LabelFilter, LetsThroughWhatIsTyped) {
    const std::pair<const char*, const char*> cases[] = {
        {"", "kick sure hand punch jump nothing react open"},
        {"  ,  , ", "kick sure hand punch jump nothing react open"},
        {"right kick up, machine, below 0.6", "kick"},
        {"right kick up machine below 0.6", "kick"},
        {"Right KICK up", "kick sure"},
        {"right_kick:up", "kick sure"},
        {"kick right", "kick sure hand"},
        {"kick", "kick sure hand"},
        {"right kick down and up", "hand"},
        {"right kick down", ""},
        {"downup", "hand"},
        {"up", "kick sure jump"},
        {"kick or punch", "kick sure hand punch jump"},
        {"kick up or left punch forward", "kick sure jump"},
        {"punch back and forward", "punch"},
        {"player 2, jump, uncertain", "jump"},
        {"fighter 2", "sure punch jump"},
        {"p1, kick", "kick hand"},
        {"uncertain", "kick jump"},
        {"kick, sure", "sure hand"},
        {"above 90 %", "sure hand punch"},
        {"above 0.95", "hand punch"},
        {"confidence < 60%", "kick"},
        {"unlabelled", "open"},
        {"labelled, player 1", "kick hand nothing react"},
        {"no label", "open"},
        {"by hand", "hand punch"},
        {"hand", "hand punch"},
        {"not by hand", "kick sure jump nothing react open"},
        {"kick, not by hand", "kick sure"},
        {"by hand or by rule", "hand punch react"},
        {"kick and not machine", "hand"},
        {"not kick, not punch, labelled", "nothing react"},
        {"no jump, left punch", "punch"},
        {"others", "nothing"},
        {"strike", "kick sure hand punch jump"},
        {"attack, jump", "jump"},
        {"jump none, kick none", "punch nothing react"},
        {"jump open", "open"},
        {"react to a kick", "react"},
        {"react kick", "react"},
        {"react", "react"},
        {"L-R", "react"},
        {"left to right", "react"},
        {"move left to left", ""},
        {"take sparring, hand", "punch"},
        {"take second round", "hand"},
        {"take \"Second Round\"", "hand"},
        {"take 2", "hand"},
        {"after 1:20", "hand jump"},
        {"after 80 s, before 1:30", "jump"},
        {"from 0:05 to 0:10", "open"},
        {"between 1:00 and 2:00", "hand jump"},
        {"at 10.2", "kick sure punch nothing react"},
        {"longer than 1 s", "hand open"},
        {"shorter than 300 ms", "jump"},
    };
    for (const auto& [typed, expected] : cases) {
        std::string found;
        EXPECT_NO_THROW(found = passing(typed)) << typed;
        EXPECT_EQ(found, expected) << typed;
    }
}

TEST(LabelFilter, TellsOfWhatItFound) {
    std::vector<AspectValue> values(7);
    values[3] = {0, LabelSource::Machine, 0.55f};
    values[0] = {0, LabelSource::Hand, 1.0f};
    const FilterSubject action{0, 0, 0, 1, values, true};
    const auto all = parseLabelFilter(words(), "").match(action);
    EXPECT_EQ(all->aspects, (std::vector<int>{0, 3}));
    EXPECT_EQ(all->source, LabelSource::Machine);
    EXPECT_FLOAT_EQ(static_cast<float>(all->confidence), 0.55f);
    EXPECT_EQ(parseLabelFilter(words(), "left punch").match(action)->source, LabelSource::Hand);
    EXPECT_EQ(parseLabelFilter(words(), "by hand").match(action)->confidence, 1.0)
        << "what a machine said beside it does not count";
    EXPECT_FALSE(parseLabelFilter(words(), "left punch, machine").match(action));
}

TEST(LabelFilter, SaysWhatItUnderstood) {
    const std::pair<const char*, const char*> cases[] = {
        {"RIGHT kick up,machine , <.6", "right kick up · by machine · confidence below 0.60"},
        {"not jump or p2", "not jump or fighter 2"},
        {"from 90 to 30", "from 0:30 to 1:30"},
        {"take 2, at 61.25", "take Second Round · at 1:01.25"},
        {"", ""},
    };
    for (const auto& [typed, expected] : cases)
        EXPECT_EQ(parseLabelFilter(words(), typed).text(), expected) << typed;
}

TEST(LabelFilter, SaysInOneSentenceWhatItDoesNotKnow) {
    const std::pair<const char*, const char*> cases[] = {
        {"right kik up", "\"kik\" is no word that the filter knows; did you mean \"kick\"?"},
        {"machin", "\"machin\" is no word that the filter knows; did you mean \"machine\"?"},
        {"xyzzy",
         "\"xyzzy\" is no word that the filter knows: it knows aspects and qualifiers, "
         "sources, confidences, fighters, takes and times."},
        {"kick below", "After \"below\" a confidence is expected, such as 0.6 or 60 %."},
        {"below kick",
         "After \"below\" a confidence is expected, such as 0.6 or 60 %, not \"kick\"."},
        {"below 6", "After \"below\" a confidence is expected, such as 0.6 or 60 %, not \"6\"."},
        {"kick 0.6", "Say whether the confidence is \"below 0.6\" or \"above 0.6\"."},
        {"player 3", "After \"player\" 1 or 2 is expected, not \"3\"."},
        {"take third", "There is no take \"third\"; the takes are sparring, Second Round."},
        {"after noon", "After \"after\" a time is expected, such as 1:20 or 80 s, not \"noon\"."},
        {"from 1:00", "After \"from\" two times are expected, such as 0:30 to 1:00."},
        {"not", "Something is missing after \"not\"."},
        {"or kick", "Nothing stands before \"or\"."},
        {"kick or", "Nothing stands after \"or\"."},
    };
    for (const auto& [typed, expected] : cases) {
        try {
            parseLabelFilter(words(), typed);
            ADD_FAILURE() << typed << " was understood";
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), expected) << typed;
        }
    }
}

TEST(LabelFilter, NeverBreaksOnAnyWords) {
    const char* pieces[] = {"kick",  "not",  "or",   ",",   "below", "0.6", "take", "from",
                            "\"",    "1:20", "p2",   "<",   "%",     "to",  "",     "\xff",
                            "react", "+:",   "9e99", "and", "up",    "none"};
    unsigned state = 1;
    for (int i = 0; i < 3000; ++i) {
        std::string typed;
        for (int word = 0; word < 5; ++word) {
            state = state * 1664525u + 1013904223u;
            typed += std::string(pieces[(state >> 16) % std::size(pieces)]) + " ";
        }
        try {
            const LabelFilter filter = parseLabelFilter(words(), typed);
            const std::vector<AspectValue> values(7);
            filter.match({0, 0, 0, 1, values, false});
            // What it says it understood means the same again.
            EXPECT_EQ(parseLabelFilter(words(), filter.text()).text(), filter.text()) << typed;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()), "");
        }
    }
}

TEST(LabelFilter, CompletesTheLastPart) {
    const auto has = [](const std::vector<std::string>& list, const std::string& text) {
        return std::find(list.begin(), list.end(), text) != list.end();
    };
    EXPECT_TRUE(has(completeLabelFilter(words(), "right k"), "right kick up"));
    EXPECT_TRUE(has(completeLabelFilter(words(), "jump, unc"), "jump, uncertain"));
    EXPECT_TRUE(has(completeLabelFilter(words(), "machine, kick"), "machine, left kick up"))
        << "also words in the middle";
    EXPECT_TRUE(has(completeLabelFilter(words(), "take s"), "take Second Round"));
    EXPECT_TRUE(completeLabelFilter(words(), "xyzzy").empty());
    EXPECT_EQ(completeLabelFilter(words(), "", 5).size(), 5u);
    // Whatever is offered is understood.
    for (const std::string& offered : completeLabelFilter(words(), "", 1000))
        EXPECT_NO_THROW(parseLabelFilter(words(), offered)) << offered;
}

TEST(LabelFilter, SpeaksTheWordsOfAnyVocabulary) {
    Vocabulary tennis;
    tennis.name = "Tennis";
    Aspect stroke;
    stroke.id = "stroke";
    stroke.name = "Stroke";
    stroke.qualifiers = {{"fh", "forehand topspin", "", "", false, 0},
                         {"none", "none", "", "", false, 1}};
    stroke.fallback = 1;
    tennis.aspects = {stroke};
    const FilterWords own{tennis, {"match"}};
    std::vector<AspectValue> values = {{0, LabelSource::Machine, 0.5f}};
    const FilterSubject action{0, 0, 0, 1, values, true};
    EXPECT_TRUE(parseLabelFilter(own, "forehand topspin").match(action));
    EXPECT_TRUE(parseLabelFilter(own, "stroke fh, below 0.6").match(action));
    EXPECT_FALSE(parseLabelFilter(own, "stroke none").match(action));
    EXPECT_THROW(parseLabelFilter(own, "kick"), Error);
}

}  // namespace
}  // namespace kumite
