#include "core/project/edits.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/project/history.h"
#include "core/project/project_file.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

constexpr FighterAddress kFirst{0, 0};

struct Bout {
    Project project = test::makeBout();
    Analysis analysis = analyse(project);

    const std::vector<Boundary>& boundaries() const {
        return analysis.at(kFirst).segmentation->boundaries;
    }
    std::vector<int> frames() const {
        std::vector<int> frames;
        for (const Boundary& b : boundaries())
            frames.push_back(b.frame);
        return frames;
    }
    void apply(const MaybeEdit& edit) {
        ASSERT_TRUE(edit);
        project = edit->project;
        analysis = analyse(project, analysis);
    }
};

TEST(BoundaryEdits, RemoveAndRestoreComeBackToTheSameProject) {
    Bout bout;
    const Project before = bout.project;
    const auto frames = bout.frames();
    bout.apply(removeBoundary(bout.project, bout.analysis, kFirst, frames[3] + 2));
    auto without = frames;
    without.erase(without.begin() + 3);
    EXPECT_EQ(bout.frames(), without) << "the nearest within 0.1 s is meant";
    bout.apply(restoreBoundary(bout.project, bout.analysis, kFirst, frames[3]));
    EXPECT_EQ(bout.project, before);
}

TEST(BoundaryEdits, MoveAndMoveBack) {
    Bout bout;
    const Project before = bout.project;
    const int frame = bout.frames()[3];
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, frame, frame + 4));
    EXPECT_EQ(bout.frames()[3], frame + 4);
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, frame + 4, frame + 3));
    EXPECT_EQ(bout.project.takes[0].fighters[0].corrections.size(), 1u)
        << "one act, one correction";
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, frame + 3, frame));
    EXPECT_EQ(bout.project, before);
}

TEST(BoundaryEdits, AMovedBoundaryThatIsRemovedAndRestoredIsMovedStill) {
    Bout bout;
    const int frame = bout.frames()[3];
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, frame, frame + 8));
    const Project moved = bout.project;
    bout.apply(removeBoundary(bout.project, bout.analysis, kFirst, frame + 8));
    EXPECT_EQ(bout.analysis.at(kFirst).segmentation->removed.size(), 1u);
    bout.apply(restoreBoundary(bout.project, bout.analysis, kFirst, frame + 8));
    EXPECT_EQ(bout.project, moved);
}

TEST(BoundaryEdits, AddRemoveRestoreMoveOfAnAddedBoundary) {
    Bout bout;
    const auto frames = bout.frames();
    const int middle = (frames[2] + frames[3]) / 2;
    bout.apply(addBoundary(bout.project, bout.analysis, kFirst, middle));
    EXPECT_EQ(bout.boundaries()[3].source, BoundarySource::Added);
    EXPECT_FALSE(addBoundary(bout.project, bout.analysis, kFirst, middle)) << "it is there";
    const Project added = bout.project;
    bout.apply(removeBoundary(bout.project, bout.analysis, kFirst, middle));
    EXPECT_EQ(bout.frames(), frames);
    bout.apply(addBoundary(bout.project, bout.analysis, kFirst, middle));
    EXPECT_EQ(bout.project, added) << "adding again what was removed restores it";
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, middle, middle + 1));
    EXPECT_EQ(bout.frames()[3], middle + 1);
    EXPECT_EQ(bout.project.takes[0].fighters[0].corrections.size(), 1u);
}

TEST(BoundaryEdits, ABoundaryAddedBesideAnotherDoesNotReplaceIt) {
    Bout bout;
    const auto frames = bout.frames();
    bout.apply(addBoundary(bout.project, bout.analysis, kFirst, frames[3] + 2));
    EXPECT_EQ(bout.frames().size(), frames.size() + 1);
}

