// What an author plans: as JSON and back, its names that outlive edits, and what it comes to.

#include "core/project/sequence_draft.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/analysis.h"
#include "core/project/library.h"
#include "tests/support/builders.h"
#include "tests/support/made_library.h"

namespace kumite {
namespace {

SequenceDraft someDraft() {
    SequenceDraft draft;
    draft.blocks.resize(3);
    draft.blocks[0].clip = "kick";
    draft.blocks[1].clip = "punch";
    draft.blocks[1].title = "jab \"left\"";
    draft.blocks[1].trim = FrameRange{5, 50};
    draft.blocks[1].repeats = 2;
    draft.blocks[1].transition.seed = 7;
    draft.blocks[2].clip = "block";
    draft.blocks[2].transition.method = TransitionMethod::Bezier;
    draft.blocks[2].locked = true;
    return draft;
}

TEST(SequenceDraft, ComesBackFromTheProject) {
    SequenceDraft draft = someDraft();
    draft.cleanFeet = false;
    draft.blocks[0].transition.path = 2;
    const Project project = test::makeBout();
    EXPECT_EQ(sequenceDraftOf(project), SequenceDraft());
    const MaybeEdit edit = setSequenceDraft(project, draft, "Add block");
    ASSERT_TRUE(edit);
    EXPECT_EQ(edit->name, "Add block");
    EXPECT_EQ(sequenceDraftOf(edit->project), draft);
    EXPECT_FALSE(setSequenceDraft(edit->project, draft, "again")) << "nothing changed";
    EXPECT_TRUE(setSequenceDraft(edit->project, {}, "Clear")->project.drafts.empty());
}

TEST(SequenceDraft, WhatIsWrongIsNamedWithItsPlace) {
    const auto errorOf = [](const std::string& text) -> std::string {
        try {
            parseSequenceDraft(text, "d.json");
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_NE(errorOf("{}").find("blocks"), std::string::npos);
    EXPECT_NE(errorOf(R"({"blocks": [{}]})").find("blocks[0]"), std::string::npos);
    EXPECT_NE(errorOf(R"({"blocks": [{"clip": 3}]})").find("clip"), std::string::npos);
    for (const char* wrong : {R"("trim": [5, 5])", R"("trim": [-1, 5])", R"("repeats": 0)",
                              R"("method": "magic")", R"("path": -1)", R"("seed": -2)"}) {
        const std::string text =
            R"({"blocks": [{"clip": "kick"}, {"clip": "kick", )" + std::string(wrong) + "}]}";
        EXPECT_NE(errorOf(text).find("blocks[1]"), std::string::npos) << wrong;
    }
}

TEST(SequenceDraft, PlaysWhatIsPlanned) {
    const auto library = test::madeLibrary();
    const Sequence sequence = sequenceOf(*library, someDraft());
    ASSERT_EQ(sequence.blocks.size(), 3u);
    EXPECT_EQ(sequence.blocks[1].repeats, 2);
    const SequenceMotion motion = makeSequence(buildFlexibleGraph(library), sequence);
    int trimmed = 0;
    for (const SequencePiece& piece : motion.pieces) {
        if (!piece.transition && piece.block == 1) {
            ++trimmed;
            EXPECT_LE(piece.frames.size(), 45);
        }
        if (piece.transition && piece.block == 2) {
            EXPECT_EQ(piece.transition->method, TransitionMethod::Bezier);
        }
    }
    EXPECT_EQ(trimmed, 2);
    SequenceDraft unknown = someDraft();
    unknown.blocks[0].clip = "headbutt";
    EXPECT_THROW(sequenceOf(*library, unknown), Error);
}

TEST(SequenceDraft, LastingNamesMeanTheSameFrames) {
    const Project project = test::makeBout();
    const Analysis analysis = analyse(project);
    for (const double rate : {15.0, 30.0, 60.0, 24.0, 120.0}) {
        const MotionLibrary library = libraryOf(project, analysis, {rate}).library;
        ASSERT_GT(library.actions.size(), 4u);
        for (const LibraryAction& action : library.actions) {
            const LibraryAction found = actionNamed(library, lastingName(library, action));
            EXPECT_EQ(found.motion, action.motion) << action.name;
            EXPECT_EQ(found.frames.begin, action.frames.begin) << action.name << " " << rate;
            EXPECT_EQ(found.frames.end, action.frames.end) << action.name << " " << rate;
        }
    }
}

}  // namespace
}  // namespace kumite
