#include "studio/app/recent_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>

namespace kumite::studio {

namespace {

constexpr int kMost = 8;
const QString kFiles = QStringLiteral("recent");
const QString kTimes = QStringLiteral("recentTimes");

QString timeKey(const QStringList& files) {
    return files.join(QLatin1Char('\n'));
}

}  // namespace

QList<RecentBout> recentBouts() {
    const QSettings settings;
    const QVariantMap times = settings.value(kTimes).toMap();
    QList<RecentBout> bouts;
    for (const QVariant& entry : settings.value(kFiles).toList()) {
        const QStringList files = entry.toStringList();
        bool there = !files.isEmpty();
        for (const QString& file : files)
            there = there && QFileInfo::exists(file);
        if (there) bouts.append({files, times.value(timeKey(files)).toDateTime()});
    }
    return bouts;
}

QList<QStringList> recentFiles() {
    QList<QStringList> entries;
    for (const RecentBout& bout : recentBouts())
        entries.append(bout.files);
    return entries;
}

void rememberFiles(const QStringList& files) {
    QStringList absolute;
    for (const QString& file : files)
        absolute.append(QFileInfo(file).absoluteFilePath());
    QList<RecentBout> bouts = recentBouts();
    bouts.removeIf([&](const RecentBout& bout) { return bout.files == absolute; });
    bouts.prepend({absolute, QDateTime::currentDateTime()});
    QVariantList entries;
    QVariantMap times;
    for (const RecentBout& bout : bouts.mid(0, kMost)) {
        entries.append(QVariant(bout.files));
        if (bout.opened.isValid()) times.insert(timeKey(bout.files), bout.opened);
    }
    QSettings settings;
    settings.setValue(kFiles, entries);
    settings.setValue(kTimes, times);
}

QString recentText(const QStringList& files) {
    QStringList names;
    for (const QString& file : files)
        names.append(QFileInfo(file).fileName());
    return names.join(QStringLiteral(" + "));
}

QString folderText(const QStringList& files) {
    if (files.isEmpty()) return {};
    const QString folder = QFileInfo(files.front()).absolutePath();
    const QString home = QDir::homePath();
    const bool own = folder == home || folder.startsWith(home + QLatin1Char('/'));
    return own ? QLatin1Char('~') + folder.mid(home.size()) : folder;
}

QString whenText(const QDateTime& time, const QDateTime& now) {
    if (!time.isValid()) return {};
    const QString clock = time.toString(QStringLiteral("H:mm"));
    const qint64 days = time.date().daysTo(now.date());
    if (days == 0) return QCoreApplication::translate("kumite", "today %1").arg(clock);
    if (days == 1) return QCoreApplication::translate("kumite", "yesterday %1").arg(clock);
    return QLocale().toString(time.date(), QStringLiteral("d MMM yyyy"));
}

}  // namespace kumite::studio
