#include "studio/app/recovery.h"

#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "studio/app/file_actions.h"
#include "studio/app/recovery_dialog.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class RecoveryTest : public WindowTest {
protected:
    void SetUp() override {
        QDir(Recovery::folder()).removeRecursively();
        WindowTest::SetUp();
    }

    static QStringList copies(const QString& suffix) {
        return QDir(Recovery::folder()).entryList({"*" + suffix}, QDir::Files);
    }

    /// What a crash leaves: the files without a lock that anybody holds.
    static void leaveBehind(const QString& name) {
        for (const char* suffix : {".edit", ".kumite"}) {
            for (const QString& copy : copies(suffix)) {
                QFile::copy(Recovery::folder() + '/' + copy,
                            Recovery::folder() + '/' + name + suffix);
            }
        }
    }
};

TEST_F(RecoveryTest, EveryEditIsOnTheDiskBeforeTheNextAndSavingTakesTheCopyAway) {
    Recovery recovery(session());
    openBout();
    EXPECT_TRUE(copies(".edit").isEmpty());
    session().toggleBoundary(someBoundary(0));
    EXPECT_EQ(copies(".edit").size(), 1) << "at once, without waiting for anything";
    EXPECT_TRUE(Recovery::leftBehind().empty()) << "its owner is alive: nobody offers it";
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    EXPECT_TRUE(copies(".edit").isEmpty());
    EXPECT_TRUE(copies(".kumite").isEmpty());
}

TEST_F(RecoveryTest, TwentyEditsOrTheTimerWriteACopyThatOutlivesAPowerCut) {
    Recovery recovery(session());
    openBout();
    const BoundaryRef boundary = someBoundary(0);
    for (int i = 0; i < 19; ++i)
        session().toggleBoundary(boundary);
    QTest::qWait(50);
    EXPECT_TRUE(copies(".kumite").isEmpty());
    recovery.autosave();
    QTRY_COMPARE(copies(".kumite").size(), 1);
    QFile::remove(Recovery::folder() + '/' + copies(".kumite").front());
    for (int i = 0; i < 20; ++i)
        session().toggleBoundary(boundary);
    QTRY_COMPARE(copies(".kumite").size(), 1);
}

TEST_F(RecoveryTest, CopyOfADeadStudioOpensAsUnsavedWithAllItsEdits) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    const BoundaryRef removed = someBoundary(0);
    {
        Recovery recovery(session());
        session().toggleBoundary(removed);
        session().toggleBoundary(someBoundary(1));
        leaveBehind("dead");
    }
    const auto left = Recovery::leftBehind();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].edits, 2);
    EXPECT_EQ(left[0].name, "bout.kumite");
    EXPECT_EQ(left[0].original, file("bout.kumite"));
    EXPECT_LE(std::abs(left[0].time.secsTo(QDateTime::currentDateTime())), 60);
    window_->files().openRecovered(left[0]);
    settle();
    EXPECT_TRUE(session().document().isModified());
    EXPECT_EQ(session().document().path(), file("bout.kumite"));
    ASSERT_NE(mark(removed), nullptr);
    EXPECT_FALSE(mark(removed)->isLive());
    Recovery::discard(left[0]);
    EXPECT_TRUE(Recovery::leftBehind().empty());
}

TEST_F(RecoveryTest, TheFirstSaveAfterwardsAsksOnlyWhereTheFileIsAnother) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    {
        Recovery recovery(session());
        session().toggleBoundary(someBoundary(0));
        leaveBehind("dead");
    }
    const RecoveryCopy left = Recovery::leftBehind().at(0);
    window_->files().openRecovered(left);
    settle();
    EXPECT_TRUE(window_->files().saveTo(file("bout.kumite")))
        << "it asked about the user's own save";

    Project other = session().document().project();
    other.segmentation.cutoff = 4.5;
    saveProject(other, toPath(file("bout.kumite")));
    window_->files().openRecovered(left);
    settle();
    answer("Cancel");
    EXPECT_FALSE(window_->files().saveTo(file("bout.kumite")));
    EXPECT_EQ(loadProject(toPath(file("bout.kumite"))).project.segmentation.cutoff, 4.5);
}

TEST_F(RecoveryTest, TheLastCopyIsOfferedAlsoWhenTheClockWasSetBack) {
    openBout();
    {
        Recovery recovery(session());
        session().toggleBoundary(someBoundary(0));
        recovery.autosave();
        QTRY_COMPARE(copies(".kumite").size(), 1);
        session().toggleBoundary(someBoundary(1));
        leaveBehind("dead");
    }
    // As if the clock had been set back by a day between the two copies.
    QFile last(Recovery::folder() + "/dead.edit");
    ASSERT_TRUE(last.open(QIODevice::ReadOnly));
    QByteArray text = last.readAll();
    last.close();
    const QDate today = QDate::currentDate();
    ASSERT_TRUE(text.contains(today.toString(Qt::ISODate).toLatin1()));
    text.replace(today.toString(Qt::ISODate).toLatin1(),
                 today.addDays(-1).toString(Qt::ISODate).toLatin1());
    ASSERT_TRUE(last.open(QIODevice::WriteOnly | QIODevice::Truncate));
    last.write(text);
    last.close();
    ASSERT_EQ(Recovery::leftBehind().size(), 1U);
    EXPECT_EQ(Recovery::leftBehind()[0].edits, 2);
}

TEST_F(RecoveryTest, WhereTheLastCopyIsTornTheOneBeforeIsOffered) {
    openBout();
    {
        Recovery recovery(session());
        session().toggleBoundary(someBoundary(0));
        recovery.autosave();
        QTRY_COMPARE(copies(".kumite").size(), 1);
        session().toggleBoundary(someBoundary(1));
        leaveBehind("dead");
    }
    QFile torn(Recovery::folder() + "/dead.edit");
    ASSERT_TRUE(torn.open(QIODevice::ReadWrite));
    ASSERT_TRUE(torn.resize(torn.size() / 2));
    torn.close();
    const auto left = Recovery::leftBehind();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].edits, 1);
}

TEST_F(RecoveryTest, DialogSaysWhatIsThereRecoversAndDiscards) {
    const auto copy = [](const QString& name, int edits) {
        RecoveryCopy made;
        made.base = Recovery::folder() + '/' + name;
        made.name = name;
        made.edits = edits;
        made.time = QDateTime::currentDateTime();
        return made;
    };
    QDir().mkpath(Recovery::folder());
    QFile file(Recovery::folder() + "/b.edit");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    RecoveryDialog dialog({copy("a", 1), copy("b", 12)}, window_.get());
    dialog.open();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    auto* list = dialog.findChild<QTreeWidget*>();
    EXPECT_EQ(list->topLevelItem(0)->text(2), "1 edit");
    EXPECT_EQ(list->topLevelItem(1)->text(2), "12 edits");
    EXPECT_TRUE(list->topLevelItem(0)->text(1).startsWith("today"));
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Delete);
    EXPECT_FALSE(file.exists());
    EXPECT_EQ(list->topLevelItemCount(), 1);
    QString recovered;
    QObject::connect(&dialog, &RecoveryDialog::recoveryWanted,
                     [&](const RecoveryCopy& chosen) { recovered = chosen.name; });
    QTest::keyClick(&dialog, Qt::Key_Return);
    EXPECT_EQ(recovered, "a");
    EXPECT_FALSE(dialog.isVisible());
}

}  // namespace
}  // namespace kumite::studio
