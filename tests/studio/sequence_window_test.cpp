// The Sequence workspace in the real window: actions strung together by keys and mouse.

#include <QApplication>
#include <QDropEvent>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "core/project/sequence_draft.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/made_motion.h"
#include "studio/workspaces/sequence/cluster_map.h"
#include "studio/workspaces/sequence/sequence_panel.h"
#include "studio/workspaces/sequence/sequence_session.h"
#include "studio/workspaces/sequence/sequence_strip.h"
#include "studio/workspaces/sequence/transition_box.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class SequenceTest : public WindowTest {
protected:
    void openWorkspace() {
        openBout();
        window_->workspaces().show("sequence");
        settle();
        ASSERT_NE(sequence().library(), nullptr) << sequence().whyNothing().toStdString();
    }
    /// Adds that many actions of the list, the first ones, by keys.
    void addActions(int count) {
        QTableView& table = panel().table();
        for (int i = 0; i < count; ++i) {
            table.setFocus();
            table.selectRow(2 * i);
            QTest::keyClick(&table, Qt::Key_Return);
            settle();
        }
    }
    SequenceSession& sequence() { return window_->sequence(); }
    SequencePanel& panel() { return *window_->findChild<SequencePanel*>(); }
    SequenceStrip& strip() { return *window_->findChild<SequenceStrip*>(); }
    std::vector<std::string> clips() {
        std::vector<std::string> names;
        for (const DraftBlock& block : sequence().draft().blocks)
            names.push_back(block.clip);
        return names;
    }
    const SequencePiece& pieceOf(int block) {
        for (const SequencePiece& piece : sequence().motion()->pieces) {
            if (piece.block == block && !piece.transition) return piece;
        }
        throw std::runtime_error("no such block");
    }
    QPoint middleOf(int block) { return strip().rectOf(pieceOf(block)).center().toPoint(); }
};

TEST_F(SequenceTest, ActionsAreFoundPreviewedAndAdded) {
    openWorkspace();
    EXPECT_TRUE(window_->stage().isLive());
    EXPECT_FALSE(timeline().isVisible());
    EXPECT_EQ(sequence().motion(), nullptr);
    const int all = panel().table().model()->rowCount();
    EXPECT_GT(all, 4);
    press(Qt::Key_F, Qt::ControlModifier);
    EXPECT_TRUE(panel().search().hasFocus());
    QTest::keyClicks(&panel().search(), ":1:0");
    EXPECT_LT(panel().table().model()->rowCount(), all);
    panel().search().clear();
    QTest::mouseClick(panel().table().viewport(), Qt::LeftButton, {},
                      panel().table().visualRect(panel().table().model()->index(1, 0)).center());
    EXPECT_EQ(sequence().showing(), SequenceSession::Showing::Action);
    EXPECT_TRUE(sequence().isPlaying());
    ASSERT_NE(sequence().pose(), nullptr);
    press(Qt::Key_Escape);
    EXPECT_EQ(sequence().showing(), SequenceSession::Showing::Sequence);
    addActions(3);
    ASSERT_NE(sequence().motion(), nullptr) << sequence().problem().toStdString();
    EXPECT_TRUE(sequence().isCurrent());
    EXPECT_EQ(sequence().draft().blocks.size(), 3U);
    EXPECT_EQ(session().document().history().position(), 3U);
    press(Qt::Key_Space);
    EXPECT_TRUE(sequence().isPlaying());
    EXPECT_TRUE(QTest::qWaitFor([&] { return sequence().seconds() > 0.2; }, 5000));
    press(Qt::Key_Space);
    window_->workspaces().show("segment");
    EXPECT_FALSE(window_->stage().isLive());
    EXPECT_TRUE(timeline().isVisible());
    // From one made motion to the other and back.
    window_->workspaces().show("bout");
    window_->workspaces().show("sequence");
    settle();
    EXPECT_TRUE(window_->stage().isLive());
    EXPECT_FALSE(timeline().isVisible());
}

TEST_F(SequenceTest, EveryChangeIsAStepThatIsUndoneAndSaved) {
    openWorkspace();
    addActions(3);
    const auto added = clips();
    session().document().undo();
    settle();
    EXPECT_EQ(clips().size(), 2U);
    session().document().redo();
    settle();
    EXPECT_EQ(clips(), added);
    sequence().select(SequencePart{0, false});
    window_->stage().setFocus();
    press(Qt::Key_Right, Qt::AltModifier);
    settle();
    EXPECT_EQ(clips(), (std::vector{added[1], added[0], added[2]}));
    EXPECT_EQ(sequence().selectedBlock(), 1);
    press(Qt::Key_Plus);
    settle();
    EXPECT_EQ(sequence().draft().blocks[1].repeats, 2);
    press(Qt::Key_Delete);
    settle();
    EXPECT_EQ(clips(), (std::vector{added[1], added[2]}));
    session().document().undo();
    settle();
    const SequenceDraft kept = sequence().draft();
    EXPECT_EQ(kept.blocks[1].repeats, 2);
    const QString path = file("sequence.kumite");
    window_->files().saveTo(path);
    settle();
    window_->files().open({path});
    settle();
    EXPECT_EQ(sequence().draft(), kept);
    ASSERT_NE(sequence().motion(), nullptr);
    EXPECT_TRUE(sequence().isCurrent());
}

