#include "studio/app/recovery.h"

#include <QDir>
#include <QFile>

#include "studio/app/file_actions.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

QStringList copies() {
    return QDir(Recovery::folder()).entryList({"*.kumite"}, QDir::Files);
}

TEST_F(WindowTest, ModifiedProjectIsCopiedAndSavingTakesTheCopyAway) {
    Recovery recovery(session());
    openBout();
    recovery.writeCopy();
    EXPECT_TRUE(copies().isEmpty());
    session().toggleBoundary(someBoundary(0));
    recovery.writeCopy();
    EXPECT_EQ(copies().size(), 1);
    // Its owner is alive: nobody offers it.
    EXPECT_FALSE(Recovery::leftBehind().has_value());
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    EXPECT_TRUE(copies().isEmpty());
}

TEST_F(WindowTest, CopyOfADeadStudioIsOfferedAndOpensAsUnsaved) {
    openBout();
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    const BoundaryRef removed = someBoundary(0);
    session().toggleBoundary(removed);
    {
        Recovery recovery(session());
        session().toggleBoundary(someBoundary(1));
        recovery.writeCopy();
        // What a crash leaves: the files without their lock.
        const QString base = Recovery::folder() + '/' + copies().front().chopped(7);
        ASSERT_TRUE(QFile::copy(base + ".kumite", Recovery::folder() + "/dead.kumite"));
        ASSERT_TRUE(QFile::copy(base + ".ini", Recovery::folder() + "/dead.ini"));
    }
    const auto copy = Recovery::leftBehind();
    ASSERT_TRUE(copy.has_value());
    EXPECT_EQ(copy->edits, 2);
    EXPECT_EQ(copy->name, "bout.kumite");
    EXPECT_EQ(copy->original, file("bout.kumite"));
    window_->files().openRecovered(copy->file, copy->original);
    settle();
    EXPECT_TRUE(session().document().isModified());
    EXPECT_EQ(session().document().path(), file("bout.kumite"));
    EXPECT_FALSE(mark(removed)->isLive());
    Recovery::discard(*copy);
    EXPECT_FALSE(Recovery::leftBehind().has_value());
}

}  // namespace
}  // namespace kumite::studio
