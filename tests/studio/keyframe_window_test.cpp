// The Keyframe workspace in the real window: keys made, drawn, moved, and made into a motion.

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QListWidget>
#include <QPushButton>
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/project/demo_bout.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_panel.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/key_strip.h"
#include "studio/workspaces/keyframe/motion_box.h"
#include "studio/workspaces/keyframe/pose_box.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class KeyframeTest : public WindowTest {
protected:
    void openWorkspace() {
        openBout();
        window_->workspaces().show("keyframe");
        settle();
        ASSERT_NE(keys().library(), nullptr) << keys().whyNothing().toStdString();
    }
    /// Keys at 0, 30 and 60 by Return.
    void makeKeys() {
        window_->stage().setFocus();
        for (const int frame : {0, 30, 60}) {
            keys().seek(frame);
            press(Qt::Key_Return);
            settle();
        }
    }
    KeySession& keys() { return window_->keys(); }
    KeyStrip& strip() { return *window_->findChild<KeyStrip*>(); }
    std::vector<int> frames() {
        std::vector<int> all;
        for (const KeyPose& key : keys().draft().track.keys)
            all.push_back(key.frame);
        return all;
    }
    Eigen::Vector3d placeOf(Handle handle) {
        return *handlePoint(*keys().draft().track.rig, *keys().pose(), handle);
    }
    /// Drags a handle of the figure by pixels.
    void dragHandle(Handle handle, const QPoint& way) {
        const auto index = static_cast<int>(handle);
        const auto at = window_->stage().handlePosition(index);
        ASSERT_TRUE(at);
        const QPoint from = at->toPoint();
        QTest::mousePress(&window_->stage(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&window_->stage(), from + way / 2);
        QTest::mouseMove(&window_->stage(), from + way);
        QTest::mouseRelease(&window_->stage(), Qt::LeftButton, {}, from + way);
        settle();
    }
};

TEST_F(KeyframeTest, TheFirstKeyIsThePoseOfTheTake) {
    openWorkspace();
    EXPECT_TRUE(window_->stage().isLive());
    EXPECT_FALSE(timeline().isVisible());
    EXPECT_EQ(keys().pose(), nullptr);
    window_->stage().setFocus();
    press(Qt::Key_Return);
    settle();
    EXPECT_EQ(frames(), std::vector{0});
    ASSERT_NE(keys().pose(), nullptr);
    EXPECT_TRUE(keys().isEditable());
    EXPECT_TRUE(window_->stage().handlePosition(0)) << "its handles are there";
    window_->workspaces().show("segment");
    EXPECT_FALSE(window_->stage().isLive());
    EXPECT_TRUE(timeline().isVisible());
    EXPECT_FALSE(window_->stage().handlePosition(0));
}

TEST_F(KeyframeTest, AHandleIsDraggedAndTheFeetStay) {
    openWorkspace();
    window_->stage().setFocus();
    press(Qt::Key_Return);
    settle();
    const Eigen::Vector3d before = placeOf(Handle::RightHand);
    const Eigen::Vector3d foot = placeOf(Handle::LeftFoot);
    const auto position = session().document().history().position();
    dragHandle(Handle::RightHand, QPoint(0, -40));
    EXPECT_EQ(keys().handle(), Handle::RightHand);
    EXPECT_GT(placeOf(Handle::RightHand).y(), before.y() + 0.05);
    EXPECT_LT((placeOf(Handle::LeftFoot) - foot).norm(), 0.01);
    EXPECT_EQ(session().document().history().position(), position + 1) << "one drag, one step";
    const Eigen::Vector3d after = placeOf(Handle::RightHand);
    session().document().undo();
    settle();
    EXPECT_LT((placeOf(Handle::RightHand) - before).norm(), 1e-4);
    session().document().redo();
    settle();
    EXPECT_LT((placeOf(Handle::RightHand) - after).norm(), 1e-4);
    // By keys, and by numbers.
    press(Qt::Key_Up, Qt::ControlModifier);
    settle();
    EXPECT_NEAR(placeOf(Handle::RightHand).y(), after.y() + 0.02, 0.005);
    auto* box = window_->findChild<PoseBox*>();
    QDoubleSpinBox* height = nullptr;
    for (auto* field : box->findChildren<QDoubleSpinBox*>()) {
        if (field->accessibleName().contains("y in")) height = field;
    }
    ASSERT_NE(height, nullptr);
    height->setValue(1.0);
    settle();
    EXPECT_NEAR(placeOf(Handle::RightHand).y(), 1.0, 0.02);
}

TEST_F(KeyframeTest, KeysAreMovedCopiedMirroredAndSaved) {
    openWorkspace();
    makeKeys();
    EXPECT_EQ(frames(), (std::vector{0, 30, 60}));
    // By the mouse.
    const QPoint from = strip().placeOf(30).toPoint(), to = strip().placeOf(40).toPoint();
    QTest::mousePress(&strip(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&strip(), (from + to) / 2);
    QTest::mouseMove(&strip(), to);
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, to);
    settle();
    ASSERT_EQ(frames().size(), 3U);
    EXPECT_NEAR(frames()[1], 40, 1);
    EXPECT_EQ(keys().key(), frames()[1]);
    const int moved = frames()[1];
    window_->stage().setFocus();
    press(Qt::Key_Right, Qt::AltModifier);
    settle();
    EXPECT_EQ(frames()[1], moved + 1);
    keys().moveKey(frames()[1], 60);
    settle();
    EXPECT_EQ(frames().size(), 3U) << "no key gives way to another";
    EXPECT_EQ(frames()[1], moved + 1);
    press(Qt::Key_D, Qt::ControlModifier);
    settle();
    EXPECT_EQ(frames().size(), 4U);
    EXPECT_EQ(frames().back(), 90) << "half a second behind the last one";
    const Eigen::Vector3d left = placeOf(Handle::LeftHand) - keys().pose()->root;
    const Eigen::Vector3d right = placeOf(Handle::RightHand) - keys().pose()->root;
    press(Qt::Key_X);
    settle();
    const Eigen::Vector3d mirrored = placeOf(Handle::RightHand) - keys().pose()->root;
    EXPECT_NEAR(mirrored.y(), left.y(), 0.02);
    EXPECT_NEAR((placeOf(Handle::LeftHand) - keys().pose()->root).y(), right.y(), 0.02);
    press(Qt::Key_Delete);
    settle();
    EXPECT_EQ(frames().size(), 3U);
    press(Qt::Key_PageUp);
    EXPECT_EQ(keys().key(), frames().back());
    const auto kept = frames();
    window_->files().saveTo(file("keys.kumite"));
    settle();
    window_->files().open({file("keys.kumite")});
    settle();
    EXPECT_EQ(frames(), kept);
}

