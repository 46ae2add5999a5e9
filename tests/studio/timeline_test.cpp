// Actions, notes, rows, loop and scrolling on the timeline of the real window.

#include "studio/timeline/timeline_view.h"

#include <QFile>
#include <QLineEdit>
#include <QSettings>
#include <QTest>
#include <QWheelEvent>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/timeline/note_field.h"
#include "studio/view3d/stage_view.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class TimelineTest : public WindowTest {
protected:
    void SetUp() override {
        QSettings().remove(QStringLiteral("timeline"));
        WindowTest::SetUp();
    }
    ActionRef someAction(int player) {
        return *session().actionAt(player, someBoundary(player).frame + 2);
    }
    void drag(const QPointF& from, const QPointF& to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(&timeline(), Qt::LeftButton, modifiers, from.toPoint());
        move((from + to) / 2, modifiers);
        move(to, modifiers);
        QTest::mouseRelease(&timeline(), Qt::LeftButton, modifiers, to.toPoint());
    }
    /// QTest::mouseMove knows no modifiers.
    void move(const QPointF& to, Qt::KeyboardModifiers modifiers) {
        QMouseEvent event(QEvent::MouseMove, to, timeline().mapToGlobal(to), Qt::NoButton,
                          Qt::LeftButton, modifiers);
        QApplication::sendEvent(&timeline(), &event);
    }
    NoteField* note() { return timeline().findChild<NoteField*>(); }
};

TEST_F(TimelineTest, ClickSelectsAnActionAndDoubleClickLoopsIt) {
    openBout();
    const ActionRef action = someAction(1);
    const TimeSpan span = session().spanOf(action);
    const QPointF at = timeline().blockOf(action).center();
    click(at);
    EXPECT_EQ(session().selectedAction(), action);
    EXPECT_FALSE(session().selection());
    EXPECT_EQ(session().activePlayer(), 1);
    EXPECT_FALSE(session().transport().isLooping());
    QTest::mouseDClick(&timeline(), Qt::LeftButton, {}, at.toPoint());
    EXPECT_TRUE(session().transport().isLooping());
    EXPECT_NEAR(*session().transport().loopIn(), span.begin, 1e-9);
    EXPECT_NEAR(*session().transport().loopOut(), span.end, 1e-9);
    EXPECT_LT(session().visible().end - session().visible().begin, 2.1 * (span.end - span.begin));
    EXPECT_LE(session().visible().begin, span.begin);
    EXPECT_GE(session().visible().end, span.end);
    press(Qt::Key_Escape);
    EXPECT_FALSE(session().selectedAction());
}

TEST_F(TimelineTest, ActionsAreChosenLoopedFramedAndJoinedByKeys) {
    openBout();
    session().transport().setPlayhead(session().timeOf({0, someBoundary(0).frame + 3}));
    press(Qt::Key_PageDown);
    ASSERT_TRUE(session().selectedAction());
    const ActionRef first = *session().selectedAction();
    press(Qt::Key_PageDown);
    const ActionRef second = *session().selectedAction();
    EXPECT_EQ(session().actionOf(first)->end, session().actionOf(second)->begin);
    EXPECT_NEAR(session().transport().playhead(), session().spanOf(second).begin, 1e-9);
    press(Qt::Key_PageUp);
    EXPECT_EQ(session().selectedAction(), first);
    press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(session().transport().isLooping());
    press(Qt::Key_A);
    press(Qt::Key_F);
    EXPECT_LT(session().visible().end - session().visible().begin,
              session().transport().span().end / 2);

    const int begin = session().actionOf(first)->begin;
    const std::size_t count = session().fighter(0)->segmentation->actions.size();
    press(Qt::Key_BracketRight, Qt::ControlModifier);
    press(Qt::Key_BracketRight, Qt::ControlModifier);
    EXPECT_EQ(session().fighter(0)->segmentation->actions.size(), count - 2);
    ASSERT_TRUE(session().selectedAction()) << "the joined action stays chosen";
    EXPECT_EQ(session().actionOf(*session().selectedAction())->begin, begin);
}

