// What the 3D view offers beside the bodies, driven by keys and mouse.

#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <set>

#include "studio/app/commands.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/pose.h"
#include "studio/view3d/stage_view.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class View3dTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        openBout();
        session().transport().setPlayhead(2.0);
    }

    StageView& stage() { return window_->stage(); }
    void clickAt(const QPointF& position) {
        QTest::mouseClick(&stage(), Qt::LeftButton, {}, position.toPoint());
    }
    int joint(int player, Role role) { return *session().fighter(player)->input.roles[role]; }
    QPointF at(int player, Role role) {
        return stage().jointPosition({player, joint(player, role)}).value();
    }
    Fighters fighters() { return {session().fighter(0), session().fighter(1)}; }
};

/// Pixels in which two pictures differ by more than a shade.
int differences(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            const int most = std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()),
                                       std::abs(p.blue() - q.blue())});
            count += most > 12;
        }
    }
    return count;
}

TEST_F(View3dTest, EverySwitchDrawsSomethingAndTakesItAway) {
    const struct {
        Qt::Key key;
        const char* command;
    } switches[] = {{Qt::Key_C, "view.contacts"},
                    {Qt::Key_T, "view.trails"},
                    {Qt::Key_M, "view.centreOfMass"},
                    {Qt::Key_O, "view.force"}};
    press(Qt::Key_F);
    for (const auto& [key, command] : switches) {
        const bool was = window_->commands().action(command)->isChecked();
        const QImage before = stage().picture();
        press(key, Qt::AltModifier);
        EXPECT_NE(window_->commands().action(command)->isChecked(), was) << command;
        EXPECT_GT(differences(before, stage().picture()), 30) << command;
        press(key, Qt::AltModifier);
        EXPECT_EQ(differences(before, stage().picture()), 0) << command;
    }
}

TEST_F(View3dTest, LongerTrailsAreLonger) {
    press(Qt::Key_T, Qt::AltModifier);
    const int length = stage().overlays().trailBefore;
    const QImage before = stage().picture();
    press(Qt::Key_Period, Qt::AltModifier);
    EXPECT_EQ(stage().overlays().trailBefore, length + 10);
    EXPECT_NE(before, stage().picture());
    for (int i = 0; i < 50; ++i)
        window_->commands().run("view.trailShorter");
    EXPECT_EQ(stage().overlays().trailBefore, 0);
}

