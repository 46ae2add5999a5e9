#pragma once

#include <QColor>
#include <QPointF>
#include <QPolygonF>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace kumite::studio {

/// What is written and marked over the 3D picture, in pixels of the view.
struct StageMarks {
    struct CentreOfMass {
        QPointF at;
        QColor colour;
        bool operator==(const CentreOfMass&) const = default;
    };
    struct Point {
        QPointF at;
        QString text;  ///< beside the point; may be empty
        bool operator==(const Point&) const = default;
    };
    struct Distance {
        QPointF from;
        QPointF to;
        QString text;
        bool operator==(const Distance&) const = default;
    };
    struct Handle {
        QPointF at;
        bool chosen = false;
        bool pinned = false;
        bool operator==(const Handle&) const = default;
    };
    struct Edge {
        QPointF from;
        QPointF to;
        bool strong = false;
        bool operator==(const Edge&) const = default;
    };
    struct Ring {
        QPolygonF points;
        int axis = 0;
        bool turned = false;
        bool operator==(const Ring&) const = default;
    };
    std::vector<CentreOfMass> centres;
    std::vector<Edge> edges;
    std::vector<Handle> handles;
    QPolygonF dots;
    std::vector<Ring> rings;
    std::vector<Point> points;
    std::optional<Distance> distance;

    bool operator==(const StageMarks&) const = default;
};

/// Draws the marks over the 3D picture; the mouse does not notice it.
class StageLabels : public QWidget {
    Q_OBJECT

public:
    explicit StageLabels(QWidget* parent);

    void show(StageMarks marks);
    const StageMarks& marks() const { return marks_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRegion extent() const;

    StageMarks marks_;
};

}  // namespace kumite::studio
