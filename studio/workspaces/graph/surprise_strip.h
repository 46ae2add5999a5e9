#pragma once

#include <QPixmap>
#include <QWidget>

#include <array>
#include <optional>

#include "studio/timeline/time_mapping.h"
#include "studio/workspaces/graph/graph_session.h"

class QToolButton;

namespace kumite::studio {

class TimelineView;

/// How unexpected each observed transition is over time, one row per fighter; over the timeline and
/// on its scale. What stands out is mislabelled or odd; a click leads there. Which surprise is
/// meant is chosen at its left.
class SurpriseStrip : public QWidget {
    Q_OBJECT

public:
    SurpriseStrip(GraphSession& graph, TimelineView& timeline, QWidget* parent = nullptr);

    /// Where a transition's bar stands; empty where it is not visible.
    QRectF barOf(const TransitionRef& transition) const;

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRectF rowOf(int player) const;
    void addChoice();
    void layOutChoice();
    void takeValues();
    void invalidate();
    void paintStill(QPainter& painter) const;
    std::optional<TransitionRef> transitionNear(const QPointF& position) const;
    void hover(const std::optional<TransitionRef>& transition);

    GraphSession& graph_;
    TimelineView& timeline_;
    std::optional<TransitionRef> hovered_;
    QToolButton* kind_;
    double top_ = 1;               ///< the surprise that fills a row
    std::array<double, 2> odd_{};  ///< by mover, from where on it stands out
    QPixmap still_;                ///< all but what follows pointer and playhead
    bool stillValid_ = false;
};

}  // namespace kumite::studio
