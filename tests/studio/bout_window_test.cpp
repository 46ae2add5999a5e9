// The Bout workspace in the real window: a bout that plays, goes back, is led and written.

#include <QAbstractButton>
#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QListView>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include <algorithm>

#include "core/base/error.h"
#include "core/project/demo_bout.h"
#include "core/project/labels.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/bout/bout_export.h"
#include "studio/workspaces/bout/bout_page.h"
#include "studio/workspaces/bout/bout_panel.h"
#include "studio/workspaces/bout/bout_session.h"
#include "studio/workspaces/bout/bout_strip.h"
#include "studio/workspaces/bout/candidates_model.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class BoutTest : public WindowTest {
protected:
    void labelAll() {
        const char* const spelled[] = {"left_punch:fwd+move:L-L", "right_punch:fwd+move:L-L",
                                       "left_kick:up+move:L-L", "jump:up+move:L-L"};
        for (const int player : {0, 1}) {
            const auto count = session().fighter(player)->segmentation->actions.size();
            session().document().apply([&](const Project& project, const Analysis& analysis) {
                MaybeEdit all;
                for (std::size_t i = 0; i < count; ++i) {
                    const int action = static_cast<int>(i);
                    const auto edit = setWholeLabel(
                        all ? all->project : project, analysis, {0, player}, std::span(&action, 1),
                        parseLabel(kickboxing(), spelled[(i * 7 + i / 3) % 4]));
                    if (edit) all = edit;
                }
                return all;
            });
        }
        settle();
    }
    void openTheBout() {
        openBout();
        labelAll();
        window_->workspaces().show("bout");
        settle();
        ASSERT_NE(bout().tape(), nullptr) << bout().whyNothing().toStdString();
    }
    BoutSession& bout() { return window_->bout(); }
    BoutPanel& panel() { return *window_->findChild<BoutPanel*>(); }
    BoutStrip& strip() { return *window_->findChild<BoutStrip*>(); }
    /// Shows some seconds more at once.
    void show(double seconds) {
        bout().step(static_cast<int>(seconds * bout().rate()));
        settle();
    }
};

TEST_F(BoutTest, WithoutLabelsItSaysWhatAppearsHere) {
    openBout();
    window_->workspaces().show("bout");
    settle();
    EXPECT_EQ(bout().tape(), nullptr);
    EXPECT_FALSE(bout().whyNothing().isEmpty());
    EXPECT_FALSE(bout().whyNothing().contains("kumite ")) << "the window has steps of its own";
    EXPECT_FALSE(panel().isVisible());
    EXPECT_FALSE(window_->stage().isLive());
    labelAll();
    EXPECT_NE(bout().tape(), nullptr) << "labels bring the bout";
    EXPECT_TRUE(panel().isVisible());
}

TEST_F(BoutTest, OfAMadeBoutPlaysAfterThreeClicks) {
    const DemoFiles demo =
        writeDemoBout({30, 60, 3}, std::filesystem::path(file("demo").toStdString()));
    window_->files().open({QString::fromStdString(demo.project().string())});
    settle();
    const auto click = [&](const QString& text) {
        for (auto* button : window_->findChildren<QAbstractButton*>()) {
            if (button->text() != text || !button->isVisible()) continue;
            QTest::mouseClick(button, Qt::LeftButton);
            settle();
            return true;
        }
        return false;
    };
    EXPECT_TRUE(click("Bout"));
    EXPECT_TRUE(click("Take over labels"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return bout().tape() != nullptr; }, 10000))
        << bout().whyNothing().toStdString();
    for (auto* button : window_->findChildren<QToolButton*>()) {
        if (button->defaultAction() == window_->commands().action("bout.play"))
            QTest::mouseClick(button, Qt::LeftButton);
    }
    EXPECT_TRUE(bout().isPlaying());
    // The button that was pressed is gone: keys are the views' again, not the next control's.
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_FALSE(bout().isPlaying());
}

