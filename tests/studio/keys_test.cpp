// Finding commands by what is typed, and giving them other keys.

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPrinter>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>

#include "studio/app/command_palette.h"
#include "studio/app/commands.h"
#include "studio/app/fuzzy_match.h"
#include "studio/app/key_bindings.h"
#include "studio/app/key_editor.h"
#include "studio/app/key_field.h"
#include "studio/app/keys_page.h"
#include "studio/timeline/timeline_view.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

TEST(FuzzyMatch, FindsLettersInOrderAndNothingElse) {
    EXPECT_TRUE(fuzzyMatch("", "Loop"));
    EXPECT_TRUE(fuzzyMatch("lop", "Loop"));
    EXPECT_FALSE(fuzzyMatch("pol", "Loop"));
    EXPECT_FALSE(fuzzyMatch("loops", "Loop"));
    EXPECT_FALSE(fuzzyMatch("ooo", "Loop"));
    EXPECT_TRUE(fuzzyMatch("PANELS hide", "Hide panels"));
    EXPECT_EQ(fuzzyMatch("ob", "Open a bout")->positions, (std::vector<int>{0, 7}));
    EXPECT_EQ(fuzzyMatch("lop", "Loop")->positions, (std::vector<int>{0, 2, 3}));
}

TEST(FuzzyMatch, PrefersBeginningsOfWordsAndRuns) {
    const auto score = [](const char* typed, const char* text) {
        return fuzzyMatch(typed, text)->score;
    };
    EXPECT_GT(score("sa", "Save as"), score("sa", "Loop ends at"));
    EXPECT_GT(score("loop", "Loop"), score("loop", "Leave open or pan"));
    EXPECT_GT(score("sa", "Swap actions"), score("sa", "Use a"));
}

/// A table of its own in a bare window with two workspaces and two parts.
class Bindings : public testing::Test {
protected:
    void SetUp() override {
        QSettings().remove("keys");
        const auto add = [this](const char* id, const char* key, QList<QWidget*> scopes = {}) {
            table_.add({id,
                        "Menu",
                        id,
                        {QKeySequence(key)},
                        [this, id] { ran_ = id; },
                        {},
                        {},
                        {},
                        std::move(scopes)});
        };
        add("everywhere", "Ctrl+G");
        add("inLeft", "X", {&left_});
        add("inRight", "X", {&right_});
        table_.addFor("label", [&] { add("label.accept", "Return"); });
        table_.addFor("bout", [&] { add("bout.hit", "Return"); });
        table_.showWorkspace("label");
    }
    void TearDown() override { QSettings().remove("keys"); }

    std::vector<QString> conflicts(const QString& id, const char* key) {
        std::vector<QString> ids;
        for (const Command* other : conflictsOf(table_, id, QKeySequence(key)))
            ids.push_back(other->id);
        return ids;
    }

    QWidget window_;
    QWidget left_{&window_};
    QWidget right_{&window_};
    QWidget insideLeft_{&left_};
    CommandTable table_{&window_};
    QString ran_;
};

TEST_F(Bindings, ConflictsRespectScopesAndWorkspaces) {
    EXPECT_TRUE(conflicts("inLeft", "X").empty());
    EXPECT_EQ(conflicts("everywhere", "X"), (std::vector<QString>{"inLeft", "inRight"}));
    EXPECT_TRUE(conflicts("label.accept", "Return").empty());
    EXPECT_EQ(conflicts("everywhere", "Return"),
              (std::vector<QString>{"label.accept", "bout.hit"}));
    EXPECT_EQ(conflicts("bout.hit", "Ctrl+G"), (std::vector<QString>{"everywhere"}));
    EXPECT_TRUE(conflicts("everywhere", "Ctrl+J").empty());
}

