#include "studio/app/file_actions.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

#include "core/project/edits.h"
#include "core/project/export.h"
#include "core/project/import.h"
#include "core/project/project_file.h"
#include "studio/app/import_dialog.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/app/recent_files.h"
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
    connect(&jobs_, &JobRunner::failed, &strip_, &MessageStrip::showError);
}

QString FileActions::startFolder() const {
    const Document& document = session_.document();
    if (!document.path().isEmpty()) return QFileInfo(document.path()).absolutePath();
    const auto& takes = document.project().takes;
    if (!takes.empty() && !takes.front().fighters.empty()) {
        return QFileInfo(fromPath(takes.front().fighters.front().recording.path)).absolutePath();
    }
    return QSettings()
        .value(QStringLiteral("folder"),
               QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .toString();
}

void FileActions::open(const QStringList& files) {
    if (files.isEmpty()) return;
    const bool anyProject = std::any_of(files.begin(), files.end(), isProjectFile);
    if (anyProject && files.size() > 1) {
        strip_.showError(
            tr("A project opens alone: choose one .kumite file, or one or two "
               "recordings."));
    } else if (anyProject) {
        if (mayLeave()) openProjectFile(files.front());
    } else if (files.size() > 2) {
        strip_.showError(tr("A take has one or two fighters: choose one or two recordings, not %1.")
                             .arg(files.size()));
    } else if (session_.document().isOpen()) {
        showImportDialog(files);
    } else {
        openBout(requestFor(files), false);
    }
}

void FileActions::openProjectFile(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    jobs_.start(
        tr("Opening %1").arg(QFileInfo(path).fileName()),
        [absolute](const Progress& progress) { return openProject(absolute, progress); },
        [this, absolute](OpenedProject project) {
            session_.document().open(History(std::move(project.project)),
                                     std::move(project.analysis), absolute, false);
            strip_.dismiss();
            strip_.showFindings(tr("Found in %1").arg(QFileInfo(absolute).fileName()),
                                project.findings);
            Q_EMIT opened({absolute});
        });
}

void FileActions::openRecovered(const QString& copy, const QString& original) {
    jobs_.start(
        tr("Recovering"), [copy](const Progress& progress) { return openProject(copy, progress); },
        [this, original](OpenedProject project) {
            session_.document().open(History(std::move(project.project), "Recover"),
                                     std::move(project.analysis), original, true);
            strip_.showFindings(tr("Found while recovering"), project.findings);
            Q_EMIT recovered();
        });
}

void FileActions::openBout(const TakeRequest& request, bool unsaved) {
    const QStringList files = filesOf(request);
    jobs_.start(
        tr("Reading %1").arg(recentText(files)),
        [request](const Progress& progress) { return openRecordings(request, progress); },
        [this, files, unsaved](OpenedProject project) {
            session_.document().open(History(std::move(project.project)),
                                     std::move(project.analysis), {}, unsaved);
            strip_.dismiss();
            strip_.showFindings(tr("Found in %1").arg(recentText(files)), project.findings);
            Q_EMIT opened(files);
        });
}

void FileActions::addBout(const TakeRequest& request) {
    jobs_.start(
        tr("Reading %1").arg(recentText(filesOf(request))),
        [request](const Progress& progress) { return importTake(request, progress); },
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
        QFileDialog::getOpenFileNames(window_, tr("Open one or two recordings"), startFolder(),
                                      tr("Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)"));
    if (files.isEmpty()) return;
    QSettings().setValue(QStringLiteral("folder"), QFileInfo(files.front()).absolutePath());
    if (files.size() > 2 || std::any_of(files.begin(), files.end(), isProjectFile)) {
        open(files);
    } else {
        showImportDialog(files);
    }
}

void FileActions::showImportDialog(const QStringList& files) {
    ImportDialog dialog(
        files, session_.document().isOpen() ? session_.document().name() : QString(), window_);
    if (dialog.exec() != QDialog::Accepted) return;
    if (dialog.addsToProject()) {
        addBout(dialog.request());
    } else if (mayLeave()) {
        openBout(dialog.request(), true);
    }
}

void FileActions::askForProject() {
    if (!mayLeave()) return;
    const QString path = QFileDialog::getOpenFileName(window_, tr("Open a project"), startFolder(),
                                                      tr("Kumite projects (*.kumite)"));
    if (path.isEmpty()) return;
    QSettings().setValue(QStringLiteral("folder"), QFileInfo(path).absolutePath());
    openProjectFile(path);
}

void FileActions::askForMissingRecording() {
    const auto& take =
        session_.document().project().takes[static_cast<std::size_t>(session_.take())];
    for (int player = 0; player < session_.playerCount(); ++player) {
        const Fighter& fighter = take.fighters[static_cast<std::size_t>(player)];
        if (fighter.motion) continue;
        const QString path = QFileDialog::getOpenFileName(
            window_,
            tr("Where is %1 of %2?")
                .arg(QFileInfo(fromPath(fighter.recording.path)).fileName(), fighterText(player)),
            startFolder(), tr("Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)"));
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

bool FileActions::save() {
    const QString path = session_.document().path();
    return path.isEmpty() ? saveAs() : saveTo(path);
}

bool FileActions::saveAs() {
    const Document& document = session_.document();
    QString suggestion = document.path();
    if (suggestion.isEmpty()) {
        suggestion = startFolder() + QLatin1Char('/') + document.name() + QStringLiteral(".kumite");
    }
    QString path = QFileDialog::getSaveFileName(window_, tr("Save the project"), suggestion,
                                                tr("Kumite projects (*.kumite)"));
    if (path.isEmpty()) return false;
    if (!isProjectFile(path)) path += QStringLiteral(".kumite");
    return saveTo(path);
}

bool FileActions::saveTo(const QString& path) {
    try {
        saveProject(session_.document().project(), toPath(path));
    } catch (const std::exception& error) {
        strip_.showError(QString::fromUtf8(error.what()));
        return false;
    }
    session_.document().markSaved(QFileInfo(path).absoluteFilePath());
    rememberFiles({path});
    Q_EMIT reported(tr("Saved %1.").arg(QFileInfo(path).fileName()));
    return true;
}

void FileActions::askForExport() {
    const auto& take =
        session_.document().project().takes[static_cast<std::size_t>(session_.take())];
    const QString suggestion = startFolder() + QLatin1Char('/') +
                               QString::fromStdString(take.name) + QStringLiteral(".csv");
    const QString path =
        QFileDialog::getSaveFileName(window_, tr("Export the actions of this take"), suggestion,
                                     tr("Table of actions (*.csv);;Segmentation (*.json);;Motion, "
                                        "one file per fighter (*.bvh)"));
    if (!path.isEmpty()) exportTo(path);
}

bool FileActions::exportTo(const QString& path) {
    QStringList written;
    try {
        Document& document = session_.document();
        document.bringUpToDate();
        for (const auto& file :
             exportTake(document.project(), document.analysis(), session_.take(), toPath(path))) {
            written.append(QFileInfo(fromPath(file)).fileName());
        }
    } catch (const std::exception& error) {
        strip_.showError(QString::fromUtf8(error.what()));
        return false;
    }
    Q_EMIT reported(tr("Exported %1.").arg(written.join(tr(" and "))));
    return true;
}

bool FileActions::mayLeave() {
    if (!session_.document().isModified()) return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to %1?").arg(session_.document().name()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box.setInformativeText(tr("What is not saved is lost."));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) return save();
    return answer == QMessageBox::Discard;
}

}  // namespace kumite::studio
