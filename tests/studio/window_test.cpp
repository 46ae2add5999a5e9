// Opening, dropping, refusing and closing, in the real window.

#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <set>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/message_strip.h"
#include "studio/app/recent_files.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

/// Presses a button of the message box that comes up next.
void answer(QMessageBox::StandardButton button) {
    QTimer::singleShot(50, qApp, [button] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_NE(box, nullptr);
        box->button(button)->click();
    });
}

TEST_F(WindowTest, StartsEmptyAndOffersTheFirstStep) {
    EXPECT_FALSE(session().document().isOpen());
    EXPECT_EQ(window_->windowTitle(), "Kumite");
    EXPECT_FALSE(window_->commands().action("file.save")->isEnabled());
    EXPECT_TRUE(window_->commands().action("file.openRecordings")->isEnabled());
    bool offered = false;
    for (const auto* button : window_->findChildren<QPushButton*>()) {
        offered = offered || (button->isVisible() && button->text() == "Open recordings…");
    }
    EXPECT_TRUE(offered);
}

TEST_F(WindowTest, OpensTwoRecordings) {
    openBout();
    EXPECT_EQ(session().playerCount(), 2);
    EXPECT_GT(session().marks(0).size(), 8U);
    EXPECT_GT(session().marks(1).size(), 8U);
    EXPECT_EQ(session().fighter(0)->frameCount(), 600);
    EXPECT_NEAR(session().transport().span().end, 599 / 60.0, 1e-9);
    EXPECT_EQ(window_->windowTitle(), "left[*] — Kumite");
    EXPECT_FALSE(window_->isWindowModified());
    EXPECT_EQ(recentFiles().front(), recordings());
}

TEST_F(WindowTest, TheWelcomePageOpensTheDemoBout) {
    qputenv("XDG_DATA_HOME", file("data").toUtf8());
    window_->show();
    QPushButton* begin = nullptr;
    for (auto* button : window_->findChildren<QPushButton*>()) {
        if (button->isVisible() && button->text() == "Open the demo bout") begin = button;
    }
    ASSERT_NE(begin, nullptr);
    QTest::mouseClick(begin, Qt::LeftButton);
    settle();
    ASSERT_TRUE(session().document().isOpen());
    EXPECT_EQ(session().playerCount(), 2);
    EXPECT_EQ(session().fighter(0)->frameCount(), 90 * 60);
    EXPECT_GT(session().marks(0).size(), 100U);
    EXPECT_FALSE(window_->isWindowModified());
    // It has no file yet: nothing of the made bout is written over by saving.
    EXPECT_TRUE(session().document().path().isEmpty());
    qunsetenv("XDG_DATA_HOME");
}

TEST_F(WindowTest, ViewIsAtLeastHalfOfTheWindow) {
    openBout();
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        window_->resize(size);
        QTest::qWait(50);
        const QSize stage = window_->stage().size();
        EXPECT_GE(2.0 * stage.width() * stage.height(), 1.0 * size.width() * size.height())
            << size.width();
    }
}

TEST_F(WindowTest, OpensASingleRecording) {
    window_->files().open({file("left.bvh")});
    settle();
    EXPECT_EQ(session().playerCount(), 1);
    EXPECT_FALSE(window_->commands().action("fighter.other")->isEnabled());
}

TEST_F(WindowTest, DroppedTextIsNotTaken) {
    QMimeData data;
    data.setText("a word");
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(window_.get(), &enter);
    EXPECT_FALSE(enter.isAccepted());
}

