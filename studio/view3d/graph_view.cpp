#include "studio/view3d/graph_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <vtkActor.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>

#include "studio/app/theme.h"
#include "studio/view3d/graph_geometry.h"
#include "studio/view3d/mesh_actor.h"
#include "studio/view3d/vtk_widget.h"

namespace kumite::studio {

namespace {

/// Names over the picture; the mouse does not notice them.
class NamesOverlay : public QWidget {
public:
    NamesOverlay(QWidget* parent, const GraphScene& scene, const CameraController& camera)
        : QWidget(parent), scene_(scene), camera_(camera) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
    }

    std::optional<int> always;

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QFont small = font();
        small.setPointSizeF(std::max(7.5, small.pointSizeF() - 1.0));
        painter.setFont(small);
        paintNames(painter, scene_, camera_, {double(width()), double(height())},
                   coloursFor(palette()), always);
    }

private:
    const GraphScene& scene_;
    const CameraController& camera_;
};

}  // namespace

struct GraphView::Drawing {
    explicit Drawing(QWidget* parent)
        : canvas(new VtkWidget(parent)), names(new NamesOverlay(parent, scene, camera)) {
        points->SetDataTypeToFloat();
        colours->SetNumberOfComponents(3);
        data->SetPoints(points);
        data->GetPointData()->SetScalars(colours);
        mapper->SetInputData(data);
        mapper->SetColorModeToDirectScalars();
        actor->SetMapper(mapper);
        actor->GetProperty()->LightingOff();
        actor->ForceOpaqueOn();
        canvas->renderer()->AddActor(actor);
        canvas->setAttribute(Qt::WA_TransparentForMouseEvents);
    }

    void show(const ColouredMesh& mesh) {
        const auto count = static_cast<vtkIdType>(mesh.points.size());
        points->SetNumberOfPoints(count);
        colours->SetNumberOfTuples(count);
        if (count > 0) {
            std::memcpy(points->GetData()->GetVoidPointer(0), mesh.points.data(),
                        mesh.points.size() * sizeof(mesh.points[0]));
            std::memcpy(colours->GetVoidPointer(0), mesh.colours.data(), mesh.colours.size());
        }
        setTriangles(*data, mesh.triangles);
        points->Modified();
        colours->Modified();
        data->Modified();
    }

    GraphScene scene;
    CameraController camera;
    VtkWidget* canvas;
    NamesOverlay* names;
    vtkNew<vtkPoints> points;
    vtkNew<vtkUnsignedCharArray> colours;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
    std::optional<GraphPick> hovered;
};

GraphView::GraphView(QWidget* parent) : QWidget(parent), drawing_(std::make_unique<Drawing>(this)) {
    setAccessibleName(tr("Graph of transitions"));
    setAccessibleDescription(tr(
        "A node is a label, an edge leads to what follows. A click shows the moments behind it."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(200, 140);
    setFlat(true);
}

GraphView::~GraphView() {
    // Before the drawing: the widget's context must still be there when VTK lets go of it.
    delete drawing_->canvas;
}

Viewport GraphView::viewport() const {
    return {double(width()), double(height())};
}

const GraphScene& GraphView::scene() const {
    return drawing_->scene;
}

void GraphView::show(GraphScene scene) {
    const bool first = drawing_->scene.nodes.empty();
    const bool sameNodes = drawing_->scene.nodes.size() == scene.nodes.size();
    drawing_->scene = std::move(scene);
    if (!sameNodes) drawing_->hovered.reset();
    if (first || !moved_) {
        showAll();
    } else {
        redraw();
    }
}

void GraphView::setFlat(bool flat) {
    flat_ = flat;
    drawing_->camera.lookFrom(flat ? 0 : 0.62, flat ? 0 : 0.22);
    showAll();
}

void GraphView::showAll() {
    moved_ = false;
    drawing_->camera.frame(extentOf(drawing_->scene), viewport());
    redraw();
}

void GraphView::redraw() {
    const Colours& c = coloursFor(palette());
    vtkRenderer* renderer = drawing_->canvas->renderer();
    renderer->SetBackground(c.ground.redF(), c.ground.greenF(), c.ground.blueF());
    const CameraController& camera = drawing_->camera;
    aim(*renderer, camera, std::max(0.05, camera.distance() - 4), camera.distance() + 6);
    drawing_->show(graphMesh(drawing_->scene, camera, c));
    drawing_->canvas->markDirty();
    drawing_->names->update();
}

QImage GraphView::picture() {
    QImage image = drawing_->canvas->picture();
    QPainter painter(&image);
    drawing_->names->render(&painter, {}, {}, QWidget::DrawChildren);
    painter.end();
    return image;
}

void GraphView::paint(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    paintGraph(painter, drawing_->scene, drawing_->camera, viewport(), coloursFor(palette()));
}

std::optional<QPointF> GraphView::positionOf(int node) const {
    const auto index = static_cast<std::size_t>(node);
    if (node < 0 || index >= drawing_->scene.nodes.size()) return std::nullopt;
    const Eigen::Vector3d at =
        drawing_->camera.project(drawing_->scene.nodes[index].place, viewport());
    if (at.z() <= 0) return std::nullopt;
    return QPointF(at.x(), at.y());
}

std::optional<GraphPick> GraphView::pickAt(const QPointF& position) const {
    return pickGraph(drawing_->scene, drawing_->camera, viewport(), position);
}

void GraphView::hoverAt(const std::optional<QPointF>& position) {
    const auto pick = position ? pickAt(*position) : std::nullopt;
    if (pick == drawing_->hovered) return;
    drawing_->hovered = pick;
    const bool onNode = pick && pick->kind == GraphPick::Kind::Node;
    drawing_->names->always = onNode ? std::optional(pick->index) : std::nullopt;
    drawing_->names->update();
    setCursor(pick ? Qt::PointingHandCursor : Qt::ArrowCursor);
    Q_EMIT hovered(pick);
}

void GraphView::mousePressEvent(QMouseEvent* event) {
    hand_.press(*event);
}

void GraphView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        hoverAt(event->position());
    } else if (hand_.drag(*event, drawing_->camera, viewport(), !flat_)) {
        moved_ = true;
        redraw();
    }
}

void GraphView::mouseReleaseEvent(QMouseEvent* event) {
    if (hand_.isDragging() || event->button() != Qt::LeftButton) return;
    Q_EMIT clicked(pickAt(event->position()));
}

void GraphView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    hand_.swallowClick();
    if (const auto pick = pickAt(event->position())) {
        Q_EMIT activated(*pick);
    } else {
        showAll();
    }
}

void GraphView::wheelEvent(QWheelEvent* event) {
    moved_ = true;
    hand_.zoom(*event, drawing_->camera, viewport());
    redraw();
}

void GraphView::leaveEvent(QEvent*) {
    hoverAt(std::nullopt);
}

void GraphView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        Q_EMIT clicked(std::nullopt);
    } else {
        QWidget::keyPressEvent(event);
    }
}

void GraphView::resizeEvent(QResizeEvent*) {
    drawing_->canvas->setGeometry(rect());
    drawing_->names->setGeometry(rect());
    drawing_->names->raise();
    if (moved_) {
        redraw();
    } else {
        showAll();
    }
}

void GraphView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) redraw();
    QWidget::changeEvent(event);
}

}  // namespace kumite::studio
