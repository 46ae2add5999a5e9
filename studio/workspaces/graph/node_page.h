#pragma once

#include <QWidget>

#include "studio/workspaces/graph/graph_drawing.h"

class QCheckBox;
class QLabel;
class QSlider;
class QToolButton;

namespace kumite::studio {

class GraphView;

/// The coupled graph as circles and edges, and which of them are drawn.
class NodePage : public QWidget {
    Q_OBJECT

public:
    explicit NodePage(GraphSession& graph, QWidget* parent = nullptr);

    GraphView& view() { return *view_; }
    const GraphDrawing& drawing() const { return drawing_; }
    const DrawingOptions& options() const { return options_; }
    void setInSpace(bool inSpace);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();
    void refresh();
    void showNumbers();
    double aspect() const;
    void choose(const std::optional<GraphPick>& pick);
    void tell(const std::optional<GraphPick>& pick);
    std::optional<GraphSelection> meaningOf(const GraphPick& pick) const;

    GraphSession& graph_;
    DrawingOptions options_;
    GraphDrawing drawing_;
    GraphView* view_;
    QToolButton* space_;
    QCheckBox* cross_;
    QCheckBox* difference_;
    QSlider* least_;
    QSlider* most_;
    QLabel* leastText_;
    QLabel* mostText_;
};

}  // namespace kumite::studio
