#pragma once

#include <QWidget>

#include <memory>

#include "core/labelling/learning_curve.h"
#include "core/project/label_judgement.h"
#include "studio/jobs/job_runner.h"
#include "studio/workspaces/label/confusion_matrix.h"

class QComboBox;
class QLabel;

namespace kumite::studio {

class FoundList;
class LabelSession;
class LearningPlot;
struct LearntLabels;

/// How well machine and rules know the bout: a confusion matrix per aspect over the hand labels,
/// whose cells open their actions, and the learning curve. Computed beside the window while it is
/// shown, from what the machine learnt last.
class QualityBox : public QWidget {
    Q_OBJECT

public:
    explicit QualityBox(LabelSession& labels, QWidget* parent);

    ConfusionMatrix& matrix() { return *matrix_; }
    LearningPlot& plot() { return *plot_; }
    FoundList& list() { return *list_; }
    int aspect() const;
    void setAspect(int aspect);
    bool isBusy() const { return judging_.isRunning() || ordering_.isRunning(); }
    const HandJudgement& judgement() const { return judgement_; }

Q_SIGNALS:
    void updated();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void follow();
    void judge();
    void order();
    void fillAspects();
    void showMatrix();
    void showPlot();
    void openCell(const ConfusionCell& cell);
    void closeCell();

    LabelSession& labels_;
    QComboBox* aspects_;
    QLabel* accuracy_;
    ConfusionMatrix* matrix_;
    QLabel* said_;
    FoundList* list_;
    LearningPlot* plot_;
    QLabel* gain_;
    std::shared_ptr<const LearntLabels> judged_;   ///< what `judgement_` is about
    std::shared_ptr<const LearntLabels> ordered_;  ///< what `orders_` is about
    HandJudgement judgement_;
    OrderCurves orders_;
    std::optional<ConfusionCell> open_;
    JobRunner judging_;
    JobRunner ordering_;
};

}  // namespace kumite::studio
