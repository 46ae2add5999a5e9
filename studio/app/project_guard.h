#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <memory>
#include <optional>

namespace kumite::studio {

/// Who else has a project open.
struct LockHolder {
    QString host;
    qint64 process = 0;
    QDateTime since;
};

/// A lock on a project file, held as long as the object lives: a hidden file beside it that says
/// which process on which host. The lock of a program that ended without a word is taken away.
/// Where none can be written, as in a folder that may not be written to, none is held: nobody
/// can save there.
class ProjectLock {
public:
    explicit ProjectLock(const QString& project);

    /// Who holds the lock instead of us; nothing: nobody.
    const std::optional<LockHolder>& holder() const { return holder_; }
    /// Takes it from whoever holds it.
    void takeOver();
    /// The lock file of a project.
    static QString fileFor(const QString& project);

private:
    void tryToLock();

    std::unique_ptr<QLockFile> lock_;
    std::optional<LockHolder> holder_;
};

/// What a file holds, to see whether somebody else wrote it: SHA-256 of its bytes; empty where
/// there is none.
std::string fingerprint(const QString& file);

}  // namespace kumite::studio
