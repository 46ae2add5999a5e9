#include "studio/view3d/graph_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

constexpr int kSegments = 14;
constexpr int kCorners = 28;
constexpr double kThinnest = 0.15;  ///< of an edge's width is left where it ends
constexpr double kRim = 0.012;
constexpr double kLitRim = 2.6 * kRim;  ///< how far the ring of the moment reaches beyond a node
constexpr double kGroundLine = 0.011;   ///< a pixel or more in a small window
constexpr double kGroundRadius = 1.08;  ///< of the circle behind a fighter's graph

using Path = std::vector<Eigen::Vector3d>;

const GraphScene::Node& nodeAt(const GraphScene& scene, int index) {
    return scene.nodes[static_cast<std::size_t>(index)];
}

Path loopPath(const GraphScene::Node& node) {
    // Above the node, away from what leads elsewhere.
    const double radius = 0.8 * node.radius + 0.02;
    const Eigen::Vector3d centre = node.place + Eigen::Vector3d(0, node.radius + 0.7 * radius, 0);
    Path path;
    for (int i = 0; i <= kSegments; ++i) {
        const double angle = -0.8 + (2 * std::numbers::pi - 0.7) * i / kSegments;
        path.emplace_back(centre + radius * Eigen::Vector3d(std::sin(angle + std::numbers::pi),
                                                            std::cos(angle + std::numbers::pi), 0));
    }
    return path;
}

/// Half the width of an edge at a point of its path.
double halfWidth(const GraphScene::Edge& edge, std::size_t point) {
    const double share = static_cast<double>(point) / kSegments;
    return 0.5 * edge.width * (1 + (kThinnest - 1) * share);
}

/// Both sides of an edge, seen from the camera.
struct Band {
    Path left, right;
};
Band bandOf(const GraphScene& scene, const GraphScene::Edge& edge, const Eigen::Vector3d& forward) {
    const Path path = edgePath(scene, edge);
    Band band;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Eigen::Vector3d along =
            path[std::min(i + 1, path.size() - 1)] - path[i == 0 ? 0 : i - 1];
        Eigen::Vector3d side = along.cross(forward);
        if (side.norm() > 1e-12) side.normalize();
        band.left.push_back(path[i] + halfWidth(edge, i) * side);
        band.right.push_back(path[i] - halfWidth(edge, i) * side);
    }
    return band;
}

class MeshMaker {
public:
    MeshMaker(ColouredMesh& mesh, const CameraController& camera)
        : mesh_(mesh), towards_(-camera.forward()), right_(camera.right()), up_(camera.up()) {}

    /// What is added from here on lies a little nearer to the camera.
    void nearer(double way) { lift_ += way; }

    void disc(const Eigen::Vector3d& centre, double radius, const QColor& colour) {
        const int middle = add(centre, colour);
        for (int i = 0; i < kCorners; ++i) {
            add(corner(centre, radius, i), colour);
            triangle(middle, middle + 1 + i, middle + 1 + (i + 1) % kCorners);
        }
    }

    void ring(const Eigen::Vector3d& centre, double radius, double width, const QColor& colour,
              bool facing) {
        const int corners = 3 * kCorners;
        const int first = static_cast<int>(mesh_.points.size());
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            const Eigen::Vector3d way =
                facing ? Eigen::Vector3d(std::cos(angle) * right_ + std::sin(angle) * up_)
                       : Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
            add(centre + (radius - width) * way, colour);
            add(centre + radius * way, colour);
            const int now = first + 2 * i;
            const int next = first + 2 * ((i + 1) % corners);
            triangle(now, now + 1, next);
            triangle(next, now + 1, next + 1);
        }
    }

    void band(const Band& band, const QColor& colour) {
        for (std::size_t i = 0; i < band.left.size(); ++i) {
            const int now = add(band.left[i], colour);
            add(band.right[i], colour);
            if (i + 1 == band.left.size()) break;
            triangle(now, now + 1, now + 2);
            triangle(now + 2, now + 1, now + 3);
        }
    }

