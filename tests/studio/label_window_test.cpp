// A labelling session in the window: questions, answers by keys, undo, painting, boundaries.

#include <QAbstractItemView>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>

#include <algorithm>

#include "core/project/demo_bout.h"
#include "core/project/label_files.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/opening.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/workspaces/label/label_panel.h"
#include "studio/workspaces/label/label_review.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class LabelTest : public WindowTest {
protected:
    LabelSession& labels() { return window_->labels(); }
    LabelReview& review() { return window_->labelReview(); }
    const Document& document() { return session().document(); }
    LabelPanel& panel() { return *window_->findChild<LabelPanel*>(); }

    void openDemo() {
        const DemoFiles demo = writeDemoBout({20, 60, 3}, toPath(file("demo")));
        window_->files().openProjectFile(fromPath(demo.project()));
        settle();
        window_->commands().run("workspace.label");
        settle();
        ASSERT_FALSE(labels().actions().empty());
        const auto found = readLabels(demo.truth(), labels().vocabulary());
        truth_ = matchLabels(document().project(), document().analysis(), found, 0).fighters;
    }
    /// What the choreographer planned of an action, where machines learn; else nothing of it.
    Label truthOf(const ShownAction& action) {
        const Vocabulary& vocabulary = labels().vocabulary();
        Label label = othersLabel(vocabulary);
        for (const FighterLabels& fighter : truth_) {
            if (fighter.fighter != action.fighter) continue;
            const Label planned = fighter.labels[std::size_t(action.index)].label();
            for (std::size_t a = 0; a < label.size(); ++a) {
                if (planned[a] != kUnknown) label[a] = planned[a];
            }
        }
        for (int a = 0; a < vocabulary.size(); ++a) {
            if (vocabulary[a].classifier != Classifier::Msvm) label[std::size_t(a)] = kUnknown;
        }
        return label;
    }
    void pressKeyOf(const QString& command) {
        const QKeySequence keys = window_->commands().find(command)->keys.front();
        press(Qt::Key(keys[0].key()), keys[0].keyboardModifiers());
    }
    /// The current action's true label, by quick key where there is one, else lane by lane.
    void answerByKeys() {
        const Vocabulary& vocabulary = labels().vocabulary();
        const Label truth = truthOf(*labels().current());
        const std::vector<QuickLabel> quick = quickLabels(vocabulary);
        for (std::size_t i = 0; i < quick.size(); ++i) {
            if (quick[i].label == truth) {
                return pressKeyOf(QString("label.quick%1").arg(i + 1));
            }
        }
        press(Qt::Key_Y);  // stay at this action
        for (int a = 0; a < vocabulary.size(); ++a) {
            if (vocabulary[a].classifier != Classifier::Msvm) continue;
            while (labels().aspect() != a)
                press(Qt::Key_Down);
            const auto value = std::size_t(truth[std::size_t(a)]);
            const int digit = std::stoi(vocabulary[a].qualifiers[value].key);
            press(Qt::Key_V);
            press(Qt::Key(Qt::Key_0 + digit));
        }
        press(Qt::Key_Y);
        pressKeyOf("label.next");
    }
    Label handLabel(FighterAddress fighter, int peak) {
        return labels().actions()[std::size_t(labels().indexOf(fighter, peak))].byHand();
    }
    void waitUntilLearnt(bool thoroughly = false) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return labels().isCurrent(thoroughly); }, 20000));
    }

    std::vector<FighterLabels> truth_;
};