TEST_F(TimelineTest, KeysNudgeTheSelectedBoundaryFrameByFrame) {
    openBout();
    const BoundaryRef boundary = someBoundary(1);
    session().goTo(boundary);
    press(Qt::Key_Right, Qt::AltModifier);
    press(Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(session().selection(), (BoundaryRef{1, boundary.frame + 2}));
    EXPECT_NEAR(session().transport().playhead(), session().timeOf({1, boundary.frame + 2}), 1e-9);
    press(Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(mark({1, boundary.frame + 1})->state, MarkState::Moved);
    press(Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(mark(boundary)->state, MarkState::Detected) << "back home nothing is corrected";
    EXPECT_TRUE(session().document().project().takes[0].fighters[1].corrections.empty());
}

TEST_F(TimelineTest, EscapeLeavesTheDragBeforeTheMeasuringTool) {
    openBout();
    press(Qt::Key_M);
    ASSERT_TRUE(window_->stage().isMeasuring());
    const QPointF from = timeline().pointOf(someBoundary(0));
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, from.toPoint());
    move({from.x() + 12, from.y()}, {});
    move({from.x() + 20, from.y()}, {});
    ASSERT_EQ(timeline().cursor().shape(), Qt::SizeHorCursor);
    press(Qt::Key_Escape);
    EXPECT_TRUE(window_->stage().isMeasuring());
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, QPoint(int(from.x()) + 20, int(from.y())));
    EXPECT_EQ(session().document().history().position(), 0U) << "the drag was left";
    press(Qt::Key_Escape);
    EXPECT_FALSE(window_->stage().isMeasuring());
    press(Qt::Key_Escape);
    EXPECT_FALSE(session().selection()) << "the last one clears the selection";
}

TEST_F(TimelineTest, ADraggedBoundarySnapsAndAModifierFreesIt) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    const QPointF from = timeline().pointOf(boundary);
    // The playhead is parked where the boundary is to go; three pixels beside it still snap.
    const int target = boundary.frame + 11;
    const double x = timeline().mapping().xOf(session().timeOf({0, target}));
    const auto parked = [&] {
        QTest::mousePress(&timeline(), Qt::LeftButton, {}, from.toPoint());
        QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, from.toPoint());
        session().transport().setPlayhead(session().timeOf({0, target}));
    };
    parked();
    // A press on the boundary moves the playhead: it is put back while the button is down.
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, from.toPoint());
    session().transport().setPlayhead(session().timeOf({0, target}));
    move({x - 12, from.y()}, {});
    move({x - 3, from.y()}, {});
    EXPECT_NEAR(session().transport().shownTime(), session().timeOf({0, target}), 1e-9);
    move({x - 3, from.y()}, Qt::ControlModifier);
    EXPECT_NE(session().transport().shownTime(), session().timeOf({0, target}));
    press(Qt::Key_Escape);
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, QPoint(int(x) - 3, int(from.y())));
    EXPECT_EQ(session().document().history().position(), 0U);
    EXPECT_NEAR(session().transport().shownTime(), session().timeOf({0, target}), 1e-9)
        << "the playhead is where it was";
}

TEST_F(TimelineTest, AMovedBorderMovesBothNeighbours) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    const Action before = *session().actionOf({0, boundary.frame - 2});
    const Action after = *session().actionOf({0, boundary.frame + 2});
    drag(timeline().pointOf(boundary), timeline().pointOf(boundary) + QPointF(14, 0),
         Qt::ControlModifier);
    ASSERT_TRUE(session().selection());
    const int now = session().selection()->frame;
    ASSERT_GT(now, boundary.frame);
    EXPECT_EQ(session().actionOf({0, before.begin})->end, now);
    EXPECT_EQ(session().actionOf({0, after.end - 1})->begin, now);
}

