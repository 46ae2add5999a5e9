#pragma once

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>

#include "studio/view3d/camera_hand.h"
#include "studio/view3d/graph_scene.h"

namespace kumite::studio {

struct Viewport;

/// Shows a graph: flat or in space. Drag turns it in space and moves it where it is flat, middle or
/// Shift+drag moves, the wheel zooms about the pointer, a click chooses a node or an edge.
class GraphView : public QWidget {
    Q_OBJECT

public:
    explicit GraphView(QWidget* parent = nullptr);
    ~GraphView() override;

    /// Another drawing from the same point of view.
    void show(GraphScene scene);
    const GraphScene& scene() const;
    /// Flat: seen from straight ahead and never turned. Shows all.
    void setFlat(bool flat);
    void showAll();

    /// What the view shows, in device pixels.
    QImage picture();
    /// The same by a painter that may write lines instead of pixels; `size()` large.
    void paint(QPainter& painter) const;
    /// Where a node is drawn; nothing where it lies behind the camera.
    std::optional<QPointF> positionOf(int node) const;

Q_SIGNALS:
    /// Nothing: beside everything.
    void clicked(const std::optional<GraphPick>& pick);
    void activated(const GraphPick& pick);
    void hovered(const std::optional<GraphPick>& pick);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Drawing;

    void redraw();
    void hoverAt(const std::optional<QPointF>& position);
    std::optional<GraphPick> pickAt(const QPointF& position) const;
    Viewport viewport() const;

    std::unique_ptr<Drawing> drawing_;
    CameraHand hand_;
    bool flat_ = true;
    bool moved_ = false;  ///< a hand chose the point of view
};

}  // namespace kumite::studio
