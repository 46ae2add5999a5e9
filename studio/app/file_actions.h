#pragma once

#include <QObject>
#include <QStringList>

#include <memory>
#include <optional>

#include "core/project/import.h"
#include "core/project/versions.h"
#include "studio/app/opening.h"
#include "studio/jobs/job_runner.h"

class QWidget;

namespace kumite::studio {

class MessageStrip;
class ProjectLock;
class Session;

/// Opening, saving and exporting, with the questions that belong to them.
class FileActions : public QObject {
    Q_OBJECT

public:
    FileActions(Session& session, MessageStrip& strip, QWidget* window);

    /// Reading, writing and exporting.
    JobRunner& jobs() { return jobs_; }
    JobRunner& writing() { return writing_; }
    JobRunner& exporting() { return exporting_; }
    bool isBusy() const {
        return jobs_.isRunning() || writing_.isRunning() || exporting_.isRunning();
    }

    /// Opens what was named on the command line or chosen: a project, or one or two recordings.
    /// Where a bout is open, recordings go through the import dialog.
    void open(const QStringList& files);
    /// The same for files that were dropped: recordings always go through the import dialog.
    void openDropped(const QStringList& files);
    /// Where another studio has the project open, asks what to do.
    void openProjectFile(const QString& path);
    /// A new project of one take. `unsaved`: its settings were made by hand.
    void openBout(const TakeRequest& request, bool unsaved, const Recordings& known = {});
    /// Adds a take to the open project.
    void addBout(const TakeRequest& request, const Recordings& known = {});
    /// Makes the demo bout and opens it as a project that has no file yet.
    void openDemo();
    void openRecovered(const RecoveryCopy& copy);

    void askForRecordings();
    void askForProject();
    void showImportDialog(const QStringList& files);
    /// Lets the user point to the first recording of the shown take that is missing.
    void askForMissingRecording();

    bool save();
    bool saveAs();
    /// Writes beside the window and waits for it; false: not saved, and said why.
    bool saveTo(const QString& path);
    void askForExport();
    void askForMotionExport();
    /// Writes beside the window; `reported` tells the end.
    void exportTo(const QString& path);
    /// Lists the states of the project that were saved over.
    void showVersions();

    /// Asks what to do with unsaved changes; false: stay.
    bool mayLeave();

    /// Waits until edits that wait for derived values are made.
    void finishEdits();
    /// The lock of the open project; null: it has no file.
    std::shared_ptr<ProjectLock> lock() const { return lock_; }
    void setLock(std::shared_ptr<ProjectLock> lock) { lock_ = std::move(lock); }

Q_SIGNALS:
    /// A bout was opened from these files.
    void opened(const QStringList& files);
    /// The project of a recovery copy is open.
    void recovered(const RecoveryCopy& copy);
    /// What was done, for the status line.
    void reported(const QString& text);

private:
    /// Where an export of the shown take would go, without a suffix.
    QString exportName() const;
    struct Saved;

    void refuseFiles(const QStringList& files, bool anyProject);
    void restore(const KeptVersion& version);
    void openVersion(const KeptVersion& version);
    bool mayTakeOver(ProjectLock& lock, const QString& path);
    bool mayReplace(const QString& path);
    std::optional<Saved> write(const QString& path, bool whateverIsThere);

    Session& session_;
    MessageStrip& strip_;
    QWidget* window_;
    JobRunner jobs_;
    JobRunner writing_;
    JobRunner exporting_;  ///< goes on while the project is saved
    std::shared_ptr<ProjectLock> lock_;
};

}  // namespace kumite::studio
