// What a user's hands do on the timeline of the real window.

#include <QAbstractItemView>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QWheelEvent>

#include <cmath>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/timeline/timeline_view.h"
#include "studio/workspaces/segment/segment_panel.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

TEST_F(WindowTest, ClickSelectsDelRemovesDelRestoresAndAllOfItIsUndone) {
    openBout();
    const BoundaryRef boundary = someBoundary(1);
    const std::size_t actions = session().fighter(1)->segmentation->actions.size();
    click(timeline().pointOf(boundary));
    ASSERT_EQ(session().selection(), boundary);
    EXPECT_EQ(session().activePlayer(), 1);
    EXPECT_NEAR(session().transport().playhead(), session().timeOf(boundary), 1e-9);
    ASSERT_TRUE(mark(boundary)->isLive());

    press(Qt::Key_Delete);
    EXPECT_FALSE(mark(boundary)->isLive());
    EXPECT_EQ(session().fighter(1)->segmentation->actions.size(), actions - 1);
    EXPECT_EQ(session().selection(), boundary);
    press(Qt::Key_Delete);
    EXPECT_TRUE(mark(boundary)->isLive());
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(mark(boundary)->isLive());
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(mark(boundary)->isLive());
    EXPECT_FALSE(session().document().isModified());
    press(Qt::Key_Y, Qt::ControlModifier);
    EXPECT_FALSE(mark(boundary)->isLive());
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(mark(boundary)->isLive());
}

TEST_F(WindowTest, SavedProjectReopensTheSame) {
    openBout();
    const BoundaryRef removed = someBoundary(0);
    session().toggleBoundary(removed);
    const BoundaryRef other = someBoundary(1);
    session().moveBoundary(other, other.frame + 5);
    const auto left = session().marks(0);
    const auto right = session().marks(1);
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    EXPECT_FALSE(window_->isWindowModified());
    EXPECT_EQ(window_->windowTitle(), "bout.kumite[*] — Kumite");
    const Project saved = session().document().project();

    window_->files().open({file("bout.kumite")});
    settle();
    ASSERT_EQ(session().marks(0).size(), left.size());
    ASSERT_EQ(session().marks(1).size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        EXPECT_EQ(session().marks(0)[i].frame, left[i].frame);
        EXPECT_EQ(session().marks(0)[i].state, left[i].state);
    }
    for (std::size_t i = 0; i < right.size(); ++i) {
        EXPECT_EQ(session().marks(1)[i].frame, right[i].frame);
    }
    EXPECT_EQ(session().document().project().takes[0].fighters[1].corrections,
              saved.takes[0].fighters[1].corrections);
    EXPECT_FALSE(session().document().isModified());
}

TEST_F(WindowTest, DoubleClickAndTheButtonOverABoundaryRemoveAndRestore) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    const QPoint at = timeline().pointOf(boundary).toPoint();
    QTest::mouseClick(&timeline(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(&timeline(), Qt::LeftButton, {}, at);
    EXPECT_FALSE(mark(boundary)->isLive());
    EXPECT_EQ(session().document().history().position(), 1U);

    hover(timeline(), at);
    const QPoint handle = timeline().handleOf(boundary).center().toPoint();
    hover(timeline(), handle);
    click(handle);
    EXPECT_TRUE(mark(boundary)->isLive());
    click(handle);
    EXPECT_FALSE(mark(boundary)->isLive());
    EXPECT_EQ(session().document().history().position(), 3U);
}

TEST_F(WindowTest, DragMovesABoundaryInOneStep) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    const QPoint from = timeline().pointOf(boundary).toPoint();
    const double playhead = session().timeOf(boundary);
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&timeline(), from + QPoint(7, 0));
    // While it is dragged, everything shows the moment where it would stand.
    EXPECT_NE(session().transport().shownTime(), playhead);
    EXPECT_EQ(session().document().history().position(), 0U);
    const QPoint to = from + QPoint(16, 0);
    QTest::mouseMove(&timeline(), to);
    QTest::mouseRelease(&timeline(), Qt::LeftButton, Qt::AltModifier, to);
    EXPECT_EQ(session().document().history().position(), 1U);
    ASSERT_TRUE(session().selection().has_value());
    const BoundaryRef moved = *session().selection();
    EXPECT_GT(moved.frame, boundary.frame);
    EXPECT_EQ(mark(moved)->state, MarkState::Moved);
    EXPECT_NEAR(session().transport().shownTime(), session().timeOf(moved), 1e-9);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(mark(boundary)->state, MarkState::Detected);
}

TEST_F(WindowTest, EscapeLeavesADraggedBoundaryWhereItWas) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    const QPoint from = timeline().pointOf(boundary).toPoint();
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&timeline(), from + QPoint(6, 0));
    QTest::mouseMove(&timeline(), from + QPoint(14, 0));
    press(Qt::Key_Escape);
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, from + QPoint(14, 0));
    EXPECT_EQ(session().document().history().position(), 0U);
    EXPECT_EQ(mark(boundary)->state, MarkState::Detected);
    EXPECT_NEAR(session().transport().shownTime(), session().timeOf(boundary), 1e-9);
}