TEST_F(TimelineTest, LoopEndsAreDraggedOnTheRuler) {
    openBout();
    session().transport().setPlayhead(2.0);
    press(Qt::Key_I);
    session().transport().setPlayhead(4.0);
    press(Qt::Key_O);
    press(Qt::Key_L, Qt::ControlModifier);
    const double y = timeline().ruler().center().y();
    const TimeMapping map = timeline().mapping();
    drag({map.xOf(4.0), y}, {map.xOf(5.0), y});
    EXPECT_NEAR(*session().transport().loopOut(), 5.0, 0.02);
    EXPECT_NEAR(*session().transport().loopIn(), 2.0, 1e-9);
    EXPECT_NEAR(session().transport().playhead(), 4.0, 1e-9) << "no scrubbing";
    drag({map.xOf(2.0), y}, {map.xOf(8.0), y});
    EXPECT_NEAR(*session().transport().loopIn(), 5.0, 0.02) << "the ends never cross";
    EXPECT_TRUE(session().transport().isLooping());
}

TEST_F(TimelineTest, HoweverNarrowMostOfABlockIsTheActions) {
    QStringList files;
    for (const double phase : {0.0, 1.0}) {
        files.append(file(QString("long%1.bvh").arg(phase)));
        QFile out(files.back());
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(QByteArray::fromStdString(bobbingPerson(phase, 100 * phase, 6000)));
    }
    window_->files().openBout(requestFor(files), false);
    settle();
    session().showAll();
    const ActionRef action = someAction(0);
    const QRectF block = timeline().blockOf(action);
    ASSERT_LT(block.width(), 16);
    for (const double share : {0.3, 0.5, 0.7}) {
        session().select(std::nullopt);
        session().selectAction(std::nullopt);
        click({block.left() + share * block.width(), block.center().y()});
        EXPECT_FALSE(session().selection()) << share;
        EXPECT_EQ(session().selectedAction(), action) << share;
    }
    click(block.topLeft() + QPointF(0, 2));
    EXPECT_TRUE(session().selection());
}

TEST_F(TimelineTest, ANoteIsWrittenByKeysShownSavedAndUndone) {
    openBout();
    const ActionRef action = someAction(0);
    click(timeline().blockOf(action).center());
    press(Qt::Key_N, Qt::ControlModifier);
    ASSERT_TRUE(note()->isVisible());
    QTest::keyClicks(note(), "feint, low");
    EXPECT_EQ(session().document().history().position(), 0U) << "letters are no commands";
    QTest::keyClick(note(), Qt::Key_Return);
    EXPECT_FALSE(note()->isVisible());
    EXPECT_EQ(session().noteOf(action), "feint, low");
    EXPECT_EQ(session().document().history().position(), 1U);
    QString said;
    QObject listener;
    QObject::connect(&session(), &Session::hovered, &listener,
                     [&](const QString& text) { said = text; });
    hover(timeline(), timeline().blockOf(action).center().toPoint());
    EXPECT_TRUE(said.contains("feint, low")) << said.toStdString();

    ASSERT_TRUE(window_->files().saveTo(file("noted.kumite")));
    window_->files().open({file("noted.kumite")});
    settle();
    EXPECT_EQ(session().noteOf(action), "feint, low");
    session().selectAction(std::nullopt);
    const QRectF block = timeline().blockOf(action);
    click({block.right() - 4, block.top() + 4});
    ASSERT_TRUE(note()->isVisible()) << "its folded corner opens it";
    EXPECT_EQ(note()->text(), "feint, low");
    QTest::keyClick(note(), Qt::Key_Escape);
    session().transport().setPlayhead(session().spanOf(action).begin + 0.05);
    press(Qt::Key_N, Qt::ControlModifier);
    EXPECT_EQ(note()->text(), "feint, low");
    QTest::keyClicks(note(), "other");
    QTest::keyClick(note(), Qt::Key_Escape);
    EXPECT_EQ(session().noteOf(action), "feint, low");
    press(Qt::Key_N, Qt::ControlModifier);
    note()->clear();
    QTest::keyClick(note(), Qt::Key_Return);
    EXPECT_EQ(session().noteOf(action), "");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session().noteOf(action), "feint, low");
}

