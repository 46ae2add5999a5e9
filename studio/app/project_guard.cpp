#include "studio/app/project_guard.h"

#include <QFile>
#include <QFileInfo>

#include "core/base/files.h"
#include "studio/app/opening.h"

namespace kumite::studio {

QString ProjectLock::fileFor(const QString& project) {
    const QFileInfo info(project);
    const QString target = info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
    const QFileInfo file(target);
    return file.path() + QStringLiteral("/.") + file.fileName() + QStringLiteral(".lock");
}

ProjectLock::ProjectLock(const QString& project)
    : lock_(std::make_unique<QLockFile>(fileFor(project))) {
    // Age says nothing: a session lasts hours. A process that is gone does.
    lock_->setStaleLockTime(0);
    tryToLock();
}

void ProjectLock::tryToLock() {
    holder_.reset();
    if (lock_->tryLock(0) || lock_->error() != QLockFile::LockFailedError) return;
    LockHolder holder;
    QString program;
    lock_->getLockInfo(&holder.process, &holder.host, &program);
    holder.since = QFileInfo(lock_->fileName()).lastModified();
    holder_ = holder;
}

void ProjectLock::takeOver() {
    QFile::remove(lock_->fileName());
    tryToLock();
}

std::string fingerprint(const QString& file) {
    if (!QFileInfo::exists(file)) return {};
    return sha256(FileBytes(toPath(file)).bytes());
}

}  // namespace kumite::studio