TEST_F(LabelTest, KeysLeadFromNothingToEveryActionLabelled) {
    openDemo();
    const int all = labels().progress().actions;
    ASSERT_GT(all, 30);
    EXPECT_EQ(labels().progress().byHand, 0);
    std::vector<Project> states{document().project()};
    std::vector<std::pair<FighterAddress, int>> asked;
    std::vector<Label> answers;
    pressKeyOf("label.next");
    for (int i = 0; i < 16; ++i) {
        const ShownAction question = *labels().current();
        const auto same = std::pair(question.fighter, question.peak);
        EXPECT_EQ(std::count(asked.begin(), asked.end(), same), 0) << "asked twice";
        asked.push_back(same);
        answers.push_back(truthOf(question));
        const std::size_t before = document().history().position();
        answerByKeys();
        ASSERT_GT(document().history().position(), before);
        while (states.size() <= document().history().position())
            states.push_back(document().history().steps()[states.size()].project);
        EXPECT_EQ(handLabel(same.first, same.second), answers.back());
        const ShownAction* next = labels().current();
        ASSERT_NE(next, nullptr);
        EXPECT_FALSE(next->fighter == same.first && next->peak == same.second)
            << "an answer goes on";
        if (i % 4 == 3) waitUntilLearnt();
    }
    EXPECT_EQ(labels().progress().byHand, 16);

    // The rest is accepted in one step, the unsure ones, too: the field says so.
    waitUntilLearnt(true);
    ASSERT_TRUE(labels().progress().expectedAccuracy.has_value());
    auto* threshold = panel().findChild<QDoubleSpinBox*>();
    threshold->setFocus();
    threshold->selectAll();
    QTest::keyClicks(threshold, "0");
    QTest::keyClick(threshold, Qt::Key_Return);
    EXPECT_EQ(labels().countSure(0), all - 16);
    const std::size_t before = document().history().position();
    press(Qt::Key_Return, Qt::ControlModifier);
    settle();
    EXPECT_EQ(document().history().position(), before + 1);
    states.push_back(document().project());
    EXPECT_EQ(labels().progress().settled, all) << "every action has its whole label";
    EXPECT_DOUBLE_EQ(labels().progress().labelledShare(), 1.0);
    EXPECT_TRUE(labels().queue().empty());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        EXPECT_EQ(handLabel(asked[i].first, asked[i].second), answers[i])
            << "no prediction touches what a hand has said";
    }

    // Every state is there again, one way and the other.
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        EXPECT_TRUE(document().project() == states[i]) << "state " << i;
        press(Qt::Key_Z, Qt::ControlModifier);
    }
    EXPECT_TRUE(document().project() == states[0]);
    EXPECT_EQ(labels().progress().byHand, 0);
    for (std::size_t i = 1; i < states.size(); ++i) {
        press(Qt::Key_Y, Qt::ControlModifier);
        EXPECT_TRUE(document().project() == states[i]) << "state " << i;
    }
}

TEST_F(LabelTest, ReturnAnswersOnlyInTheViewsAndPressesTheButtonThatHasTheFocus) {
    openDemo();
    pressKeyOf("label.next");
    press(Qt::Key_B);
    waitUntilLearnt(true);
    const std::size_t before = document().history().position();
    int tried = 0;
    for (auto* tab : window_->menuBar()->findChildren<QToolButton*>()) {
        if (tab->accessibleName() != "Label workspace") continue;
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Backspace}) {
            tab->setFocus(Qt::TabFocusReason);
            QTest::keyClick(tab, key);
            ++tried;
        }
        EXPECT_TRUE(tab->isChecked());
    }
    EXPECT_EQ(tried, 3);
    auto* threshold = panel().findChild<QDoubleSpinBox*>();
    threshold->setFocus();
    QTest::keyClicks(threshold, "0.5");
    QTest::keyClick(threshold, Qt::Key_Return);
    QTest::keyClick(threshold, Qt::Key_Return);
    EXPECT_EQ(document().history().position(), before) << "nobody answered";
    for (auto* tab : window_->menuBar()->findChildren<QToolButton*>()) {
        if (tab->accessibleName() != "Segment workspace") continue;
        tab->setFocus(Qt::TabFocusReason);
        QTest::keyClick(tab, Qt::Key_Return);
    }
    EXPECT_EQ(window_->workspaces().current(), "segment");
    EXPECT_EQ(document().history().position(), before);
}

