#pragma once

#include <QObject>
#include <QStringList>

#include "core/project/import.h"
#include "studio/jobs/job_runner.h"

class QWidget;

namespace kumite::studio {

class MessageStrip;
class Session;

/// Opening, saving and exporting, with the questions that belong to them.
class FileActions : public QObject {
    Q_OBJECT

public:
    FileActions(Session& session, MessageStrip& strip, QWidget* window);

    JobRunner& jobs() { return jobs_; }

    /// Opens what was dropped, named on the command line or chosen: a project, or one or two
    /// recordings. Where a bout is open, recordings go through the import dialog.
    void open(const QStringList& files);
    void openProjectFile(const QString& path);
    /// A new project of one take. `unsaved`: its settings were made by hand.
    void openBout(const TakeRequest& request, bool unsaved);
    /// Adds a take to the open project.
    void addBout(const TakeRequest& request);
    void openRecovered(const QString& copy, const QString& original);

    void askForRecordings();
    void askForProject();
    void showImportDialog(const QStringList& files);
    /// Lets the user point to the first recording of the shown take that is missing.
    void askForMissingRecording();

    bool save();
    bool saveAs();
    bool saveTo(const QString& path);
    void askForExport();
    bool exportTo(const QString& path);

    /// Asks what to do with unsaved changes; false: stay.
    bool mayLeave();

Q_SIGNALS:
    /// A bout was opened from these files.
    void opened(const QStringList& files);
    /// The project of a recovery copy is open.
    void recovered();
    /// What was done, for the status line.
    void reported(const QString& text);

private:
    QString startFolder() const;

    Session& session_;
    MessageStrip& strip_;
    QWidget* window_;
    JobRunner jobs_;
};

}  // namespace kumite::studio
