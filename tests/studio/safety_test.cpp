// Saving, locks, versions and kill -9, in the real window and the real program.

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include <csignal>
#include <functional>
#include <random>

#include <sys/resource.h>

#include "core/project/project_file.h"
#include "core/project/versions.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/app/project_guard.h"
#include "studio/app/recovery.h"
#include "studio/app/versions_dialog.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

int corrections(const Project& project) {
    int count = 0;
    for (const Take& take : project.takes) {
        for (const Fighter& fighter : take.fighters)
            count += static_cast<int>(fighter.corrections.size());
    }
    return count;
}

class SafetyTest : public WindowTest {
protected:
    void openSaved() {
        openBout();
        ASSERT_TRUE(window_->files().saveTo(project()));
    }
    QString project() const { return file("bout.kumite"); }
    Project onDisk() const { return loadProject(toPath(project())).project; }
    /// What `kumite correct` in another window does.
    void changeBehindTheBack() const {
        Project other = onDisk();
        other.segmentation.cutoff = 4.5;
        saveProject(other, toPath(project()));
    }
};

TEST_F(SafetyTest, AFileThatSomebodyElseChangedIsNotSavedOverUnasked) {
    openSaved();
    session().toggleBoundary(someBoundary(0));
    changeBehindTheBack();
    answer("Cancel");
    EXPECT_FALSE(window_->files().saveTo(project()));
    EXPECT_TRUE(session().document().isModified());
    EXPECT_EQ(onDisk().segmentation.cutoff, 4.5);
    answer("Save over it");
    EXPECT_TRUE(window_->files().saveTo(project()));
    EXPECT_EQ(onDisk().segmentation.cutoff, 6.0);
    const auto kept = keptVersions(toPath(project()));
    ASSERT_FALSE(kept.empty());
    EXPECT_EQ(loadVersion(toPath(project()), kept.front()).project.segmentation.cutoff, 4.5)
        << "what was saved over is not lost";
    session().toggleBoundary(someBoundary(1));
    EXPECT_TRUE(window_->files().saveTo(project())) << "and is not asked about again";
}

TEST_F(SafetyTest, AFullDiskGivesASentenceAndTheOldFileStaysWhole) {
    openSaved();
    QFile file(project());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray before = file.readAll();
    session().toggleBoundary(someBoundary(0));
    rlimit old{};
    ::getrlimit(RLIMIT_FSIZE, &old);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit tiny{100, old.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &tiny);
    const bool saved = window_->files().saveTo(project());
    ::setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(saved);
    EXPECT_TRUE(window_->messages().text().contains("bout.kumite"));
    EXPECT_TRUE(window_->messages().text().contains("your work is still open"));
    EXPECT_TRUE(session().document().isModified());
    file.seek(0);
    QFile again(project());
    ASSERT_TRUE(again.open(QIODevice::ReadOnly));
    EXPECT_EQ(again.readAll(), before);
    EXPECT_TRUE(window_->files().saveTo(project())) << "once there is room it is saved";
}

TEST_F(SafetyTest, VersionsAreListedAndRestoredAsAnEdit) {
    openSaved();
    const Project first = session().document().project();
    for (const int player : {0, 1}) {
        session().toggleBoundary(someBoundary(player));
        ASSERT_TRUE(window_->files().saveTo(project()));
    }
    const Project last = session().document().project();
    window_->commands().run("file.versions");
    auto* dialog = qobject_cast<VersionsDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    auto* list = dialog->findChild<QTreeWidget*>();
    QTRY_COMPARE(list->topLevelItemCount(), 2);
    EXPECT_EQ(list->topLevelItem(0)->text(2), "1");
    EXPECT_EQ(list->topLevelItem(1)->text(2), "0");
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(dialog, Qt::Key_Return);
    settle();
    std::string steps;
    for (const auto& step : session().document().history().steps())
        steps += step.name + "; ";
    EXPECT_EQ(session().document().project(), first)
        << steps << window_->messages().text().toStdString();
    EXPECT_TRUE(session().document().isModified());
    session().document().undo();
    EXPECT_EQ(session().document().project(), last) << steps;
    EXPECT_FALSE(session().document().isModified());
}

