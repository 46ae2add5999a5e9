#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace kumite::studio {

class Session;

/// A copy that a run of the studio left behind without saying goodbye.
struct RecoveryCopy {
    QString file;      ///< the copy itself, a project file
    QString original;  ///< the project that it is of; empty: it was never saved
    QString name;
    QDateTime time;
    int edits = 0;
};

/// Every 30 s writes a copy of a modified project to a folder of the user's data; takes it away
/// when the project is saved or closed. A running studio holds a lock on its own copy.
class Recovery : public QObject {
    Q_OBJECT

public:
    explicit Recovery(Session& session, QObject* parent = nullptr);
    /// A clean end: removes the copy.
    ~Recovery() override;

    /// The newest copy of a studio that is not running any more.
    static std::optional<RecoveryCopy> leftBehind();
    static void discard(const RecoveryCopy& copy);
    static QString folder();

    /// How long changes wait for the next copy; 30 at first.
    void setInterval(int seconds) { timer_.setInterval(seconds * 1000); }
    /// Writes the copy if something changed since the last one.
    void writeCopy();
    void removeCopy();

private:
    Session& session_;
    QString base_;  ///< path of the copy without suffix
    std::unique_ptr<QLockFile> lock_;
    QTimer timer_;
    bool dirty_ = false;
};

}  // namespace kumite::studio
