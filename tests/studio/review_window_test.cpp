// A review in the Segment workspace: suspects, decisions, settings, comparison.

#include <QAbstractItemView>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include <algorithm>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/message_strip.h"
#include "studio/timeline/timeline_view.h"
#include "studio/workspaces/segment/compare_box.h"
#include "studio/workspaces/segment/review.h"
#include "studio/workspaces/segment/segment_panel.h"
#include "studio/workspaces/segment/statistics_box.h"
#include "studio/workspaces/segment/unmatched_box.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class ReviewTest : public WindowTest {
protected:
    SegmentPanel& panel() { return *window_->findChild<SegmentPanel*>(); }
    template <typename Widget>
    Widget* named(const QString& name) {
        for (auto* widget : panel().findChildren<Widget*>()) {
            if (widget->accessibleName() == name) return widget;
        }
        ADD_FAILURE() << "nothing is called " << name.toStdString();
        return nullptr;
    }
    QPushButton* button(const QString& text) {
        for (auto* each : panel().findChildren<QPushButton*>()) {
            if (each->text() == text) return each;
        }
        return nullptr;
    }
    const std::vector<Correction>& corrections(int player) {
        return session().document().project().takes[0].fighters[std::size_t(player)].corrections;
    }
};

TEST_F(ReviewTest, KeysLeadThroughTheSuspectsWorstFirst) {
    openBout();
    const auto suspects = suspectsOf(session());
    ASSERT_GT(suspects.size(), 3U);
    for (std::size_t i = 1; i < suspects.size(); ++i)
        EXPECT_GE(suspects[i - 1].suspicion, suspects[i].suspicion);
    press(Qt::Key_N);
    EXPECT_EQ(session().selection(), suspects[0].boundary);
    EXPECT_NEAR(session().transport().playhead(), suspects[0].seconds, 1e-9);
    // It is shown from near.
    EXPECT_LE(session().visible().end - session().visible().begin, 8.0 + 1e-9);
    EXPECT_LT(session().visible().begin, suspects[0].seconds);
    EXPECT_GT(session().visible().end, suspects[0].seconds);
    // Round among the suspects while there are any, then among the other minima.
    const auto count = static_cast<std::size_t>(
        std::count_if(suspects.begin(), suspects.end(),
                      [](const Suspect& each) { return each.suspicion >= kSuspect; }));
    ASSERT_GT(count, 0U);
    press(Qt::Key_N);
    EXPECT_EQ(session().selection(), suspects[1 % count].boundary);
    press(Qt::Key_N, Qt::ShiftModifier);
    press(Qt::Key_N, Qt::ShiftModifier);
    EXPECT_EQ(session().selection(), suspects[count - 1].boundary) << "round at the ends";
    EXPECT_EQ(session().document().history().position(), 0U);
    for (std::size_t i = 0; i < suspects.size() && suspectsOf(session())[0].suspicion >= kSuspect;
         ++i) {
        session().goTo(suspectsOf(session())[0].boundary);
        press(Qt::Key_Return);
    }
    const auto rest = suspectsOf(session());
    ASSERT_TRUE(rest[1].isOpen());
    session().select(std::nullopt);
    press(Qt::Key_N);
    EXPECT_EQ(session().selection(), rest[0].boundary);
    press(Qt::Key_N);
    EXPECT_EQ(session().selection(), rest[1].boundary);
}

TEST_F(ReviewTest, ReturnAcceptsForGoodAndBackspaceRemoves) {
    openBout();
    const std::size_t all = suspectsOf(session()).size();
    press(Qt::Key_N);
    const BoundaryRef kept = *session().selection();
    press(Qt::Key_Return);
    EXPECT_EQ(mark(kept)->state, MarkState::Accepted);
    EXPECT_NE(suspectsOf(session()).front().boundary, kept);
    EXPECT_EQ(suspectsOf(session()).size(), all) << "decided ones stay in the list, below";
    session().goTo(suspectsOf(session()).front().boundary);
    const BoundaryRef spurious = *session().selection();
    press(Qt::Key_Backspace);
    EXPECT_FALSE(mark(spurious)->isLive());
    EXPECT_EQ(session().document().history().position(), 2U);

    ASSERT_TRUE(window_->files().saveTo(file("reviewed.kumite")));
    window_->files().open({file("reviewed.kumite")});
    settle();
    EXPECT_EQ(mark(kept)->state, MarkState::Accepted) << "the decision is in the project";
    EXPECT_FALSE(mark(spurious)->isLive());
    // Decided anew it is a suspect again.
    session().goTo(kept);
    press(Qt::Key_Return, Qt::ShiftModifier);
    EXPECT_EQ(mark(kept)->state, MarkState::Detected);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(mark(kept)->state, MarkState::Accepted);
}