TEST_F(LabelTest, AfterAnAnswerByAButtonReturnIsForTheNextQuestion) {
    openDemo();
    pressKeyOf("label.next");
    press(Qt::Key_B);
    waitUntilLearnt(true);
    const int byHand = labels().progress().byHand;
    int tried = 0;
    for (auto* button : panel().findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || !button->isEnabled() || !button->text().contains("⏎")) continue;
        ++tried;
        button->setFocus(Qt::TabFocusReason);
        QTest::keyClick(button, Qt::Key_Return);
        QTest::qWait(1);
        EXPECT_EQ(labels().progress().byHand, byHand + 1);
        EXPECT_EQ(QApplication::focusWidget(), &window_->timeline());
        break;
    }
    EXPECT_EQ(tried, 1);
    // From the search field the palette's key leads back to the views, not to a field of a number.
    press(Qt::Key_F, Qt::ControlModifier);
    QTest::qWait(1);
    EXPECT_TRUE(QApplication::focusWidget()->inherits("QLineEdit"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F4);
    QTest::qWait(1);
    EXPECT_EQ(QApplication::focusWidget(), &window_->timeline());
}

TEST_F(LabelTest, AnAnswerStaysWhenAnotherActionIsChosenBeforeTheSecondClass) {
    openDemo();
    pressKeyOf("label.next");
    const ActionRef first = *session().selectedAction();
    const std::size_t steps = document().history().position();
    pressKeyOf("label.composite");
    press(Qt::Key_Q);
    ASSERT_TRUE(labels().find(first)->anyByHand());
    session().stepAction(-1);
    const ActionRef second = *session().selectedAction();
    ASSERT_FALSE(first == second);
    press(Qt::Key_W);
    EXPECT_TRUE(labels().find(first)->anyByHand()) << "what was said first is kept";
    EXPECT_TRUE(labels().find(second)->anyByHand());
    EXPECT_EQ(document().history().position(), steps + 2);
}

TEST_F(LabelTest, TwoClassesAreSaidByVInAnyWay) {
    openDemo();
    pressKeyOf("label.next");
    const Vocabulary& vocabulary = labels().vocabulary();
    const Label both = parseLabel(vocabulary, "left_punch:fwd+right_kick:up");
    const auto said = [&](const ActionRef& action) {
        Label label = labels().find(action)->byHand();
        for (std::size_t a = 0; a < label.size(); ++a) {
            if (both[a] == kUnknown) label[a] = kUnknown;
        }
        return labelText(vocabulary, label);
    };
    // First V, then both: the first answer stays, the second goes on.
    const ActionRef first = *session().selectedAction();
    const std::size_t steps = document().history().position();
    pressKeyOf("label.composite");
    press(Qt::Key_Q);
    EXPECT_EQ(session().selectedAction(), first) << "the second class is still to come";
    press(Qt::Key_Z, Qt::ShiftModifier);
    EXPECT_EQ(document().history().position(), steps + 1) << "both are one step";
    EXPECT_EQ(said(first), "left_punch:fwd+right_kick:up");
    EXPECT_FALSE(session().selectedAction() == first);
    // One class is said already, V adds another; by number as by letter.
    window_->commands().run("label.advance");
    const ActionRef second = *session().selectedAction();
    press(Qt::Key_Q);
    pressKeyOf("label.composite");
    press(Qt::Key_Z, Qt::ShiftModifier);
    EXPECT_EQ(said(second), "left_punch:fwd+right_kick:up");
    EXPECT_FALSE(review().isComposite());
    press(Qt::Key_W);
    EXPECT_EQ(said(second), "left_punch:bwd") << "without V a strike takes the place of others";
    pressKeyOf("label.composite");
    EXPECT_TRUE(review().isComposite());
    pressKeyOf("label.next");
    EXPECT_FALSE(review().isComposite()) << "it was meant for the action before";
    window_->commands().run("label.advance");
}

TEST_F(LabelTest, ReturnInAnOpenListAnswersNoQuestion) {
    openDemo();
    pressKeyOf("label.next");
    press(Qt::Key_B);
    waitUntilLearnt(true);
    window_->commands().run("label.next");
    auto* pages = panel().findChild<QTabWidget*>();
    pages->setCurrentIndex(1);
    auto* order = panel().findChild<QComboBox*>();
    order->setFocus(Qt::TabFocusReason);
    const std::size_t before = document().history().position();
    order->showPopup();
    ASSERT_TRUE(QTest::qWaitFor([&] { return order->view()->isVisible(); }, 2000));
    QTest::keyClick(order->view(), Qt::Key_Down);
    QTest::keyClick(order->view(), Qt::Key_Return);
    QTest::qWait(20);
    EXPECT_EQ(document().history().position(), before);
}

