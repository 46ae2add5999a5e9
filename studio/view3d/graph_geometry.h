#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

#include "studio/view3d/camera_controller.h"
#include "studio/view3d/graph_scene.h"

namespace kumite::studio {

struct Colours;

/// The middle line of an edge, from the rim of one node to that of the other; of an edge back to
/// its own node a loop.
std::vector<Eigen::Vector3d> edgePath(const GraphScene& scene, const GraphScene::Edge& edge);

/// Triangles that face the camera, each corner with its colour; later ones lie nearer to it.
struct ColouredMesh {
    std::vector<Eigen::Vector3f> points;
    std::vector<unsigned char> colours;  ///< red, green, blue of each point
    std::vector<int> triangles;
};
ColouredMesh graphMesh(const GraphScene& scene, const CameraController& camera,
                       const Colours& colours);

/// The node or edge at a point of the picture; nodes before edges.
std::optional<GraphPick> pickGraph(const GraphScene& scene, const CameraController& camera,
                                   const Viewport& viewport, const QPointF& at);

/// A name in the picture.
struct GraphName {
    int node = 0;
    QRectF box;
};
/// Names beside their nodes such that none covers another; those that find no room are left out,
/// but for `always`.
std::vector<GraphName> placeNames(const GraphScene& scene, const CameraController& camera,
                                  const Viewport& viewport, const QFontMetrics& metrics,
                                  std::optional<int> always = {});
/// Writes names and captions over a picture of the graph.
void paintNames(QPainter& painter, const GraphScene& scene, const CameraController& camera,
                const Viewport& viewport, const Colours& colours, std::optional<int> always = {});

/// The whole drawing with a painter, for pictures made of lines (SVG).
void paintGraph(QPainter& painter, const GraphScene& scene, const CameraController& camera,
                const Viewport& viewport, const Colours& colours);

/// What must be seen for all to be seen.
Box extentOf(const GraphScene& scene);

}  // namespace kumite::studio
