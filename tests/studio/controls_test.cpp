// Every control of every page has a name and a tip, the tip tells the key of what it does, and the
// keyboard reaches it.

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>

#include <set>

#include "studio/app/command_palette.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/focus_frame.h"
#include "studio/app/import/import_dialog.h"
#include "studio/app/message_strip.h"
#include "studio/app/recovery_dialog.h"
#include "studio/app/versions_dialog.h"
#include "studio/app/workspaces.h"
#include "studio/help/whats_this.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/label/label_exchange.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

/// Parts of Qt's own widgets, which their owners stand for.
bool isInner(const QWidget* widget) {
    if (widget->objectName().startsWith("qt_")) return true;
    // Tabs name themselves.
    if (qobject_cast<const QTabWidget*>(widget) || qobject_cast<const QTabBar*>(widget))
        return true;
    if (qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QHeaderView*>(widget) ||
        qobject_cast<const QLabel*>(widget)) {
        return true;
    }
    const QWidget* parent = widget->parentWidget();
    const auto* area = qobject_cast<const QAbstractScrollArea*>(parent);
    if (area != nullptr && area->viewport() == widget) return true;
    const bool ofQt =
        parent != nullptr && (parent->inherits("QTableView") || parent->inherits("QLineEdit") ||
                              parent->inherits("QTabBar"));
    return ofQt && qobject_cast<const QAbstractButton*>(widget) != nullptr;
}

std::string told(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return std::string(widget->metaObject()->className()) + " \"" +
           widget->accessibleName().toStdString() + "\" " +
           (button ? button->text().toStdString() : std::string()) + " of " +
           (widget->parentWidget() ? widget->parentWidget()->metaObject()->className() : "nothing");
}

class EveryControl : public WindowTest {
protected:
    static std::vector<QWidget*> controlsOf(QWidget* root) {
        std::vector<QWidget*> controls;
        for (QWidget* widget : root->findChildren<QWidget*>()) {
            if (!widget->isVisibleTo(root) || widget->window() != root || isInner(widget)) continue;
            const bool button = qobject_cast<QAbstractButton*>(widget) != nullptr;
            if (button || (widget->focusPolicy() & Qt::TabFocus)) controls.push_back(widget);
        }
        return controls;
    }

    void expectDescribed(QWidget* root) {
        for (QWidget* widget : controlsOf(root)) {
            SCOPED_TRACE(told(widget));
            const auto* button = qobject_cast<QAbstractButton*>(widget);
            const bool named =
                !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
            EXPECT_TRUE(named) << "has no name";
            if (qobject_cast<QScrollArea*>(widget) != nullptr) continue;
            EXPECT_FALSE(tipOf(widget).isEmpty()) << "has no tip";
            expectKeyTold(widget);
        }
    }

    static QString tipOf(QWidget* widget) {
        if (!widget->toolTip().isEmpty()) return widget->toolTip();
        // Over a drawn view a tip would hide what is under the pointer.
        if (!widget->accessibleDescription().isEmpty()) return widget->accessibleDescription();
        // The rows of a list have tips of their own.
        const auto* list = qobject_cast<QAbstractItemView*>(widget);
        if (list == nullptr || list->model() == nullptr) return {};
        return list->model()->index(0, 0).data(Qt::ToolTipRole).toString();
    }

    void expectKeyTold(QWidget* widget) {
        QString id = widget->property("command").toString();
        const auto* tool = qobject_cast<QToolButton*>(widget);
        if (tool && tool->defaultAction()) id = tool->defaultAction()->objectName();
        const Command* command = window_->commands().find(id);
        if (command == nullptr || command->keys.isEmpty()) return;
        const QString key = command->keys.front().toString(QKeySequence::NativeText);
        EXPECT_TRUE(widget->toolTip().endsWith('(' + key + ')'))
            << widget->toolTip().toStdString() << " does not tell " << key.toStdString();
    }

    /// By the key that goes back, since Tab has another meaning in the views.
    void expectReached(QWidget* root) {
        QApplication::setActiveWindow(root);
        const auto controls = controlsOf(root);
        ASSERT_FALSE(controls.empty());
        std::set<QWidget*> reached;
        controls.front()->setFocus();
        for (std::size_t i = 0; i < 3 * controls.size() + 60; ++i) {
            QWidget* now = root->focusWidget();
            ASSERT_NE(now, nullptr);
            reached.insert(now);
            if (now->focusProxy()) reached.insert(now->focusProxy());
            QTest::keyClick(now, Qt::Key_Backtab, Qt::ShiftModifier);
        }
        for (QWidget* widget : controls) {
            if (!widget->isEnabled()) continue;
            EXPECT_TRUE(reached.count(widget)) << told(widget) << " is not reached";
        }
    }

    void expectUsable(QWidget* root) {
        ASSERT_NE(root, nullptr);
        ASSERT_TRUE(root->isVisible());
        expectDescribed(root);
        expectReached(root);
    }

