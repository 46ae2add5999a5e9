#include "studio/app/opening.h"

#include "core/project/project_file.h"
#include "studio/app/project_guard.h"
#include "studio/app/recovery.h"

namespace kumite::studio {

namespace {

OpenedProject analysed(LoadedProject loaded, const Progress& progress) {
    OpenedProject opened;
    opened.analysis = analyse(loaded.project, {}, progress);
    opened.project = std::move(loaded.project);
    opened.findings = std::move(loaded.findings);
    return opened;
}

}  // namespace

OpenedProject openProject(const QString& path, const Progress& progress) {
    // Whoever writes the file while it is read is noticed before it is saved over.
    const std::string read = fingerprint(path);
    OpenedProject opened =
        analysed(loadProject(toPath(path), progress.part(0.0, 0.7)), progress.part(0.7, 1.0));
    opened.fingerprint = read;
    return opened;
}

OpenedProject openCopy(const RecoveryCopy& copy, const Progress& progress) {
    const auto folder = toPath(Recovery::folder());
    Project project = parseProject(copy.project.toStdString(), copy.name.toStdString(), folder);
    return analysed(loadRecordings(std::move(project), folder, {}, progress.part(0.0, 0.7)),
                    progress.part(0.7, 1.0));
}

ImportedTake readTake(const TakeRequest& request, const Recordings& known,
                      const Progress& progress) {
    for (const RecordingKey& key : recordingsOf(request)) {
        if (!known.contains(key)) return importTake(request, progress);
    }
    return makeTake(request, known);
}

OpenedProject openRecordings(const TakeRequest& request, const Recordings& known,
                             const Progress& progress) {
    ImportedTake imported = readTake(request, known, progress.part(0.0, 0.7));
    LoadedProject loaded;
    loaded.project.takes.push_back(std::move(imported.take));
    loaded.findings = std::move(imported.findings);
    return analysed(std::move(loaded), progress.part(0.7, 1.0));
}

TakeRequest requestFor(const QStringList& files) {
    TakeRequest request;
    for (const QString& file : files) {
        FighterRequest fighter;
        fighter.path = toPath(file);
        request.fighters.push_back(std::move(fighter));
    }
    return request;
}

bool isProjectFile(const QString& path) {
    return path.endsWith(QStringLiteral(".kumite"), Qt::CaseInsensitive);
}

std::filesystem::path toPath(const QString& path) {
    const QByteArray bytes = path.toUtf8();
    return std::filesystem::path(std::u8string(bytes.begin(), bytes.end()));
}

QString fromPath(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return QString::fromUtf8(reinterpret_cast<const char*>(text.data()),
                             static_cast<qsizetype>(text.size()));
}

}  // namespace kumite::studio
