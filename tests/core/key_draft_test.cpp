// Key poses and choices as a project holds them.

#include "core/project/key_draft.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/hit_draft.h"
#include "tests/support/builders.h"
#include "tests/support/made_library.h"

namespace kumite {
namespace {

KeyDraft someDraft(const MotionLibrary& library) {
    KeyDraft draft;
    draft.track.rig = library.rig;
    draft.track.rate = library.rate;
    for (const int frame : {3, 20, 41})
        draft.track = withKey(std::move(draft.track),
                              {frame, library.motions[0].clip.frames[std::size_t(frame)],
                               frame == 20 ? Easing::Hold : Easing::Smooth});
    draft.body = "punch@10:50";
    draft.parts[static_cast<std::size_t>(BodyPart::RightArm)] = PartChoice::Kind::Own;
    draft.parts[static_cast<std::size_t>(BodyPart::Trunk)] = PartChoice::Kind::WithBody;
    draft.assembly.adjusted = false;
    draft.assembly.meetKeys = 0.25;
    return draft;
}

TEST(KeyDraft, ComesBackFromTheProject) {
    const auto library = test::madeLibrary();
    const KeyDraft draft = someDraft(*library);
    const Project project = test::makeBout();
    EXPECT_TRUE(keyDraftOf(project, library->rig, 60).track.keys.empty());
    EXPECT_EQ(keyDraftOf(project, library->rig, 60).track.rate, 60);
    const MaybeEdit edit = setKeyDraft(project, draft, "Add key");
    ASSERT_TRUE(edit);
    const KeyDraft again = keyDraftOf(edit->project, library->rig, 60);
    ASSERT_EQ(again.track.keys.size(), 3u);
    EXPECT_EQ(again.track.rate, library->rate);
    EXPECT_EQ(again.track.keys[1].easing, Easing::Hold);
    EXPECT_EQ(again.body, draft.body);
    EXPECT_EQ(again.parts, draft.parts);
    EXPECT_EQ(again.assembly.meetKeys, 0.25);
    EXPECT_FALSE(again.assembly.adjusted);
    for (std::size_t j = 0; j < library->rig->joints.size(); ++j) {
        EXPECT_LT(
            again.track.keys[2].pose.turns[j].angularDistance(draft.track.keys[2].pose.turns[j]),
            1e-5);
    }
    KeyDraft empty = draft;
    empty.track.keys.clear();
    EXPECT_TRUE(setKeyDraft(edit->project, empty, "Clear")->project.drafts.empty());
}

TEST(KeyDraft, APartHasAPlaceOfItsOwn) {
    const auto library = test::madeLibrary();
    KeyDraft draft = someDraft(*library);
    const auto arm = static_cast<std::size_t>(BodyPart::RightArm);
    const auto leg = static_cast<std::size_t>(BodyPart::LeftLeg);
    draft.places[arm] = "punch@5:40";
    draft.places[leg] = "punch@5:40";
    const KeyDraft again = parseKeyDraft(keyDraftText(draft), "draft", library->rig);
    EXPECT_EQ(again.places, draft.places);
    const AssemblyChoices choices = choicesOf(*library, again);
    ASSERT_TRUE(choices.parts[arm].within);
    EXPECT_EQ(choices.parts[arm].within->frames.begin, 5);
    EXPECT_FALSE(choices.parts[leg].within) << "only a part of its own is looked for elsewhere";
}

TEST(HitDraft, ComesBackFromTheProject) {
    const Project project = test::makeBout();
    EXPECT_TRUE(hitDraftOf(project).isEmpty());
    HitDraft draft;
    draft.strike = "right_punch";
    draft.target = Eigen::Vector3d(0.1, 1.4, 0.7);
    draft.aim = Role::Head;
    draft.distance = 0.9;
    const MaybeEdit edit = setHitDraft(project, draft, "Aim");
    ASSERT_TRUE(edit);
    EXPECT_EQ(hitDraftOf(edit->project), draft);
    EXPECT_TRUE(setHitDraft(edit->project, {}, "None")->project.drafts.empty());
    EXPECT_THROW(parseHitDraft(R"({"aim": "tail"})", "draft"), Error);
    EXPECT_THROW(parseHitDraft(R"({"target": [1, 2]})", "draft"), Error);
}

TEST(KeyDraft, FollowsATakeThatIsRenamed) {
    const auto library = test::madeLibrary();
    Project project = test::makeBout();
    KeyDraft draft = someDraft(*library);
    const std::string name = project.takes[0].name;
    draft.body = name + ":1@10:50";
    draft.places[0] = name + ":of old@1:2";
    project = setKeyDraft(project, draft, "Add key")->project;
    const MaybeEdit edit = renameTake(project, 0, "another");
    ASSERT_TRUE(edit);
    const KeyDraft again = keyDraftOf(edit->project, library->rig, 60);
    EXPECT_EQ(again.body, "another:1@10:50");
    EXPECT_EQ(again.places[0], draft.places[0]) << "that is no player";
}

TEST(KeyDraft, ChoicesNamePlacesOfTheLibrary) {
    const auto library = test::madeLibrary();
    const AssemblyChoices choices = choicesOf(*library, someDraft(*library));
    ASSERT_TRUE(choices.body);
    EXPECT_EQ(library->motions[static_cast<std::size_t>(choices.body->clip)].name, "punch");
    EXPECT_EQ(choices.body->frames, (FrameRange{10, 50}));
    EXPECT_EQ(choices.parts[static_cast<std::size_t>(BodyPart::RightArm)].kind,
              PartChoice::Kind::Own);
    KeyDraft gone = someDraft(*library);
    gone.body = "gone";
    EXPECT_THROW(choicesOf(*library, gone), Error);
}

TEST(KeyDraft, WhatIsWrongIsNamed) {
    const auto library = test::madeLibrary();
    const std::string good = keyDraftText(someDraft(*library));
    const auto wrong = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        EXPECT_THROW(parseKeyDraft(text, "k", library->rig), InputError) << to;
    };
    wrong("\"own\"", "\"mine\"");
    wrong("\"right_arm\"", "\"tail\"");
    wrong("\"meet\":0.25", "\"meet\":1.5");
    wrong("\"adjusted\":false", "\"adjusted\":3");
}

}  // namespace
}  // namespace kumite
