#include "studio/app/file_actions.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

#include "core/project/demo_bout.h"
#include "core/project/edits.h"
#include "core/project/export.h"
#include "core/project/import.h"
#include "core/project/project_file.h"
#include "studio/app/folders.h"
#include "studio/app/import/import_dialog.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/app/project_guard.h"
#include "studio/app/questions.h"
#include "studio/app/recent_files.h"
#include "studio/app/recovery.h"
#include "studio/app/session.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

QStringList filesOf(const TakeRequest& request) {
    QStringList files;
    for (const FighterRequest& fighter : request.fighters)
        files.append(fromPath(fighter.path));
    return files;
}

}  // namespace

FileActions::FileActions(Session& session, MessageStrip& strip, QWidget* window)
    : QObject(window), session_(session), strip_(strip), window_(window) {
    for (JobRunner* runner : {&jobs_, &writing_, &exporting_})
        connect(runner, &JobRunner::failed, &strip_, &MessageStrip::showError);
}

void FileActions::open(const QStringList& files) {
    if (files.isEmpty()) return;
    const bool anyProject = std::any_of(files.begin(), files.end(), isProjectFile);
    if (files.size() > (anyProject ? 1 : 2)) {
        refuseFiles(files, anyProject);
    } else if (anyProject) {
        if (mayLeave()) openProjectFile(files.front());
    } else if (session_.document().isOpen()) {
        showImportDialog(files);
    } else {
        openBout(requestFor(files), false);
    }
}

void FileActions::openDropped(const QStringList& files) {
    const bool anyProject = std::any_of(files.begin(), files.end(), isProjectFile);
    if (anyProject || files.isEmpty() || files.size() > 2) {
        open(files);
    } else {
        showImportDialog(files);
    }
}

void FileActions::refuseFiles(const QStringList& files, bool anyProject) {
    strip_.showError(
        anyProject ? tr("A project opens alone: choose one .kumite file, or one or two recordings.")
                   : tr("A take has one or two fighters: choose one or two recordings, not %1.")
                         .arg(files.size()));
}

void FileActions::openProjectFile(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const bool isOpenHere = lock_ && session_.document().path() == absolute;
    auto lock = isOpenHere ? lock_ : std::make_shared<ProjectLock>(absolute);
    bool asCopy = false;
    if (lock->holder()) {
        QMessageBox box(QMessageBox::Question, tr("Open elsewhere"),
                        tr("%1 is open in another studio.").arg(QFileInfo(path).fileName()),
                        QMessageBox::Cancel, window_);
        box.setInformativeText(holderText(*lock->holder()) + QLatin1Char('\n') +
                               tr("A copy can be changed and saved under another name. Taking "
                                  "over, you save into this file, and so may the other."));
        QAbstractButton* copy = box.addButton(tr("Open a copy"), QMessageBox::AcceptRole);
        QAbstractButton* take = box.addButton(tr("Take over"), QMessageBox::DestructiveRole);
        box.setDefaultButton(static_cast<QPushButton*>(copy));
        const QAbstractButton* answer = answerOf(box, copy);
        asCopy = answer == copy;
        if (answer == take) {
            lock->takeOver();
        } else if (!asCopy) {
            return;
        }
    }
    jobs_.start(
        tr("Opening %1").arg(QFileInfo(path).fileName()),
        [absolute](const Progress& progress) { return openProject(absolute, progress); },
        [this, absolute, asCopy, lock](OpenedProject project) {
            lock_ = asCopy ? nullptr : lock;
            session_.document().open(History(std::move(project.project)),
                                     std::move(project.analysis), asCopy ? QString() : absolute,
                                     asCopy, asCopy ? std::string() : project.fingerprint);
            strip_.dismiss();
            strip_.showFindings(tr("Found in %1").arg(QFileInfo(absolute).fileName()),
                                project.findings);
            Q_EMIT opened({absolute});
        });
}

void FileActions::openDemo() {
    if (!mayLeave()) return;
    jobs_.start(
        tr("Making the demo bout"),
        [](const Progress& progress) {
            const DemoFiles files = writeDemoBout({}, demoFolder(), progress.part(0, 0.6));
            return openProject(fromPath(files.project()), progress.part(0.6, 1));
        },
        [this](OpenedProject project) {
            lock_ = nullptr;
            session_.document().open(History(std::move(project.project)),
                                     std::move(project.analysis), {}, false);
            strip_.dismiss();
            Q_EMIT reported(
                tr("The demo bout: two made fighters. Save it to keep what you change."));
        });
}

