#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace kumite::studio {

class JobRunner;

/// What is being worked on, how far it is, and a way to stop it; shows itself only where a job
/// takes longer than 0.2 s.
class JobBar : public QWidget {
    Q_OBJECT

public:
    explicit JobBar(QWidget* parent = nullptr);
    void watch(JobRunner& runner);

private:
    QLabel* title_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QTimer delay_;
    JobRunner* shown_ = nullptr;
};

}  // namespace kumite::studio