TEST_F(Bindings, WorkspacesShareAKeyAndOnlyTheShownOneHearsIt) {
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
    QApplication::setActiveWindow(&window_);
    QTest::keyClick(&window_, Qt::Key_Return);
    EXPECT_EQ(ran_, "label.accept");
    table_.showWorkspace("bout");
    QTest::keyClick(&window_, Qt::Key_Return);
    EXPECT_EQ(ran_, "bout.hit");
    EXPECT_FALSE(table_.isEnabled(*table_.find("label.accept")));
    EXPECT_FALSE(table_.action("label.accept")->isVisible());
}

TEST_F(Bindings, AreKeptAndLeaveNoTwoMeanings) {
    rebind(table_, "inLeft", {QKeySequence("Ctrl+G"), QKeySequence("Y")});
    // Another run: the same commands with the keys that the studio brings.
    table_.setKeys("inLeft", {QKeySequence("X")});
    table_.setKeys("everywhere", {QKeySequence("Ctrl+G")});
    loadKeys(table_);
    EXPECT_EQ(table_.find("inLeft")->keys,
              (QList<QKeySequence>{QKeySequence("Ctrl+G"), QKeySequence("Y")}));
    EXPECT_TRUE(table_.find("everywhere")->keys.isEmpty());
    resetKeys(table_, "everywhere");
    EXPECT_EQ(table_.find("everywhere")->keys, (QList<QKeySequence>{QKeySequence("Ctrl+G")}));
    EXPECT_EQ(table_.find("inLeft")->keys, (QList<QKeySequence>{QKeySequence("Y")}));
    resetKeys(table_);
    EXPECT_EQ(table_.find("inLeft")->keys, (QList<QKeySequence>{QKeySequence("X")}));
    EXPECT_FALSE(QSettings().contains("keys/inLeft"));
}

TEST(KeyOf, DropsTheShiftThatOnlyMakesTheSign) {
    EXPECT_EQ(keyOf(Qt::ShiftModifier, Qt::Key_Plus, "+"), QKeySequence("+"));
    EXPECT_EQ(keyOf(Qt::ShiftModifier, Qt::Key_S, "S"), QKeySequence("Shift+S"));
    EXPECT_EQ(keyOf(Qt::ShiftModifier, Qt::Key_Left, ""), QKeySequence("Shift+Left"));
    EXPECT_EQ(keyOf(Qt::ShiftModifier, Qt::Key_Backtab, ""), QKeySequence("Shift+Tab"));
    EXPECT_TRUE(keyOf(Qt::ControlModifier, Qt::Key_Control, "").isEmpty());
}

QLineEdit* paletteField(MainWindow& window) {
    return window.commandPalette().findChild<QLineEdit*>();
}

TEST_F(WindowTest, PaletteRunsACommandByItsName) {
    QSettings().remove("palette");
    openBout();
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(window_->commandPalette().isVisible());
    QLineEdit* field = paletteField(*window_);
    ASSERT_TRUE(field->hasFocus());
    // Letters are letters here, although S, A, L and K are keys of commands.
    QTest::keyClicks(field, "slak");
    EXPECT_EQ(field->text(), "slak");
    EXPECT_EQ(session().document().history().position(), 0U);
    field->selectAll();
    QTest::keyClicks(field, "pan hid");
    ASSERT_FALSE(window_->commandPalette().shownCommands().isEmpty());
    EXPECT_EQ(window_->commandPalette().shownCommands().front(), "view.panels");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FALSE(window_->commandPalette().isVisible());
    EXPECT_FALSE(window_->panelsShown());
    EXPECT_TRUE(timeline().hasFocus());
    // What was used lately comes first.
    press(Qt::Key_K, Qt::ControlModifier);
    EXPECT_EQ(window_->commandPalette().shownCommands().front(), "view.panels");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(window_->panelsShown());
}

