#include "studio/app/folders.h"

#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include "core/project/demo_bout.h"
#include "studio/app/document.h"
#include "studio/app/opening.h"

namespace kumite::studio {

namespace {
constexpr const char* kKey = "folder";
}

QString startFolder(const Document& document) {
    if (!document.path().isEmpty()) return QFileInfo(document.path()).absolutePath();
    const auto& takes = document.project().takes;
    if (!takes.empty() && !takes.front().fighters.empty()) {
        const auto folder = takes.front().fighters.front().recording.path.parent_path();
        if (folder != demoFolder()) return fromPath(folder);
    }
    return QSettings()
        .value(QLatin1String(kKey),
               QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .toString();
}

void rememberFolder(const QString& file) {
    QSettings().setValue(QLatin1String(kKey), QFileInfo(file).absolutePath());
}

}  // namespace kumite::studio