TEST_F(TimelineTest, RowsAreChosenAndRemembered) {
    openBout();
    const QImage plain = timeline().grab().toImage();
    const int low = timeline().minimumHeight();
    for (const char* command :
         {"timeline.rawForce", "timeline.handSpeed", "timeline.footSpeed", "timeline.height"}) {
        const QImage before = timeline().grab().toImage();
        window_->commands().run(command);
        settle();
        EXPECT_NE(timeline().grab().toImage(), before) << command;
    }
    EXPECT_GT(timeline().minimumHeight(), low);
    EXPECT_EQ(timeline().options(), (TimelineOptions{false, true, true, true, RulerUnits::Both}));
    press(Qt::Key_T);
    EXPECT_EQ(timeline().options().ruler, RulerUnits::Time);
    window_->commands().run("timeline.rulerFrames");
    EXPECT_EQ(timeline().options().ruler, RulerUnits::Frames);
    EXPECT_TRUE(window_->commands().action("timeline.rulerFrames")->isChecked());
    MainWindow another;
    EXPECT_EQ(another.timeline().options(), timeline().options());
    QSettings().remove(QStringLiteral("timeline"));
}

TEST_F(TimelineTest, CurvesOnWishAreMadeBesideTheWindow) {
    openBout();
    const int plain = timeline().height();
    window_->commands().run("timeline.handSpeed");
    EXPECT_TRUE(timeline().isPreparing());
    EXPECT_TRUE(window_->isBusy());
    settle();
    EXPECT_FALSE(timeline().isPreparing());
    const QImage with = timeline().grab().toImage();
    // Off before it was made: it does not come back.
    window_->commands().run("timeline.footSpeed");
    window_->commands().run("timeline.footSpeed");
    settle();
    EXPECT_EQ(timeline().grab().toImage(), with);
    window_->commands().run("timeline.handSpeed");
    settle();
    EXPECT_GT(with.height(), plain + 20) << "the row had its room";
    EXPECT_NEAR(timeline().height(), plain, 1) << "and gave it back";
    // Another cutoff does not touch them.
    window_->commands().run("timeline.handSpeed");
    settle();
    SegmentationSettings settings = session().document().project().segmentation;
    settings.cutoff = 4;
    session().document().apply(
        [&](const Project& project) { return setSegmentation(project, settings); });
    while (session().document().isComputing())
        QTest::qWait(1);
    EXPECT_FALSE(timeline().isPreparing());
    QSettings().remove(QStringLiteral("timeline"));
}

TEST_F(TimelineTest, WhatIsDraggedGoesWithItsBoundaryOrItsTake) {
    openBout();
    ASSERT_TRUE(session().document().apply([](const Project& project) {
        Take one = project.takes[0];
        one.name = "alone";
        one.fighters.pop_back();
        return addTake(project, one);
    }));
    settle();
    const auto begin = [&] {
        const BoundaryRef boundary = someBoundary(1);
        session().setVisible({session().timeOf(boundary) - 1, session().timeOf(boundary) + 1});
        const QPoint at = timeline().pointOf(boundary).toPoint();
        QTest::mousePress(&timeline(), Qt::LeftButton, {}, at);
        QTest::mouseMove(&timeline(), at + QPoint(30, 0));
        QTest::mouseMove(&timeline(), at + QPoint(40, 0));
        EXPECT_NE(session().transport().shownTime(), session().transport().playhead());
        return at + QPoint(40, 0);
    };
    const auto steps = [&] { return session().document().history().steps().size(); };
    // Undo while it is held takes the boundary from under it.
    const BoundaryRef added{1, someBoundary(1).frame + 11};
    session().setActivePlayer(1);
    session().transport().setPlayhead(session().timeOf(added));
    press(Qt::Key_S);
    const auto before = steps();
    session().setVisible({session().timeOf(added) - 1, session().timeOf(added) + 1});
    const QPoint at = timeline().pointOf(added).toPoint();
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, at);
    QTest::mouseMove(&timeline(), at + QPoint(30, 0));
    QTest::mouseMove(&timeline(), at + QPoint(40, 0));
    press(Qt::Key_Z, Qt::ControlModifier);
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, at + QPoint(40, 0));
    EXPECT_EQ(steps(), before) << "nothing was moved";
    EXPECT_TRUE(session().document().history().canRedo());
    EXPECT_EQ(session().transport().shownTime(), session().transport().playhead());

    const QPoint held = begin();
    session().setTake(1);
    timeline().grab();
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, held);
    EXPECT_EQ(steps(), before) << "nothing was moved in the other take";
    EXPECT_EQ(session().take(), 1);
}

