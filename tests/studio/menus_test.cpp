// Context menus of views and lists, and the welcome page by keys.

#include <QApplication>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <QWindow>

#include "studio/app/commands.h"
#include "studio/app/document_panel.h"
#include "studio/app/file_actions.h"
#include "studio/app/takes_list.h"
#include "studio/app/welcome_page.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/picking.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/segment/segment_panel.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class ContextMenus : public WindowTest {
protected:
    void TearDown() override {
        closeMenu();
        WindowTest::TearDown();
    }

    /// As the window system sends it: the window finds out for whom a menu is asked.
    void rightClick(QWidget* widget, const QPoint& at) {
        closeMenu();
        QTest::mouseClick(window_->windowHandle(), Qt::RightButton, Qt::NoModifier,
                          widget->mapTo(window_.get(), at));
        QTest::qWait(20);
    }

    void pressMenuKey(QWidget* widget) {
        closeMenu();
        QContextMenuEvent event(QContextMenuEvent::Keyboard, {},
                                widget->mapToGlobal(widget->rect().center()));
        QApplication::sendEvent(widget, &event);
        QTest::qWait(20);
    }

    static QMenu* menu() { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); }

    static void closeMenu() {
        if (menu()) menu()->close();
    }

    /// Ids of the commands in the menu that is open.
    static QStringList offered() {
        QStringList ids;
        if (menu() == nullptr) return ids;
        for (const QAction* action : menu()->actions()) {
            if (!action->isSeparator() && action->isVisible()) ids.append(action->objectName());
        }
        return ids;
    }

    /// Takes an entry with the mouse.
    void take(const QString& id) {
        ASSERT_NE(menu(), nullptr);
        QAction* action = window_->commands().action(id);
        ASSERT_TRUE(menu()->actions().contains(action)) << id.toStdString();
        QTest::mouseClick(menu(), Qt::LeftButton, {}, menu()->actionGeometry(action).center());
        settle();
    }
};

TEST_F(ContextMenus, OfABoundarySelectItAndActOnIt) {
    openBout();
    const BoundaryRef boundary = someBoundary(1);
    session().setActivePlayer(0);
    rightClick(&timeline(), timeline().pointOf(boundary).toPoint());
    EXPECT_EQ(session().selection(), boundary);
    EXPECT_EQ(session().activePlayer(), 1);
    EXPECT_TRUE(offered().contains("review.accept"));
    EXPECT_FALSE(offered().contains("action.loop"));
    take("boundary.toggle");
    EXPECT_EQ(mark(boundary)->state, MarkState::Removed);
}

TEST_F(ContextMenus, OfAnActionSelectItAndActOnIt) {
    openBout();
    const auto action = session().actionAt(0, 200);
    ASSERT_TRUE(action);
    rightClick(&timeline(), timeline().blockOf(*action).center().toPoint());
    EXPECT_EQ(session().selectedAction(), action);
    EXPECT_TRUE(offered().contains("action.note"));
    EXPECT_FALSE(offered().contains("boundary.toggle"));
    take("action.loop");
    const TimeSpan span = session().spanOf(*action);
    EXPECT_DOUBLE_EQ(session().transport().loopIn().value_or(-1), span.begin);
    EXPECT_DOUBLE_EQ(session().transport().loopOut().value_or(-1), span.end);
}

TEST_F(ContextMenus, OfTheRulerActWhereThePointerIs) {
    openBout();
    const QPoint at(timeline().width() / 2, static_cast<int>(timeline().ruler().center().y()));
    rightClick(&timeline(), at);
    const double there = timeline().mapping().timeAt(at.x());
    EXPECT_NEAR(session().transport().playhead(), there, 1e-9);
    take("loop.in");
    EXPECT_NEAR(session().transport().loopIn().value_or(-1), there, 1e-9);
}

TEST_F(ContextMenus, ByKeyAreThoseOfWhatIsSelected) {
    openBout();
    session().goTo(someBoundary(0));
    pressMenuKey(&timeline());
    EXPECT_TRUE(offered().contains("boundary.toggle"));
    session().select(std::nullopt);
    pressMenuKey(&timeline());
    EXPECT_TRUE(offered().contains("action.loop"));
    pressMenuKey(&window_->stage());
    EXPECT_TRUE(offered().contains("fighter.properties"));
}

