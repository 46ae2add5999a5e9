// The Keyframe workspace in the real window: keys made, drawn, moved, and made into a motion.

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QSlider>
#include <QSpinBox>

#include "core/motion/blend.h"
#include "studio/app/file_actions.h"
#include "studio/timeline/timeline_view.h"
#include "studio/workspaces/keyframe/joint_box.h"
#include "studio/workspaces/keyframe/motion_box.h"
#include "studio/workspaces/keyframe/pose_box.h"
#include "studio/workspaces/keyframe/pose_dialog.h"
#include "tests/studio/keyframe_fixture.h"

namespace kumite::studio {
namespace {

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

TEST_F(KeyframeTest, EscLeavesADragAndOnlyItsButtonEndsIt) {
    openWorkspace();
    makeKeys();
    const auto position = session().document().history().position();
    const Eigen::Vector3d before = placeOf(Handle::RightHand);
    StageView& stage = window_->stage();
    for (auto* label : stage.findChildren<QLabel*>())
        EXPECT_FALSE(label->text().contains("contact force")) << "there is none";
    const QPoint from = stage.handlePosition(static_cast<int>(Handle::RightHand))->toPoint();
    QTest::mousePress(&stage, Qt::LeftButton, {}, from);
    QTest::mouseMove(&stage, from + QPoint(0, -30));
    EXPECT_GT(placeOf(Handle::RightHand).y(), before.y() + 0.03);
    QTest::mouseClick(&stage, Qt::RightButton, {}, from + QPoint(0, -30));
    EXPECT_EQ(session().document().history().position(), position) << "the left one is still held";
    QTest::keyClick(&stage, Qt::Key_Escape);
    EXPECT_LT((placeOf(Handle::RightHand) - before).norm(), 1e-9);
    QTest::mouseMove(&stage, from + QPoint(0, -50));
    QTest::mouseRelease(&stage, Qt::LeftButton, {}, from + QPoint(0, -50));
    settle();
    EXPECT_LT((placeOf(Handle::RightHand) - before).norm(), 1e-9);
    EXPECT_EQ(session().document().history().position(), position);
    // The same for a key.
    const QPoint key = strip().placeOf(30).toPoint(), to = strip().placeOf(40).toPoint();
    QTest::mousePress(&strip(), Qt::LeftButton, {}, key);
    QTest::mouseMove(&strip(), (key + to) / 2);
    QTest::mouseMove(&strip(), to);
    QTest::mouseClick(&strip(), Qt::RightButton, {}, to);
    EXPECT_EQ(frames(), (std::vector{0, 30, 60}));
    QTest::keyClick(&strip(), Qt::Key_Escape);
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, to);
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 30, 60}));
    EXPECT_EQ(session().document().history().position(), position);
    // Nudges of one handle are one step, those of another a second one.
    stage.setFocus();
    const Eigen::Vector3d start = placeOf(Handle::RightHand);
    for (int i = 0; i < 3; ++i)
        press(Qt::Key_Up, Qt::ControlModifier);
    settle();
    EXPECT_NEAR(placeOf(Handle::RightHand).y(), start.y() + 0.06, 0.01);
    EXPECT_EQ(session().document().history().position(), position + 1);
    keys().setHandle(Handle::LeftHand);
    press(Qt::Key_Up, Qt::ControlModifier);
    EXPECT_EQ(session().document().history().position(), position + 2);
    session().document().undo();
    session().document().undo();
    settle();
    EXPECT_LT((placeOf(Handle::RightHand) - start).norm(), 1e-4);
}

TEST_F(KeyframeTest, AJointIsTurnedByRingsAndNumbers) {
    openWorkspace();
    makeKeys();
    const Rig& rig = *keys().draft().track.rig;
    const int elbow = *rig.roles[Role::RightElbow];
    const auto turnOf = [&] { return keys().pose()->turns[static_cast<std::size_t>(elbow)]; };
    EXPECT_FALSE(window_->stage().ringPosition(0, 0));
    press(Qt::Key_J);
    EXPECT_EQ(keys().joint(), 0) << "the first of them";
    keys().setJoint(elbow);
    const auto position = session().document().history().position();
    const Eigen::Quaterniond before = turnOf();
    // A ring that the hands' handles do not hide.
    StageView& stage = window_->stage();
    int ring = -1;
    QPoint from, way;
    for (int i = 0; i < 3 && ring < 0; ++i) {
        for (double angle = 0; angle < 6.2 && ring < 0; angle += 0.1) {
            const QPointF at = *stage.ringPosition(i, angle);
            bool isFree = true;
            for (int h = 0; h < kHandleCount; ++h)
                isFree = isFree && QLineF(at, *stage.handlePosition(h)).length() > 20;
            for (int other = 0; other < 3; ++other) {
                for (double b = 0; b < 6.3 && other != i; b += 0.05)
                    isFree = isFree && QLineF(at, *stage.ringPosition(other, b)).length() > 9;
            }
            if (!isFree) continue;
            ring = i;
            from = at.toPoint();
            way = (*stage.ringPosition(i, angle + 0.3) - at).toPoint();
        }
    }
    ASSERT_GE(ring, 0);
    const auto pull = [&](bool leave) {
        QTest::mousePress(&stage, Qt::LeftButton, {}, from);
        QTest::mouseMove(&stage, from + way);
        EXPECT_GT(turnOf().angularDistance(before), 0.1);
        if (leave) QTest::keyClick(&stage, Qt::Key_Escape);
        QTest::mouseRelease(&stage, Qt::LeftButton, {}, from + way);
        settle();
    };
    pull(true);
    EXPECT_LT(turnOf().angularDistance(before), 1e-9);
    EXPECT_EQ(session().document().history().position(), position);
    pull(false);
    EXPECT_GT(turnOf().angularDistance(before), 0.1);
    EXPECT_EQ(session().document().history().position(), position + 1);
    session().document().undo();
    settle();
    EXPECT_LT(turnOf().angularDistance(before), 1e-4);
    // By numbers, within the limits.
    QDoubleSpinBox* field = nullptr;
    for (auto* each : window_->findChild<JointBox*>()->findChildren<QDoubleSpinBox*>()) {
        if (each->accessibleName().contains("about x")) field = each;
    }
    ASSERT_NE(field, nullptr);
    const Eigen::Vector3d angles = jointAngles(turnOf());
    field->setValue(angles.x() + 8);
    settle();
    EXPECT_NEAR(jointAngles(turnOf(), angles).x(), angles.x() + 8, 0.11);
    EXPECT_NEAR(jointAngles(turnOf(), angles).y(), angles.y(), 0.01);
    EXPECT_EQ(session().document().history().position(), position + 1);
    keys().turnTo(Eigen::Quaterniond(Eigen::AngleAxisd(3.1, Eigen::Vector3d::UnitX())));
    EXPECT_LE(jointBend(rig, elbow, turnOf())->swing, jointLimit(rig, elbow)->swing + 1e-6);
}