TEST_F(SequenceTest, BlocksAreDraggedAndTrimmedByTheMouse) {
    openWorkspace();
    addActions(3);
    const auto added = clips();
    strip().showAll();
    const QPoint from = middleOf(0), to = middleOf(2) + QPoint(15, 0);
    QTest::mousePress(&strip(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&strip(), (from + to) / 2);
    QTest::mouseMove(&strip(), to);
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, to);
    settle();
    EXPECT_EQ(clips(), (std::vector{added[1], added[2], added[0]}));
    // Its end a little earlier, and back to the whole.
    QTest::mouseClick(&strip(), Qt::LeftButton, {}, middleOf(1));
    EXPECT_EQ(sequence().selectedBlock(), 1);
    const QRectF rect = strip().rectOf(pieceOf(1));
    const QPoint edge(static_cast<int>(rect.right()) - 1, static_cast<int>(rect.center().y()));
    const QPoint inside = edge - QPoint(static_cast<int>(rect.width() / 3), 0);
    QTest::mousePress(&strip(), Qt::LeftButton, {}, edge);
    QTest::mouseMove(&strip(), inside);
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, inside);
    settle();
    ASSERT_TRUE(sequence().draft().blocks[1].trim);
    EXPECT_LT(strip().rectOf(pieceOf(1)).width(), rect.width());
    window_->stage().setFocus();
    press(Qt::Key_O, Qt::ShiftModifier);
    settle();
    EXPECT_FALSE(sequence().draft().blocks[1].trim);
    // The ruler scrubs.
    QTest::mouseClick(&strip(), Qt::LeftButton, {}, QPoint(middleOf(1).x(), 6));
    EXPECT_NEAR(sequence().seconds(), strip().mapping().timeAt(middleOf(1).x()), 0.02);
}

TEST_F(SequenceTest, AnActionIsDroppedBetweenBlocksAndItLoops) {
    openWorkspace();
    addActions(2);
    const auto added = clips();
    strip().showAll();
    const std::unique_ptr<QMimeData> dragged(
        panel().table().model()->mimeData({panel().table().model()->index(5, 0)}));
    const QPointF between(strip().rectOf(pieceOf(1)).left() + 2, middleOf(1).y());
    QDragEnterEvent enter(between.toPoint(), Qt::CopyAction, dragged.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&strip(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(between, Qt::CopyAction, dragged.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&strip(), &drop);
    settle();
    ASSERT_EQ(clips().size(), 3U);
    EXPECT_EQ(clips()[0], added[0]);
    EXPECT_EQ(clips()[2], added[1]);
    window_->stage().setFocus();
    press(Qt::Key_L);
    EXPECT_TRUE(sequence().isLooping());
    sequence().seek(sequence().length() - 0.05);
    press(Qt::Key_Space);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return sequence().isPlaying() && sequence().seconds() < 0.5 * sequence().length(); },
        5000))
        << "from the end to the start again";
    press(Qt::Key_Space);
}

TEST_F(SequenceTest, ATransitionIsTakenAnotherWayDrawnAnewAndLocked) {
    openWorkspace();
    addActions(3);
    sequence().select(SequencePart{1, true});
    auto* list = window_->findChild<TransitionBox*>()->findChild<QListWidget*>();
    ASSERT_GE(list->count(), 3);
    const int curve = list->count() - 2;
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(curve)).center());
    settle();
    EXPECT_EQ(sequence().draft().blocks[1].transition.method, TransitionMethod::Bezier);
    ASSERT_NE(sequence().selectedPiece(), nullptr);
    EXPECT_EQ(sequence().selectedPiece()->transition->method, TransitionMethod::Bezier);
    EXPECT_TRUE(list->item(curve)->text().startsWith(QStringLiteral("●")));
    window_->stage().setFocus();
    press(Qt::Key_K);
    settle();
    EXPECT_TRUE(sequence().draft().blocks[1].locked);
    const auto seeds = [&] {
        std::vector<std::uint64_t> all;
        for (const DraftBlock& block : sequence().draft().blocks)
            all.push_back(block.transition.seed);
        return all;
    };
    const auto before = seeds();
    press(Qt::Key_R, Qt::ShiftModifier);
    settle();
    EXPECT_EQ(seeds()[1], before[1]);
    EXPECT_NE(seeds()[2], before[2]);
    press(Qt::Key_R);
    settle();
    EXPECT_NE(seeds()[1], before[1]) << "asked for by name";
}

