#include "studio/app/opening.h"

#include "core/project/project_file.h"

namespace kumite::studio {

OpenedProject openProject(const QString& path, const Progress& progress) {
    LoadedProject loaded = loadProject(toPath(path), progress.part(0.0, 0.7));
    OpenedProject opened;
    opened.analysis = analyse(loaded.project, {}, progress.part(0.7, 1.0));
    opened.project = std::move(loaded.project);
    opened.findings = std::move(loaded.findings);
    opened.path = path;
    return opened;
}

OpenedProject openRecordings(const TakeRequest& request, const Progress& progress) {
    ImportedTake imported = importTake(request, progress.part(0.0, 0.7));
    OpenedProject opened;
    opened.project.takes.push_back(std::move(imported.take));
    opened.analysis = analyse(opened.project, {}, progress.part(0.7, 1.0));
    opened.findings = std::move(imported.findings);
    return opened;
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
