#include "core/project/review.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/edits.h"
#include "core/project/history.h"
#include "core/project/notes.h"
#include "core/project/project_file.h"
#include "core/project/report.h"
#include "core/segmentation/boundary_comparison.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

constexpr FighterAddress kFirst{0, 0};
using Kind = Correction::Kind;

struct Bout {
    Project project = test::makeBout();
    Analysis analysis = analyse(project);

    const FighterAnalysis& fighter() const { return analysis.at(kFirst); }
    const Segmentation& cut() const { return *fighter().segmentation; }
    int frame(std::size_t boundary) const { return cut().boundaries[boundary].frame; }
    void apply(const MaybeEdit& edit) {
        ASSERT_TRUE(edit);
        project = edit->project;
        analysis = analyse(project, analysis);
    }
};

TEST(Acceptance, IsADecisionThatHoldsAndCanBeTakenBack) {
    Bout bout;
    const Project before = bout.project;
    const int frame = bout.frame(3);
    const double suspected = (*bout.fighter().suspicion)[*bout.cut().boundaries[3].minimum];
    bout.apply(acceptBoundary(bout.project, bout.analysis, kFirst, frame + 1));
    EXPECT_EQ(bout.cut().boundaries[3].source, BoundarySource::Accepted);
    EXPECT_EQ(bout.frame(3), frame);
    EXPECT_LE((*bout.fighter().suspicion)[*bout.cut().boundaries[3].minimum], suspected);
    EXPECT_FALSE(acceptBoundary(bout.project, bout.analysis, kFirst, frame)) << "nothing to decide";
    // It stays where a higher threshold removes all that nobody accepted.
    bout.apply(setSegmentation(bout.project, {6, 100, ForceCurve::Norm}));
    ASSERT_EQ(bout.cut().boundaries.size(), 3u);
    EXPECT_EQ(bout.frame(1), frame);
    bout.apply(setSegmentation(bout.project, SegmentationSettings{}));
    bout.apply(withdrawAcceptance(bout.project, bout.analysis, kFirst, frame));
    EXPECT_EQ(bout.project, before);
    EXPECT_FALSE(withdrawAcceptance(bout.project, bout.analysis, kFirst, frame));
}

TEST(Acceptance, SurvivesRemovalAndRestoringAndAMoveAndBack) {
    Bout bout;
    const int frame = bout.frame(3);
    bout.apply(acceptBoundary(bout.project, bout.analysis, kFirst, frame));
    const Project accepted = bout.project;
    bout.apply(removeBoundary(bout.project, bout.analysis, kFirst, frame));
    EXPECT_NE(bout.frame(3), frame);
    bout.apply(restoreBoundary(bout.project, bout.analysis, kFirst, frame));
    EXPECT_EQ(bout.project, accepted);
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, frame, frame + 2));
    EXPECT_EQ(bout.cut().boundaries[3].source, BoundarySource::Moved);
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, frame + 2, frame));
    EXPECT_EQ(bout.project, accepted);
}

TEST(Acceptance, OfAMinimumThatIsGoneIsListedForDecision) {
    Bout bout;
    bout.project.takes[0].fighters[0].corrections = {{Kind::Keep, 9000, 0, false, false}};
    bout.analysis = analyse(bout.project);
    EXPECT_EQ(bout.cut().unmatched.size(), 1u);
}

TEST(UnmatchedCorrections, AreForgottenOneByOneOrBecomeBoundariesByHand) {
    Bout bout;
    const int place = (bout.frame(3) + bout.frame(4)) / 2;
    const Correction move{Kind::Move, 9000, place, false, false};
    const Correction removal{Kind::Remove, 9500, 0, false, false};
    bout.project.takes[0].fighters[0].corrections = {move, removal};
    bout.analysis = analyse(bout.project);
    ASSERT_EQ(bout.cut().unmatched.size(), 2u);
    EXPECT_THROW(addBoundaryOfCorrection(bout.project, bout.analysis, kFirst, removal), Error);
    bout.apply(addBoundaryOfCorrection(bout.project, bout.analysis, kFirst, move));
    EXPECT_EQ(bout.cut().unmatched, (std::vector<Correction>{removal}));
    EXPECT_EQ(bout.frame(4), place);
    EXPECT_EQ(bout.cut().boundaries[4].source, BoundarySource::Added);
    bout.apply(forgetCorrection(bout.project, bout.analysis, kFirst, removal));
    EXPECT_TRUE(bout.cut().unmatched.empty());
    EXPECT_EQ(bout.project.takes[0].fighters[0].corrections.size(), 1u);
    EXPECT_THROW(forgetCorrection(bout.project, bout.analysis, kFirst, removal), Error);
}

