#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <memory>
#include <string>
#include <vector>

#include "core/project/project.h"
#include "studio/jobs/job_runner.h"

namespace kumite::studio {

class Session;

/// A copy that a run of the studio left behind without saying goodbye.
struct RecoveryCopy {
    QString base;      ///< path of its files without their suffixes
    QString original;  ///< the project that it is of; empty: it was never saved
    QString name;
    std::string onDisk;  ///< fingerprint of the project's file when it was last read or saved
    QDateTime time;      ///< of the last edit in it, by the machine's clock, which may be set
    int edits = 0;       ///< since the project was saved
    int number = 0;      ///< counts the copies of one run: a greater one is newer
    QByteArray project;  ///< text of the project file
};

/// Keeps a copy of a modified project in a folder of the user's data, so that at most the act in
/// progress is lost however the program ends:
/// - after every edit, before the next is possible, a copy that outlives the program (`.edit`);
/// - every 30 s and after 20 edits, beside the window, one that outlives a power cut (`.kumite`).
/// Saving or closing takes them away. A running studio holds a lock on its own copies.
class Recovery : public QObject {
    Q_OBJECT

public:
    explicit Recovery(Session& session, QObject* parent = nullptr);
    /// A clean end: removes the copies.
    ~Recovery() override;

    /// Copies of studios that are not running any more, the newest first. The newer of the two
    /// files counts that can be read.
    static std::vector<RecoveryCopy> leftBehind();
    static void discard(const RecoveryCopy& copy);
    static QString folder();

    /// How long changes wait for the next autosave.
    void setInterval(int seconds) { timer_.setInterval(seconds * 1000); }
    /// Edits that the open project had before it was recovered: they count as not saved.
    void countOn(int edits) { before_ = edits; }
    /// Writes the copy that outlives a power cut, if something changed since the last one.
    void autosave();

Q_SIGNALS:
    /// The copy cannot be written; said once until it can be again.
    void failed(const QString& sentence);

private:
    void projectChanged();
    void removeCopies();
    QByteArray copyText() const;
    void report(const QString& sentence);

    Session& session_;
    QString base_;
    std::unique_ptr<QLockFile> lock_;
    QTimer timer_;
    JobRunner writing_;
    Project copied_;        ///< what `.edit` holds
    bool hasCopy_ = false;  ///< whether it holds anything
    int sinceAutosave_ = 0;
    int number_ = 0;  ///< of the copy that was written last
    int before_ = 0;
    bool reported_ = false;
};

}  // namespace kumite::studio
