// The window's frame: keys that work everywhere, preferences, layout, notes, workspaces, welcome.

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QSplitter>
#include <QStackedWidget>
#include <QTest>
#include <QToolButton>

#include "studio/app/commands.h"
#include "studio/app/document_panel.h"
#include "studio/app/file_actions.h"
#include "studio/app/findings_page.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/app/recent_files.h"
#include "studio/app/welcome_page.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

TEST_F(WindowTest, KeysOfPlaybackDoWhatHandsExpect) {
    openBout();
    Transport& transport = session().transport();
    press(Qt::Key_End);
    EXPECT_DOUBLE_EQ(transport.playhead(), transport.span().end);
    press(Qt::Key_Home);
    EXPECT_DOUBLE_EQ(transport.playhead(), transport.span().begin);
    press(Qt::Key_Period);
    EXPECT_EQ(session().shownFrame(0), 1);
    press(Qt::Key_Comma);
    EXPECT_EQ(session().shownFrame(0), 0);
    press(Qt::Key_L);
    press(Qt::Key_L);
    EXPECT_TRUE(transport.isPlaying());
    EXPECT_DOUBLE_EQ(transport.speed(), 2);
    press(Qt::Key_J);
    EXPECT_DOUBLE_EQ(transport.speed(), -1);
    press(Qt::Key_K);
    EXPECT_FALSE(transport.isPlaying());
    // 10 % to 400 %, and no further.
    for (int i = 0; i < 12; ++i)
        press(Qt::Key_Minus);
    EXPECT_DOUBLE_EQ(transport.speed(), 0.1);
    for (int i = 0; i < 12; ++i)
        press(Qt::Key_Plus);
    EXPECT_DOUBLE_EQ(transport.speed(), 4);
    press(Qt::Key_L, Qt::ControlModifier);
    EXPECT_TRUE(transport.isLooping());
}

TEST_F(WindowTest, KeysOfTheWindowDoWhatHandsExpect) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    session().toggleBoundary(someBoundary(0));
    ASSERT_TRUE(session().document().isModified());
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_FALSE(session().document().isModified());
    press(Qt::Key_F11);
    EXPECT_TRUE(window_->isFullScreen());
    press(Qt::Key_F11);
    EXPECT_FALSE(window_->isFullScreen());
    const int before = window_->stage().width();
    press(Qt::Key_H);
    EXPECT_FALSE(window_->documentPanel().isVisible());
    EXPECT_TRUE(QTest::qWaitFor([&] { return window_->stage().width() > before; }));
    press(Qt::Key_H);
    EXPECT_TRUE(window_->documentPanel().isVisible());
}

TEST_F(WindowTest, UndoInAFieldOfANumberUndoesTheEdit) {
    openBout();
    QDoubleSpinBox* field = nullptr;
    for (auto* each : window_->findChildren<QDoubleSpinBox*>()) {
        if (each->accessibleName() == "Cutoff of the low-pass in Hz") field = each;
    }
    ASSERT_NE(field, nullptr);
    const double before = field->value();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "3");
    QTest::keyClick(field, Qt::Key_Return);
    settle();
    ASSERT_EQ(session().document().history().position(), 1U);
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(session().document().history().position(), 0U);
    EXPECT_DOUBLE_EQ(field->value(), before);
}