TEST_F(LabelTest, TheBarOfTheSureHasKeysAndBeginsAnewWithEveryProject) {
    openDemo();
    auto* threshold = panel().findChild<QDoubleSpinBox*>();
    EXPECT_DOUBLE_EQ(threshold->value(), 0.9);
    pressKeyOf("label.barDown");
    pressKeyOf("label.barDown");
    EXPECT_DOUBLE_EQ(threshold->value(), 0.8);
    pressKeyOf("label.barUp");
    EXPECT_DOUBLE_EQ(threshold->value(), 0.85);
    openDemo();
    EXPECT_DOUBLE_EQ(threshold->value(), 0.9);
}

TEST_F(LabelTest, TheFirstQuestionsStandForManyActions) {
    openDemo();
    const auto& batch = labels().learnt()->batch;
    ASSERT_EQ(batch.size(), 5U);
    std::vector<int> first(labels().queue().begin(), labels().queue().begin() + 5);
    for (std::size_t i = 0; i < 5; ++i) {
        const ShownAction& question = labels().actions()[std::size_t(first[i])];
        EXPECT_EQ(question.row, batch[i]);
        pressKeyOf("label.next");
        EXPECT_EQ(session().selectedAction(), (ActionRef{question.fighter.player, question.peak}));
    }
    // They lie apart, not one beside the other.
    std::sort(first.begin(), first.end());
    EXPECT_GT(first.back() - first.front(), 10);
    // Answered one by one they are asked to the end, whatever is learnt between.
    const std::vector<int> asked(labels().queue().begin(), labels().queue().begin() + 5);
    labels().choose({});
    pressKeyOf("label.next");
    for (std::size_t i = 0; i < 5; ++i) {
        const ShownAction* question = labels().current();
        EXPECT_EQ(labels().indexOf(question->fighter, question->peak), asked[i]);
        press(Qt::Key_B);
        waitUntilLearnt();
    }
}

TEST_F(LabelTest, UndoGoesBackToTheQuestion) {
    openDemo();
    pressKeyOf("label.next");
    const ActionRef first = *session().selectedAction();
    press(Qt::Key_1);
    const ActionRef second = *session().selectedAction();
    ASSERT_FALSE(second == first);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session().selectedAction(), first);
    EXPECT_FALSE(labels().find(first)->anyByHand());
    // It loops with some air around it.
    const TimeSpan span = session().spanOf(first);
    EXPECT_TRUE(session().transport().isLooping());
    EXPECT_NEAR(*session().transport().loopIn(), std::max(0.0, span.begin - 0.3), 1e-6);
    EXPECT_NEAR(*session().transport().loopOut(),
                std::min(session().transport().span().end, span.end + 0.3), 1e-6);
}

TEST_F(LabelTest, ReturnTakesTheBestAndBackspaceTheSecondBest) {
    openDemo();
    pressKeyOf("label.next");
    press(Qt::Key_Return);
    EXPECT_EQ(document().history().position(), 0U) << "nothing is proposed yet";
    for (int i = 0; i < 12; ++i)
        answerByKeys();
    waitUntilLearnt(true);
    const ShownAction question = *labels().current();
    ASSERT_FALSE(question.anyByHand());
    const Label best = agreedLabel(labels().vocabulary(), question.byHand(), question.label());
    press(Qt::Key_Return);
    EXPECT_EQ(handLabel(question.fighter, question.peak), best);

    // What is proposed is what the numbers say: the second best is never likelier.
    int told = 0;
    for (const ShownAction& action : labels().actions()) {
        const auto most = probabilityOf(labels().vocabulary(), action, action.label());
        const Label next = secondBest(labels().vocabulary(), action);
        if (!most || action.anyByHand() || next.front() == kUnknown) continue;
        EXPECT_GE(*most, probabilityOf(labels().vocabulary(), action, next).value());
        told += *most > 0;
    }
    EXPECT_GT(told, 10);

    // One whose learnt aspects have two classes.
    const auto torn = std::find_if(
        labels().actions().begin(), labels().actions().end(), [&](const ShownAction& action) {
            const Label second = secondBest(labels().vocabulary(), action);
            return !action.anyByHand() && second.front() != kUnknown;
        });
    ASSERT_NE(torn, labels().actions().end());
    const ShownAction asked = *torn;
    const Label second = secondBest(labels().vocabulary(), asked);
    EXPECT_NE(second, agreedLabel(labels().vocabulary(), asked.byHand(), asked.label()));
    review().show(asked);
    press(Qt::Key_Backspace);
    EXPECT_EQ(handLabel(asked.fighter, asked.peak), second);
}