TEST_F(WindowTest, DraggedBoundaryStaysBetweenItsNeighbours) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    const QPoint from = timeline().pointOf(boundary).toPoint();
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&timeline(), from + QPoint(10, 0));
    QTest::mouseMove(&timeline(), from + QPoint(900, 0));
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, from + QPoint(900, 0));
    EXPECT_TRUE(window_->messages().text().isEmpty());
    ASSERT_TRUE(session().selection().has_value());
    int live = 0;
    for (const BoundaryMark& each : session().marks(0)) {
        if (each.isLive() && each.frame > boundary.frame &&
            each.frame <= session().selection()->frame) {
            ++live;
        }
    }
    EXPECT_EQ(live, 1);
}

TEST_F(WindowTest, SAddsABoundaryAtThePlayheadOfTheActiveFighter) {
    openBout();
    press(Qt::Key_Tab);
    EXPECT_EQ(session().activePlayer(), 1);
    const BoundaryRef near = someBoundary(1);
    session().transport().setPlayhead(session().timeOf({1, near.frame + 12}));
    press(Qt::Key_S);
    ASSERT_TRUE(session().selection().has_value());
    EXPECT_EQ(session().selection()->frame, near.frame + 12);
    EXPECT_EQ(mark(*session().selection())->state, MarkState::Added);
    press(Qt::Key_Delete);
    press(Qt::Key_Z, Qt::ControlModifier);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(mark({1, near.frame + 12}), nullptr);
}

TEST_F(WindowTest, ActionsAreJoinedWithTheirNeighbours) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    session().transport().setPlayhead(session().timeOf({0, boundary.frame + 5}));
    press(Qt::Key_BracketLeft, Qt::ControlModifier);
    EXPECT_FALSE(mark(boundary)->isLive());
    press(Qt::Key_Z, Qt::ControlModifier);
    session().transport().setPlayhead(session().timeOf({0, boundary.frame - 5}));
    press(Qt::Key_BracketRight, Qt::ControlModifier);
    EXPECT_FALSE(mark(boundary)->isLive());
}

TEST_F(WindowTest, TakeAddedToAProjectIsShownAndUndoTakesItAway) {
    openBout();
    TakeRequest request = requestFor({file("right.bvh")});
    request.name = "second";
    window_->files().addBout(request);
    settle();
    settle();
    EXPECT_EQ(session().take(), 1);
    EXPECT_EQ(session().playerCount(), 1);
    ASSERT_NE(session().fighter(0), nullptr);
    EXPECT_GT(session().marks(0).size(), 8U);
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(session().take(), 0);
    EXPECT_EQ(session().playerCount(), 2);
    EXPECT_NE(session().fighter(1), nullptr);
}

TEST_F(WindowTest, DelAwayFromBoundariesSaysSoQuietly) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    session().select(std::nullopt);
    session().transport().setPlayhead(session().timeOf({0, boundary.frame + 10}));
    press(Qt::Key_Delete);
    EXPECT_EQ(session().document().history().position(), 0U);
    EXPECT_TRUE(window_->messages().text().isEmpty());
}

TEST_F(WindowTest, RulerScrubsAlsoWhilePlaying) {
    openBout();
    const double y = timeline().ruler().center().y();
    const double x = timeline().mapping().xOf(4.0);
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, QPoint(int(x), int(y)));
    EXPECT_NEAR(session().transport().playhead(), 4.0, 0.02);
    QTest::mouseMove(&timeline(), QPoint(int(x) + 100, int(y)));
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, QPoint(int(x) + 100, int(y)));
    EXPECT_NEAR(session().transport().playhead(), timeline().mapping().timeAt(x + 100), 0.02);
    press(Qt::Key_Space);
    ASSERT_TRUE(session().transport().isPlaying());
    click(QPointF(timeline().mapping().xOf(1.0), y));
    EXPECT_LT(session().transport().playhead(), 1.5);
    EXPECT_TRUE(session().transport().isPlaying());
}

TEST_F(WindowTest, PlayAdvancesAndStopsAtTheEnd) {
    openBout();
    press(Qt::Key_Space);
    EXPECT_TRUE(QTest::qWaitFor([&] { return session().transport().playhead() > 0.3; }, 5000));
    press(Qt::Key_Space);
    EXPECT_FALSE(session().transport().isPlaying());
    session().transport().setPlayhead(session().transport().span().end - 0.1);
    press(Qt::Key_L);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !session().transport().isPlaying(); }, 5000));
    EXPECT_DOUBLE_EQ(session().transport().playhead(), session().transport().span().end);
    press(Qt::Key_J);
    press(Qt::Key_J);
    EXPECT_DOUBLE_EQ(session().transport().speed(), -2);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return session().transport().playhead() < session().transport().span().end - 0.2; },
        5000));
    press(Qt::Key_K);
    EXPECT_FALSE(session().transport().isPlaying());
    EXPECT_DOUBLE_EQ(session().transport().speed(), 1);
}

