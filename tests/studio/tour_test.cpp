// The tour on the demo bout, done by keys in the real window.

#include <QApplication>
#include <QPushButton>
#include <QTest>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/workspaces.h"
#include "studio/help/help.h"
#include "studio/help/tour.h"
#include "studio/help/tour_box.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/bout/bout_session.h"
#include "studio/workspaces/graph/graph_session.h"
#include "studio/workspaces/label/label_session.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class TourTest : public WindowTest {
protected:
    Tour& tour() { return window_->help().tour(); }
    TourBox& box() { return tour().box(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QApplication::setActiveWindow(window_.get());
        QWidget* focused = window_->focusWidget();
        QTest::keyClick(focused ? focused : window_.get(), key, modifiers);
        settle();
    }
    void next() { key(Qt::Key_N, Qt::ControlModifier | Qt::AltModifier); }
    /// Inside the window, and not over what it points at.
    void expectBoxBeside(int step) {
        const QWidget* target = tour().steps()[static_cast<std::size_t>(step)].target();
        ASSERT_NE(target, nullptr);
        EXPECT_TRUE(target->isVisible());
        const QRect at(target->mapTo(window_.get(), QPoint()), target->size());
        EXPECT_TRUE(window_->rect().contains(box().geometry()));
        EXPECT_TRUE(!at.intersects(box().geometry()) || step == 3) << step;
    }
};

TEST_F(TourTest, LeadsThroughTheRealJob) {
    window_->commands().run("help.tour");
    settle();
    QTest::qWait(100);
    ASSERT_TRUE(tour().isRunning());
    ASSERT_EQ(tour().steps().size(), 5u);
    ASSERT_TRUE(box().isVisible());
    EXPECT_FALSE(box().showsDone());
    EXPECT_TRUE(box().text().contains("<b>Backspace</b>"));
    expectBoxBeside(0);

    // 1: a suspect.
    window_->timeline().setFocus();
    key(Qt::Key_N);
    EXPECT_FALSE(tour().isDone(0));
    key(Qt::Key_Backspace);
    EXPECT_TRUE(tour().isDone(0));
    EXPECT_TRUE(box().showsDone());

    // 2: a label.
    next();
    ASSERT_EQ(tour().step(), 1);
    EXPECT_EQ(window_->workspaces().current(), "label");
    EXPECT_FALSE(box().showsDone());
    expectBoxBeside(1);
    key(Qt::Key_N);
    key(Qt::Key_Q);
    EXPECT_TRUE(tour().isDone(1));

    // 3: the rest, after a third was labelled by the box's button.
    next();
    expectBoxBeside(2);
    ASSERT_TRUE(box().helpButton()->isVisible());
    QTest::mouseClick(box().helpButton(), Qt::LeftButton);
    settle();
    EXPECT_GT(window_->labels().progress().byHand, 50);
    EXPECT_FALSE(tour().isDone(2));
    key(Qt::Key_Return, Qt::ControlModifier);
    QTest::qWait(50);
    settle();
    EXPECT_TRUE(tour().isDone(2));
    EXPECT_GT(window_->labels().progress().accepted, 20);

    // 4: the graph.
    next();
    ASSERT_EQ(window_->workspaces().current(), "graph");
    settle();
    EXPECT_FALSE(tour().isDone(3));
    ASSERT_TRUE(window_->graph().hasGraph());
    window_->stage().setFocus();
    key(Qt::Key_N);
    EXPECT_TRUE(tour().isDone(3));
    EXPECT_FALSE(box().helpButton()->isVisible());

    // 5: a bout.
    next();
    ASSERT_EQ(window_->workspaces().current(), "bout");
    settle();
    expectBoxBeside(4);
    ASSERT_NE(window_->bout().tape(), nullptr);
    key(Qt::Key_Space);
    EXPECT_TRUE(tour().isDone(4));
    window_->bout().setPlaying(false);
    next();
    EXPECT_FALSE(tour().isRunning());
    EXPECT_FALSE(box().isVisible());
}

TEST_F(TourTest, ComesWhenItIsAskedForAndGoesBackAndAway) {
    window_->files().openDemo();
    settle();
    QTest::qWait(100);
    ASSERT_FALSE(tour().isRunning()) << "who opens the demo bout wants to work";
    window_->commands().run("help.tour");
    settle();
    QTest::qWait(100);
    ASSERT_TRUE(tour().isRunning());
    next();
    EXPECT_EQ(tour().step(), 1);
    key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(tour().step(), 0);
    EXPECT_EQ(window_->workspaces().current(), "segment");
    key(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_FALSE(tour().isRunning());
    EXPECT_FALSE(box().isVisible());
}

TEST_F(TourTest, IsNotForOtherBouts) {
    openBout();
    QTest::qWait(50);
    EXPECT_FALSE(tour().isRunning());
}

}  // namespace
}  // namespace kumite::studio