TEST_F(ContextMenus, OfTheStageKnowTheFighterUnderThePointer) {
    openBout();
    StageView& stage = window_->stage();
    session().setActivePlayer(0);
    const auto& roles = session().fighter(1)->input.roles;
    const auto at = stage.jointPosition({1, *roles[Role::Chest]});
    ASSERT_TRUE(at);
    rightClick(&stage, at->toPoint());
    EXPECT_EQ(session().activePlayer(), 1);
    EXPECT_TRUE(offered().contains("view.shoulder2"));
    EXPECT_FALSE(offered().contains("view.savePicture"));
    rightClick(&stage, QPoint(12, 12));
    EXPECT_EQ(session().activePlayer(), 1);
    EXPECT_TRUE(offered().contains("view.savePicture"));
    take("view.contacts");
    EXPECT_FALSE(stage.overlays().contacts);
    // A drag with the right button turns, and asks for nothing.
    QTest::mousePress(&stage, Qt::RightButton, {}, {40, 40});
    QTest::mouseMove(&stage, {90, 60});
    QTest::mouseRelease(&stage, Qt::RightButton, {}, {90, 60});
    EXPECT_EQ(menu(), nullptr);
}

TEST_F(ContextMenus, OfListsActOnTheRowUnderThePointer) {
    openBout();
    auto* table = window_->findChild<SegmentPanel*>()->findChild<QTableView*>();
    ASSERT_NE(table, nullptr);
    const QModelIndex third = table->model()->index(2, 0);
    rightClick(table->viewport(), table->visualRect(third).center());
    EXPECT_EQ(table->currentIndex().row(), 2);
    ASSERT_TRUE(session().selection());
    const BoundaryRef chosen = *session().selection();
    take("review.reject");
    EXPECT_EQ(mark(chosen)->state, MarkState::Removed);

    auto* history = window_->documentPanel().findChild<QListView*>(QStringLiteral("history"));
    ASSERT_NE(history, nullptr);
    ASSERT_EQ(session().document().history().position(), 1U);
    rightClick(history->viewport(), history->visualRect(history->model()->index(0, 0)).center());
    // Asking for the menu does not go back to that state.
    EXPECT_EQ(session().document().history().position(), 1U);
    take("edit.undo");
    EXPECT_EQ(session().document().history().position(), 0U);

    TakesList& takes = window_->documentPanel().takes();
    rightClick(takes.viewport(), takes.visualItemRect(takes.item(0)).center());
    EXPECT_TRUE(offered().contains("take.rename"));
}

TEST_F(ContextMenus, ShowTheKeysOfTheirCommands) {
    openBout();
    session().goTo(someBoundary(0));
    pressMenuKey(&timeline());
    ASSERT_NE(menu(), nullptr);
    for (const QAction* action : menu()->actions()) {
        if (action->isSeparator()) continue;
        const Command* command = window_->commands().find(action->objectName());
        ASSERT_NE(command, nullptr);
        EXPECT_EQ(action->text(), command->text);
        EXPECT_EQ(action->shortcuts(), command->keys);
        EXPECT_TRUE(action->isShortcutVisibleInContextMenu());
    }
}

class Welcome : public WindowTest {
protected:
    QString focused() {
        const auto* button = qobject_cast<QPushButton*>(QApplication::focusWidget());
        return button == nullptr          ? QString()
               : button->text().isEmpty() ? button->accessibleName()
                                          : button->text();
    }
    void key(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }

    void restart() {
        ASSERT_TRUE(window_->close());
        window_ = std::make_unique<MainWindow>();
        window_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
        QApplication::setActiveWindow(window_.get());
    }
};

TEST_F(Welcome, ArrowKeysLeadFromChoiceToChoiceAndReturnTakesOne) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("first.kumite")));
    ASSERT_TRUE(window_->files().saveTo(file("second.kumite")));
    restart();
    EXPECT_EQ(focused(), "Open the demo bout");
    key(Qt::Key_Down);
    EXPECT_EQ(focused(), "Open recordings…");
    key(Qt::Key_Up);
    key(Qt::Key_Up);
    EXPECT_EQ(focused(), "Tour on the demo bout");
    key(Qt::Key_Home);
    EXPECT_EQ(focused(), "Open the demo bout");
    key(Qt::Key_Right);
    EXPECT_TRUE(focused().startsWith("Open second.kumite")) << focused().toStdString();
    key(Qt::Key_Down);
    EXPECT_TRUE(focused().startsWith("Open first.kumite")) << focused().toStdString();
    key(Qt::Key_Return);
    settle();
    EXPECT_EQ(session().document().name(), "first.kumite");
}

TEST_F(Welcome, ReturnTakesTheMarkedStep) {
    restart();
    bool asked = false;
    QObject::connect(window_->commands().action("file.openDemo"), &QAction::triggered,
                     window_.get(), [&] { asked = true; });
    key(Qt::Key_Return);
    settle();
    EXPECT_TRUE(asked);
    EXPECT_TRUE(session().document().isOpen());
}

}  // namespace
}  // namespace kumite::studio
