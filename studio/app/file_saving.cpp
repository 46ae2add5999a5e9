// Saving, exporting, versions and leaving: the writing half of FileActions.

#include <QEventLoop>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "core/base/error.h"
#include "core/project/edits.h"
#include "core/project/export.h"
#include "core/project/project_file.h"
#include "studio/app/file_actions.h"
#include "studio/app/folders.h"
#include "studio/app/message_strip.h"
#include "studio/app/project_guard.h"
#include "studio/app/questions.h"
#include "studio/app/recent_files.h"
#include "studio/app/session.h"
#include "studio/app/versions_dialog.h"
#include "studio/app/words.h"

namespace kumite::studio {

/// What came of a save.
struct FileActions::Saved {
    bool othersWork = false;  ///< somebody else wrote the file: nothing was saved
    Findings findings;
    std::string fingerprint;
};

bool FileActions::save() {
    const QString path = session_.document().path();
    return path.isEmpty() ? saveAs() : saveTo(path);
}

bool FileActions::saveAs() {
    const Document& document = session_.document();
    QString suggestion = document.path();
    if (suggestion.isEmpty()) {
        suggestion =
            startFolder(document) + QLatin1Char('/') + document.name() + QStringLiteral(".kumite");
    }
    QString path =
        fileToSave(window_, tr("Save the project"), suggestion, tr("Kumite projects (*.kumite)"));
    if (path.isEmpty()) return false;
    if (!isProjectFile(path)) path += QStringLiteral(".kumite");
    return saveTo(path);
}

void FileActions::finishEdits() {
    // Edits that wait for derived values belong to what is written.
    const Document& document = session_.document();
    while (document.isWaiting() && document.isComputing()) {
        QEventLoop loop;
        connect(&session_.document().jobs(), &JobRunner::finished, &loop, &QEventLoop::quit);
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    }
}

std::optional<FileActions::Saved> FileActions::write(const QString& path, bool whateverIsThere) {
    std::optional<Saved> saved;
    finishEdits();
    QEventLoop loop;
    connect(&writing_, &JobRunner::finished, &loop, &QEventLoop::quit);
    writing_.start(
        tr("Saving %1").arg(QFileInfo(path).fileName()),
        [project = session_.document().project(), path, whateverIsThere,
         expected = session_.document().onDisk()](const Progress&) {
            Saved result;
            if (!whateverIsThere) {
                const std::string now = fingerprint(path);
                result.othersWork = !now.empty() && now != expected;
                if (result.othersWork) return result;
            }
            try {
                result.findings = saveProject(project, toPath(path));
            } catch (const std::exception& error) {
                throw Error(std::string(error.what()) +
                            " The file is as it was, and your work is still open here: try again, "
                            "or save it elsewhere.");
            }
            result.fingerprint = fingerprint(path);
            return result;
        },
        [&saved](Saved result) { saved = std::move(result); });
    // The window goes on to draw; keys and clicks wait, so that what is saved is what is shown.
    if (writing_.isRunning()) loop.exec(QEventLoop::ExcludeUserInputEvents);
    return saved;
}

bool FileActions::saveTo(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const bool isNew = absolute != session_.document().path();
    auto lock = isNew || !lock_ ? std::make_shared<ProjectLock>(absolute) : lock_;
    if (lock->holder() && !mayTakeOver(*lock, absolute)) return false;
    // A file dialog has asked before about a file that is there.
    std::optional<Saved> saved = write(absolute, isNew);
    if (saved && saved->othersWork) {
        if (!mayReplace(absolute)) return false;
        saved = write(absolute, true);
    }
    if (!saved) return false;
    lock_ = lock;
    session_.document().markSaved(absolute, saved->fingerprint);
    rememberFiles({absolute});
    strip_.showFindings(tr("Found while saving"), saved->findings);
    Q_EMIT reported(tr("Saved %1.").arg(QFileInfo(path).fileName()));
    return true;
}

bool FileActions::mayTakeOver(ProjectLock& lock, const QString& path) {
    QMessageBox box(QMessageBox::Question, tr("Open elsewhere"),
                    tr("%1 is open in another studio.").arg(QFileInfo(path).fileName()),
                    QMessageBox::Cancel, window_);
    box.setInformativeText(holderText(*lock.holder()));
    auto* take = box.addButton(tr("Save all the same"), QMessageBox::DestructiveRole);
    auto* as = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
    box.setDefaultButton(as);
    const QAbstractButton* answer = answerOf(box, box.button(QMessageBox::Cancel));
    if (answer == take) {
        lock.takeOver();
        return true;
    }
    if (answer == as) saveAs();
    return false;
}

bool FileActions::mayReplace(const QString& path) {
    QMessageBox box(QMessageBox::Question, tr("Changed on the disk"),
                    tr("%1 was changed outside this window since you opened it.")
                        .arg(QFileInfo(path).fileName()),
                    QMessageBox::Cancel, window_);
    box.setInformativeText(
        tr("It was written %1. If you save over it, what it holds now is kept as a version.")
            .arg(momentText(QFileInfo(path).lastModified(), true)));
    auto* over = box.addButton(tr("Save over it"), QMessageBox::DestructiveRole);
    auto* as = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
    box.setDefaultButton(as);
    const QAbstractButton* answer = answerOf(box, box.button(QMessageBox::Cancel));
    if (answer == as) saveAs();
    return answer == over;
}

QString FileActions::exportName() const {
    const Document& document = session_.document();
    const auto& takes = document.project().takes;
    const QString take =
        QString::fromStdString(takes[static_cast<std::size_t>(session_.take())].name);
    const QString project = QFileInfo(document.path()).completeBaseName();
    const QString name = project.isEmpty() || project == take ? take
                         : takes.size() == 1                  ? project
                                                              : project + QLatin1Char('-') + take;
    return startFolder(document) + QLatin1Char('/') + name;
}

void FileActions::askForExport() {
    const QString path = fileToSave(window_, tr("Export the actions of this take"),
                                    exportName() + QStringLiteral(".csv"),
                                    tr("Table of actions (*.csv);;Segmentation (*.json)"));
    if (!path.isEmpty()) exportTo(path);
}

void FileActions::askForMotionExport() {
    const QString path = fileToSave(window_, tr("Export the motion of this take"),
                                    exportName() + QStringLiteral(".bvh"),
                                    tr("Motion, one file per fighter (*.bvh)"));
    if (!path.isEmpty()) exportTo(path);
}

void FileActions::exportTo(const QString& path) {
    finishEdits();
    const Document& document = session_.document();
    exporting_.start(
        tr("Exporting %1").arg(QFileInfo(path).fileName()),
        [project = document.project(), previous = document.analysis(), take = session_.take(),
         path](const Progress& progress) {
            const Analysis analysis = analyse(project, previous, progress.part(0.0, 0.5));
            QStringList written;
            for (const auto& file : exportTake(project, analysis, take, toPath(path)))
                written.append(QFileInfo(fromPath(file)).fileName());
            return written;
        },
        [this](const QStringList& written) {
            Q_EMIT reported(tr("Exported %1.").arg(written.join(tr(" and "))));
        });
}

void FileActions::showVersions() {
    auto* dialog = new VersionsDialog(session_.document().path(), window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &VersionsDialog::restoreWanted, this, &FileActions::restore);
    connect(dialog, &VersionsDialog::copyWanted, this, &FileActions::openVersion);
    dialog->open();
}

void FileActions::restore(const KeptVersion& version) {
    const Document& document = session_.document();
    const QString when = momentText(momentOf(version), true);
    jobs_.start(
        tr("Reading the version of %1").arg(when),
        [path = document.path(), version, known = document.project()](const Progress& progress) {
            return loadVersion(toPath(path), version, known, progress);
        },
        [this, when](LoadedProject loaded) {
            const bool restored = session_.document().apply([&](const Project& project) {
                return restoreVersion(project, loaded.project, when.toStdString());
            });
            strip_.showFindings(tr("Found in the version"), loaded.findings);
            Q_EMIT reported(restored
                                ? tr("Restored the version of %1; Ctrl+Z takes it back.").arg(when)
                                : tr("That version is what is open."));
        });
}

void FileActions::openVersion(const KeptVersion& version) {
    if (!mayLeave()) return;
    const QString when = momentText(momentOf(version), true);
    jobs_.start(
        tr("Reading the version of %1").arg(when),
        [path = session_.document().path(), version,
         known = session_.document().project()](const Progress& progress) {
            LoadedProject loaded = loadVersion(toPath(path), version, known, progress);
            Analysis analysis = analyse(loaded.project, {}, progress.part(0.7, 1.0));
            return std::pair(std::move(loaded), std::move(analysis));
        },
        [this, when](std::pair<LoadedProject, Analysis> version) {
            lock_.reset();
            session_.document().open(History(std::move(version.first.project)),
                                     std::move(version.second), {}, true);
            strip_.showFindings(tr("Found in the version"), version.first.findings);
            Q_EMIT reported(tr("The version of %1 is open as a copy.").arg(when));
        });
}

bool FileActions::mayLeave() {
    if (!session_.document().isModified()) return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to %1?").arg(session_.document().name()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box.setInformativeText(tr("What is not saved is lost."));
    box.setDefaultButton(QMessageBox::Save);
    const QAbstractButton* answer = answerOf(box, box.button(QMessageBox::Discard));
    if (answer == box.button(QMessageBox::Save)) return save();
    return answer == box.button(QMessageBox::Discard);
}

}  // namespace kumite::studio
