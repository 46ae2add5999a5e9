#include "studio/app/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace kumite::studio {

namespace {
constexpr int kMost = 8;
const QString kKey = QStringLiteral("recent");
}  // namespace

QList<QStringList> recentFiles() {
    QSettings settings;
    QList<QStringList> entries;
    for (const QVariant& entry : settings.value(kKey).toList()) {
        const QStringList files = entry.toStringList();
        bool there = !files.isEmpty();
        for (const QString& file : files)
            there = there && QFileInfo::exists(file);
        if (there) entries.append(files);
    }
    return entries;
}

void rememberFiles(const QStringList& files) {
    QStringList absolute;
    for (const QString& file : files)
        absolute.append(QFileInfo(file).absoluteFilePath());
    QList<QStringList> entries = recentFiles();
    entries.removeAll(absolute);
    entries.prepend(absolute);
    QVariantList values;
    for (const QStringList& entry : entries.mid(0, kMost))
        values.append(QVariant(entry));
    QSettings().setValue(kKey, values);
}

QString recentText(const QStringList& files) {
    QStringList names;
    for (const QString& file : files)
        names.append(QFileInfo(file).fileName());
    return names.join(QStringLiteral(" + "));
}

}  // namespace kumite::studio