TEST_F(WindowTest, PaletteKnowsTheWordsOfOtherPrograms) {
    QSettings().remove("palette");
    openBout();
    session().goTo(someBoundary(0));
    const std::vector<std::pair<const char*, const char*>> words = {
        {"reject", "review.reject"},        {"accept", "review.accept"},
        {"split", "boundary.add"},          {"cut", "boundary.add"},
        {"dark mode", "view.theme2"},       {"screenshot", "view.savePicture"},
        {"render", "view.savePicture"},     {"settings", "app.preferences"},
        {"shortcuts", "help.keys"},         {"csv", "file.export"},
        {"import", "file.openRecordings"},  {"comment", "action.note"},
        {"slow motion", "transport.slower"}};
    window_->commandPalette().open();
    for (const auto& [typed, id] : words) {
        paletteField(*window_)->setText(typed);
        const QStringList shown = window_->commandPalette().shownCommands();
        EXPECT_TRUE(shown.mid(0, 3).contains(id)) << typed << ": " << shown.join(' ').toStdString();
    }
    paletteField(*window_)->setText("delete");
    const QStringList shown = window_->commandPalette().shownCommands();
    for (const char* id : {"boundary.toggle", "review.reject", "take.remove"})
        EXPECT_TRUE(shown.contains(id)) << id;
    // What is called so comes before what others call so.
    const std::vector<std::pair<const char*, const char*>> names = {
        {"remove", "boundary.toggle"}, {"join", "boundary.mergeLeft"}, {"loop", "transport.loop"}};
    for (const auto& [typed, id] : names) {
        paletteField(*window_)->setText(typed);
        const QString first = window_->commandPalette().shownCommands().value(0);
        const Command* command = window_->commands().find(first);
        ASSERT_NE(command, nullptr) << typed;
        EXPECT_TRUE(command->plainText().contains(typed, Qt::CaseInsensitive)) << typed;
        EXPECT_TRUE(window_->commandPalette().shownCommands().contains(id)) << typed;
    }
}

TEST_F(WindowTest, PaletteIsLeftByEscapeAndOffersOnlyWhatCanBeDone) {
    press(Qt::Key_K, Qt::ControlModifier);
    EXPECT_FALSE(window_->commandPalette().shownCommands().contains("file.save"));
    EXPECT_TRUE(window_->commandPalette().shownCommands().contains("file.openProject"));
    QTest::keyClick(paletteField(*window_), Qt::Key_Escape);
    EXPECT_FALSE(window_->commandPalette().isVisible());
    openBout();
    press(Qt::Key_K, Qt::ControlModifier);
    EXPECT_TRUE(window_->commandPalette().shownCommands().contains("file.save"));
    QLineEdit* field = paletteField(*window_);
    auto* list = window_->commandPalette().findChild<QListWidget*>();
    QTest::keyClick(field, Qt::Key_Down);
    QTest::keyClick(field, Qt::Key_Down);
    EXPECT_EQ(list->currentRow(), 2);
    QTest::keyClick(field, Qt::Key_Up);
    EXPECT_EQ(list->currentRow(), 1);
    QTest::keyClicks(field, "zzzz");
    EXPECT_TRUE(window_->commandPalette().shownCommands().isEmpty());
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(window_->commandPalette().isVisible());
    QTest::keyClick(field, Qt::Key_Escape);
}

QPushButton* buttonOf(QWidget& parent, const QString& text) {
    for (auto* button : parent.findChildren<QPushButton*>()) {
        if (button->text() == text) return button;
    }
    return nullptr;
}