/// The program as users start it, on a home of its own.
class Studio : public QProcess {
public:
    Studio(const QString& home, const QStringList& arguments) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_DATA_HOME", home);
        environment.insert("XDG_CONFIG_HOME", home);
        setProcessEnvironment(environment);
        start(KUMITE_STUDIO_PROGRAM, arguments);
    }
    ~Studio() override {
        kill();
        waitForFinished();
    }
    /// Lines that it has told until there are `count`; fewer where it ends before.
    QStringList lines(int count) {
        do {
            while (canReadLine())
                lines_.append(QString::fromUtf8(readLine()).trimmed());
        } while (lines_.size() < count && waitForReadyRead(60000));
        return lines_;
    }

private:
    QStringList lines_;
};

void writeText(const QString& path, const QString& text) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text.toUtf8());
}

TEST_F(SafetyTest, TheSecondStudioOnAProjectIsTold) {
    openSaved();
    writeText(file("script"), "wait 1\n");
    window_->files().openBout(requestFor(recordings()), false);  // lets go of the lock
    settle();
    Studio other(file("home"), {"--script", file("script"), project()});
    ASSERT_EQ(other.lines(1).size(), 1);
    answer("Cancel");
    window_->files().openProjectFile(project());
    settle();
    EXPECT_TRUE(session().document().path().isEmpty());
    answer("Open a copy");
    window_->files().openProjectFile(project());
    settle();
    EXPECT_TRUE(session().document().path().isEmpty());
    EXPECT_TRUE(session().document().isModified());
    answer("Take over");
    window_->files().openProjectFile(project());
    settle();
    EXPECT_EQ(session().document().path(), project());
}

TEST_F(SafetyTest, PicturesAndWatchedRunsAskNobody) {
    openSaved();  // and holds the lock
    const std::string before = fingerprint(project());
    writeText(file("script"), "boundary.add\nfile.saveAs\nfile.quit\n");
    const auto told = [&](const QStringList& arguments) {
        Studio studio(file("alone"), arguments + QStringList{project()});
        EXPECT_TRUE(studio.waitForFinished(120000)) << "it waits for somebody";
        EXPECT_EQ(studio.exitCode(), 0);
        return QString::fromUtf8(studio.readAllStandardError());
    };
    const QString elsewhere =
        "bout.kumite is open in another studio. Nobody is here to answer: "
        "Open a copy.";
    const QString ofPicture = told({"--picture", file("out.png")});
    EXPECT_TRUE(ofPicture.contains(elsewhere)) << ofPicture.toStdString();
    EXPECT_TRUE(QFile::exists(file("out.png")));
    const QString ofScript = told({"--watch", "--script", file("script")});
    EXPECT_TRUE(ofScript.contains(elsewhere)) << ofScript.toStdString();
    EXPECT_TRUE(ofScript.contains("nobody is here to choose a file"));
    EXPECT_TRUE(ofScript.contains("Save the changes to"));
    EXPECT_EQ(fingerprint(project()), before) << "it wrote into the project of another";
}

TEST_F(SafetyTest, TheLockOfADeadStudioIsNoObstacle) {
    openSaved();
    writeText(file("script"), "wait 1\n");
    window_->files().openBout(requestFor(recordings()), false);
    settle();
    {
        Studio other(file("home"), {"--script", file("script"), project()});
        ASSERT_EQ(other.lines(1).size(), 1);
        ASSERT_TRUE(QFile::exists(ProjectLock::fileFor(project())));
    }
    ASSERT_TRUE(QFile::exists(ProjectLock::fileFor(project()))) << "killed, it could not tidy up";
    window_->files().openProjectFile(project());  // a question would hang here
    settle();
    EXPECT_EQ(session().document().path(), project());
}

/// Acts in the real program that is killed at a random instant, again and again. What it had told
/// is there again, but for the act in progress.
struct KilledSession {
    QString before;          ///< lines of the script that come first
    QStringList acts;        ///< lines of each act; `told` is one of them
    QString told;            ///< the command that makes an act
    std::vector<int> truth;  ///< what `count` gives after so many acts
    std::function<int(const Project&)> count;
    int rounds = 6;
};