TEST_F(ReviewTest, UndoGoesBackToTheBoundary) {
    openBout();
    const BoundaryRef first = someBoundary(0), second = someBoundary(1);
    session().goTo(first);
    press(Qt::Key_Delete);
    session().goTo(second);
    press(Qt::Key_Delete);
    session().select(std::nullopt);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session().selection(), second);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session().selection(), first);
    EXPECT_TRUE(mark(first)->isLive());
    press(Qt::Key_Y, Qt::ControlModifier);
    EXPECT_EQ(session().selection(), first);
    EXPECT_FALSE(mark(first)->isLive());
}

TEST_F(ReviewTest, FromAMinimumThatIsNoSuspectTheMostSuspiciousComesNext) {
    openBout();
    const auto suspects = suspectsOf(session());
    ASSERT_GT(suspects.size(), 3U);
    ASSERT_GE(suspects.front().suspicion, kSuspect);
    ASSERT_LT(suspects.back().suspicion, kSuspect);
    session().goTo(suspects.back().boundary);
    press(Qt::Key_N);
    EXPECT_EQ(session().selection(), suspects.front().boundary);
    // Back and on among the suspects alone.
    std::size_t last = 0;
    while (last + 1 < suspects.size() && suspects[last + 1].suspicion >= kSuspect)
        ++last;
    press(Qt::Key_N, Qt::ShiftModifier);
    EXPECT_EQ(session().selection(), suspects[last].boundary);
    press(Qt::Key_N, Qt::ShiftModifier);
    EXPECT_EQ(session().selection(), suspects[last > 0 ? last - 1 : 0].boundary);
    session().goTo(suspects.front().boundary);
    session().examine(suspects.front().boundary);
    // What plays shows both actions that meet there.
    const Transport& transport = session().transport();
    EXPECT_TRUE(transport.isLooping());
    EXPECT_LT(*transport.loopIn(), transport.playhead());
    EXPECT_GT(*transport.loopOut(), transport.playhead());
}

TEST_F(ReviewTest, ADecisionShowsTheNextSuspect) {
    openBout();
    // Two removals of a kind make the others of it suspect.
    int decided = 0;
    press(Qt::Key_N);
    while (decided < 6) {
        const BoundaryRef now = *session().selection();
        press(Qt::Key_Backspace);
        ++decided;
        EXPECT_FALSE(mark(now)->isLive());
        const auto left = suspectsOf(session());
        if (!left.front().isOpen() || left.front().suspicion < kSuspect) {
            EXPECT_FALSE(session().selection())
                << "nothing is left that is worth a look, and the same key again undoes nothing";
            press(Qt::Key_N);
        } else {
            EXPECT_EQ(session().selection(), left.front().boundary);
        }
    }
    EXPECT_EQ(corrections(0).size() + corrections(1).size(), 6U);
}

TEST_F(ReviewTest, ReturnInAFieldIsNoDecision) {
    openBout();
    press(Qt::Key_N);
    auto* field = named<QDoubleSpinBox>("Cutoff of the low-pass in Hz");
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Return);
    QTest::keyClick(field, Qt::Key_Backspace);
    EXPECT_TRUE(corrections(0).empty());
    EXPECT_TRUE(corrections(1).empty());
}

TEST_F(ReviewTest, TheReasonIsSaidInWords) {
    openBout();
    press(Qt::Key_N);
    const QString reason = named<QLabel>("Why the minimum is suspected")->text();
    EXPECT_TRUE(reason.contains("prominence")) << reason.toStdString();
    EXPECT_TRUE(reason.endsWith(QString("\u00a0BW"))) << "the unit stays with its number";
    // Whose it is and how likely stand in its row.
    const auto* list = qobject_cast<QAbstractItemView*>(panel().list());
    ASSERT_NE(list, nullptr);
    const QString told = list->currentIndex().data(Qt::AccessibleTextRole).toString();
    EXPECT_TRUE(told.contains("fighter ")) << told.toStdString();
    EXPECT_TRUE(told.contains("suspicion"));
}

TEST_F(ReviewTest, ASliderActsWhileItMovesAndIsOneStep) {
    openBout();
    auto* slider = named<QSlider>("Least prominence in body weights");
    const std::size_t before = session().fighter(0)->segmentation->actions.size();
    slider->setSliderDown(true);
    slider->setSliderPosition(slider->maximum() / 2);
    settle();
    const std::size_t during = session().fighter(0)->segmentation->actions.size();
    slider->setSliderPosition(slider->maximum());
    settle();
    EXPECT_LT(session().fighter(0)->segmentation->actions.size(), before);
    EXPECT_LE(session().fighter(0)->segmentation->actions.size(), during);
    EXPECT_EQ(session().document().history().position(), 1U);
    slider->setSliderDown(false);
    EXPECT_EQ(session().document().history().position(), 1U);
    EXPECT_DOUBLE_EQ(session().document().project().segmentation.prominence, 0.5);
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(session().fighter(0)->segmentation->actions.size(), before);
    EXPECT_FALSE(session().document().history().canUndo());
    EXPECT_NEAR(named<QDoubleSpinBox>("Least prominence in body weights")->value(), 0.05, 1e-9);
}