TEST_F(TimelineTest, WhatIsHeldStaysUnderTheHandWhilePlaying) {
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    const double moment = session().timeOf(boundary);
    session().setVisible({moment - 0.5, moment + 0.5});
    const TimeSpan visible = session().visible();
    const QPoint at = timeline().pointOf(boundary).toPoint();
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, at);
    QTest::mouseMove(&timeline(), at + QPoint(10, 0));
    session().transport().setPlaying(true);
    session().transport().setPlayhead(moment + 3);
    QTest::mouseMove(&timeline(), at + QPoint(20, 0));
    EXPECT_EQ(session().visible().begin, visible.begin);
    QTest::mouseRelease(&timeline(), Qt::LeftButton, Qt::ControlModifier, at + QPoint(20, 0));
    EXPECT_GT(session().selection()->frame, boundary.frame);
    session().transport().setPlaying(false);
}

TEST_F(TimelineTest, MiddleDragPansAndShiftWheelScrolls) {
    openBout();
    session().setVisible({3, 5});
    const QPoint at(500, 80);
    QTest::mousePress(&timeline(), Qt::MiddleButton, {}, at);
    QMouseEvent moved(QEvent::MouseMove, QPointF(at) + QPointF(-100, 0),
                      timeline().mapToGlobal(QPointF(at)), Qt::NoButton, Qt::MiddleButton, {});
    QApplication::sendEvent(&timeline(), &moved);
    QTest::mouseRelease(&timeline(), Qt::MiddleButton, {}, at - QPoint(100, 0));
    EXPECT_NEAR(session().visible().begin, 3 + 100 / timeline().mapping().pixelsPerSecond(), 1e-6);
    const double begin = session().visible().begin;
    QWheelEvent scroll(at, timeline().mapToGlobal(QPointF(at)), {}, {0, -120}, Qt::NoButton,
                       Qt::ShiftModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&timeline(), &scroll);
    EXPECT_GT(session().visible().begin, begin);
    EXPECT_NEAR(session().visible().end - session().visible().begin, 2.0, 1e-9);
}

TEST_F(TimelineTest, ABodyWithoutForceIsCutByHandWithTheMouseToo) {
    QFile out(file("rope.bvh"));
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    QByteArray text =
        "HIERARCHY\nROOT a { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation "
        "Xrotation Yrotation\n JOINT b { OFFSET 0 10 0 CHANNELS 3 Zrotation Xrotation Yrotation\n"
        "  End Site { OFFSET 0 10 0 } } }\nMOTION\nFrames: 200\nFrame Time: 0.0166667\n";
    for (int frame = 0; frame < 200; ++frame)
        text += "0 " + QByteArray::number(frame) + " 0 0 0 0 0 0 0\n";
    out.write(text);
    out.close();
    window_->files().open({file("rope.bvh")});
    settle();
    ASSERT_NE(session().fighter(0), nullptr);
    ASSERT_EQ(session().fighter(0)->force, nullptr);
    const QString said = window_->messages().text();
    session().transport().setPlayhead(session().timeOf({0, 100}));
    press(Qt::Key_S);
    const QPointF at = timeline().pointOf({0, 100});
    QTest::mouseMove(&timeline(), (at + QPointF(60, 0)).toPoint());
    drag(at, at + QPointF(50, 0));
    ASSERT_TRUE(session().selection());
    EXPECT_GT(session().selection()->frame, 100);
    for (const char* command : {"timeline.rawForce", "timeline.handSpeed", "timeline.footSpeed"}) {
        window_->commands().run(command);
        settle();
        timeline().grab();
    }
    EXPECT_EQ(window_->messages().text(), said) << "nothing failed";
    QSettings().remove(QStringLiteral("timeline"));
}

}  // namespace
}  // namespace kumite::studio