TEST(BoundaryEdits, WhatCannotBeDoneIsSaidAndChangesNothing) {
    Bout bout;
    const auto frames = bout.frames();
    const auto& p = bout.project;
    const auto& a = bout.analysis;
    EXPECT_THROW(removeBoundary(p, a, kFirst, 0), Error);
    EXPECT_THROW(removeBoundary(p, a, kFirst, 360), Error);
    EXPECT_THROW(removeBoundary(p, a, kFirst, 9999), Error);
    EXPECT_THROW(restoreBoundary(p, a, kFirst, frames[3]), Error);
    EXPECT_THROW(addBoundary(p, a, kFirst, 0), Error);
    EXPECT_THROW(addBoundary(p, a, kFirst, 360), Error);
    EXPECT_THROW(moveBoundary(p, a, kFirst, frames[3], frames[4]), Error);
    EXPECT_THROW(moveBoundary(p, a, kFirst, frames[3], frames[2]), Error);
    EXPECT_FALSE(moveBoundary(p, a, kFirst, frames[3], frames[3]));
    EXPECT_FALSE(dropUnmatchedCorrections(p, a, kFirst));
    Project missing = p;
    missing.takes[0].fighters[0].motion = nullptr;
    EXPECT_THROW(removeBoundary(missing, analyse(missing), kFirst, frames[3]), Error);
}

TEST(BoundaryEdits, CorrectionsSurviveAChangeOfSettings) {
    Bout bout;
    const int frame = bout.frames()[3];
    bout.apply(removeBoundary(bout.project, bout.analysis, kFirst, frame));
    for (const double cutoff : {5.0, 7.0, 8.0}) {
        bout.apply(setSegmentation(bout.project, {cutoff, 0.05, ForceCurve::Norm}));
        for (const int other : bout.frames())
            EXPECT_GT(std::abs(other - frame), 6) << cutoff;
        EXPECT_EQ(bout.analysis.at(kFirst).segmentation->removed.size(), 1u);
    }
}