TEST_F(ReviewTest, ASliderLedBackChangesNothing) {
    openBout();
    auto* slider = named<QSlider>("Cutoff of the low-pass in Hz");
    const int home = slider->value();
    slider->setSliderDown(true);
    slider->setSliderPosition(home + 40);
    settle();
    EXPECT_EQ(session().document().history().position(), 1U);
    slider->setSliderPosition(home);
    settle();
    slider->setSliderDown(false);
    settle();
    EXPECT_FALSE(session().document().isModified());
}

TEST_F(ReviewTest, ACutoffThatSmoothsNothingIsWarnedAbout) {
    openBout();
    auto* warning = named<QLabel>("Warning about the cutoff");
    EXPECT_FALSE(warning->isVisible());
    auto* cutoff = named<QDoubleSpinBox>("Cutoff of the low-pass in Hz");
    cutoff->setFocus();
    cutoff->selectAll();
    QTest::keyClicks(cutoff, "45");
    QTest::keyClick(cutoff, Qt::Key_Return);
    settle();
    EXPECT_TRUE(warning->isVisible());
    EXPECT_TRUE(warning->text().contains("30 Hz")) << warning->text().toStdString();
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_FALSE(warning->isVisible());
}

TEST_F(ReviewTest, TwoSettingsAreComparedAndTheOtherIsTaken) {
    openBout();
    const std::size_t own = session().marks(0).size();
    press(Qt::Key_C);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session().comparison().has_value(); }, 3000));
    EXPECT_TRUE(session().comparison()->players[0].onlyA.empty()) << "B begins as A";
    auto* prominence = named<QDoubleSpinBox>("Least prominence in body weights B");
    prominence->setFocus();
    prominence->selectAll();
    QTest::keyClicks(prominence, "0.9");
    QTest::keyClick(prominence, Qt::Key_Return);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return !session().comparison()->players[0].onlyA.empty(); }, 3000));
    const BoundaryComparison difference = session().comparison()->players[0];
    EXPECT_EQ(difference.both + difference.onlyA.size(), own - 2);
    EXPECT_TRUE(difference.onlyB.empty());
    const QString counts = named<QLabel>("Boundaries that differ")->text();
    EXPECT_TRUE(counts.contains(QString("%1 only A").arg(difference.onlyA.size())))
        << counts.toStdString();
    EXPECT_EQ(session().document().history().position(), 0U) << "looking changes nothing";
    timeline().grab();
    QTest::mouseClick(button("Use B"), Qt::LeftButton);
    settle();
    EXPECT_DOUBLE_EQ(session().document().project().segmentation.prominence, 0.9);
    EXPECT_EQ(session().marks(0).size(), own - difference.onlyA.size());
    press(Qt::Key_C);
    EXPECT_FALSE(session().comparison());
}

TEST_F(ReviewTest, CorrectionsWithoutAMinimumAreListedForDecision) {
    openBout();
    auto* box = panel().findChild<UnmatchedBox*>();
    EXPECT_FALSE(box->isVisible());
    const int place = someBoundary(0).frame + 11;
    session().document().apply([&](const Project& project) {
        Edit edit{project, "as if loaded"};
        edit.project.takes[0].fighters[0].corrections = {
            {Correction::Kind::Move, 9000, place, false, false},
            {Correction::Kind::Remove, 9500, 0, false, false}};
        return MaybeEdit(edit);
    });
    settle();
    ASSERT_TRUE(box->isVisible());
    auto* list = box->findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 2);
    list->setCurrentRow(1);
    EXPECT_FALSE(button("Put boundary")->isEnabled()) << "a removal leaves no boundary";
    QTest::mouseClick(button("Forget"), Qt::LeftButton);
    ASSERT_EQ(list->count(), 1);
    QTest::mouseClick(button("Put boundary"), Qt::LeftButton);
    EXPECT_FALSE(box->isVisible());
    ASSERT_NE(mark({0, place}), nullptr);
    EXPECT_EQ(mark({0, place})->state, MarkState::Added);
    EXPECT_EQ(corrections(0).size(), 1U);
}

TEST_F(ReviewTest, StatisticsFollowTheHand) {
    openBout();
    const auto cells = [&] {
        QStringList texts;
        for (const auto* label : panel().findChild<StatisticsBox*>()->findChildren<QLabel*>())
            texts.append(label->text());
        return texts;
    };
    const QStringList before = cells();
    session().toggleBoundary(someBoundary(0));
    EXPECT_NE(cells(), before);
    EXPECT_TRUE(cells().contains("take"));
}

}  // namespace
}  // namespace kumite::studio