TEST_F(WindowTest, LoopStaysInsideItsRange) {
    openBout();
    session().transport().setPlayhead(1.0);
    press(Qt::Key_I);
    session().transport().setPlayhead(1.2);
    press(Qt::Key_O);
    press(Qt::Key_L, Qt::ControlModifier);
    ASSERT_TRUE(session().transport().isLooping());
    press(Qt::Key_Space);
    for (int i = 0; i < 20; ++i) {
        QTest::qWait(30);
        EXPECT_GE(session().transport().playhead(), 1.0 - 1e-9);
        EXPECT_LE(session().transport().playhead(), 1.2 + 1e-9);
    }
}

TEST_F(WindowTest, ArrowsStepFramesAndBoundaries) {
    openBout();
    press(Qt::Key_Home);
    press(Qt::Key_Right);
    EXPECT_EQ(session().shownFrame(0), 1);
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(session().shownFrame(0), 11);
    press(Qt::Key_Left);
    EXPECT_EQ(session().shownFrame(0), 10);
    press(Qt::Key_Home);
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(session().shownFrame(0), session().marks(0)[1].frame);
    EXPECT_EQ(session().selection(), (BoundaryRef{0, session().marks(0)[1].frame}));
    press(Qt::Key_End);
    EXPECT_EQ(session().shownFrame(0), 599);
    press(Qt::Key_Right);
    EXPECT_EQ(session().shownFrame(0), 599);
}

TEST_F(WindowTest, WheelZoomsAboutThePointerAndScrolls) {
    openBout();
    const QPointF at(timeline().mapping().xOf(5.0), 60);
    QWheelEvent zoom(at, timeline().mapToGlobal(at), {}, {0, 480}, Qt::NoButton,
                     Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&timeline(), &zoom);
    const TimeSpan visible = session().visible();
    EXPECT_LT(visible.end - visible.begin, 5.0);
    EXPECT_NEAR(timeline().mapping().timeAt(at.x()), 5.0, 0.01);
    QWheelEvent scroll(at, timeline().mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                       Qt::NoScrollPhase, false);
    QApplication::sendEvent(&timeline(), &scroll);
    EXPECT_GT(session().visible().begin, visible.begin);
    press(Qt::Key_A);
    EXPECT_DOUBLE_EQ(session().visible().begin, session().transport().span().begin);
}

TEST_F(WindowTest, SuspectListSelectsAndItsButtonRemoves) {
    openBout();
    auto* panel = window_->findChild<SegmentPanel*>();
    auto* list = panel->findChild<QAbstractItemView*>();
    ASSERT_GT(list->model()->rowCount(), 2);
    list->setCurrentIndex(list->model()->index(1, 0));
    ASSERT_TRUE(session().selection().has_value());
    const BoundaryRef chosen = *session().selection();
    EXPECT_NEAR(session().transport().playhead(), session().timeOf(chosen), 1e-9);
    QPushButton* button = nullptr;
    for (auto* each : panel->findChildren<QPushButton*>()) {
        if (each->text() == "Remove") button = each;
    }
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_FALSE(mark(chosen)->isLive());
    session().goTo(chosen);
    EXPECT_EQ(button->text(), "Restore");
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(mark(chosen)->isLive());
}

TEST_F(WindowTest, SettingsAreOneUndoableStepEach) {
    openBout();
    const auto field = [&](const QString& name) {
        for (auto* each : window_->findChild<SegmentPanel*>()->findChildren<QDoubleSpinBox*>()) {
            if (each->accessibleName() == name) return each;
        }
        return static_cast<QDoubleSpinBox*>(nullptr);
    };
    QDoubleSpinBox* cutoff = field("Cutoff of the low-pass in Hz");
    QDoubleSpinBox* prominence = field("Least prominence in body weights");
    ASSERT_TRUE(cutoff && prominence);
    const std::size_t before = session().fighter(0)->segmentation->actions.size();
    prominence->setFocus();
    prominence->selectAll();
    QTest::keyClicks(prominence, "0.9");
    QTest::keyClick(prominence, Qt::Key_Return);
    settle();
    EXPECT_EQ(session().document().history().position(), 1U);
    EXPECT_DOUBLE_EQ(session().document().project().segmentation.prominence, 0.9);
    EXPECT_NE(session().fighter(0)->segmentation->actions.size(), before);
    // Looking at a field without changing it is no edit.
    cutoff->setFocus();
    QTest::keyClick(cutoff, Qt::Key_Return);
    EXPECT_EQ(session().document().history().position(), 1U);
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(session().fighter(0)->segmentation->actions.size(), before);
}

TEST_F(WindowTest, LettersTypedIntoAFieldOfTextAreNoCommands) {
    openBout();
    session().transport().setPlayhead(2.0);
    press(Qt::Key_N, Qt::ControlModifier);
    auto* note = timeline().findChild<QLineEdit*>();
    ASSERT_NE(note, nullptr);
    ASSERT_TRUE(note->isVisible());
    QTest::keyClicks(note, "snag");
    EXPECT_EQ(note->text(), "snag");
    EXPECT_EQ(session().document().history().position(), 0U);
}

}  // namespace
}  // namespace kumite::studio
