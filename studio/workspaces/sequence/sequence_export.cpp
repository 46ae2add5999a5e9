#include "studio/workspaces/sequence/sequence_export.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/formats/gltf.h"
#include "core/project/kept_clip.h"
#include "studio/app/questions.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

namespace {

QString text(const char* source) {
    return QApplication::translate("kumite::studio::SequenceExport", source);
}

QString suggestion(SequenceSession& sequence) {
    const Document& document = sequence.session().document();
    const QString folder = document.path().isEmpty()
                               ? QSettings().value(QStringLiteral("exportFolder")).toString()
                               : QFileInfo(document.path()).path();
    return folder + QStringLiteral("/sequence.bvh");
}

void addClipsOf(SequenceSession& sequence, const QStringList& paths) {
    if (paths.isEmpty()) return;
    QSettings().setValue(QStringLiteral("clipFolder"), QFileInfo(paths.front()).path());
    std::vector<std::filesystem::path> clips;
    for (const QString& path : paths)
        clips.emplace_back(path.toStdString());
    sequence.session().document().apply(
        Document::ProjectEdit([&](const Project& project) { return addClips(project, clips); }));
}

}  // namespace

void keepSequence(SequenceSession& sequence, QWidget* window) {
    sequence.setPlaying(false);
    const QString path = fileToSave(window, text("Keep the sequence as a take"),
                                    suggestion(sequence), text("Recordings (*.bvh)"));
    if (!path.isEmpty()) keepSequenceAs(sequence, path);
}

void keepSequenceAs(SequenceSession& sequence, const QString& path) {
    const auto motion = sequence.sharedMotion();
    const auto library = sequence.sharedLibrary();
    if (motion == nullptr || library == nullptr) return;
    const QFileInfo info(path);
    sequence.writing().start(
        text("Keeping the sequence"),
        [project = sequence.session().document().project(), motion, library,
         name = info.completeBaseName().toStdString(),
         folder = info.path().toStdString()](const Progress& progress) {
            return keepClip(project, *library, motion->clip, name, folder, progress);
        },
        [&sequence](const KeptClip& kept) {
            const Take& take = kept.edit.project.takes.back();
            // The project may have changed since: the take is added to what it is now.
            const bool done = sequence.session().document().apply(
                Document::ProjectEdit([&](const Project& project) {
                    MaybeEdit edit = addTake(project, take);
                    if (edit) edit->name = kept.edit.name;
                    return edit;
                }));
            if (done) {
                Q_EMIT sequence.session().hinted(
                    text("Kept as take %1.").arg(QString::fromStdString(take.name)));
            }
        });
}

void exportSequence(SequenceSession& sequence, QWidget* window) {
    sequence.setPlaying(false);
    const QString path = fileToSave(window, text("Export the sequence"), suggestion(sequence),
                                    text("Motion (*.bvh);;glTF: skeleton and animation (*.glb)"));
    if (path.isEmpty()) return;
    QSettings().setValue(QStringLiteral("exportFolder"), QFileInfo(path).absolutePath());
    exportSequenceTo(sequence, path);
}

void exportSequenceTo(SequenceSession& sequence, const QString& path) {
    const auto motion = sequence.sharedMotion();
    const auto library = sequence.sharedLibrary();
    if (motion == nullptr || library == nullptr) return;
    sequence.writing().start(
        text("Writing the sequence"),
        [motion, library, path](const Progress& progress) {
            const QString suffix = QFileInfo(path).suffix().toLower();
            if (suffix == QLatin1String("bvh")) {
                writeFileAtomically(path.toStdString(), clipText(*library, motion->clip, progress));
            } else if (suffix == QLatin1String("glb")) {
                GltfFigure figure;
                figure.name = "sequence";
                figure.clip = &motion->clip;
                writeFileAtomically(
                    path.toStdString(),
                    glbBytes({&figure, 1}, QFileInfo(path).completeBaseName().toStdString(),
                             progress));
            } else {
                throw Error(path.toStdString() + ": the name must end in .bvh or .glb.");
            }
            return path;
        },
        [&sequence](const QString& written) {
            Q_EMIT sequence.session().hinted(text("Written: %1").arg(written));
        });
}

void addSequenceClips(SequenceSession& sequence, QWidget* window) {
    addClipsOf(sequence, filesToOpen(window, text("Add clips"),
                                     QSettings().value(QStringLiteral("clipFolder")).toString(),
                                     text("Motion and projects (*.bvh *.amc *.kumite)")));
}

void addSequenceFolder(SequenceSession& sequence, QWidget* window) {
    if (!isAttended()) return;
    const QString folder = QFileDialog::getExistingDirectory(
        window, text("Add all clips of a folder"),
        QSettings().value(QStringLiteral("clipFolder")).toString());
    if (!folder.isEmpty()) addClipsOf(sequence, {folder});
}

}  // namespace kumite::studio