TEST_F(WindowTest, PreferencesTakeEffectAtOnceAndAreKept) {
    window_->preferences().set({});
    openBout();
    press(Qt::Key_Comma, Qt::ControlModifier);
    auto* dialog = window_->findChild<PreferencesDialog*>();
    ASSERT_NE(dialog, nullptr);
    for (auto* box : dialog->findChildren<QSpinBox*>()) {
        if (box->accessibleName() == "Frames of a leap") box->setValue(25);
        if (box->accessibleName() == "Autosave interval in seconds") box->setValue(7);
    }
    press(Qt::Key_Home);
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(session().shownFrame(0), 25);
    EXPECT_EQ(window_->commands().find("transport.onTen")->text, "25 frames on");
    for (auto* box : dialog->findChildren<QComboBox*>()) {
        if (box->accessibleName() != "Theme") continue;
        box->setCurrentIndex(static_cast<int>(ThemeChoice::Light));
        EXPECT_FALSE(coloursFor(window_->QWidget::palette()).dark);
        box->setCurrentIndex(static_cast<int>(ThemeChoice::Dark));
        EXPECT_TRUE(coloursFor(window_->QWidget::palette()).dark);
    }
    PreferenceValues values = window_->preferences().values();
    EXPECT_EQ(values.autosaveSeconds, 7);
    values.playbackSpeed = 0.5;
    values.looping = true;
    values.mouseSpeed = 2;
    window_->preferences().set(values);
    EXPECT_EQ(Preferences().values(), values);
    window_->files().openBout(requestFor({file("left.bvh")}), false);
    settle();
    EXPECT_DOUBLE_EQ(session().transport().speed(), 0.5);
    EXPECT_TRUE(session().transport().isLooping());
    // What a damaged settings file says is brought into range.
    QSettings().setValue("leapFrames", -3);
    QSettings().setValue("mouseSpeed", "nan");
    QSettings().setValue("theme", 77);
    EXPECT_EQ(Preferences().values().leapFrames, 2);
    EXPECT_DOUBLE_EQ(Preferences().values().mouseSpeed, 1);
    EXPECT_EQ(Preferences().values().theme, ThemeChoice::Dark);
    window_->preferences().set({ThemeChoice::Dark});
    QSettings().setValue("leapFrames", 10);
    QSettings().setValue("mouseSpeed", 1.0);
    QSettings().setValue("theme", static_cast<int>(ThemeChoice::Dark));
}

TEST_F(WindowTest, LayoutIsRestored) {
    openBout();
    auto* columns = qobject_cast<QSplitter*>(window_->documentPanel().parentWidget());
    ASSERT_NE(columns, nullptr);
    // Somebody drags the handle beside the left panel.
    QWidget* handle = columns->handle(1);
    const int before = window_->documentPanel().width();
    QTest::mousePress(handle, Qt::LeftButton, {}, handle->rect().center());
    QTest::mouseMove(handle, handle->rect().center() + QPoint(60, 0));
    QTest::mouseRelease(handle, Qt::LeftButton, {}, handle->rect().center() + QPoint(60, 0));
    const int wide = window_->documentPanel().width();
    ASSERT_GT(wide, before + 40);
    window_->resize(1400, 900);
    QTest::qWait(30);
    const int timelineHeight = timeline().height();
    ASSERT_TRUE(window_->close());

    window_ = std::make_unique<MainWindow>();
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    openBout();
    EXPECT_EQ(window_->size(), QSize(1400, 900));
    EXPECT_NEAR(window_->documentPanel().width(), wide, 2);
    EXPECT_NEAR(timeline().height(), timelineHeight, 2);
    press(Qt::Key_H);
    ASSERT_TRUE(window_->close());

    window_ = std::make_unique<MainWindow>();
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    openBout();
    EXPECT_FALSE(window_->documentPanel().isVisible());
    press(Qt::Key_H);
    EXPECT_TRUE(window_->documentPanel().isVisible());
    EXPECT_NEAR(window_->documentPanel().width(), wide, 2);
    for (const char* key : {"geometry", "layout", "panels"})
        QSettings().remove(key);
}

TEST_F(WindowTest, NotesAreCountedAndListed) {
    openBout();
    const int before = window_->findings().count();
    window_->messages().showFindings("Found in a file", {{Severity::Note, "A quiet remark."}});
    // No message for what is no warning, but it can be read.
    EXPECT_TRUE(window_->messages().text().isEmpty());
    EXPECT_EQ(window_->findings().count(), before + 1);
    window_->commands().run("project.findings");
    auto* page = window_->findChild<FindingsPage*>();
    ASSERT_NE(page, nullptr);
    const auto texts = [&] {
        QStringList all;
        for (const auto* label : page->findChildren<QLabel*>())
            all.append(label->text());
        return all;
    };
    EXPECT_TRUE(texts().contains("A quiet remark."));
    EXPECT_TRUE(texts().contains("Found in a file"));
    window_->messages().showFindings("Found in a file", {{Severity::Warning, "Mind this."}});
    EXPECT_EQ(window_->messages().text(), "Mind this.");
    EXPECT_TRUE(texts().contains("Mind this."));
    window_->files().openBout(requestFor({file("left.bvh")}), false);
    settle();
    EXPECT_FALSE(texts().contains("A quiet remark."));
}

