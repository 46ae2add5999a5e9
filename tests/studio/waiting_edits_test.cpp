// Edits that are made while derived values are being computed: nobody waits for them, and nothing
// is lost. A job's result is only taken over by the event loop, so that until a test lets it run
// the analysis is going on.

#include <QFile>
#include <QTest>

#include "core/project/edits.h"
#include "core/project/project_file.h"
#include "studio/app/file_actions.h"
#include "studio/timeline/timeline_view.h"
#include "studio/workspaces/segment/review.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class WaitingEdits : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        openBout();
        QObject::connect(&session(), &Session::hinted,
                         [this](const QString& sentence) { hints_.append(sentence); });
    }
    Document& document() { return session().document(); }
    QString lastStep() { return QString::fromStdString(document().history().steps().back().name); }
    /// Puts the floor elsewhere, which sets off the analysis and leaves all minima where they are.
    void setOff() {
        ASSERT_TRUE(document().apply([](const Project& project) {
            return setFloor(project, {0, 0}, 0.01);
        }));
        ASSERT_TRUE(document().isComputing());
        ASSERT_FALSE(document().isCurrent());
    }
    std::optional<double> floor() { return document().project().takes[0].fighters[0].floor; }

    QStringList hints_;
};

TEST_F(WaitingEdits, RemovalComesOnceTheValuesAreThere) {
    const BoundaryRef boundary = someBoundary(0);
    session().goTo(boundary);
    setOff();
    press(Qt::Key_Delete);
    EXPECT_TRUE(document().isComputing()) << "the analysis went on";
    EXPECT_TRUE(document().isWaiting());
    EXPECT_TRUE(document().isModified());
    EXPECT_EQ(document().history().steps().size(), 2U) << "only the floor yet";
    ASSERT_FALSE(hints_.isEmpty());
    EXPECT_TRUE(hints_.back().contains("waits"));
    settle();
    EXPECT_FALSE(document().isWaiting());
    ASSERT_EQ(document().history().steps().size(), 3U);
    EXPECT_TRUE(lastStep().startsWith("Remove boundary")) << lastStep().toStdString();
    EXPECT_TRUE(hints_.back().isEmpty()) << "nothing waits any more";
}

TEST_F(WaitingEdits, AreTheSameAsWithoutWaiting) {
    const BoundaryRef first = someBoundary(0);
    const auto act = [&] {
        session().goTo(first);
        press(Qt::Key_Delete);
        session().transport().setPlayhead(session().timeOf(first) + 0.2);
        press(Qt::Key_S);
        session().setNote({1, 100}, "feint");
        session().select(std::nullopt);
        session().goTo(someBoundary(1));
        press(Qt::Key_Right, Qt::AltModifier);
    };
    setOff();
    act();
    settle();
    const Project waited = document().project();
    const auto steps = document().history().steps().size();
    document().goToStep(1);
    settle();
    act();
    EXPECT_EQ(document().project(), waited);
    EXPECT_EQ(document().history().steps().size(), steps);
    EXPECT_EQ(waited.takes[0].fighters[1].notes.size(), 1U);
}

TEST_F(WaitingEdits, UndoTakesBackTheLastThatWaitsAndRedoWaits) {
    session().goTo(someBoundary(0));
    setOff();
    press(Qt::Key_Delete);
    press(Qt::Key_S);
    press(Qt::Key_Y, Qt::ControlModifier);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(document().isWaiting()) << "the removal";
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(document().isWaiting());
    settle();
    EXPECT_EQ(document().history().steps().size(), 2U);
    EXPECT_EQ(floor(), 0.01) << "the floor was not undone";
}

TEST_F(WaitingEdits, DecisionsOfTheReviewGoOnToTheNextWhenTheyAreMade) {
    press(Qt::Key_N);
    ASSERT_TRUE(session().selection());
    const BoundaryRef suspect = *session().selection();
    setOff();
    press(Qt::Key_Backspace);
    settle();
    EXPECT_TRUE(lastStep().startsWith("Remove boundary"));
    ASSERT_NE(mark(suspect), nullptr);
    EXPECT_FALSE(mark(suspect)->isLive());
    const auto open = suspectsOf(session()).front();
    if (open.isOpen() && open.suspicion >= kSuspect) {
        EXPECT_EQ(session().selection(), open.boundary);
    }
}

TEST_F(WaitingEdits, AreDroppedInASentenceWhereAnotherTakeIsShown) {
    ASSERT_TRUE(document().apply([](const Project& project) {
        Take copy = project.takes[0];
        copy.name = "second";
        return addTake(project, copy);
    }));
    settle();
    session().goTo(someBoundary(0));
    setOff();
    press(Qt::Key_Delete);
    session().setTake(1);
    settle();
    EXPECT_EQ(document().history().steps().size(), 3U);
    EXPECT_TRUE(hints_.back().contains("another take"));
}

TEST_F(WaitingEdits, ACancelledAnalysisDropsThemAndTheNextEditStartsItAgain) {
    session().goTo(someBoundary(0));
    setOff();
    press(Qt::Key_Delete);
    document().jobs().cancel();
    settle();
    EXPECT_FALSE(document().isWaiting());
    EXPECT_FALSE(document().isCurrent());
    EXPECT_EQ(document().history().steps().size(), 2U);
    press(Qt::Key_Delete);
    settle();
    EXPECT_TRUE(document().isCurrent());
    EXPECT_EQ(document().analysis().takes[0][0].body->floor, 0.01);
    EXPECT_TRUE(lastStep().startsWith("Remove boundary"));
}

TEST_F(WaitingEdits, BelongToWhatIsSaved) {
    session().goTo(someBoundary(0));
    setOff();
    press(Qt::Key_Delete);
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    EXPECT_FALSE(document().isModified());
    const auto saved = loadProject(file("bout.kumite").toStdString()).project;
    EXPECT_EQ(saved.takes[0].fighters[0].corrections.size(), 1U);
}

TEST_F(WaitingEdits, ABoundaryLetGoDuringAnAnalysisArrives) {
    const BoundaryRef boundary = someBoundary(0);
    session().setVisible({session().timeOf(boundary) - 1, session().timeOf(boundary) + 1});
    const QPoint at = timeline().pointOf(boundary).toPoint();
    QTest::mousePress(&timeline(), Qt::LeftButton, {}, at);
    QTest::mouseMove(&timeline(), at + QPoint(40, 0));
    setOff();
    QTest::mouseMove(&timeline(), at + QPoint(60, 0));
    QTest::mouseRelease(&timeline(), Qt::LeftButton, Qt::ControlModifier, at + QPoint(60, 0));
    settle();
    EXPECT_TRUE(lastStep().startsWith("Move boundary")) << lastStep().toStdString();
}

TEST_F(WaitingEdits, AnEditThatCannotWaitIsRefusedInASentence) {
    QString sentence;
    QObject::connect(&document(), &Document::failed, &document(),
                     [&](const QString& text) { sentence = text; });
    setOff();
    EXPECT_FALSE(document().apply([](const Project& project, const Analysis& analysis) {
        return addBoundary(project, analysis, {0, 0}, 77);
    }));
    EXPECT_TRUE(sentence.contains("being computed"));
    settle();
}

TEST_F(WaitingEdits, SavingDoesNotStopAnExport) {
    window_->files().exportTo(file("actions.csv"));
    ASSERT_TRUE(window_->files().saveTo(file("bout.kumite")));
    settle();
    EXPECT_TRUE(QFile::exists(file("actions.csv")));
}

}  // namespace
}  // namespace kumite::studio