TEST_F(BoutTest, PlaysInTheStageAndLeavesItAgain) {
    openTheBout();
    EXPECT_TRUE(window_->stage().isLive());
    EXPECT_FALSE(timeline().isVisible());
    EXPECT_TRUE(strip().isVisible());
    const char* const ofRecordings[] = {"view.shoulder1", "view.shoulder2", "view.addGhost",
                                        "view.measure", "view.nextJoint"};
    for (const char* id : ofRecordings)
        EXPECT_FALSE(window_->commands().action(id)->isEnabled()) << id;
    const double playhead = session().transport().playhead();
    press(Qt::Key_Space);
    EXPECT_TRUE(bout().isPlaying());
    EXPECT_TRUE(QTest::qWaitFor([&] { return bout().tape()->frame() > 20; }, 5000));
    press(Qt::Key_Space);
    EXPECT_FALSE(bout().isPlaying());
    EXPECT_FALSE(session().transport().isPlaying()) << "the recording has another clock";
    EXPECT_EQ(session().transport().playhead(), playhead);
    const int frame = bout().tape()->frame();
    QTest::qWait(60);
    EXPECT_EQ(bout().tape()->frame(), frame);
    press(Qt::Key_Space);
    window_->workspaces().show("segment");
    EXPECT_FALSE(bout().isPlaying()) << "nobody looks";
    EXPECT_FALSE(window_->stage().isLive());
    for (const char* id : ofRecordings)
        EXPECT_TRUE(window_->commands().action(id)->isEnabled()) << id;
    EXPECT_TRUE(timeline().isVisible());
    window_->workspaces().show("bout");
    settle();
    EXPECT_GE(bout().tape()->frame(), frame) << "it is there again";
    EXPECT_TRUE(window_->stage().isLive());
}

TEST_F(BoutTest, GoesBackAndOnAsItWas) {
    openTheBout();
    show(6);
    const int end = bout().tape()->end();
    const auto rootAt = [&](int frame) {
        bout().seek(frame);
        return bout().tape()->now().shown(0).joints.positions.front();
    };
    const Eigen::Vector3d then = rootAt(end);
    press(Qt::Key_Home);
    EXPECT_EQ(bout().tape()->frame(), 0);
    press(Qt::Key_Right);
    EXPECT_EQ(bout().tape()->frame(), 1);
    EXPECT_EQ(bout().tape()->end(), end) << "what was shown waits";
    press(Qt::Key_End);
    EXPECT_EQ(bout().tape()->frame(), end);
    EXPECT_EQ(rootAt(end), then);
    // A click on an action of the strip leads to the choice of it.
    const auto& blocks = strip().blocks();
    const auto block = std::find_if(blocks.begin(), blocks.end(), [&](const auto& each) {
        return each.choice && strip().rectOf(each).width() > 6 &&
               strip().rectOf(each).left() > strip().mapping().left;
    });
    ASSERT_NE(block, blocks.end());
    const auto choice = block->choice;
    QTest::mouseClick(&strip(), Qt::LeftButton, {}, strip().rectOf(*block).center().toPoint());
    EXPECT_EQ(bout().choice(), choice);
    EXPECT_EQ(bout().tape()->frame(), choice->frame);
    EXPECT_EQ(panel().candidates().choice(), choice.get());
}

TEST_F(BoutTest, AnAlternativeIsTakenAndTheBoutGoesOn) {
    openTheBout();
    show(6);
    std::shared_ptr<const BoutChoice> open;
    int node = kAnyNode;
    for (const auto& choice : bout().tape()->choices()) {
        for (const Option& option : choice->options.options) {
            if (option.barred != Barred::No || option.candidate.node == choice->node) continue;
            open = choice;
            node = option.candidate.node;
        }
        if (open) break;
    }
    ASSERT_TRUE(open) << "somewhere more than one label could follow";
    bout().pointTo(open);
    QListView* list = panel().list();
    int row = -1;
    for (int i = 0; i < panel().candidates().rowCount(); ++i) {
        if (panel().candidates().at(i).candidate.node == node) row = i;
    }
    ASSERT_GE(row, 0);
    const QModelIndex index = list->model()->index(row, 0);
    list->scrollTo(index);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(index).center());
    EXPECT_TRUE(bout().isPlaying());
    EXPECT_TRUE(QTest::qWaitFor([&] { return bout().tape()->frame() > open->frame + 5; }, 5000));
    bout().setPlaying(false);
    const auto& choices = bout().tape()->choices();
    const auto again = std::find_if(choices.begin(), choices.end(), [&](const auto& each) {
        return each->frame == open->frame && each->player == open->player;
    });
    ASSERT_NE(again, choices.end());
    EXPECT_EQ((*again)->node, node);
    EXPECT_TRUE((*again)->forced);
}

