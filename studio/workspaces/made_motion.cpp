#include "studio/workspaces/made_motion.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/formats/gltf.h"
#include "core/project/kept_clip.h"
#include "core/project/made_takes.h"
#include "studio/app/folders.h"
#include "studio/app/questions.h"
#include "studio/app/session.h"
#include "studio/jobs/job_runner.h"

namespace kumite::studio {

namespace {

/// Translations of this file.
struct MadeMotionWords {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::MadeMotion)
};

QString suggestion(const Session& session, const QString& name) {
    return startFolder(session.document()) + QLatin1Char('/') + name + QStringLiteral(".bvh");
}

void addClipsOf(Session& session, const QStringList& paths) {
    if (paths.isEmpty()) return;
    QSettings().setValue(QStringLiteral("clipFolder"), QFileInfo(paths.front()).path());
    std::vector<std::filesystem::path> clips;
    for (const QString& path : paths)
        clips.emplace_back(path.toStdString());
    session.document().apply(
        Document::ProjectEdit([&](const Project& project) { return addClips(project, clips); }));
}

}  // namespace

void keepMotion(Session& session, JobRunner& writing, const MadeMotion& motion, QWidget* window) {
    const QString path =
        fileToSave(window, MadeMotionWords::tr("Keep the motion as a take"),
                   suggestion(session, motion.name), MadeMotionWords::tr("Recordings (*.bvh)"));
    if (!path.isEmpty()) keepMotionAs(session, writing, motion, path);
}

void keepMotionAs(Session& session, JobRunner& writing, const MadeMotion& motion,
                  const QString& path) {
    const QFileInfo info(path);
    writing.start(
        MadeMotionWords::tr("Keeping the motion"),
        [project = session.document().project(), motion,
         name = info.completeBaseName().toStdString(),
         folder = info.path().toStdString()](const Progress& progress) {
            return keepClip(project, *motion.library, *motion.clip, name, folder, progress);
        },
        [&session](const KeptClip& kept) {
            const Take& take = kept.edit.project.takes.back();
            // The project may have changed since: the take is added to what it is now.
            const bool done =
                session.document().apply(Document::ProjectEdit([&](const Project& project) {
                    MaybeEdit edit = addMadeTake(project, take);
                    if (edit) edit->name = kept.edit.name;
                    return edit;
                }));
            if (done) {
                Q_EMIT session.hinted(
                    MadeMotionWords::tr("Kept as take %1.").arg(QString::fromStdString(take.name)));
            }
        });
}

void exportMotion(Session& session, JobRunner& writing, const MadeMotion& motion, QWidget* window) {
    const QString path = fileToSave(
        window, MadeMotionWords::tr("Export the motion"), suggestion(session, motion.name),
        MadeMotionWords::tr("Motion (*.bvh);;glTF: skeleton and animation (*.glb)"));
    if (path.isEmpty()) return;
    rememberFolder(path);
    exportMotionTo(session, writing, motion, path);
}

void exportMotionTo(Session& session, JobRunner& writing, const MadeMotion& motion,
                    const QString& path) {
    writing.start(
        MadeMotionWords::tr("Writing the motion"),
        [motion, path](const Progress& progress) {
            const QString suffix = QFileInfo(path).suffix().toLower();
            if (suffix == QLatin1String("bvh")) {
                writeFileAtomically(path.toStdString(),
                                    clipText(*motion.library, *motion.clip, progress));
            } else if (suffix == QLatin1String("glb")) {
                GltfFigure figure;
                figure.name = motion.name.toStdString();
                figure.clip = motion.clip.get();
                writeFileAtomically(
                    path.toStdString(),
                    glbBytes({&figure, 1}, QFileInfo(path).completeBaseName().toStdString(),
                             progress));
            } else {
                throw Error(path.toStdString() + ": the name must end in .bvh or .glb.");
            }
            return path;
        },
        [&session](const QString& written) {
            Q_EMIT session.hinted(MadeMotionWords::tr("Written: %1").arg(written));
        });
}

void askForClips(Session& session, QWidget* window) {
    addClipsOf(session,
               filesToOpen(window, MadeMotionWords::tr("Add clips"),
                           QSettings().value(QStringLiteral("clipFolder")).toString(),
                           MadeMotionWords::tr("Motion and projects (*.bvh *.amc *.kumite)")));
}

void askForClipFolder(Session& session, QWidget* window) {
    if (!isAttended()) return;
    const QString folder = QFileDialog::getExistingDirectory(
        window, MadeMotionWords::tr("Add all clips of a folder"),
        QSettings().value(QStringLiteral("clipFolder")).toString());
    if (!folder.isEmpty()) addClipsOf(session, {folder});
}

}  // namespace kumite::studio