void FileActions::openRecovered(const RecoveryCopy& copy) {
    jobs_.start(
        tr("Recovering %1").arg(copy.name),
        [copy](const Progress& progress) { return openCopy(copy, progress); },
        [this, copy](OpenedProject project) {
            // Saving asks where its file is not any more what was edited.
            lock_.reset();
            session_.document().open(History(std::move(project.project), "Recover"),
                                     std::move(project.analysis), copy.original, true, copy.onDisk);
            strip_.showFindings(tr("Found while recovering"), project.findings);
            Q_EMIT recovered(copy);
        });
}

void FileActions::openBout(const TakeRequest& request, bool unsaved, const Recordings& known) {
    const QStringList files = filesOf(request);
    jobs_.start(
        tr("Reading %1").arg(recentText(files)),
        [request, known](const Progress& progress) {
            return openRecordings(request, known, progress);
        },
        [this, files, unsaved](OpenedProject project) {
            lock_.reset();
            session_.document().open(History(std::move(project.project)),
                                     std::move(project.analysis), {}, unsaved);
            strip_.dismiss();
            strip_.showFindings(tr("Found in %1").arg(recentText(files)), project.findings);
            Q_EMIT opened(files);
        });
}

void FileActions::addBout(const TakeRequest& request, const Recordings& known) {
    jobs_.start(
        tr("Reading %1").arg(recentText(filesOf(request))),
        [request, known](const Progress& progress) { return readTake(request, known, progress); },
        [this](ImportedTake imported) {
            const bool added = session_.document().apply(
                [&imported](const Project& project) { return addTake(project, imported.take); });
            if (!added) return;
            session_.setTake(static_cast<int>(session_.document().project().takes.size()) - 1);
            strip_.showFindings(tr("Found in the recordings"), imported.findings);
        });
}

void FileActions::askForRecordings() {
    const QStringList files =
        filesToOpen(window_, tr("Open one or two recordings"), startFolder(session_.document()),
                    tr("Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)"));
    if (files.isEmpty()) return;
    rememberFolder(files.front());
    if (files.size() > 2 || std::any_of(files.begin(), files.end(), isProjectFile)) {
        open(files);
    } else {
        showImportDialog(files);
    }
}

void FileActions::showImportDialog(const QStringList& files) {
    const Document& document = session_.document();
    auto* dialog =
        new ImportDialog(files, document.isOpen() ? document.name() : QString(), window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (dialog->addsToProject()) {
            addBout(dialog->request(), dialog->recordings());
        } else if (mayLeave()) {
            openBout(dialog->request(), true, dialog->recordings());
        }
    });
    dialog->open();
}

void FileActions::askForProject() {
    if (!mayLeave()) return;
    const QString path = fileToOpen(window_, tr("Open a project"), startFolder(session_.document()),
                                    tr("Kumite projects (*.kumite)"));
    if (path.isEmpty()) return;
    rememberFolder(path);
    openProjectFile(path);
}

void FileActions::askForMissingRecording() {
    const auto& take =
        session_.document().project().takes[static_cast<std::size_t>(session_.take())];
    for (int player = 0; player < session_.playerCount(); ++player) {
        const Fighter& fighter = take.fighters[static_cast<std::size_t>(player)];
        if (fighter.motion) continue;
        const QString path = fileToOpen(
            window_,
            tr("Where is %1 of %2?")
                .arg(QFileInfo(fromPath(fighter.recording.path)).fileName(), fighterText(player)),
            startFolder(session_.document()),
            tr("Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)"));
        if (path.isEmpty()) return;
        const FighterAddress address{session_.take(), player};
        jobs_.start(
            tr("Reading %1").arg(QFileInfo(path).fileName()),
            [path, root = fighter.recording.root](const Progress& progress) {
                const Recording recording = readRecording(toPath(path), {}, progress);
                return std::pair(referTo(recording, toPath(path), root),
                                 motionOfRoot(recording, root));
            },
            [this, address](auto found) {
                session_.document().apply([&](const Project& project) {
                    return relinkRecording(project, address, found.first, found.second);
                });
            });
        return;
    }
}

}  // namespace kumite::studio