TEST_F(SequenceTest, TheMapShowsTheWayOfATransition) {
    openWorkspace();
    addActions(3);
    auto* map = window_->findChild<ClusterMap*>();
    EXPECT_FALSE(map->isVisible());
    window_->stage().setFocus();
    press(Qt::Key_V);
    EXPECT_TRUE(map->isVisible());
    sequence().select(SequencePart{0, false});
    EXPECT_TRUE(map->way().empty()) << "the first block is not led to";
    sequence().select(SequencePart{1, true});
    ASSERT_NE(sequence().selectedPiece(), nullptr);
    EXPECT_EQ(map->way(), sequence().selectedPiece()->transition->visited);
    EXPECT_FALSE(map->way().empty());
    for (int cluster = 0; cluster < sequence().graph()->clusters.count(); ++cluster)
        EXPECT_TRUE(map->rect().contains(map->placeOf(cluster).toPoint()));
    window_->workspaces().show("segment");
    EXPECT_FALSE(map->isVisible());
    window_->workspaces().show("sequence");
    EXPECT_TRUE(map->isVisible()) << "as it was left";
    press(Qt::Key_V);
    EXPECT_FALSE(map->isVisible());
}

TEST_F(SequenceTest, KeysPlayBlocksAtOnce) {
    openWorkspace();
    addActions(3);
    window_->stage().setFocus();
    press(Qt::Key_L, Qt::ControlModifier);
    EXPECT_EQ(sequence().showing(), SequenceSession::Showing::Live);
    EXPECT_TRUE(sequence().isPlaying());
    EXPECT_TRUE(QTest::qWaitFor([&] { return sequence().pose() != nullptr; }, 5000));
    EXPECT_FALSE(sequence().liveReport());
    press(Qt::Key_2);
    EXPECT_TRUE(sequence().liveReport()) << "it is led over to the second block";
    EXPECT_EQ(sequence().selectedBlock(), 1);
    press(Qt::Key_Escape);
    EXPECT_EQ(sequence().showing(), SequenceSession::Showing::Sequence);
    EXPECT_FALSE(sequence().isPlaying());
}

TEST_F(SequenceTest, IsKeptAsATakeAndWritten) {
    openWorkspace();
    addActions(2);
    const int frames = sequence().motion()->clip.frameCount();
    keepMotionAs(session(), sequence().writing(), sequence().madeMotion(), file("mine.bvh"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !sequence().writing().isRunning(); }, 5000));
    settle();
    ASSERT_EQ(session().document().project().takes.size(), 2U);
    const Take& take = session().document().project().takes.back();
    EXPECT_EQ(take.name, "mine");
    EXPECT_EQ(take.fighters.front().frames.size(), frames);
    EXPECT_TRUE(QFileInfo::exists(file("mine.bvh")));
    const auto isThere = [&] {
        const MotionLibrary* library = sequence().library();
        return library != nullptr &&
               std::any_of(library->motions.begin(), library->motions.end(),
                           [](const LibraryMotion& motion) { return motion.name == "mine:1"; });
    };
    EXPECT_TRUE(QTest::qWaitFor(isThere, 5000)) << "what was kept is a source, too";
    const auto written = [&] { return !sequence().writing().isRunning(); };
    exportMotionTo(session(), sequence().writing(), sequence().madeMotion(), file("out.glb"));
    EXPECT_TRUE(QTest::qWaitFor(written, 5000));
    EXPECT_GT(QFileInfo(file("out.glb")).size(), 1000);
    QSignalSpy failures(&sequence(), &SequenceSession::failed);
    exportMotionTo(session(), sequence().writing(), sequence().madeMotion(), file("out.fbx"));
    EXPECT_TRUE(QTest::qWaitFor(written, 5000));
    EXPECT_EQ(failures.size(), 1);
}

TEST_F(SequenceTest, WhatIsNotThereAnyMoreIsSaid) {
    openWorkspace();
    addActions(2);
    session().document().apply(Document::ProjectEdit([&](const Project& project) {
        SequenceDraft draft = sequence().draft();
        draft.blocks[1].clip = "gone";
        return setSequenceDraft(project, draft, "x");
    }));
    settle();
    EXPECT_TRUE(sequence().problem().contains("gone")) << sequence().problem().toStdString();
    EXPECT_FALSE(sequence().isCurrent());
    session().document().undo();
    settle();
    EXPECT_TRUE(sequence().problem().isEmpty());
    EXPECT_TRUE(sequence().isCurrent());
}

}  // namespace
}  // namespace kumite::studio