TEST(Notes, BelongToTheActionWhereverItsBordersGo) {
    Bout bout;
    const Action action = bout.cut().actions[3];
    bout.apply(setNote(bout.project, bout.analysis, kFirst, action.begin + 1, "feint, \"low\""));
    const auto note = [&](int frame) {
        return noteOf(bout.fighter().input.notes, bout.cut(), *actionAt(bout.cut(), frame));
    };
    EXPECT_EQ(note(action.peak), "feint, \"low\"");
    EXPECT_EQ(note(bout.cut().actions[4].peak), "");
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, action.end, action.end - 2));
    EXPECT_EQ(note(action.peak), "feint, \"low\"");
    bout.apply(setNote(bout.project, bout.analysis, kFirst, bout.cut().actions[4].peak, "second"));
    bout.apply(removeBoundary(bout.project, bout.analysis, kFirst, action.end - 2));
    EXPECT_EQ(note(action.peak), "feint, \"low\"; second") << "joined actions keep both";
    bout.apply(setNote(bout.project, bout.analysis, kFirst, action.peak, "one"));
    EXPECT_EQ(bout.fighter().input.notes.size(), 1u);
    EXPECT_FALSE(setNote(bout.project, bout.analysis, kFirst, action.peak, "one"));
    bout.apply(setNote(bout.project, bout.analysis, kFirst, action.peak, ""));
    EXPECT_TRUE(bout.fighter().input.notes.empty());
    EXPECT_THROW(setNote(bout.project, bout.analysis, kFirst, 100000, "x"), Error);
}

TEST(Notes, AreExported) {
    Bout bout;
    bout.apply(setNote(bout.project, bout.analysis, kFirst, bout.cut().actions[1].peak, "a, b"));
    const std::string csv = actionsCsv(bout.project, bout.analysis, {});
    EXPECT_NE(csv.find(",\"a, b\"\n"), std::string::npos);
    const std::string json = segmentationJson(bout.project, bout.analysis);
    EXPECT_NE(json.find("\"note\": \"a, b\""), std::string::npos);
}

TEST(ProjectFile, KeepsAcceptancesAndNotes) {
    Bout bout;
    bout.apply(acceptBoundary(bout.project, bout.analysis, kFirst, bout.frame(3)));
    bout.apply(setNote(bout.project, bout.analysis, kFirst, 100, "über, \"quoted\"\nsecond line"));
    const std::string text = projectText(bout.project, "/");
    const Project read = parseProject(text, "x", "/");
    EXPECT_EQ(read.takes[0].fighters[0].corrections, bout.project.takes[0].fighters[0].corrections);
    EXPECT_EQ(read.takes[0].fighters[0].notes, bout.project.takes[0].fighters[0].notes);
    EXPECT_EQ(projectText(read, "/"), text);
}