    template <typename Dialog>
    Dialog* shownDialog() {
        QTest::qWait(20);
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* dialog = qobject_cast<Dialog*>(widget);
            if (dialog != nullptr && dialog->isVisible()) return dialog;
        }
        return nullptr;
    }

    /// All pages of the first tab widget in it.
    void expectPagesUsable(QWidget* root) {
        ASSERT_NE(root, nullptr);
        auto* tabs = root->findChild<QTabWidget*>();
        ASSERT_NE(tabs, nullptr);
        for (int page = 0; page < tabs->count(); ++page) {
            SCOPED_TRACE(tabs->tabText(page).toStdString());
            tabs->setCurrentIndex(page);
            expectUsable(root);
        }
    }
};

TEST_F(EveryControl, OfTheWelcomePage) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    ASSERT_TRUE(window_->close());
    window_ = std::make_unique<MainWindow>();
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    expectUsable(window_.get());
}

TEST_F(EveryControl, OfTheWindow) {
    openBout();
    window_->commands().run("segment.compare");
    settle();
    session().goTo(someBoundary(0));
    window_->messages().showError("Something went wrong.");
    expectUsable(window_.get());
    // Another key, another tip.
    window_->commands().setKeys("review.accept", {QKeySequence("Ctrl+Alt+Y")});
    window_->commands().setKeys("review.reject", {QKeySequence("Ctrl+Alt+X")});
    window_->commands().setKeys("transport.play", {QKeySequence("Ctrl+Alt+P")});
    expectDescribed(window_.get());
}

/// All that a workspace shows once there is something to show says what it is.
TEST_F(EveryControl, OfEveryWorkspace) {
    window_->commands().run("file.openDemo");
    settle();
    ASSERT_TRUE(session().document().isOpen());
    window_->findChild<LabelExchange*>()->takeOver();
    settle();
    const auto look = [this](const QString& at) {
        settle();
        SCOPED_TRACE(at.toStdString());
        expectDescribed(window_.get());
        for (QWidget* widget : controlsOf(window_.get())) {
            SCOPED_TRACE(told(widget));
            const bool area = qobject_cast<QScrollArea*>(widget) != nullptr;
            EXPECT_TRUE(area || !whatsThisOf(*widget, window_->commands()).isEmpty());
        }
    };
    const QMap<QString, QStringList> states = {
        {"segment", {"segment.compare"}},
        {"label",
         {"label.page.similar", "label.page.quality", "label.page.rules", "label.page.compare",
          "label.find", "label.page.label"}},
        {"graph", {"graph.view", "graph.space", "graph.nextSurprise"}},
        {"bout", {"bout.avatar", "bout.passive", "bout.automatic"}},
        {"sequence", {"sequence.add", "sequence.map", "sequence.live"}},
        {"keyframe", {"keys.add", "keys.hit"}}};
    for (const Workspace& workspace : window_->workspaces().all()) {
        window_->workspaces().show(workspace.id);
        look(workspace.id);
        for (const QString& command : states[workspace.id]) {
            window_->commands().run(command);
            look(command);
        }
    }
}

TEST_F(EveryControl, ShowsThatTheKeyboardHasLedToIt) {
    openBout();
    auto* frame = timeline().findChild<FocusFrame*>();
    ASSERT_NE(frame, nullptr);
    window_->stage().setFocus();
    timeline().setFocus(Qt::BacktabFocusReason);
    EXPECT_TRUE(frame->isVisible());
    EXPECT_EQ(frame->geometry(), timeline().rect());
    click(timeline().rect().center());
    EXPECT_FALSE(frame->isVisible());
}

TEST_F(EveryControl, OfTheMenusOfTheViews) {
    openBout();
    for (auto* button : window_->findChildren<QToolButton*>()) {
        if (button->menu() == nullptr) continue;
        SCOPED_TRACE(button->accessibleName().toStdString());
        button->menu()->popup(button->mapToGlobal(QPoint()));
        expectDescribed(button->menu());
        button->menu()->close();
    }
}

TEST_F(EveryControl, OfThePalette) {
    openBout();
    window_->commandPalette().open();
    expectDescribed(window_.get());
    window_->commandPalette().dismiss();
}

TEST_F(EveryControl, OfThePagesBesideTheWindow) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    session().toggleBoundary(someBoundary(0));
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    window_->messages().showFindings("Found in a file", {{Severity::Note, "A remark."}});
    for (const char* id :
         {"help.open", "help.keys", "fighter.properties", "project.findings", "file.versions"}) {
        SCOPED_TRACE(id);
        window_->commands().run(id);
        settle();
        auto* dialog = shownDialog<QDialog>();
        expectUsable(dialog);
        if (dialog != nullptr) dialog->close();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    window_->commands().run("app.preferences");
    expectPagesUsable(shownDialog<QDialog>());
}

TEST_F(EveryControl, OfTheImportDialog) {
    window_->files().showImportDialog(recordings());
    auto* dialog = shownDialog<ImportDialog>();
    ASSERT_NE(dialog, nullptr);
    QTest::qWait(300);
    expectPagesUsable(dialog);
    dialog->reject();
}

TEST_F(EveryControl, OfTheRecoveryDialog) {
    RecoveryCopy copy;
    copy.name = "bout.kumite";
    copy.edits = 3;
    RecoveryDialog dialog({copy}, window_.get());
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    expectUsable(&dialog);
}

}  // namespace
}  // namespace kumite::studio