TEST_F(KeyframeTest, KeysBecomeAMotionThatIsKept) {
    openWorkspace();
    makeKeys();
    ASSERT_NE(keys().motion(), nullptr) << keys().problem().toStdString();
    EXPECT_TRUE(keys().isCurrent());
    EXPECT_EQ(keys().motion()->assembly.clip.frameCount(), 61);
    auto* list = window_->findChild<MotionBox*>()->findChild<QListWidget*>();
    ASSERT_GT(list->count(), 1);
    EXPECT_TRUE(list->item(0)->text().startsWith(QStringLiteral("●")));
    const PoseMatch other = keys().motion()->found[1];
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(1)).center());
    settle();
    ASSERT_NE(keys().motion(), nullptr) << keys().problem().toStdString();
    EXPECT_EQ(keys().motion()->plan.body.match.clip, other.match.clip);
    EXPECT_NEAR(keys().motion()->plan.body.match.frames.front(), other.match.frames.front(), 2);
    window_->stage().setFocus();
    press(Qt::Key_V);
    EXPECT_TRUE(keys().showsMotion());
    press(Qt::Key_Space);
    EXPECT_TRUE(keys().isPlaying());
    const double begun = keys().frame();
    EXPECT_TRUE(QTest::qWaitFor([&] { return keys().frame() > begun + 3; }, 5000));
    press(Qt::Key_Space);
    press(Qt::Key_B);
    settle();
    EXPECT_TRUE(keys().draft().body.empty());
    keepMotionAs(session(), keys().writing(), keys().madeMotion(), file("made.bvh"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !keys().writing().isRunning(); }, 5000));
    settle();
    ASSERT_EQ(session().document().project().takes.size(), 2U);
    EXPECT_EQ(session().document().project().takes.back().fighters.front().frames.size(), 61);
    EXPECT_TRUE(QFileInfo::exists(file("made.bvh")));
}

/// Strikes come with the demo bout and its labels.
TEST_F(KeyframeTest, AStrikeFollowsADraggedTarget) {
    const DemoFiles demo =
        writeDemoBout({60, 60, 3}, std::filesystem::path(file("demo").toStdString()));
    window_->files().open({QString::fromStdString(demo.project().string())});
    settle();
    window_->workspaces().show("bout");
    settle();
    for (auto* button : window_->findChildren<QPushButton*>()) {
        if (button->text() == "Take over labels" && button->isVisible())
            QTest::mouseClick(button, Qt::LeftButton);
    }
    settle();
    window_->workspaces().show("keyframe");
    settle();
    window_->stage().setFocus();
    press(Qt::Key_S);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_->hit().motion().has_value(); }, 60000))
        << window_->hit().problem().toStdString();
    HitSession& hit = window_->hit();
    EXPECT_TRUE(hit.motion()->hits);
    const auto& strikes = hit.strikes();
    EXPECT_NE(std::find(strikes.begin(), strikes.end(), "right_punch"), strikes.end());
    const Eigen::Vector3d before = hit.target();
    const auto at = window_->stage().handlePosition(0);
    ASSERT_TRUE(at);
    const QPoint from = at->toPoint(), to = from + QPoint(6, -12);
    QTest::mousePress(&window_->stage(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&window_->stage(), (from + to) / 2);
    QTest::mouseMove(&window_->stage(), to);
    QTest::mouseRelease(&window_->stage(), Qt::LeftButton, {}, to);
    EXPECT_GT(hit.target().y(), before.y());
    ASSERT_TRUE(hit.motion());
    EXPECT_LT((hit.motion()->reached - hit.target()).norm(), 0.05);
    // Keeping it changes the project and so the library; the target stays.
    const Eigen::Vector3d aimed = hit.target();
    keepMotionAs(session(), keys().writing(), hit.madeMotion(), file("hit.bvh"));
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return session().document().project().takes.size() == 2; }, 10000));
    settle();
    ASSERT_TRUE(QTest::qWaitFor([&] { return hit.motion().has_value(); }, 20000));
    EXPECT_EQ(hit.target(), aimed);
    // Far outside of what can be reached: it says so, and the nearest is shown.
    hit.setTarget({2.5, 2.4, -2.0});
    ASSERT_TRUE(hit.motion());
    EXPECT_FALSE(hit.motion()->hits);
    EXPECT_NE(hit.pose(), nullptr);
    press(Qt::Key_Space);
    EXPECT_TRUE(hit.isPlaying());
    press(Qt::Key_Space);
    press(Qt::Key_S);
    EXPECT_FALSE(hit.isOn());
    EXPECT_EQ(keys().pose(), nullptr) << "no keys were made";
}

}  // namespace
}  // namespace kumite::studio