TEST_F(BoutTest, KeysAndFloorLeadTheAvatar) {
    openTheBout();
    window_->commands().run("bout.avatar");
    settle();
    ASSERT_TRUE(bout().steers());
    const auto words = bout().commandWords();
    ASSERT_GE(words.size(), 3u);
    EXPECT_TRUE(window_->commands().find("bout.act1")->plainText().contains("Avatar: "));
    press(Qt::Key_1);
    EXPECT_EQ(bout().tape()->now().wish(), words[0]);
    press(Qt::Key_0);
    EXPECT_TRUE(bout().tape()->now().wish().empty());
    QSignalSpy said(&window_->stage(), &StageView::floorClicked);
    const QPoint below(window_->stage().width() / 2, window_->stage().height() - 20);
    QTest::mouseClick(&window_->stage(), Qt::LeftButton, {}, below);
    ASSERT_EQ(said.count(), 1);
    ASSERT_TRUE(bout().tape()->now().target());
    EXPECT_EQ(*bout().tape()->now().target(), said[0][0].value<Eigen::Vector2d>());
    show(2);
    window_->commands().run("bout.automatic");
    settle();
    EXPECT_FALSE(bout().steers());
}

TEST_F(BoutTest, IsMeasuredBesideTheRecording) {
    openTheBout();
    show(3);
    bout().judge();
    EXPECT_TRUE(QTest::qWaitFor([&] { return bout().judgement().has_value(); }, 20000));
    const QTableWidget& table = *panel().quality();
    EXPECT_NEAR(bout().judgement()->seconds, 3, 0.1);
    bool both = false;
    for (int row = 0; row < table.rowCount(); ++row) {
        const bool here = table.item(row, 1)->text() != "–";
        both = both || (here && table.item(row, 2)->text() != "–");
    }
    EXPECT_TRUE(both);
}

TEST_F(BoutTest, IsWrittenInManyWays) {
    openTheBout();
    show(2);
    const Project& project = session().document().project();
    for (const char* name : {"b.bvh", "b.json", "b.glb"})
        writeBout(project, *bout().tape(), file(name), {});
    for (const char* name : {"b-1.bvh", "b-2.bvh", "b.json", "b.glb"})
        EXPECT_GT(QFileInfo(file(name)).size(), 100) << name;
    EXPECT_THROW(writeBout(project, *bout().tape(), file("b.txt"), {}), Error);

    FilmFrames frames;
    frames.count = 3;
    frames.picture = [&](int index) {
        bout().seek(index);
        return window_->stage().picture();
    };
    frames.goesOn = [](double) { return true; };
    EXPECT_EQ(writePictures(frames, file("film.png")), QString());
    const QImage first(file("film-00001.png"));
    EXPECT_EQ(first.size(), window_->stage().picture().size());
    EXPECT_TRUE(QFileInfo::exists(file("film-00003.png")));
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", folder_.path().toUtf8());
    EXPECT_TRUE(writeVideo(frames, file("film.mp4")).contains("ffmpeg"));
    // With a program of that name it gets every frame.
    QFile fake(file("ffmpeg"));
    ASSERT_TRUE(fake.open(QIODevice::WriteOnly));
    fake.write("#!/bin/sh\nfor last; do :; done\n/bin/cat > \"$last\"\n");
    fake.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    fake.close();
    EXPECT_EQ(writeVideo(frames, file("film.mp4")), QString());
    EXPECT_GT(QFileInfo(file("film.mp4")).size(), 3000);
    qputenv("PATH", path);
    if (QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty()) return;
    ASSERT_EQ(writeVideo(frames, file("real.mp4")), QString());
    QFile video(file("real.mp4"));
    ASSERT_TRUE(video.open(QIODevice::ReadOnly));
    EXPECT_EQ(video.read(12).mid(4, 4), "ftyp");
}

TEST_F(BoutTest, AnotherSeedNeedsNothingNewAndASavedProjectIsTheSame) {
    openTheBout();
    show(1);
    const BoutLibrary* library = &bout().library();
    BoutSettings settings = bout().wanted();
    settings.seed += 5;
    settings.temperature = 0.5;
    bout().setWanted(settings);
    settle();
    ASSERT_NE(bout().tape(), nullptr);
    EXPECT_EQ(&bout().library(), library);
    EXPECT_EQ(bout().tape()->now().settings().seed, settings.seed);
    EXPECT_EQ(bout().tape()->end(), 0);

    session().document().markSaved(file("saved.kumite"));
    settle();
    EXPECT_FALSE(bout().isOutdated());
    settings.mode = BoutMode::Avatar;
    bout().setWanted(settings);
    settle();
    EXPECT_TRUE(QTest::qWaitFor([&] { return bout().steers(); }, 20000));
    EXPECT_NE(&bout().library(), library) << "an avatar learns more";
}

}  // namespace
}  // namespace kumite::studio