/// Random acts around two boundaries, settings changed in between: each does exactly what it says.
TEST(BoundaryEdits, EveryActDoesWhatItSaysAfterAnyOther) {
    std::mt19937 random(5);
    const auto draw = [&](int from, int to) {
        return from + static_cast<int>(random() % static_cast<unsigned>(to - from + 1));
    };
    const Bout fresh;
    const std::array<int, 2> places = {fresh.frames()[3], fresh.frames()[5]};
    int acts = 0;
    for (int run = 0; run < 400; ++run) {
        Bout bout;
        std::string log;
        for (int step = 0; step < 8; ++step) {
            const int frame = places[random() % 2] + draw(-9, 9);
            const int to = frame + draw(-12, 12);
            const auto before = bout.frames();
            const int act = draw(0, 7);
            MaybeEdit edit;
            try {
                const Project& p = bout.project;
                const Analysis& a = bout.analysis;
                if (act <= 1) edit = removeBoundary(p, a, kFirst, frame);
                if (act == 2) edit = addBoundary(p, a, kFirst, frame);
                if (act == 3) edit = moveBoundary(p, a, kFirst, frame, to);
                if (act == 4) edit = restoreBoundary(p, a, kFirst, frame);
                if (act == 6) edit = acceptBoundary(p, a, kFirst, frame);
                if (act == 7) edit = withdrawAcceptance(p, a, kFirst, frame);
                if (act == 5)
                    edit = setSegmentation(
                        p, {1.0 * draw(5, 7), 0.01 * draw(1, 30), ForceCurve::Norm});
            } catch (const Error&) {
                continue;
            }
            if (!edit) continue;
            ++acts;
            log +=
                std::to_string(act) + " " + std::to_string(frame) + " " + std::to_string(to) + "; ";
            const auto nearest = *std::min_element(before.begin(), before.end(), [&](int x, int y) {
                return std::abs(x - frame) < std::abs(y - frame);
            });
            bout.apply(edit);
            const auto after = bout.frames();
            const auto has = [&](int f) { return std::count(after.begin(), after.end(), f) > 0; };
            const auto change = static_cast<int>(after.size()) - static_cast<int>(before.size());
            const bool asSaid[] = {change == -1 && !has(nearest),
                                   change == -1 && !has(nearest),
                                   change == 1 && has(frame),
                                   change == 0 && has(to),
                                   change == 1,
                                   true,
                                   change == 0 && has(nearest),
                                   change <= 0};
            EXPECT_TRUE(asSaid[act]) << log;
            const std::string text = projectText(bout.project, "/");
            EXPECT_EQ(projectText(parseProject(text, "x", "/"), "/"), text) << log;
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(acts, 1000);
}

TEST(BoundaryEdits, UnmatchedCorrectionsAreForgottenOnRequestOnly) {
    Bout bout;
    bout.project.takes[0].fighters[0].corrections = {
        {Correction::Kind::Move, 9000, 9001, false, false},
        {Correction::Kind::Add, 5000, 0, false, false}};
    bout.analysis = analyse(bout.project);
    ASSERT_EQ(bout.analysis.at(kFirst).segmentation->unmatched.size(), 2u);
    bout.apply(dropUnmatchedCorrections(bout.project, bout.analysis, kFirst));
    EXPECT_TRUE(bout.project.takes[0].fighters[0].corrections.empty());
}

Take otherTake() {
    Take take = test::makeBout().takes[0];
    take.name = "other";
    return take;
}

/// Every edit there is, each applicable to a fresh bout.
std::vector<std::pair<std::string, std::function<MaybeEdit(const Bout&)>>> everyEdit() {
    const auto frame = [](const Bout& bout) { return bout.frames()[3]; };
    return {
        {"remove",
         [=](const Bout& b) { return removeBoundary(b.project, b.analysis, kFirst, frame(b)); }},
        {"add",
         [=](const Bout& b) { return addBoundary(b.project, b.analysis, kFirst, frame(b) + 9); }},
        {"move",
         [=](const Bout& b) {
             return moveBoundary(b.project, b.analysis, kFirst, frame(b), frame(b) + 1);
         }},
        {"accept",
         [=](const Bout& b) { return acceptBoundary(b.project, b.analysis, kFirst, frame(b)); }},
        {"note",
         [=](const Bout& b) {
             return setNote(b.project, b.analysis, kFirst, frame(b), "a feint");
         }},
        {"settings",
         [](const Bout& b) {
             return setSegmentation(b.project, {5, 0.1, ForceCurve::Vertical});
         }},
        {"body",
         [](const Bout& b) {
             return setBodyModel(b.project, {"none", {}});
         }},
        {"add take", [](const Bout& b) { return addTake(b.project, otherTake()); }},
        {"remove take", [](const Bout& b) { return removeTake(b.project, 0); }},
        {"rename", [](const Bout& b) { return renameTake(b.project, 0, "round 2"); }},
        {"swap", [](const Bout& b) { return swapFighters(b.project, 0); }},
        {"offset", [](const Bout& b) { return setOffset(b.project, kFirst, 0.5); }},
        {"place",
         [](const Bout& b) {
             return setPlacement(b.project, kFirst, {1, 2, 3});
         }},
        {"floor", [](const Bout& b) { return setFloor(b.project, kFirst, 0.05); }},
        {"role", [](const Bout& b) { return setRole(b.project, kFirst, Role::Head, 2); }},
        {"relink",
         [](const Bout& b) {
             return relinkRecording(b.project, kFirst, {"/elsewhere.bvh", {}, "x", ""},
                                    b.project.takes[0].fighters[0].motion);
         }},
    };
}

TEST(Edits, EveryEditUndoRedo) {
    for (const auto& [what, make] : everyEdit()) {
        SCOPED_TRACE(what);
        const Bout bout;
        History history(bout.project);
        const MaybeEdit edit = make(bout);
        ASSERT_TRUE(edit);
        EXPECT_FALSE(edit->name.empty());
        EXPECT_NE(edit->project, bout.project);
        history.commit(*edit);
        EXPECT_FALSE(history.isSaved());
        EXPECT_EQ(history.undoName(), edit->name);
        history.undo();
        EXPECT_EQ(history.current(), bout.project);
        EXPECT_TRUE(history.isSaved());
        EXPECT_EQ(history.redoName(), edit->name);
        history.redo();
        EXPECT_EQ(history.current(), edit->project);
        EXPECT_NO_THROW(analyse(history.current(), bout.analysis));
    }
}

TEST(Edits, AnEditThatChangesNothingIsNone) {
    const Bout b;
    EXPECT_FALSE(setSegmentation(b.project, b.project.segmentation));
    EXPECT_FALSE(setBodyModel(b.project, b.project.bodyModel));
    EXPECT_FALSE(renameTake(b.project, 0, "made"));
    EXPECT_FALSE(setOffset(b.project, kFirst, 0));
    EXPECT_FALSE(setPlacement(b.project, kFirst, {}));
    EXPECT_FALSE(setFloor(b.project, kFirst, std::nullopt));
    EXPECT_FALSE(setRole(b.project, kFirst, Role::Head, 3));
}

TEST(Edits, TakesMoveAndTheOthersCloseUp) {
    const Bout b;
    Project project = b.project;
    for (const char* name : {"two", "three", "four"})
        project = addTake(project, Take{name, otherTake().fighters})->project;
    const auto names = [](const Project& p) {
        std::string all;
        for (const Take& take : p.takes)
            all += take.name + ' ';
        return all;
    };
    EXPECT_EQ(names(moveTake(project, 0, 2)->project), "two three made four ");
    EXPECT_EQ(names(moveTake(project, 3, 1)->project), "made four two three ");
    EXPECT_EQ(moveTake(moveTake(project, 1, 3)->project, 3, 1)->project, project);
    EXPECT_FALSE(moveTake(project, 1, 1));
    EXPECT_THROW(moveTake(project, 1, 4), Error);
    EXPECT_THROW(moveTake(project, 1, -1), Error);
    EXPECT_THROW(moveTake(project, 9, 0), std::out_of_range);
}

TEST(Edits, NonsenseIsRefused) {
    const Bout b;
    const auto& p = b.project;
    EXPECT_THROW(setSegmentation(p, {0, 0.05, ForceCurve::Norm}), Error);
    EXPECT_THROW(setSegmentation(p, {6, -1, ForceCurve::Norm}), Error);
    EXPECT_THROW(setSegmentation(p, {std::nan(""), 0.05, ForceCurve::Norm}), Error);
    EXPECT_THROW(addTake(p, p.takes[0]), Error);
    EXPECT_THROW(addTake(p, Take{"", otherTake().fighters}), Error);
    EXPECT_THROW(addTake(p, Take{"empty", {}}), Error);
    EXPECT_THROW(renameTake(p, 0, ""), Error);
    EXPECT_THROW(setOffset(p, kFirst, INFINITY), Error);
    EXPECT_THROW(setRole(p, kFirst, Role::Head, 999), Error);
    Take single = otherTake();
    single.fighters.pop_back();
    EXPECT_THROW(swapFighters(addTake(p, single)->project, 1), Error);
    const auto shorter = test::bobbing(10, 60, [](double) { return 0.0; });
    EXPECT_THROW(relinkRecording(p, kFirst, {}, shorter), Error);
}

TEST(History, BranchingDropsWhatWasUndone) {
    History history(test::makeBout());
    history.commit({Project{}, "one"});
    history.markSaved();
    history.undo();
    EXPECT_FALSE(history.isSaved());
    history.commit({Project{}, "two"});
    EXPECT_FALSE(history.canRedo());
    EXPECT_FALSE(history.isSaved()) << "the saved step is gone";
    history.undo();
    EXPECT_FALSE(history.isSaved());
    EXPECT_FALSE(history.canUndo());
    history.undo();
    history.goTo(1);
    EXPECT_EQ(history.undoName(), "two");
    history.redo();
    EXPECT_EQ(history.position(), 1u);
}

}  // namespace
}  // namespace kumite