private:
    Eigen::Vector3d corner(const Eigen::Vector3d& centre, double radius, int i) const {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        return centre + radius * (std::cos(angle) * right_ + std::sin(angle) * up_);
    }
    int add(const Eigen::Vector3d& point, const QColor& colour) {
        mesh_.points.emplace_back((point + lift_ * towards_).cast<float>());
        for (const int part : {colour.red(), colour.green(), colour.blue()})
            mesh_.colours.push_back(static_cast<unsigned char>(part));
        return static_cast<int>(mesh_.points.size()) - 1;
    }
    void triangle(int a, int b, int c) {
        for (const int each : {a, b, c})
            mesh_.triangles.push_back(each);
    }

    ColouredMesh& mesh_;
    Eigen::Vector3d towards_, right_, up_;
    double lift_ = 0;
};

QColor faded(const QColor& colour, double presence, const Colours& c) {
    return mixed(c.ground, colour, std::clamp(presence, 0.0, 1.0));
}

std::vector<std::size_t> farToNear(const GraphScene& scene, const CameraController& camera) {
    std::vector<std::size_t> order(scene.nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const Eigen::Vector3d forward = camera.forward();
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return scene.nodes[a].place.dot(forward) > scene.nodes[b].place.dot(forward) + 1e-9;
    });
    return order;
}

double pixelsPer(const Eigen::Vector3d& projected, const Viewport& viewport) {
    return 1 / CameraController::metresPerPixel(std::max(0.01, projected.z()), viewport);
}

double distanceToPath(const std::vector<QPointF>& path, const QPointF& at) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const QPointF along = path[i] - path[i - 1];
        const double length = QPointF::dotProduct(along, along);
        const double share =
            length > 0 ? std::clamp(QPointF::dotProduct(at - path[i - 1], along) / length, 0.0, 1.0)
                       : 0.0;
        const QPointF way = at - (path[i - 1] + share * along);
        nearest = std::min(nearest, std::hypot(way.x(), way.y()));
    }
    return nearest;
}

}  // namespace

std::vector<Eigen::Vector3d> edgePath(const GraphScene& scene, const GraphScene::Edge& edge) {
    const GraphScene::Node& from = nodeAt(scene, edge.from);
    const GraphScene::Node& to = nodeAt(scene, edge.to);
    if (edge.from == edge.to) return loopPath(from);
    const Eigen::Vector3d way = to.place - from.place;
    const double length = way.norm();
    if (length < 1e-9) return Path(kSegments + 1, from.place);
    // Bent to its right, so that there and back are two edges; a quarter turn in the plane, or
    // sideways where it leads from one plane to the other.
    Eigen::Vector3d side = way.cross(Eigen::Vector3d::UnitZ());
    if (side.norm() < 1e-9) side = way.cross(Eigen::Vector3d::UnitY());
    const Eigen::Vector3d bend = from.place + 0.5 * way + 0.14 * length * side.normalized();
    const double begin = std::min(0.45, from.radius / length);
    const double end = 1 - std::min(0.45, (to.radius + 0.004) / length);
    Path path;
    for (int i = 0; i <= kSegments; ++i) {
        const double t = begin + (end - begin) * i / kSegments;
        path.emplace_back((1 - t) * (1 - t) * from.place + 2 * t * (1 - t) * bend +
                          t * t * to.place);
    }
    return path;
}

ColouredMesh graphMesh(const GraphScene& scene, const CameraController& camera,
                       const Colours& colours) {
    ColouredMesh mesh;
    MeshMaker maker(mesh, camera);
    for (const GraphScene::Ground& ground : scene.grounds)
        maker.ring(ground.centre, kGroundRadius, kGroundLine, faded(ground.colour, 0.35, colours),
                   false);
    const Eigen::Vector3d forward = camera.forward();
    const double apart = 0.01 / std::max<std::size_t>(1, scene.edges.size());
    for (const GraphScene::Edge& edge : scene.edges) {
        maker.nearer(apart);
        maker.band(bandOf(scene, edge, forward), faded(edge.colour, edge.presence, colours));
    }
    for (const std::size_t index : farToNear(scene, camera)) {
        const GraphScene::Node& node = scene.nodes[index];
        maker.nearer(0.0004);
        maker.disc(node.place, node.radius + 0.5 * kRim, colours.ground);
        maker.nearer(0.0004);
        maker.disc(node.place, node.radius, faded(node.fill, node.presence, colours));
        maker.nearer(0.0004);
        if (node.lit) {
            maker.ring(node.place, node.radius + kLitRim, 1.3 * kRim, colours.accent, true);
        }
        if (node.ringed) {
            maker.ring(node.place, node.radius + kRim, 0.9 * kRim, colours.text, true);
        }
    }
    return mesh;
}

