#pragma once

#include <QWidget>

#include <functional>

#include "studio/workspaces/graph/graph_session.h"

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace kumite::studio {

class MatrixPage;
class NodePage;

/// What the Graph workspace shows beside the 3D view: the transitions as a matrix or as a graph, of
/// one fighter or compared; where there are none, what makes them appear.
class GraphCentre : public QWidget {
    Q_OBJECT

public:
    explicit GraphCentre(GraphSession& graph, QWidget* parent = nullptr);

    MatrixPage& matrix() { return *matrix_; }
    NodePage& nodes() { return *nodes_; }
    bool showsMatrix() const;
    void showMatrix(bool matrix);
    /// Offers a step where there is nothing to show.
    void addStep(const QString& text, const QString& tip, std::function<void()> run);

private:
    QWidget* makeHeader();
    QWidget* makeEmptyPage();
    void refresh();

    GraphSession& graph_;
    QStackedWidget* pages_;
    QStackedWidget* views_;
    MatrixPage* matrix_;
    NodePage* nodes_;
    QButtonGroup* viewButtons_;
    QButtonGroup* moverButtons_;
    QComboBox* versus_;
    QLabel* why_;
    QHBoxLayout* steps_;
};

}  // namespace kumite::studio
