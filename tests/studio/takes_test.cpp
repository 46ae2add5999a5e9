// Takes, fighters and the history in the left panel and the window of properties.

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QTest>

#include <numbers>

#include "studio/app/commands.h"
#include "studio/app/document_panel.h"
#include "studio/app/fighter_properties.h"
#include "studio/app/file_actions.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/app/takes_list.h"
#include "studio/timeline/timeline_view.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class TakesTest : public WindowTest {
protected:
    void openThree() {
        openBout();
        for (const char* name : {"second", "third"}) {
            TakeRequest request = requestFor({file("right.bvh")});
            request.name = name;
            window_->files().addBout(request);
            settle();
            settle();
        }
        ASSERT_EQ(names(), (QStringList{"left", "second", "third"}));
    }

    QStringList names() {
        QStringList all;
        for (const Take& take : session().document().project().takes)
            all.append(QString::fromStdString(take.name));
        return all;
    }
    QStringList shownNames() {
        QStringList all;
        for (int row = 0; row < list().count(); ++row)
            all.append(list().item(row)->text());
        return all;
    }
    TakesList& list() { return window_->documentPanel().takes(); }
    void undo() {
        press(Qt::Key_Z, Qt::ControlModifier);
        settle();
    }
};

TEST_F(TakesTest, RenamedWhereTheyStand) {
    openThree();
    session().setTake(1);
    press(Qt::Key_F2);
    auto* editor = list().findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClicks(editor, "Round two");
    QTest::keyClick(editor, Qt::Key_Return);
    settle();
    EXPECT_EQ(names(), (QStringList{"left", "Round two", "third"}));
    EXPECT_EQ(shownNames(), names());
    EXPECT_EQ(session().take(), 1);
    undo();
    EXPECT_EQ(names(), (QStringList{"left", "second", "third"}));
    EXPECT_EQ(shownNames(), names());

    // A name that is taken is refused in a sentence, and the list tells the truth.
    press(Qt::Key_F2);
    editor = list().findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, "third");
    QTest::keyClick(editor, Qt::Key_Return);
    settle();
    EXPECT_EQ(shownNames(), (QStringList{"left", "second", "third"}));
    EXPECT_TRUE(window_->messages().text().contains("third"));
}