std::optional<GraphPick> pickGraph(const GraphScene& scene, const CameraController& camera,
                                   const Viewport& viewport, const QPointF& at) {
    constexpr double kSlack = 3;
    constexpr double kEdgeReach = 5;
    std::optional<GraphPick> best;
    double nearest = 1e9;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const GraphScene::Node& node = scene.nodes[i];
        const Eigen::Vector3d place = camera.project(node.place, viewport);
        if (place.z() <= 0) continue;
        const double distance = std::hypot(place.x() - at.x(), place.y() - at.y());
        const double reach = std::max(5.0, node.radius * pixelsPer(place, viewport)) + kSlack;
        if (distance > reach || distance / reach + 0.01 * place.z() >= nearest) continue;
        nearest = distance / reach + 0.01 * place.z();
        best = GraphPick{GraphPick::Kind::Node, static_cast<int>(i)};
    }
    if (best) return best;
    nearest = kEdgeReach;
    for (std::size_t i = 0; i < scene.edges.size(); ++i) {
        std::vector<QPointF> path;
        for (const Eigen::Vector3d& point : edgePath(scene, scene.edges[i])) {
            const Eigen::Vector3d place = camera.project(point, viewport);
            path.emplace_back(place.x(), place.y());
        }
        const double distance = distanceToPath(path, at) + (1 - scene.edges[i].presence);
        if (distance > nearest) continue;
        nearest = distance;
        best = GraphPick{GraphPick::Kind::Edge, static_cast<int>(i)};
    }
    return best;
}

std::vector<GraphName> placeNames(const GraphScene& scene, const CameraController& camera,
                                  const Viewport& viewport, const QFontMetrics& metrics,
                                  std::optional<int> always) {
    // What is chosen or pointed at has its name even where that covers something.
    const auto isWanted = [&](int node) { return node == always || nodeAt(scene, node).ringed; };
    std::vector<int> order;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const int index = static_cast<int>(i);
        if (scene.nodes[i].rank >= 0 || isWanted(index)) order.push_back(index);
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        if (isWanted(a) != isWanted(b)) return isWanted(a);
        return nodeAt(scene, a).rank > nodeAt(scene, b).rank;
    });
    const QRectF view(2, 2, viewport.width - 4, viewport.height - 4);
    std::vector<QRectF> taken;
    // Names do not cover the larger nodes either, but for those that stand back.
    for (const GraphScene::Node& node : scene.nodes) {
        if (node.presence < 0.5) continue;
        const Eigen::Vector3d place = camera.project(node.place, viewport);
        const double radius = 0.6 * node.radius * pixelsPer(place, viewport);
        taken.emplace_back(place.x() - radius, place.y() - radius, 2 * radius, 2 * radius);
    }
    std::vector<GraphName> names;
    for (const int index : order) {
        const GraphScene::Node& node = nodeAt(scene, index);
        const Eigen::Vector3d place = camera.project(node.place, viewport);
        if (place.z() <= 0) continue;
        const double rim = node.lit ? kLitRim : node.ringed ? kRim : 0;
        const double reach = (node.radius + rim) * pixelsPer(place, viewport) + 3;
        const QSizeF size(metrics.horizontalAdvance(node.name) + 2, metrics.height() - 2);
        const QPointF at(place.x(), place.y());
        const QPointF corners[] = {at + QPointF(reach, -size.height() / 2),
                                   at + QPointF(-reach - size.width(), -size.height() / 2),
                                   at + QPointF(-size.width() / 2, reach),
                                   at + QPointF(-size.width() / 2, -reach - size.height())};
        std::optional<QRectF> room;
        for (const QPointF& corner : corners) {
            const QRectF box(corner, size);
            const bool free = view.contains(box) &&
                              std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) {
                                  return other.intersects(box);
                              });
            if (!free) continue;
            room = box;
            break;
        }
        if (!room && isWanted(index)) {
            QRectF box(corners[0], size);
            if (box.right() > view.right()) box.moveRight(view.right());
            if (box.left() < view.left()) box.moveLeft(view.left());
            room = box;
        }
        if (!room) continue;
        taken.push_back(*room);
        names.push_back({index, *room});
    }
    return names;
}

