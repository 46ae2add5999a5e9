#pragma once

#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <optional>
#include <vector>

#include "core/labelling/learning_curve.h"

namespace kumite::studio {

/// What the plot shows; shares 0 … 1 over numbers of labels.
struct LearningPlotValues {
    std::vector<QPointF> expected;  ///< as the session went: labels, expected accuracy
    OrderCurves orders;             ///< asked against random; may be empty
    bool mayStop = false;           ///< more labels will hardly help
};

/// The axes of the plot: round numbers of labels across, shares up.
struct LearningPlotAxes {
    QRectF area;
    int mostLabels = 10;
    int labelStep = 5;
    double leastShare = 0;

    QPointF pointOf(double labels, double share) const;
    double labelsAt(double x) const;
};
LearningPlotAxes axesOf(const LearningPlotValues& values, const QRectF& area);

/// Accuracy over labels given: what cross-validation expected as the session went, and, estimated
/// from the hand labels, the order of the queue against random order. The values under the pointer
/// stand above; the last point is marked where more labels will hardly help.
class LearningPlot : public QWidget {
    Q_OBJECT

public:
    explicit LearningPlot(QWidget* parent = nullptr);

    void show(const LearningPlotValues& values);
    bool isEmpty() const;
    /// The values at a number of labels: "40 labels: expected 91 %, as asked 88 %, random 79 %".
    QString textAt(double labels) const;
    LearningPlotAxes axes() const;

    QSize sizeHint() const override { return {260, 150}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

Q_SIGNALS:
    void pointed(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paintAxes(QPainter& painter, const LearningPlotAxes& axes) const;
    void paintCurves(QPainter& painter, const LearningPlotAxes& axes) const;
    void paintLegend(QPainter& painter, const LearningPlotAxes& axes) const;

    LearningPlotValues values_;
    std::optional<double> pointer_;  ///< labels under the pointer
};

}  // namespace kumite::studio
