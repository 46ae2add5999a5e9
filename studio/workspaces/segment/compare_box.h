#pragma once

#include <QWidget>

#include "core/project/analysis.h"
#include "studio/jobs/job_runner.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace kumite::studio {

class Session;
class SettingsFields;

/// A second way to cut the take beside the project's own: its boundaries are drawn faintly on the
/// timeline, and counted where they differ. Nothing of it is kept but by "Use B".
class CompareBox : public QWidget {
    Q_OBJECT

public:
    explicit CompareBox(Session& session, QWidget* parent);

    bool isOn() const;
    void setOn(bool on);
    QCheckBox* toggle() const { return on_; }

Q_SIGNALS:
    void toggled();

private:
    void compute();
    void showCounts();
    void use();

    Session& session_;
    QCheckBox* on_;
    SettingsFields* fields_;
    QLabel* counts_;
    QPushButton* use_;
    Analysis values_;  ///< the take cut by B; its stages are taken over by the next
    JobRunner jobs_;
};

}  // namespace kumite::studio
