// What the Keyframe workspace shows beside keys, and its tools, in the real window.

#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

#include "core/project/demo_bout.h"
#include "studio/app/file_actions.h"
#include "studio/view3d/action_tiles.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/motion_box.h"
#include "studio/workspaces/keyframe/part_dialog.h"
#include "tests/studio/keyframe_fixture.h"

namespace kumite::studio {
namespace {

TEST_F(KeyframeTest, NeighboursAndWhatIsNotAdjustedAreSeen) {
    openWorkspace();
    makeKeys();
    press(Qt::Key_X);
    press(Qt::Key_PageUp);
    settle();
    const QImage plain = window_->stage().picture();
    press(Qt::Key_O);
    EXPECT_EQ(keys().neighbours().size(), 2U);
    const QImage ghosts = window_->stage().picture();
    EXPECT_NE(ghosts, plain);
    press(Qt::Key_O);
    EXPECT_EQ(window_->stage().picture(), plain);
    ASSERT_NE(keys().motion(), nullptr);
    EXPECT_EQ(keys().motion()->direct.clip.frameCount(),
              keys().motion()->assembly.clip.frameCount());
    press(Qt::Key_V);
    const QImage motion = window_->stage().picture();
    press(Qt::Key_C);
    EXPECT_TRUE(keys().directPose());
    EXPECT_NE(window_->stage().picture(), motion);
    press(Qt::Key_C);
    EXPECT_EQ(window_->stage().picture(), motion);
}

TEST_F(KeyframeTest, APartComesFromAChosenPlace) {
    openWorkspace();
    makeKeys();
    tabs().setCurrentIndex(1);
    auto* box = window_->findChild<MotionBox*>();
    auto* tiles = box->findChild<ActionTiles*>();
    QComboBox* scope = nullptr;
    for (auto* combo : box->findChildren<QComboBox*>()) {
        if (combo->accessibleName() == "What is looked for") scope = combo;
    }
    ASSERT_NE(scope, nullptr);
    const auto arm = static_cast<std::size_t>(BodyPart::RightArm);
    scope->setCurrentIndex(scope->findData(static_cast<int>(arm)));
    ASSERT_NE(keys().motion(), nullptr);
    const PoseMatch wanted = keys().motion()->foundOfPart[arm].at(1);
    ASSERT_GE(tiles->count(), 3) << "the keys and places like them";
    settle();
    QTest::mouseClick(tiles, Qt::LeftButton, {}, tiles->tileRect(2).center().toPoint());
    settle();
    EXPECT_FALSE(keys().draft().places[arm].empty());
    ASSERT_NE(keys().motion(), nullptr) << keys().problem().toStdString();
    const auto& taken = keys().motion()->plan.parts[arm];
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->match.clip, wanted.match.clip);
    EXPECT_NEAR(taken->match.frames.front(), wanted.match.frames.front(), 2);
    EXPECT_TRUE(keys().draft().body.empty()) << "the body stays";
    const auto place = keys().draft().places[arm];
    window_->files().saveTo(file("keys.kumite"));
    settle();
    window_->files().open({file("keys.kumite")});
    settle();
    EXPECT_EQ(keys().draft().places[arm], place);
    session().document().undo();
}

TEST_F(KeyframeTest, APartOfATakeIsReplaced) {
    openWorkspace();
    window_->stage().setFocus();
    press(Qt::Key_R);
    auto* dialog = window_->findChild<PartDialog*>();
    ASSERT_NE(dialog, nullptr);
    const auto field = [&](const char* name) {
        for (auto* each : dialog->findChildren<QSpinBox*>()) {
            if (each->accessibleName() == name) return each;
        }
        return static_cast<QSpinBox*>(nullptr);
    };
    field("Last frame of the take that is changed")->setValue(60);
    field("First frame of the take that is changed")->setValue(20);
    field("Last frame of the take or clip that lends the part")->setValue(90);
    field("First frame of the take or clip that lends the part")->setValue(60);
    ASSERT_NE(dialog->result(), nullptr);
    EXPECT_EQ(dialog->findChild<ActionTiles*>()->count(), 3);
    const MotionLibrary& library = *keys().motions();
    int index = -1;
    for (auto* combo : dialog->findChildren<QComboBox*>()) {
        if (combo->accessibleName() == "The take that is changed") index = combo->currentIndex();
    }
    ASSERT_GE(index, 0);
    const Clip& take = library.motions[static_cast<std::size_t>(index)].clip;
    // The made fighters move with their shoulders.
    const auto shoulder = static_cast<std::size_t>(*library.rig->roles[Role::RightShoulder]);
    const Clip& made = *dialog->result();
    ASSERT_EQ(made.frameCount(), take.frameCount());
    EXPECT_GT(made.frames[40].turns[shoulder].angularDistance(take.frames[40].turns[shoulder]),
              1e-3);
    std::vector<int> parents;
    for (const Rig::Joint& joint : library.rig->joints)
        parents.push_back(joint.parent);
    const auto parts = partsOfJoints(parents, library.rig->roles);
    for (const std::size_t frame : {5U, 40U, 80U}) {
        for (std::size_t j = 0; j < take.frames[frame].turns.size(); ++j) {
            if (frame == 40 && parts[j] == BodyPart::RightArm) continue;
            EXPECT_EQ(made.frames[frame].turns[j].coeffs(), take.frames[frame].turns[j].coeffs());
        }
        EXPECT_EQ(made.frames[frame].root, take.frames[frame].root);
    }
    field("First frame of the take that is changed")->setValue(61);
    EXPECT_EQ(dialog->result(), nullptr) << "it would end before it begins";
    field("First frame of the take that is changed")->setValue(20);
    keepMotionAs(session(), keys().writing(), dialog->madeMotion(), file("edited.bvh"));
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return session().document().project().takes.size() == 2; }, 10000));
    EXPECT_TRUE(QFileInfo::exists(file("edited.bvh")));
    QTest::keyClick(dialog, Qt::Key_Escape);
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
    // Each is a step of the history, and saved.
    const auto steps = session().document().history().position();
    hit.setTarget(before);
    EXPECT_EQ(session().document().history().position(), steps + 1);
    session().document().undo();
    EXPECT_EQ(hit.target(), aimed);
    const std::string strike = hit.strike();
    const std::string other = strike == strikes.front() ? strikes.back() : strikes.front();
    hit.setStrike(other);
    EXPECT_EQ(hit.strike(), other);
    session().document().undo();
    settle();
    EXPECT_EQ(hit.strike(), strike);
    ASSERT_TRUE(QTest::qWaitFor([&] { return hit.motion().has_value(); }, 20000));
    EXPECT_EQ(hit.target(), aimed);
    EXPECT_LT((*hitDraftOf(session().document().project()).target - aimed).norm(), 1e-12);
    // Esc leaves the target where it was.
    const QPoint held = window_->stage().handlePosition(0)->toPoint();
    QTest::mousePress(&window_->stage(), Qt::LeftButton, {}, held);
    QTest::mouseMove(&window_->stage(), held + QPoint(0, -20));
    EXPECT_NE(hit.target(), aimed);
    QTest::keyClick(&window_->stage(), Qt::Key_Escape);
    QTest::mouseRelease(&window_->stage(), Qt::LeftButton, {}, held);
    EXPECT_EQ(hit.target(), aimed);
    // At the opponent's body, a place of the recording.
    hit.setAim(Role::Head);
    ASSERT_NE(hit.opponent(), nullptr);
    hit.setDistance(1.1);
    const Eigen::Vector3d head = hit.target();
    EXPECT_LT((*hitDraftOf(session().document().project()).target - head).norm(), 1e-9);
    EXPECT_GT(head.y(), 1.2);
    hit.setDistance(0.9);
    EXPECT_NEAR(hit.target().z(), head.z() - 0.2, 1e-6);
    const QPoint mark = window_->stage().handlePosition(3)->toPoint();
    QTest::mouseClick(&window_->stage(), Qt::LeftButton, {}, mark);
    EXPECT_TRUE(hit.aim());
    EXPECT_NE(hit.aim(), Role::Head) << "a click on another of its marks";
    EXPECT_LT(hit.target().y(), head.y());
    session().document().undo();
    EXPECT_EQ(hit.aim(), Role::Head);
    hit.setAim(std::nullopt);
    EXPECT_EQ(hit.opponent(), nullptr);
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
