#pragma once

#include <QDateTime>
#include <QDialog>

#include <vector>

#include "core/project/versions.h"
#include "studio/jobs/job_runner.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace kumite::studio {

QDateTime momentOf(const KeptVersion& version);

/// The states of a project that were saved over: when, what they hold; one can be restored as an
/// edit that undo takes back, or opened as a copy.
class VersionsDialog : public QDialog {
    Q_OBJECT

public:
    /// `project`: path of its file; empty: it was never saved.
    VersionsDialog(const QString& project, QWidget* parent);

Q_SIGNALS:
    void restoreWanted(const KeptVersion& version);
    void copyWanted(const KeptVersion& version);

private:
    void fill(std::vector<KeptVersion> versions);
    const KeptVersion* chosen() const;
    void refresh();

    std::vector<KeptVersion> versions_;
    QLabel* text_;
    QTreeWidget* list_;
    QPushButton* restore_;
    QPushButton* copy_;
    JobRunner reading_;
};

}  // namespace kumite::studio
