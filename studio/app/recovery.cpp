#include "studio/app/recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QUuid>

#include "core/project/project_file.h"
#include "studio/app/opening.h"
#include "studio/app/session.h"

namespace kumite::studio {

namespace {

QString withoutSuffix(const QString& file) {
    return file.left(file.lastIndexOf(QLatin1Char('.')));
}

void removeFiles(const QString& base) {
    for (const char* suffix : {".kumite", ".ini", ".lock"})
        QFile::remove(base + QLatin1String(suffix));
}

}  // namespace

QString Recovery::folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
           QStringLiteral("/recovery");
}

Recovery::Recovery(Session& session, QObject* parent) : QObject(parent), session_(session) {
    QDir().mkpath(folder());
    base_ = folder() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces);
    lock_ = std::make_unique<QLockFile>(base_ + QStringLiteral(".lock"));
    lock_->setStaleLockTime(0);
    lock_->tryLock();
    timer_.setInterval(30'000);
    timer_.start();
    connect(&timer_, &QTimer::timeout, this, &Recovery::writeCopy);
    connect(&session_.document(), &Document::changed, this, [this] {
        dirty_ = session_.document().isModified();
        if (!dirty_) removeCopy();
    });
}

Recovery::~Recovery() {
    removeCopy();
    lock_->unlock();
}

void Recovery::writeCopy() {
    const Document& document = session_.document();
    if (!dirty_ || !document.isModified()) return;
    try {
        saveProject(document.project(), toPath(base_ + QStringLiteral(".kumite")));
    } catch (const std::exception&) {
        // A full disk must not interrupt the work; the next attempt is half a minute away.
        return;
    }
    QSettings about(base_ + QStringLiteral(".ini"), QSettings::IniFormat);
    about.setValue(QStringLiteral("original"), document.path());
    about.setValue(QStringLiteral("name"), document.name());
    about.setValue(QStringLiteral("edits"), static_cast<int>(document.history().position()));
    dirty_ = false;
}

void Recovery::removeCopy() {
    for (const char* suffix : {".kumite", ".ini"})
        QFile::remove(base_ + QLatin1String(suffix));
}

std::optional<RecoveryCopy> Recovery::leftBehind() {
    const QFileInfoList files =
        QDir(folder()).entryInfoList({QStringLiteral("*.kumite")}, QDir::Files, QDir::Time);
    for (const QFileInfo& file : files) {
        const QString base = withoutSuffix(file.absoluteFilePath());
        QLockFile lock(base + QStringLiteral(".lock"));
        lock.setStaleLockTime(0);
        if (!lock.tryLock()) continue;
        const QSettings about(base + QStringLiteral(".ini"), QSettings::IniFormat);
        return RecoveryCopy{file.absoluteFilePath(),
                            about.value(QStringLiteral("original")).toString(),
                            about.value(QStringLiteral("name")).toString(), file.lastModified(),
                            about.value(QStringLiteral("edits")).toInt()};
    }
    return std::nullopt;
}

void Recovery::discard(const RecoveryCopy& copy) {
    removeFiles(withoutSuffix(copy.file));
}

}  // namespace kumite::studio