TEST_F(KeyframeTest, APoseIsCopiedFromAnyFrame) {
    openWorkspace();
    makeKeys();
    const Eigen::Vector3d place = keys().pose()->root;
    press(Qt::Key_T, Qt::ShiftModifier);
    auto* dialog = window_->findChild<PoseDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QSlider*>()->setValue(47);
    QTest::keyClick(dialog, Qt::Key_Return);
    settle();
    const Pose& wanted = keys().motions()->motions[0].clip.frames[47];
    for (std::size_t j = 0; j < wanted.turns.size(); ++j)
        EXPECT_LT(keys().pose()->turns[j].angularDistance(wanted.turns[j]), 1e-4);
    EXPECT_NEAR(keys().pose()->root.x(), place.x(), 1e-6) << "where the key was";
    EXPECT_EQ(frames().size(), 3U);
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
    press(Qt::Key_2);
    EXPECT_EQ(tabs().currentIndex(), 1);
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
    ASSERT_NE(keys().motion(), nullptr) << keys().problem().toStdString();
    EXPECT_TRUE(keys().motions()->motions.back().made);
    for (const PoseMatch& match : keys().motion()->found)
        EXPECT_FALSE(keys().library()->motion(match.match.clip).made)
            << "no source of its own keys";
    // The body's place follows the take's name.
    const QString place = QString::fromStdString(keys().library()->motion(0).name);
    keys().change("Take the body from elsewhere",
                  [&](KeyDraft& draft) { draft.body = place.toStdString() + "@0:100"; });
    session().document().apply(Document::ProjectEdit(
        [](const Project& project) { return renameTake(project, 0, "renamed"); }));
    settle();
    EXPECT_EQ(keys().draft().body, "renamed:1@0:100");
    EXPECT_NE(keys().motion(), nullptr) << keys().problem().toStdString();
    EXPECT_EQ(session().document().project().takes.back().fighters.front().frames.size(), 61);
    EXPECT_TRUE(QFileInfo::exists(file("made.bvh")));
}

TEST_F(KeyframeTest, KeysAreRetimed) {
    openWorkspace();
    makeKeys();
    press(Qt::Key_PageUp);
    ASSERT_EQ(keys().key(), 30);
    auto* box = window_->findChild<PoseBox*>();
    auto* frame = box->findChild<QSpinBox*>();
    frame->setValue(25);
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 25, 60}));
    frame->setValue(60);
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 25, 60})) << "a key stands there";
    EXPECT_EQ(frame->value(), 25);
    for (auto* check : box->findChildren<QCheckBox*>()) {
        if (check->text() == "and later keys") check->setChecked(true);
    }
    frame->setValue(30);
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 30, 65}));
    window_->stage().setFocus();
    press(Qt::Key_Right, Qt::AltModifier | Qt::ShiftModifier);
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 31, 66}));
    for (auto* field : box->findChildren<QDoubleSpinBox*>()) {
        if (!field->accessibleName().startsWith("Time from")) continue;
        field->setValue(2);
        EXPECT_EQ(field->value(), 1) << "ready for the next time";
    }
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 31, 101}));
    window_->stage().setFocus();
    press(Qt::Key_BracketLeft);
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 31, 94}));
    session().document().undo();
    session().document().undo();
    settle();
    EXPECT_EQ(frames(), (std::vector{0, 31, 66}));
}

TEST_F(KeyframeTest, TheRecordingsPoseIsThatOfTheActiveFighter) {
    openWorkspace();
    makeKeys();
    session().setActivePlayer(1);
    session().transport().setPlayhead(1.5);
    press(Qt::Key_T);
    settle();
    for (const LibraryMotion& motion : keys().motions()->motions) {
        if (motion.take != 0 || motion.player != 1) continue;
        const Pose wanted = poseAt(motion.clip, session().shownFrame(1) / motion.sourceRate);
        for (std::size_t j = 0; j < wanted.turns.size(); ++j)
            EXPECT_LT(keys().pose()->turns[j].angularDistance(wanted.turns[j]), 1e-4);
        return;
    }
    ADD_FAILURE() << "the library knows which fighter a motion is";
}

}  // namespace
}  // namespace kumite::studio
