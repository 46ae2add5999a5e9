#pragma once

#include <QWidget>

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace kumite::studio {

class SequenceSession;

/// The clusters of poses as a map on which like poses lie near each other, how motions lead from
/// one to another, and the way that the chosen transition takes, with the clusters' middle poses as
/// small figures. The pose under the pointer is drawn large.
class ClusterMap : public QWidget {
    Q_OBJECT

public:
    explicit ClusterMap(SequenceSession& sequence, QWidget* parent = nullptr);

    QPointF placeOf(int cluster) const;
    /// The clusters that the chosen transition passes; empty where there is none.
    std::vector<int> way() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void takeLibrary();
    /// The middle pose of a cluster as lines, feet at `at`, `height` pixels for a grown person.
    void paintFigure(QPainter& painter, int cluster, const QPointF& at, double height) const;

    SequenceSession& sequence_;
    std::vector<std::vector<Eigen::Vector3d>> figures_;  ///< joints of each, seen from its front
    int hovered_ = -1;
};

}  // namespace kumite::studio