void paintNames(QPainter& painter, const GraphScene& scene, const CameraController& camera,
                const Viewport& viewport, const Colours& colours, std::optional<int> always) {
    for (const GraphScene::Ground& ground : scene.grounds) {
        const Eigen::Vector3d top =
            camera.project(ground.centre + Eigen::Vector3d(0, kGroundRadius, 0), viewport);
        if (top.z() <= 0) continue;
        painter.setPen(ground.colour);
        painter.drawText(QRectF(top.x() - 100, std::max(2.0, top.y() - 20), 200, 18),
                         Qt::AlignCenter, ground.caption);
    }
    const auto names = placeNames(scene, camera, viewport, painter.fontMetrics(), always);
    for (const GraphName& name : names) {
        const GraphScene::Node& node = nodeAt(scene, name.node);
        const double presence = name.node == always ? 1.0 : 0.3 + 0.7 * node.presence;
        painter.setPen(Qt::NoPen);
        painter.setBrush(withAlpha(colours.ground, 0.78));
        painter.drawRoundedRect(name.box.adjusted(-1, 0, 1, 0), 2, 2);
        painter.setPen(faded(colours.text, presence, colours));
        painter.drawText(name.box, Qt::AlignCenter, node.name);
    }
}

void paintGraph(QPainter& painter, const GraphScene& scene, const CameraController& camera,
                const Viewport& viewport, const Colours& colours) {
    const auto screen = [&](const Eigen::Vector3d& point) {
        const Eigen::Vector3d at = camera.project(point, viewport);
        return QPointF(at.x(), at.y());
    };
    painter.fillRect(QRectF(0, 0, viewport.width, viewport.height), colours.ground);
    for (const GraphScene::Ground& ground : scene.grounds) {
        QPolygonF circle;
        for (int i = 0; i < 3 * kCorners; ++i) {
            const double angle = 2 * std::numbers::pi * i / (3 * kCorners);
            circle << screen(ground.centre +
                             kGroundRadius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(faded(ground.colour, 0.35, colours), 1));
        painter.drawPolygon(circle);
    }
    painter.setPen(Qt::NoPen);
    for (const GraphScene::Edge& edge : scene.edges) {
        const Band band = bandOf(scene, edge, camera.forward());
        QPolygonF shape;
        for (const Eigen::Vector3d& point : band.left)
            shape << screen(point);
        for (auto point = band.right.rbegin(); point != band.right.rend(); ++point)
            shape << screen(*point);
        painter.setBrush(faded(edge.colour, edge.presence, colours));
        painter.drawPolygon(shape);
    }
    for (const std::size_t index : farToNear(scene, camera)) {
        const GraphScene::Node& node = scene.nodes[index];
        const Eigen::Vector3d at = camera.project(node.place, viewport);
        const double scale = pixelsPer(at, viewport);
        const auto circle = [&](double radius, const QPen& pen, const QBrush& brush) {
            painter.setPen(pen);
            painter.setBrush(brush);
            painter.drawEllipse(QPointF(at.x(), at.y()), radius * scale, radius * scale);
        };
        circle(node.radius, QPen(colours.ground, 0.5 * kRim * scale),
               faded(node.fill, node.presence, colours));
        if (node.ringed) {
            circle(node.radius + 0.5 * kRim, QPen(colours.text, 0.9 * kRim * scale), Qt::NoBrush);
        }
        if (node.lit) {
            circle(node.radius + 2 * kRim, QPen(colours.accent, 1.3 * kRim * scale), Qt::NoBrush);
        }
    }
    paintNames(painter, scene, camera, viewport, colours);
}

Box extentOf(const GraphScene& scene) {
    Box box;
    for (const GraphScene::Ground& ground : scene.grounds) {
        box.add(ground.centre - Eigen::Vector3d(1.1, 1.1, 0));
        box.add(ground.centre + Eigen::Vector3d(1.1, 1.22, 0));
    }
    for (const GraphScene::Node& node : scene.nodes)
        box.add(node.place);
    return box;
}

}  // namespace kumite::studio
