// Every command of the table, run once on nothing, on a bout and on a project without takes.

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTimer>

#include <map>

#include "studio/app/command_palette.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/key_bindings.h"
#include "studio/app/keys_page.h"
#include "studio/app/workspaces.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class EveryCommand : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        // Whatever asks a question is told no.
        connection_ = QObject::connect(&refuser_, &QTimer::timeout, [] {
            if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
                dialog->reject();
            }
        });
        refuser_.start(20);
    }

    void TearDown() override {
        QObject::disconnect(connection_);
        WindowTest::TearDown();
    }

    std::vector<QString> ids() {
        std::vector<QString> found;
        for (const Command& command : window_->commands().commands()) {
            // These leave what is open; tests of their own run them.
            const bool leaves = command.id == "file.quit" || command.id == "file.openDemo" ||
                                command.id == "help.tour";
            if (!leaves) found.push_back(command.id);
        }
        return found;
    }

    void closePages() {
        window_->commandPalette().dismiss();
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (widget->parentWidget() == window_.get() && qobject_cast<QDialog*>(widget)) {
                widget->close();
            }
        }
        if (window_->isFullScreen()) window_->showNormal();
    }

    void expectValid() {
        const Document& document = session().document();
        const auto takes = static_cast<int>(document.project().takes.size());
        EXPECT_GE(session().take(), 0);
        EXPECT_LT(session().take(), std::max(1, takes));
        EXPECT_LE(document.history().position(), document.history().steps().size());
        const TimeSpan span = session().transport().span();
        EXPECT_GE(session().transport().playhead(), span.begin);
        EXPECT_LE(session().transport().playhead(), std::max(span.begin, span.end));
        if (session().playerCount() > 0) {
            EXPECT_LT(session().activePlayer(), session().playerCount());
            EXPECT_NE(session().fighter(session().activePlayer()), nullptr);
        }
        EXPECT_FALSE(window_->grab().isNull());
    }

    QTimer refuser_;
    QMetaObject::Connection connection_;
};

TEST_F(EveryCommand, OnNothing) {
    for (const QString& id : ids()) {
        SCOPED_TRACE(id.toStdString());
        window_->commands().run(id);
        settle();
        EXPECT_FALSE(session().document().isOpen());
        expectValid();
        closePages();
    }
}

TEST_F(EveryCommand, OnABout) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    const Project before = session().document().project();
    for (const QString& id : ids()) {
        SCOPED_TRACE(id.toStdString());
        session().goTo(someBoundary(0));
        window_->commands().run(id);
        settle();
        ASSERT_TRUE(session().document().isOpen());
        expectValid();
        closePages();
        session().transport().setPlaying(false);
        // What was edited can be undone, whatever it was.
        while (session().document().history().canUndo())
            session().document().undo();
        settle();
        ASSERT_EQ(session().document().project(), before);
        expectValid();
    }
}

TEST_F(EveryCommand, OnAProjectWithoutTakes) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    for (const QString& id : ids()) {
        SCOPED_TRACE(id.toStdString());
        window_->commands().run("take.remove");
        settle();
        ASSERT_TRUE(session().document().project().takes.empty());
        window_->commands().run(id);
        settle();
        expectValid();
        closePages();
        session().document().goToStep(0);
        settle();
        ASSERT_NE(session().fighter(0), nullptr);
    }
}

TEST_F(EveryCommand, HasItsKeysToItself) {
    for (const Command& command : window_->commands().commands()) {
        for (const QKeySequence& key : command.keys) {
            for (const Command* other : conflictsOf(window_->commands(), command.id, key)) {
                ADD_FAILURE() << key.toString().toStdString() << " means "
                              << command.id.toStdString() << " and " << other->id.toStdString();
            }
        }
    }
}

TEST_F(EveryCommand, IsNotHiddenByTheLetterOfAMenu) {
    std::map<QString, QString> letters;
    for (const QAction* menu : window_->menuBar()->actions()) {
        const QKeySequence letter = QKeySequence::mnemonic(menu->text());
        ASSERT_FALSE(letter.isEmpty()) << menu->text().toStdString();
        const bool first = letters.emplace(letter.toString(), menu->text()).second;
        EXPECT_TRUE(first) << menu->text().toStdString();
    }
    for (const Command& command : window_->commands().commands()) {
        for (const QKeySequence& key : command.keys)
            EXPECT_EQ(letters.count(key.toString()), 0U) << command.id.toStdString();
    }
}

TEST_F(EveryCommand, StandsInThePaletteAndOnTheSheetOfKeysOfItsWorkspace) {
    openBout();
    for (const Workspace& workspace : window_->workspaces().all()) {
        window_->workspaces().show(workspace.id);
        settle();
        window_->commandPalette().open();
        const QStringList offered = window_->commandPalette().shownCommands();
        QStringList sheet;
        for (const KeyGroup& group : keyGroups(window_->commands())) {
            for (const KeyGroup::Row& row : group.rows)
                sheet.append(group.title + row.text + row.keys);
        }
        for (const Command& command : window_->commands().commands()) {
            SCOPED_TRACE((workspace.id + ' ' + command.id).toStdString());
            // A menu of its own and the palette itself cannot be run from the palette.
            const bool runs = window_->commands().action(command.id)->menu() == nullptr &&
                              command.id != "app.palette";
            if (runs && window_->commands().isEnabled(command)) {
                EXPECT_TRUE(offered.contains(command.id));
            }
            if (command.keys.isEmpty()) continue;
            EXPECT_EQ(
                sheet.contains(command.plainMenu() + command.plainText() + command.keysText()),
                command.isOf(workspace.id));
        }
        window_->commandPalette().hide();
    }
}

TEST_F(EveryCommand, CanBeFoundAndHasATip) {
    for (const Command& command : window_->commands().commands()) {
        SCOPED_TRACE(command.id.toStdString());
        EXPECT_FALSE(command.plainText().contains('&'));
        EXPECT_FALSE(command.plainMenu().isEmpty());
        EXPECT_TRUE(command.run);
        const QString tip = window_->commands().action(command.id)->toolTip();
        if (!command.keys.isEmpty()) {
            EXPECT_TRUE(tip.contains(command.keys.front().toString())) << tip.toStdString();
        }
    }
}

}  // namespace
}  // namespace kumite::studio