TEST_F(TakesTest, ReorderedByKeysTheShownOneStaysShown) {
    openThree();
    session().setTake(0);
    session().transport().setPlayhead(3.0);
    press(Qt::Key_Down, Qt::AltModifier);
    settle();
    EXPECT_EQ(names(), (QStringList{"second", "left", "third"}));
    EXPECT_EQ(shownNames(), names());
    EXPECT_EQ(session().take(), 1);
    EXPECT_EQ(session().playerCount(), 2);
    EXPECT_NEAR(session().transport().playhead(), 3.0, 1e-9);
    EXPECT_NE(session().fighter(1), nullptr);
    press(Qt::Key_Up, Qt::AltModifier);
    settle();
    EXPECT_EQ(names(), (QStringList{"left", "second", "third"}));
    undo();
    EXPECT_EQ(session().take(), 1);
    EXPECT_EQ(session().playerCount(), 2);
    undo();
    EXPECT_EQ(session().take(), 0);
    press(Qt::Key_PageDown, Qt::ControlModifier);
    EXPECT_EQ(session().take(), 1);
    press(Qt::Key_PageUp, Qt::ControlModifier);
    EXPECT_EQ(session().take(), 0);
    // At the end of the list there is nothing to do.
    press(Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(names(), (QStringList{"left", "second", "third"}));
}

TEST_F(TakesTest, ReorderedByADrop) {
    openThree();
    list().setCurrentRow(0);
    // What does not come from the list itself is not taken for a take.
    const QRect last = list().visualItemRect(list().item(2));
    std::unique_ptr<QMimeData> data(list().model()->mimeData({list().model()->index(0, 0)}));
    QDropEvent foreign(QPointF(last.center().x(), last.bottom() - 1), Qt::MoveAction, data.get(),
                       Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(list().viewport(), &foreign);
    EXPECT_EQ(names(), (QStringList{"left", "second", "third"}));  // not from this list
    EXPECT_EQ(list().placeAt({last.center().x(), last.bottom() - 1}), 2);
    EXPECT_EQ(list().placeAt({last.center().x(), last.top() + 1}), 1);
    EXPECT_EQ(list().placeAt({last.center().x(), list().height() - 1}), 2);
    EXPECT_EQ(list().placeAt({last.center().x(), 2}), 0);
    list().moveTo(0, list().placeAt({last.center().x(), last.bottom() - 1}));
    settle();
    EXPECT_EQ(names(), (QStringList{"second", "third", "left"}));
    EXPECT_EQ(shownNames(), names());
    EXPECT_EQ(session().take(), 2);
    undo();
    EXPECT_EQ(names(), (QStringList{"left", "second", "third"}));
}

TEST_F(TakesTest, RemovedAndBroughtBack) {
    openThree();
    session().setTake(0);
    press(Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
    settle();
    EXPECT_EQ(names(), (QStringList{"second", "third"}));
    EXPECT_EQ(session().take(), 0);
    EXPECT_EQ(session().playerCount(), 1);
    EXPECT_NE(session().fighter(0), nullptr);
    undo();
    EXPECT_EQ(names(), (QStringList{"left", "second", "third"}));
    EXPECT_EQ(shownNames(), names());
    press(Qt::Key_Home);
    EXPECT_NE(session().fighter(0), nullptr);
}

TEST_F(TakesTest, FightersAreSwapped) {
    openBout();
    const Take before = session().document().project().takes[0];
    const auto left = session().marks(0);
    window_->commands().run("fighter.swap");
    settle();
    const Take& after = session().document().project().takes[0];
    EXPECT_EQ(after.fighters[0], before.fighters[1]);
    EXPECT_EQ(after.fighters[1], before.fighters[0]);
    EXPECT_EQ(session().marks(1).size(), left.size());
    undo();
    EXPECT_EQ(session().document().project().takes[0], before);
}

TEST_F(TakesTest, AClickInTheHistoryGoesThere) {
    openBout();
    for (int i = 0; i < 3; ++i) {
        session().toggleBoundary(someBoundary(i % 2));
        settle();
    }
    QAbstractItemView* history = nullptr;
    for (auto* view : window_->documentPanel().findChildren<QAbstractItemView*>()) {
        if (view->accessibleName() == "History") history = view;
    }
    ASSERT_NE(history, nullptr);
    ASSERT_EQ(history->model()->rowCount(), 4);
    EXPECT_EQ(history->currentIndex().row(), 3);
    const auto clickRow = [&](int row) {
        QTest::mouseClick(history->viewport(), Qt::LeftButton, {},
                          history->visualRect(history->model()->index(row, 0)).center());
        settle();
    };
    clickRow(0);
    EXPECT_EQ(session().document().history().position(), 0U);
    EXPECT_FALSE(session().document().isModified());
    EXPECT_EQ(history->model()->rowCount(), 4);
    clickRow(2);
    EXPECT_EQ(session().document().history().position(), 2U);
    const QString told = history->model()->index(3, 0).data(Qt::AccessibleTextRole).toString();
    EXPECT_TRUE(told.contains("undone")) << told.toStdString();
    // A new edit drops what was undone.
    session().transport().setPlayhead(session().timeOf({0, someBoundary(0).frame + 10}));
    session().addBoundaryAtPlayhead();
    settle();
    EXPECT_EQ(history->model()->rowCount(), 4);
    EXPECT_EQ(history->currentIndex().row(), 3);
}

class PropertiesTest : public TakesTest {
protected:
    void openProperties() {
        openBout();
        press(Qt::Key_I, Qt::ControlModifier);
        page_ = window_->findChild<FighterProperties*>();
        ASSERT_NE(page_, nullptr);
    }
    template <typename Field>
    Field* field(const QString& name) {
        for (auto* each : page_->findChildren<Field*>()) {
            if (each->accessibleName() == name) return each;
        }
        ADD_FAILURE() << name.toStdString();
        return nullptr;
    }
    const Fighter& fighterNow(int player) {
        return session().document().project().takes[0].fighters[static_cast<std::size_t>(player)];
    }
    std::size_t steps() { return session().document().history().position(); }

    FighterProperties* page_ = nullptr;
};

TEST_F(PropertiesTest, StartFollowsTheKeysAndIsOneStep) {
    openProperties();
    session().setActivePlayer(1);
    auto* start = field<QDoubleSpinBox>("Start in seconds");
    start->setFocus();
    for (int i = 0; i < 6; ++i)
        QTest::keyClick(start, Qt::Key_Up);
    settle();
    EXPECT_NEAR(fighterNow(1).offset, 0.1, 2e-3);
    EXPECT_NEAR(session().transport().span().end, 599 / 60.0 + fighterNow(1).offset, 1e-6);
    EXPECT_EQ(steps(), 1U);
    undo();
    EXPECT_DOUBLE_EQ(fighterNow(1).offset, 0);
    EXPECT_DOUBLE_EQ(start->value(), 0);
    EXPECT_NEAR(session().transport().span().end, 599 / 60.0, 1e-9);
}

TEST_F(PropertiesTest, PlaceAndTurnAreSeparateValues) {
    openProperties();
    field<QDoubleSpinBox>("x in metres")->setValue(1.25);
    field<QDoubleSpinBox>("Turn in degrees")->setValue(90);
    EXPECT_EQ(fighterNow(0).placement, (Placement{1.25, 0, std::numbers::pi / 2}));
    EXPECT_EQ(steps(), 1U);
    field<QDoubleSpinBox>("Start in seconds")->setValue(0.5);
    EXPECT_EQ(steps(), 2U);
    undo();
    undo();
    EXPECT_EQ(fighterNow(0).placement, Placement{});
    EXPECT_EQ(field<QDoubleSpinBox>("x in metres")->value(), 0);
}

TEST_F(PropertiesTest, FloorIsFoundOrSet) {
    openProperties();
    QCheckBox* found = page_->findChild<QCheckBox*>();
    ASSERT_TRUE(found->isChecked());
    auto* height = field<QDoubleSpinBox>("Height of the floor in metres");
    EXPECT_FALSE(height->isEnabled());
    found->click();
    ASSERT_TRUE(fighterNow(0).floor.has_value());
    EXPECT_TRUE(height->isEnabled());
    height->setValue(0.25);
    settle();
    EXPECT_DOUBLE_EQ(*fighterNow(0).floor, 0.25);
    EXPECT_DOUBLE_EQ(session().fighter(0)->body->floor, 0.25);
    found->click();
    EXPECT_FALSE(fighterNow(0).floor.has_value());
}

TEST_F(PropertiesTest, RolesAndBodyModelAreChosen) {
    openProperties();
    auto* head = field<QComboBox>("Joint of the role head");
    const auto was = fighterNow(0).roles[Role::Head];
    ASSERT_TRUE(was.has_value());
    EXPECT_EQ(head->currentIndex(), *was + 1);
    QApplication::setActiveWindow(page_);
    head->setFocus();
    QTest::keyClick(head, Qt::Key_Home);
    EXPECT_FALSE(fighterNow(0).roles.has(Role::Head));
    undo();
    EXPECT_EQ(fighterNow(0).roles[Role::Head], was);
    EXPECT_EQ(head->currentIndex(), *was + 1);

    const auto before = session().fighter(0)->body->com.position;
    auto* model = field<QComboBox>("Body model");
    QApplication::setActiveWindow(page_);
    model->setFocus();
    QTest::keyClick(model, Qt::Key_Down);
    settle();
    EXPECT_TRUE(session().document().project().bodyModel.name.find("female") != std::string::npos);
    EXPECT_NE(session().fighter(0)->body->com.position, before);
    undo();
    EXPECT_EQ(session().document().project().bodyModel, deLevaMale());
    EXPECT_EQ(model->currentIndex(), 0);
}

TEST_F(PropertiesTest, FollowsTheActiveFighterAndItsKeysUndo) {
    openProperties();
    session().setActivePlayer(1);
    field<QDoubleSpinBox>("z in metres")->setValue(2);
    EXPECT_DOUBLE_EQ(fighterNow(1).placement.z, 2);
    EXPECT_DOUBLE_EQ(fighterNow(0).placement.z, 0);
    QApplication::setActiveWindow(page_);
    auto* z = field<QDoubleSpinBox>("z in metres");
    z->setFocus();
    QTest::keyClick(z, Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_DOUBLE_EQ(fighterNow(1).placement.z, 0);
}

}  // namespace
}  // namespace kumite::studio
