#include "studio/workspaces/bout/bout_export.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

#include <cmath>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/formats/bvh.h"
#include "core/formats/gltf.h"
#include "core/project/kept_bout.h"
#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

/// Translations of this file.
struct BoutExport {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::BoutExport)
};

/// "folder/bout" of "folder/bout.bvh".
QString stemOf(const QString& path) {
    const QFileInfo info(path);
    return info.path() + QLatin1Char('/') + info.completeBaseName();
}

void writeBvhPair(const Project& project, const BoutTape& tape, const QString& path,
                  const Progress& progress) {
    const std::array<Motion, 2> motions = boutMotions(project, tape, progress);
    for (const std::size_t player : {0U, 1U}) {
        const QString file = stemOf(path) + QStringLiteral("-%1.bvh").arg(player + 1);
        const Motion& motion = motions[player];
        writeFileAtomically(file.toStdString(), bvhText(motion, motion.frames(), motion.frameTime));
    }
}

/// A component of sRGB as the linear light that glTF counts in.
float linear(float component) {
    return component <= 0.04045f ? component / 12.92f
                                 : std::pow((component + 0.055f) / 1.055f, 2.4f);
}

void writeGltf(const BoutTape& tape, const QString& path, const Progress& progress) {
    const std::array<Clip, 2> clips = boutClips(tape, progress.part(0, 0.5));
    const Colours& c = colours(false);
    std::array<GltfFigure, 2> figures;
    for (const std::size_t player : {0U, 1U}) {
        const QColor colour = c.fighters[player];
        figures[player].name = "player" + std::to_string(player + 1);
        figures[player].clip = &clips[player];
        figures[player].colour = {linear(colour.redF()), linear(colour.greenF()),
                                  linear(colour.blueF())};
    }
    writeFileAtomically(
        path.toStdString(),
        glbBytes(figures, QFileInfo(path).completeBaseName().toStdString(), progress.part(0.5, 1)));
}

}  // namespace

void writeBout(const Project& project, const BoutTape& tape, const QString& path,
               const Progress& progress) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("bvh")) {
        writeBvhPair(project, tape, path, progress);
    } else if (suffix == QLatin1String("glb")) {
        writeGltf(tape, path, progress);
    } else if (suffix == QLatin1String("json")) {
        writeFileAtomically(path.toStdString(), boutLog(tape));
    } else {
        throw Error(path.toStdString() + ": the name must end in .bvh, .glb, .json, .png or .mp4.");
    }
}

QString writePictures(const FilmFrames& frames, const QString& path) {
    for (int i = 0; i < frames.count; ++i) {
        if (!frames.goesOn(static_cast<double>(i) / frames.count)) return {};
        const QString file =
            stemOf(path) + QStringLiteral("-%1.png").arg(i + 1, 5, 10, QLatin1Char('0'));
        if (!frames.picture(i).save(file, "PNG")) {
            return BoutExport::tr("%1: it cannot be written there.").arg(file);
        }
    }
    return {};
}

QString writeVideo(const FilmFrames& frames, const QString& path) {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
    if (program.isEmpty()) {
        return BoutExport::tr(
            "There is no ffmpeg on this computer, which a video needs: install it (on Debian and "
            "Ubuntu: sudo apt install ffmpeg), or export pictures (.png).");
    }
    QProcess ffmpeg;
    ffmpeg.setProcessChannelMode(QProcess::MergedChannels);
    ffmpeg.start(program, {"-y", "-loglevel", "error", "-f", "image2pipe", "-framerate",
                           QString::number(frames.rate, 'f', 3), "-i", "-", "-vf",
                           "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", path});
    if (!ffmpeg.waitForStarted()) return BoutExport::tr("%1 cannot be started.").arg(program);
    for (int i = 0; i < frames.count; ++i) {
        if (!frames.goesOn(static_cast<double>(i) / frames.count)) {
            ffmpeg.kill();
            ffmpeg.waitForFinished();
            QFile::remove(path);
            return {};
        }
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        frames.picture(i).save(&buffer, "PNG");
        ffmpeg.write(bytes);
        while (ffmpeg.bytesToWrite() > 0 && ffmpeg.waitForBytesWritten(10000)) {
        }
        if (ffmpeg.state() != QProcess::Running) break;
    }
    ffmpeg.closeWriteChannel();
    ffmpeg.waitForFinished(-1);
    if (ffmpeg.exitStatus() == QProcess::NormalExit && ffmpeg.exitCode() == 0) return {};
    return BoutExport::tr("ffmpeg could not write the video: %1")
        .arg(QString::fromUtf8(ffmpeg.readAll()).trimmed());
}

}  // namespace kumite::studio