TEST_F(LabelTest, SeveralAreLabelledAsOneStep) {
    openDemo();
    session().setActivePlayer(0);
    labels().choose({{0, labels().actionsOf(0)[2].peak}});
    press(Qt::Key_Down, Qt::ShiftModifier);
    press(Qt::Key_Down, Qt::ShiftModifier);
    ASSERT_EQ(labels().chosen().size(), 3U);
    press(Qt::Key_1);
    EXPECT_EQ(document().history().position(), 1U);
    EXPECT_EQ(labels().progress().byHand, 3);
    press(Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_EQ(labels().chosen().size(), 2U) << "led back, the end is let go";
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(labels().progress().byHand, 0);
}

TEST_F(LabelTest, ABrushPaintsAsOneStep) {
    openDemo();
    session().setVisible({2, 6});
    review().setBrush(Brush{0, 0});
    const auto own = labels().actionsOf(0);
    std::vector<QPoint> path;
    for (const ShownAction& action : own) {
        const QRectF block = timeline().blockOf({0, action.peak});
        if (block.width() > 12) path.push_back(block.center().toPoint());
    }
    ASSERT_GT(path.size(), 2U);
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, path[0]);
    for (const QPoint& point : path)
        QTest::mouseMove(&timeline(), point);
    QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, path.back());
    EXPECT_EQ(labels().progress().byHand, int(path.size()));
    EXPECT_EQ(document().history().position(), 1U);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(labels().progress().byHand, 0);
}

TEST_F(LabelTest, LabelsSurviveBoundaryEdits) {
    openDemo();
    const auto actionsOf = [&] { return labels().actionsOf(0); };
    const ShownAction first = actionsOf()[4];
    const ShownAction second = actionsOf()[5];
    const std::vector<int> both = {labels().indexOf(first.fighter, first.peak),
                                   labels().indexOf(second.fighter, second.peak)};
    ASSERT_TRUE(labels().name(std::span(both).first(1), 0, 0));
    ASSERT_TRUE(labels().name(std::span(both).last(1), 1, 1));
    const Label one = handLabel(first.fighter, first.peak);
    const Label other = handLabel(second.fighter, second.peak);
    const std::size_t count = actionsOf().size();
    // Joined, the higher peak's label counts; parted again both are there.
    labels().choose({{0, first.peak}});
    press(Qt::Key_BracketRight, Qt::ControlModifier);
    settle();
    ASSERT_EQ(actionsOf().size(), count - 1);
    const Label joined = actionsOf()[4].byHand();
    EXPECT_TRUE(joined == one || joined == other);
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(handLabel(first.fighter, first.peak), one);
    EXPECT_EQ(handLabel(second.fighter, second.peak), other);
    // A boundary moved by some frames takes nothing away.
    session().goTo({0, session().actionOf({0, first.peak})->end});
    press(Qt::Key_Left, Qt::AltModifier);
    settle();
    EXPECT_EQ(actionsOf()[4].byHand(), one);
    EXPECT_EQ(actionsOf()[5].byHand(), other);
    waitUntilLearnt();
    EXPECT_EQ(labels().learnt()->examples.size(), 2U);
}

TEST_F(LabelTest, TheEmptyPanelSaysWhatToDo) {
    window_->commands().run("workspace.label");
    openBout();
    const auto texts = [&] {
        QString all;
        for (const auto* label : panel().findChildren<QLabel*>())
            all += label->text() + '\n';
        return all;
    };
    EXPECT_TRUE(texts().contains("Label a few actions by hand")) << texts().toStdString();
    EXPECT_TRUE(texts().contains("0 % labelled") || texts().contains("0\u00a0% labelled"));
    pressKeyOf("label.next");
    press(Qt::Key_1);
    EXPECT_TRUE(texts().contains("Go on")) << texts().toStdString();
}

}  // namespace
}  // namespace kumite::studio