class KillTest : public SafetyTest {
protected:
    void expectNothingLost(const KilledSession& killed) {
        window_.reset();
        std::mt19937 random(20080131);
        QFile saved(project());
        ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
        const QByteArray whole = saved.readAll();
        saved.close();
        writeText(file("script"), killed.before + killed.acts.join(QString()) + "wait 100000\n");
        const int lines = static_cast<int>(killed.acts.join(QString()).count('\n'));
        for (int round = 0; round < killed.rounds; ++round) {
            writeText(project(), QString::fromUtf8(whole));
            const QString home = file(QString("home%1").arg(round));
            QStringList told;
            {
                Studio studio(home, {"--script", file("script"), project()});
                const int acts = static_cast<int>(killed.before.count('\n')) +
                                 std::uniform_int_distribution(1, lines - 1)(random);
                told = studio.lines(acts);
                ASSERT_GE(told.size(), acts) << studio.readAllStandardError().toStdString();
                QTest::qSleep(std::uniform_int_distribution(0, 9)(random));
                studio.kill();
                studio.waitForFinished();
                told = studio.lines(1000);
            }
            const auto done = static_cast<std::size_t>(told.count(killed.told));
            // The file is whole, whatever was being written.
            int recovered = killed.count(onDisk());
            const QDir folder(home + "/kumite/kumite-studio/recovery");
            for (const QFileInfo& copy : folder.entryInfoList({"*.edit"}, QDir::Files)) {
                QFile text(copy.absoluteFilePath());
                ASSERT_TRUE(text.open(QIODevice::ReadOnly));
                const QByteArray about = text.readLine();
                EXPECT_TRUE(about.contains(project().toUtf8()));
                const Project found =
                    parseProject(text.readAll().toStdString(), "copy", toPath(folder.path()));
                recovered = std::max(recovered, killed.count(found));
            }
            // Nothing that was told is missing; the act in progress may be there.
            EXPECT_GE(recovered, killed.truth[done]) << "round " << round;
            EXPECT_LE(recovered, killed.truth[std::min(done + 1, killed.truth.size() - 1)])
                << "round " << round;
        }
    }
};

TEST_F(KillTest, WhileBoundariesAreAddedAtMostTheActInProgressIsLost) {
    openSaved();
    constexpr int kActs = 60;
    KilledSession killed{{}, {}, "boundary.add", {}, corrections};
    // How many corrections there are after each act: some fall where a boundary is already.
    killed.truth = {corrections(session().document().project())};
    for (int i = 0; i < kActs; ++i) {
        const double moment = 0.08 + 0.155 * i;
        session().transport().setPlayhead(moment);
        session().addBoundaryAtPlayhead();
        killed.truth.push_back(corrections(session().document().project()));
        killed.acts.append(QString("time %1\nboundary.add\n").arg(moment) +
                           (i % 7 == 6 ? "file.save\n" : ""));
    }
    ASSERT_GT(killed.truth.back(), kActs / 2);
    expectNothingLost(killed);
}

TEST_F(KillTest, WhileActionsAreLabelledAtMostTheActInProgressIsLost) {
    openSaved();
    const auto labelled = [](const Project& project) {
        int count = 0;
        for (const Fighter& fighter : project.takes.at(0).fighters)
            count += static_cast<int>(fighter.labels->size());
        return count;
    };
    KilledSession killed{"workspace.label\nlabel.next\n", {}, "label.class1", {0}, labelled, 2};
    constexpr int kActs = 6;
    ASSERT_GT(session().fighter(0)->segmentation->actions.size(), std::size_t(kActs));
    for (int i = 0; i < kActs; ++i) {
        // An answer goes on to the next question by itself.
        killed.truth.push_back(i + 1);
        killed.acts.append(i % 3 == 2 ? "label.class1\nfile.save\n" : "label.class1\n");
    }
    expectNothingLost(killed);
}

}  // namespace
}  // namespace kumite::studio