TEST_F(WindowTest, WorkspacesAreTabsAndCommands) {
    EXPECT_EQ(window_->workspaces().current(), "segment");
    auto* bar = window_->menuBar()->findChild<WorkspaceBar*>();
    ASSERT_NE(bar, nullptr);
    EXPECT_EQ(std::size_t(bar->findChildren<QToolButton*>().size()),
              window_->workspaces().all().size());
    window_->commands().run("workspace.graph");
    EXPECT_EQ(window_->workspaces().current(), "graph");
}

TEST(Workspaces, RegisterThemselvesWithPanelCommandsAndKeys) {
    QWidget window;
    CommandTable table(&window);
    QStackedWidget panels(&window);
    QStackedWidget centres(&window);
    Workspaces workspaces(table, &panels, &centres);
    WorkspaceBar bar(workspaces, &window);
    QString ran;
    const auto make = [&](const QString& id) {
        return Workspace{
            id, id.toUpper(), "segment", "tip", new QWidget, [&table, &ran, id] {
                table.add(
                    {id + ".act", "Menu", "Act", {QKeySequence("1")}, [&ran, id] { ran = id; }});
            }};
    };
    workspaces.add(make("segment"));
    workspaces.add(make("label"));
    EXPECT_TRUE(centres.isHidden()) << "nothing stands beside the 3D view";
    Workspace withCentre = make("graph");
    withCentre.centre = new QWidget;
    workspaces.add(withCentre);
    workspaces.addSwitchCommands("View");
    QMenuBar menus;
    table.fillMenus(&menus);
    table.refresh();
    EXPECT_EQ(workspaces.current(), "segment");
    EXPECT_TRUE(table.action("segment.act")->isEnabled());
    EXPECT_FALSE(table.action("label.act")->isEnabled());
    table.run("workspace.label");
    EXPECT_EQ(workspaces.current(), "label");
    EXPECT_EQ(panels.currentIndex(), 1);
    table.run("workspace.graph");
    EXPECT_EQ(centres.currentWidget(), withCentre.centre);
    EXPECT_FALSE(centres.isHidden());
    table.run("workspace.label");
    EXPECT_TRUE(centres.isHidden());
    EXPECT_FALSE(table.action("segment.act")->isVisible());
    table.run("label.act");
    EXPECT_EQ(ran, "label");
    const auto tabs = bar.findChildren<QToolButton*>();
    QToolButton* first = nullptr;
    for (auto* tab : tabs) {
        if (tab->text() == "SEGMENT" && !tab->isHidden()) first = tab;
    }
    ASSERT_NE(first, nullptr);
    EXPECT_FALSE(first->isChecked());
    first->click();
    EXPECT_EQ(workspaces.current(), "segment");
    workspaces.show("nowhere");
    EXPECT_EQ(workspaces.current(), "segment");
}

TEST_F(WindowTest, WelcomePageNamesWhatWasOpenedAndOpensIt) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    ASSERT_TRUE(window_->close());
    window_ = std::make_unique<MainWindow>();
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    auto* page = window_->findChild<WelcomePage*>();
    ASSERT_NE(page, nullptr);
    QPushButton* recent = nullptr;
    for (auto* button : page->findChildren<QPushButton*>()) {
        if (button->accessibleName().startsWith("Open bout.kumite, today")) recent = button;
    }
    ASSERT_NE(recent, nullptr);
    QStringList texts;
    for (const auto* label : recent->findChildren<QLabel*>())
        texts.append(label->toolTip() + label->text());
    EXPECT_TRUE(texts.contains("bout.kumite"));
    QTest::mouseClick(recent, Qt::LeftButton);
    settle();
    EXPECT_EQ(session().document().name(), "bout.kumite");
}

TEST(RecentFiles, TellTheDayAndTheFolder) {
    const QDateTime now(QDate(2026, 3, 12), QTime(18, 0));
    EXPECT_EQ(whenText(QDateTime(QDate(2026, 3, 12), QTime(9, 5)), now), "today 9:05");
    EXPECT_EQ(whenText(QDateTime(QDate(2026, 3, 11), QTime(23, 59)), now), "yesterday 23:59");
    EXPECT_EQ(whenText(QDateTime(QDate(2025, 12, 1), QTime(1, 0)), now), "1 Dec 2025");
    EXPECT_TRUE(whenText({}, now).isEmpty());
    EXPECT_EQ(folderText({QDir::homePath() + "/mocap/a.bvh"}), "~/mocap");
    EXPECT_EQ(folderText({"/data/a.bvh", "/data/b.bvh"}), "/data");
}

}  // namespace
}  // namespace kumite::studio