TEST_F(View3dTest, GhostStaysWhileTheFightersMoveOn) {
    const QImage before = stage().picture();
    press(Qt::Key_G);
    EXPECT_EQ(stage().ghostCount(), 1);
    press(Qt::Key_G);
    EXPECT_EQ(stage().ghostCount(), 1) << "twice at one moment";
    session().transport().setPlayhead(2.7);
    const QImage with = stage().picture();
    press(Qt::Key_G, Qt::ControlModifier);
    const QImage hidden = stage().picture();
    EXPECT_GT(differences(with, hidden), 500);
    press(Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(stage().picture(), with);
    press(Qt::Key_G, Qt::ShiftModifier);
    EXPECT_EQ(stage().ghostCount(), 0);
    EXPECT_EQ(stage().picture(), hidden);
    session().transport().setPlayhead(2.0);
    EXPECT_EQ(stage().picture(), before);
}

TEST_F(View3dTest, PresetsLookFromWhereTheySay) {
    // Fighter 2 stands at x = 1.2 m.
    press(Qt::Key_1, Qt::AltModifier);
    EXPECT_GT(at(1, Role::Pelvis).x(), at(0, Role::Pelvis).x() + 50);
    EXPECT_LT(at(0, Role::Head).y(), at(0, Role::LeftAnkle).y() - 100);
    press(Qt::Key_2, Qt::AltModifier);
    EXPECT_NEAR(at(1, Role::Pelvis).x(), at(0, Role::Pelvis).x(), 40);
    press(Qt::Key_3, Qt::AltModifier);
    EXPECT_NEAR(at(0, Role::Head).y(), at(0, Role::Pelvis).y(), 40);
    // Over the shoulder: the opponent in the middle.
    for (const int player : {0, 1}) {
        press(player == 0 ? Qt::Key_4 : Qt::Key_5, Qt::AltModifier);
        EXPECT_NEAR(at(1 - player, Role::Chest).x(), stage().width() / 2.0, 80);
    }
}

TEST_F(View3dTest, ShoulderViewStandsBehindTheFighter) {
    for (const int player : {0, 1}) {
        const auto view = overShoulder(fighters(), player, 2.0);
        ASSERT_TRUE(view);
        const Eigen::Vector3d own = centreAt(*session().fighter(player), 120);
        const Eigen::Vector3d other = centreAt(*session().fighter(1 - player), 120);
        EXPECT_LT((view->position - own).dot(other - own), -0.5);
        EXPECT_GT(view->position.y(), own.y());
        EXPECT_LT((view->target - other).norm(), 0.5);
    }
    const Fighters alone = {session().fighter(0), nullptr};
    EXPECT_TRUE(overShoulder(alone, 0, 2.0));
    EXPECT_FALSE(overShoulder(alone, 1, 2.0));
}

TEST_F(View3dTest, FollowedPointMovesSmoothlyAndTheCameraWithIt) {
    double largest = 0;
    for (double time = 1; time < 8; time += 1 / 60.0) {
        const Eigen::Vector3d step =
            *followedPoint(fighters(), time + 1 / 60.0) - *followedPoint(fighters(), time);
        largest = std::max(largest, step.norm());
    }
    EXPECT_LT(largest, 0.01);
    EXPECT_FALSE(followedPoint({nullptr, nullptr}, 1.0));

    press(Qt::Key_F, Qt::ShiftModifier);
    EXPECT_TRUE(stage().isFollowing());
    const auto middle = [&] { return 0.5 * (at(0, Role::Pelvis).x() + at(1, Role::Pelvis).x()); };
    EXPECT_NEAR(middle(), stage().width() / 2.0, 60);
    const double before = middle();
    session().transport().setPlayhead(6.0);
    EXPECT_NEAR(middle(), before, 15);
}

TEST_F(View3dTest, ClickOnAFighterMakesItActive) {
    ASSERT_EQ(session().activePlayer(), 0);
    const QPointF thigh = 0.5 * (at(1, Role::LeftHip) + at(1, Role::LeftKnee));
    clickAt(thigh);
    EXPECT_EQ(session().activePlayer(), 1);
    clickAt({10, 10});
    EXPECT_EQ(session().activePlayer(), 1) << "a click beside both changes nothing";
    clickAt(at(0, Role::Head));
    EXPECT_EQ(session().activePlayer(), 0);
}

TEST_F(View3dTest, MeasuresBetweenClickedJointsAndStaysLive) {
    press(Qt::Key_M);
    ASSERT_TRUE(stage().isMeasuring());
    press(Qt::Key_1, Qt::AltModifier);
    clickAt(at(0, Role::LeftWrist));
    EXPECT_FALSE(stage().measuredDistance());
    clickAt(at(1, Role::Head));
    ASSERT_TRUE(stage().measuredDistance());
    EXPECT_EQ(stage().measuring().from, (JointRef{0, joint(0, Role::LeftWrist)}));
    EXPECT_EQ(stage().measuring().to, (JointRef{1, joint(1, Role::Head)}));
    const auto expected = [&](int frame) {
        return (jointAt(*session().fighter(0), frame, joint(0, Role::LeftWrist)) -
                jointAt(*session().fighter(1), frame, joint(1, Role::Head)))
            .norm();
    };
    EXPECT_NEAR(*stage().measuredDistance(), expected(120), 1e-5);
    session().transport().setPlayhead(2.5);
    EXPECT_NEAR(*stage().measuredDistance(), expected(150), 1e-5);
    EXPECT_EQ(session().activePlayer(), 0) << "measuring does not choose a fighter";
    press(Qt::Key_Escape);
    EXPECT_FALSE(stage().isMeasuring());
    EXPECT_FALSE(stage().measuredDistance());
}

TEST_F(View3dTest, MeasuresByKeysAlone) {
    QString said;
    const QObject listener;
    QObject::connect(&session(), &Session::hovered, &listener,
                     [&](const QString& text) { said = text; });
    const auto stepTo = [&](int player, Role role) {
        for (int i = 0; i < 60; ++i) {
            if (stage().measuring().hovered == JointRef{player, joint(player, role)}) return true;
            press(Qt::Key_PageDown, Qt::AltModifier);
        }
        return false;
    };
    // The first step begins to measure.
    press(Qt::Key_PageDown, Qt::AltModifier);
    ASSERT_TRUE(stage().isMeasuring());
    ASSERT_TRUE(stepTo(0, Role::LeftWrist));
    const auto speed = [&](int frame) {
        const FighterAnalysis& fighter = *session().fighter(0);
        return QString::number(jointSpeed(fighter.motion->positions, joint(0, Role::LeftWrist),
                                          frame, fighter.input.rate),
                               'f', 1);
    };
    EXPECT_EQ(said, QString("fighter 1: left wrist   %1 m/s").arg(speed(120)));
    session().transport().setPlayhead(2.1);
    EXPECT_EQ(said, QString("fighter 1: left wrist   %1 m/s").arg(speed(126))) << "as it is now";
    press(Qt::Key_M, Qt::ShiftModifier);
    EXPECT_TRUE(said.endsWith("from fighter 1: left wrist"));
    // The same joint of the other fighter, then on to the head.
    press(Qt::Key_Tab);
    EXPECT_EQ(stage().measuring().hovered, (JointRef{1, joint(1, Role::LeftWrist)}));
    ASSERT_TRUE(stepTo(1, Role::Head));
    press(Qt::Key_M, Qt::ShiftModifier);
    const double distance = (jointAt(*session().fighter(0), 126, joint(0, Role::LeftWrist)) -
                             jointAt(*session().fighter(1), 126, joint(1, Role::Head)))
                                .norm();
    ASSERT_TRUE(stage().measuredDistance());
    EXPECT_NEAR(*stage().measuredDistance(), distance, 1e-5);
    EXPECT_TRUE(said.endsWith(
        QString("%1 m from fighter 1: left wrist to fighter 2: head").arg(distance, 0, 'f', 2)))
        << said.toStdString();
    EXPECT_EQ(stage().accessibleDescription(), said);
    const JointRef before = *stage().measuring().hovered;
    press(Qt::Key_PageUp, Qt::AltModifier);
    EXPECT_NE(stage().measuring().hovered, before);
    press(Qt::Key_Escape);
    EXPECT_TRUE(said.isEmpty()) << "over is over";
}

TEST_F(View3dTest, KeysLeadThroughEveryJointOnceAndRoundAgain) {
    std::set<int> seen;
    const int count = session().fighter(0)->motion->positions.jointCount;
    for (int i = 0; i < count; ++i) {
        press(Qt::Key_PageDown, Qt::AltModifier);
        seen.insert(stage().measuring().hovered->joint);
    }
    EXPECT_EQ(int(seen.size()), count);
    const JointRef last = *stage().measuring().hovered;
    press(Qt::Key_PageDown, Qt::AltModifier);
    press(Qt::Key_PageUp, Qt::AltModifier);
    EXPECT_EQ(stage().measuring().hovered, last);
}

TEST_F(View3dTest, HoveredJointTellsItsNameAndSpeed) {
    QString said;
    const QObject listener;
    QObject::connect(&session(), &Session::hovered, &listener,
                     [&](const QString& text) { said = text; });
    press(Qt::Key_1, Qt::AltModifier);
    hover(stage(), at(1, Role::LeftKnee).toPoint());
    EXPECT_TRUE(said.isEmpty()) << "only the tool asks for joints";
    press(Qt::Key_M);
    hover(stage(), at(1, Role::LeftKnee).toPoint() + QPoint(2, 1));
    const FighterAnalysis& fighter = *session().fighter(1);
    const double speed =
        jointSpeed(fighter.motion->positions, joint(1, Role::LeftKnee), 120, fighter.input.rate);
    EXPECT_EQ(said, QString("fighter 2: left knee   %1 m/s").arg(speed, 0, 'f', 1));
}

TEST_F(View3dTest, PictureGoesToTheClipboard) {
    QApplication::clipboard()->clear();
    press(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    const QImage copied = QApplication::clipboard()->image();
    EXPECT_EQ(copied.size(), stage().size() * window_->devicePixelRatio());
    EXPECT_EQ(differences(copied.convertToFormat(QImage::Format_RGB32), stage().picture()), 0);
}

TEST_F(View3dTest, ButtonsHaveNamesTipsAndMenus) {
    int menus = 0;
    for (const auto* button : stage().findChildren<QToolButton*>()) {
        EXPECT_FALSE(button->accessibleName().isEmpty());
        EXPECT_FALSE(button->toolTip().isEmpty()) << button->accessibleName().toStdString();
        menus += button->menu() != nullptr;
    }
    EXPECT_EQ(menus, 2);
}

TEST_F(View3dTest, StillPictureGetsSmoothEdges) {
    const auto grabbed = [&] { return stage().grab().toImage(); };
    session().transport().setPlayhead(3.0);
    const QImage first = grabbed();
    EXPECT_TRUE(QTest::qWaitFor([&] { return grabbed() != first; }, 3000));
}

}  // namespace
}  // namespace kumite::studio