TEST(Reasons, NameTheStrongestEvidence) {
    Bout bout;
    auto evidence = *bout.fighter().evidence;
    FighterAnalysis fighter = bout.fighter();
    const auto reasonWith = [&](const SuspicionEvidence& what) {
        evidence[2] = what;
        fighter.evidence = std::make_shared<std::vector<SuspicionEvidence>>(evidence);
        return suspectReason(fighter, 2);
    };
    using Reason = SuspectReason::Kind;
    EXPECT_EQ(reasonWith({-1, -1, -1, -1}).kind, Reason::Unremarkable);
    EXPECT_EQ(reasonWith({2, 1, 0, 0}).kind, Reason::Shallow);
    EXPECT_EQ(reasonWith({0, 1, 0.5, 0}).kind, Reason::High);
    EXPECT_EQ(reasonWith({0, 1, 1.5, 0}).kind, Reason::Crowded);
    EXPECT_EQ(reasonWith({0, 1, 0, 1.5}).kind, Reason::MovingFoot) << "both feet stand";
    const SuspectReason reason = reasonWith({2, 1, 0, 0});
    EXPECT_DOUBLE_EQ(reason.prominence, fighter.force->minima[2].prominence);
    EXPECT_GT(reason.nearest, 0.0);
}

TEST(Statistics, CountWhatHandsDid) {
    Bout bout;
    const double threshold = bout.project.segmentation.prominence;
    const ReviewStatistics fresh = reviewStatistics(bout.fighter(), threshold);
    EXPECT_NEAR(fresh.seconds, bout.fighter().frameCount() / 60.0, 1e-9);
    EXPECT_EQ(fresh.minima, static_cast<int>(bout.cut().boundaries.size()) - 2);
    EXPECT_DOUBLE_EQ(fresh.shareCorrected(), 0.0);
    bout.apply(removeBoundary(bout.project, bout.analysis, kFirst, bout.frame(2)));
    bout.apply(moveBoundary(bout.project, bout.analysis, kFirst, bout.frame(3), bout.frame(3) + 1));
    bout.apply(acceptBoundary(bout.project, bout.analysis, kFirst, bout.frame(4)));
    bout.apply(addBoundary(bout.project, bout.analysis, kFirst, bout.frame(1) + 9));
    ReviewStatistics now = reviewStatistics(bout.fighter(), threshold);
    EXPECT_EQ(now.removed, 1);
    EXPECT_EQ(now.moved, 1);
    EXPECT_EQ(now.accepted, 1);
    EXPECT_EQ(now.added, 1);
    EXPECT_EQ(now.minima, fresh.minima);
    EXPECT_NEAR(now.shareCorrected(), 3.0 / (fresh.minima + 1), 1e-12);
    now += fresh;
    EXPECT_EQ(now.minima, 2 * fresh.minima);
    EXPECT_EQ(reviewStatistics(FighterAnalysis{}, threshold).minima, 0);
}

TEST(BoundaryComparison, PairsTheNearestAndListsTheRest) {
    const std::vector<int> a = {0, 50, 100, 200, 300};
    const std::vector<int> b = {0, 52, 53, 110, 205, 300};
    const BoundaryComparison difference = compareBoundaries(a, b, 6);
    EXPECT_EQ(difference.both, 4);
    EXPECT_EQ(difference.onlyA, (std::vector<int>{100}));
    EXPECT_EQ(difference.onlyB, (std::vector<int>{53, 110}));
    EXPECT_EQ(compareBoundaries(a, a, 6).both, 5);
    EXPECT_EQ(compareBoundaries(a, {}, 6).onlyA, a);
    EXPECT_EQ(compareBoundaries({}, b, 6).onlyB, b);
}

TEST(History, AmendingIsOneStepHoweverOften) {
    const Bout bout;
    History history(bout.project);
    const auto cutoff = [&](double hertz) {
        return *setSegmentation(history.current(), {hertz, 0.05, ForceCurve::Norm});
    };
    history.commit(cutoff(7));
    history.markSaved();
    history.amend(cutoff(8));
    EXPECT_FALSE(history.isSaved()) << "what was saved is no step any more";
    history.amend(cutoff(9));
    EXPECT_EQ(history.steps().size(), 2u);
    EXPECT_DOUBLE_EQ(history.current().segmentation.cutoff, 9);
    history.undo();
    EXPECT_EQ(history.current(), bout.project);
    history.redo();
    history.amend(cutoff(6));
    EXPECT_EQ(history.steps().size(), 1u) << "back at the beginning nothing was done";
    EXPECT_FALSE(history.canRedo());
}

}  // namespace
}  // namespace kumite