TEST_F(WindowTest, KeysAreTakenOverOnPurposeAndReset) {
    resetKeys(window_->commands());
    openBout();
    const BoundaryRef near = someBoundary(0);
    session().transport().setPlayhead(session().timeOf({0, near.frame + 10}));
    press(Qt::Key_Comma, Qt::ControlModifier);
    auto* editor = window_->findChild<KeyEditor*>();
    ASSERT_NE(editor, nullptr);
    editor->chooseCommand("view.panels");
    auto* field = editor->findChild<KeyField*>();
    // S adds a boundary: the conflict is named with that command.
    QTest::keyClick(field, Qt::Key_S);
    EXPECT_EQ(session().document().history().position(), 0U);
    bool named = false;
    for (const auto* label : editor->findChildren<QLabel*>())
        named = named || label->text().contains("Split here: add a boundary (Segment)");
    EXPECT_TRUE(named);
    QPushButton* take = buttonOf(*editor, "Take it over");
    ASSERT_NE(take, nullptr);
    take->click();
    QTest::qWait(20);
    EXPECT_TRUE(window_->commands().find("boundary.add")->keys.isEmpty());
    EXPECT_TRUE(window_->commands().find("view.panels")->keys.contains(QKeySequence("S")));
    // In force at once, in the window and on the sheet.
    press(Qt::Key_S);
    EXPECT_EQ(session().document().history().position(), 0U);
    EXPECT_FALSE(window_->panelsShown());
    for (const KeyGroup& group : keyGroups(window_->commands())) {
        for (const KeyGroup::Row& row : group.rows)
            EXPECT_NE(row.text, "Split here: add a boundary");
    }
    // And in the next window.
    MainWindow next;
    EXPECT_TRUE(next.commands().find("view.panels")->keys.contains(QKeySequence("S")));
    EXPECT_TRUE(next.commands().find("boundary.add")->keys.isEmpty());

    QPushButton* reset = buttonOf(*editor, "Reset all keys");
    ASSERT_NE(reset, nullptr);
    reset->click();
    press(Qt::Key_H);
    EXPECT_TRUE(window_->panelsShown());
    press(Qt::Key_S);
    EXPECT_EQ(session().document().history().position(), 1U);
}

TEST_F(WindowTest, AFreeKeyIsAssignedWithoutAQuestion) {
    resetKeys(window_->commands());
    openBout();
    window_->showPreferences(PreferencesDialog::KeysPage);
    auto* editor = window_->findChild<KeyEditor*>();
    editor->chooseCommand("fighter.swap");
    QTest::keyClick(editor->findChild<KeyField*>(), Qt::Key_F12);
    QPushButton* assign = buttonOf(*editor, "Assign");
    ASSERT_NE(assign, nullptr);
    ASSERT_TRUE(assign->isEnabled());
    assign->click();
    const Project before = session().document().project();
    press(Qt::Key_F12);
    EXPECT_EQ(session().document().project().takes[0].fighters[0], before.takes[0].fighters[1]);
    resetKeys(window_->commands());
}

TEST_F(WindowTest, SheetOfKeysIsSearchedAndSaved) {
    KeysPage page(window_->commands(), window_.get());
    const auto texts = [&] {
        QStringList all;
        for (const auto* label : page.findChildren<QLabel*>())
            all.append(label->text());
        return all;
    };
    EXPECT_TRUE(texts().contains("Save"));
    page.findChild<QLineEdit*>()->setText("loop");
    QTest::qWait(10);
    EXPECT_TRUE(texts().contains("Loop begins here"));
    EXPECT_FALSE(texts().contains("Save"));
    ASSERT_TRUE(page.saveTo(file("keys.pdf")));
    QFile pdf(file("keys.pdf"));
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    EXPECT_TRUE(pdf.read(5).startsWith("%PDF-"));
    EXPECT_FALSE(page.saveTo(file("nowhere/keys.pdf")));
    // On paper, too; the printer is a file here. All workspaces' keys, not those in force alone.
    QPrinter printer;
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(file("printed.pdf"));
    ASSERT_TRUE(page.printTo(printer));
    QFile printed(file("printed.pdf"));
    ASSERT_TRUE(printed.open(QIODevice::ReadOnly));
    const QByteArray paper = printed.readAll();
    EXPECT_TRUE(paper.startsWith("%PDF"));
    EXPECT_GT(paper.count("/Type /Page\n"), 1);
    const auto rows = [&](KeysOf which) {
        std::size_t count = 0;
        for (const KeyGroup& group : keyGroups(window_->commands(), which))
            count += group.rows.size();
        return count;
    };
    EXPECT_GT(rows(KeysOf::Everything), 2 * rows(KeysOf::ShownWorkspace));
}

}  // namespace
}  // namespace kumite::studio
