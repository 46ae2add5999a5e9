#include "studio/workspaces/sequence/cluster_map.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include "studio/app/theme.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

namespace {
constexpr double kMargin = 46;
constexpr double kMetres = 1.8;  // height for which a figure is scaled
}  // namespace

ClusterMap::ClusterMap(SequenceSession& sequence, QWidget* parent)
    : QWidget(parent), sequence_(sequence) {
    setAccessibleName(tr("Map of poses"));
    setMouseTracking(true);
    setMinimumSize(200, 160);
    connect(&sequence_, &SequenceSession::libraryChanged, this, &ClusterMap::takeLibrary);
    for (auto signal : {&SequenceSession::selectionChanged, &SequenceSession::motionChanged,
                        &SequenceSession::draftChanged})
        connect(&sequence_, signal, this, qOverload<>(&QWidget::update));
}

void ClusterMap::takeLibrary() {
    figures_.clear();
    hovered_ = -1;
    const auto graph = sequence_.graph();
    for (int cluster = 0; graph != nullptr && cluster < graph->clusters.count(); ++cluster) {
        const Rig& rig = *graph->library->rig;
        const Pose& pose = graph->medoid(cluster);
        JointFrames frames;
        jointFrames(rig, pose, frames);
        const double yaw = headingOf(rig, pose).value_or(0) - 0.6;  // a little from the side
        const Eigen::AngleAxisd turn(-yaw, Eigen::Vector3d::UnitY());
        std::vector<Eigen::Vector3d>& joints = figures_.emplace_back();
        for (const Eigen::Vector3d& joint : frames.positions)
            joints.push_back(turn * (joint - Eigen::Vector3d(pose.root.x(), 0, pose.root.z())));
    }
    update();
}

QPointF ClusterMap::placeOf(int cluster) const {
    const Eigen::Vector2d& at = sequence_.places()[static_cast<std::size_t>(cluster)];
    return {width() / 2.0 + at.x() * (width() / 2.0 - kMargin),
            height() / 2.0 - at.y() * (height() / 2.0 - kMargin)};
}

std::vector<int> ClusterMap::way() const {
    const auto block = sequence_.selectedBlock();
    if (!block || !sequence_.isCurrent() || sequence_.motion() == nullptr) return {};
    for (const SequencePiece& piece : sequence_.motion()->pieces) {
        if (piece.block == *block && piece.transition) return piece.transition->visited;
    }
    return {};
}

void ClusterMap::paintFigure(QPainter& painter, int cluster, const QPointF& at,
                             double height) const {
    const auto graph = sequence_.graph();
    const auto& joints = figures_[static_cast<std::size_t>(cluster)];
    const double scale = height / kMetres;
    const auto point = [&](std::size_t joint) {
        return QPointF(at.x() + scale * joints[joint].x(), at.y() - scale * joints[joint].y());
    };
    const Rig& rig = *graph->library->rig;
    for (std::size_t j = 1; j < joints.size(); ++j) {
        const int parent = rig.joint(static_cast<int>(j)).parent;
        painter.drawLine(point(static_cast<std::size_t>(parent)), point(j));
    }
    if (const auto head = rig.roles[Role::Head]) {
        const double radius = 0.11 * scale;
        painter.drawEllipse(point(static_cast<std::size_t>(*head)) - QPointF(0, 0.8 * radius),
                            radius, radius);
    }
}

void ClusterMap::paintEvent(QPaintEvent*) {
    const Colours& c = coloursFor(palette());
    QPainter painter(this);
    painter.fillRect(rect(), c.ground);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto graph = sequence_.graph();
    painter.setPen(c.secondText);
    if (graph == nullptr || figures_.empty()) {
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("A map of the poses appears here: like ones near each other, and the "
                            "way that a transition takes."));
        return;
    }
    const std::vector<int> way = this->way();
    const auto onWay = [&](int cluster) {
        return std::find(way.begin(), way.end(), cluster) != way.end();
    };
    QColor faint = c.secondText;
    faint.setAlphaF(
        std::clamp(40.0f / static_cast<float>(graph->graph.edges.size()), 0.04f, 0.35f));
    painter.setPen(QPen(faint, 1));
    for (const GraphEdge& edge : graph->graph.edges)
        painter.drawLine(placeOf(edge.source), placeOf(edge.target));
    painter.setPen(Qt::NoPen);
    painter.setBrush(withAlpha(c.fighters[0], 0.6));
    for (int cluster = 0; cluster < graph->clusters.count(); ++cluster)
        painter.drawEllipse(placeOf(cluster), 2.5, 2.5);
    painter.setBrush(Qt::NoBrush);
    if (!way.empty()) {
        QPainterPath path(placeOf(way.front()));
        for (const int cluster : way)
            path.lineTo(placeOf(cluster));
        painter.setPen(QPen(c.accent, 2.5));
        painter.drawPath(path);
    }
    for (std::size_t i = 0; i < way.size(); ++i) {
        const QPointF at = placeOf(way[i]);
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.accent);
        painter.drawEllipse(at, 4, 4);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(c.text, 1.6, Qt::SolidLine, Qt::RoundCap));
        paintFigure(painter, way[i], at + QPointF(0, -6), 44);
    }
    if (hovered_ >= 0 && !onWay(hovered_)) {
        const QPointF at = placeOf(hovered_);
        painter.setPen(QPen(c.text, 1.8, Qt::SolidLine, Qt::RoundCap));
        painter.drawEllipse(at, 4, 4);
        paintFigure(painter, hovered_, at + QPointF(0, at.y() > 100 ? -8 : 92), 84);
    }
    painter.setPen(c.secondText);
    painter.drawText(rect().adjusted(12, 8, -12, -8), Qt::AlignTop | Qt::AlignLeft,
                     tr("%1 kinds of poses, like ones near each other · line: what leads where")
                         .arg(graph->clusters.count()));
}

void ClusterMap::mouseMoveEvent(QMouseEvent* event) {
    hovered_ = -1;
    double least = 14;
    for (int cluster = 0; cluster < static_cast<int>(figures_.size()); ++cluster) {
        const QPointF away = placeOf(cluster) - event->position();
        const double distance = std::hypot(away.x(), away.y());
        if (distance < least) {
            least = distance;
            hovered_ = cluster;
        }
    }
    update();
}

void ClusterMap::leaveEvent(QEvent*) {
    hovered_ = -1;
    update();
}

}  // namespace kumite::studio