TEST_F(WindowTest, UnreadableFileGivesASentenceAndTheWindowStays) {
    QFile broken(file("broken.bvh"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("HIERARCHY\nROOT Hips\n{\n OFFSET 0 zero 0\n");
    broken.close();
    window_->files().open({file("broken.bvh")});
    settle();
    EXPECT_FALSE(session().document().isOpen());
    EXPECT_TRUE(window_->messages().text().contains("broken.bvh"))
        << window_->messages().text().toStdString();
    openBout();
    EXPECT_TRUE(window_->messages().text().isEmpty());
}

TEST_F(WindowTest, MissingFileKeepsTheOpenBout) {
    openBout();
    window_->files().openProjectFile(file("nowhere.kumite"));
    settle();
    EXPECT_TRUE(session().document().isOpen());
    EXPECT_FALSE(window_->messages().text().isEmpty());
}

TEST_F(WindowTest, ThreeRecordingsAreRefused) {
    window_->files().open({"a.bvh", "b.bvh", "c.bvh"});
    settle();
    EXPECT_FALSE(session().document().isOpen());
    EXPECT_TRUE(window_->messages().text().contains("one or two"));
}

TEST_F(WindowTest, ClosingWithUnsavedChangesAsks) {
    openBout();
    session().toggleBoundary(someBoundary(0));
    ASSERT_TRUE(session().document().isModified());
    EXPECT_TRUE(window_->isWindowModified());
    answer(QMessageBox::Cancel);
    EXPECT_FALSE(window_->close());
    EXPECT_TRUE(window_->isVisible());
    answer(QMessageBox::Discard);
    EXPECT_TRUE(window_->close());
}

TEST_F(WindowTest, ClosingCanSave) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    session().toggleBoundary(someBoundary(0));
    answer(QMessageBox::Save);
    EXPECT_TRUE(window_->close());
    EXPECT_FALSE(session().document().isModified());
}

TEST_F(WindowTest, MissingRecordingIsShownAndCanBeFoundAgain) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    ASSERT_TRUE(QFile::remove(file("right.bvh")));
    window_->files().openProjectFile(file("bout.kumite"));
    settle();
    EXPECT_NE(session().fighter(0), nullptr);
    EXPECT_EQ(session().fighter(1), nullptr);
    EXPECT_FALSE(window_->messages().text().isEmpty());
    EXPECT_TRUE(window_->commands().action("file.findRecording")->isEnabled());
    press(Qt::Key_Tab);
    press(Qt::Key_Delete);
    press(Qt::Key_S);
    timeline().grab();
}

TEST_F(WindowTest, ExportsActions) {
    openBout();
    window_->files().exportTo(file("actions.csv"));
    settle();
    EXPECT_TRUE(QFile::exists(file("actions.csv"))) << window_->messages().text().toStdString();
    window_->files().exportTo(file("actions.xyz"));
    settle();
    EXPECT_FALSE(window_->messages().text().isEmpty());
}

TEST_F(WindowTest, CommandsHaveNamesAndTheKeysThatHandsExpect) {
    std::set<QString> ids;
    std::set<QString> keys;
    for (const Command& command : window_->commands().commands()) {
        EXPECT_TRUE(ids.insert(command.id).second) << command.id.toStdString();
        EXPECT_FALSE(command.text.isEmpty());
        for (const QKeySequence& key : command.keys)
            keys.insert(key.toString());
    }
    for (const char* key :
         {"Space", "Left", "Right", "Shift+Left", "Ctrl+Right", "Home",   "End",
          "J",     "K",    "L",     "I",          "O",          "Ctrl+L", "Tab",
          "S",     "Del",  "F",     "A",          "Ctrl+Z",     "Ctrl+Y", "Ctrl+Shift+Z",
          "-",     "+",    "H",     "F11",        "Ctrl+S"}) {
        EXPECT_TRUE(keys.contains(key)) << key;
    }
}

TEST_F(WindowTest, ThemesAndPanelsSwitch) {
    openBout();
    window_->setTheme(ThemeChoice::Light);
    EXPECT_FALSE(coloursFor(window_->palette()).dark);
    timeline().grab();
    window_->setTheme(ThemeChoice::Dark);
    EXPECT_TRUE(coloursFor(window_->palette()).dark);
    const int before = timeline().parentWidget()->width();
    press(Qt::Key_H);
    press(Qt::Key_H);
    EXPECT_EQ(timeline().parentWidget()->width(), before);
}

}  // namespace
}  // namespace kumite::studio
