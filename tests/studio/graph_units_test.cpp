// What the Graph workspace is made of, without a window: grids, scales, orders, geometry.

#include <gtest/gtest.h>

#include <QGuiApplication>

#include <algorithm>

#include "studio/app/theme.h"
#include "studio/view3d/graph_geometry.h"
#include "studio/workspaces/graph/colour_scale.h"
#include "studio/workspaces/graph/matrix_grid.h"
#include "studio/workspaces/graph/matrix_table.h"

namespace kumite::studio {
namespace {

MatrixGrid grid() {
    MatrixGrid grid;
    grid.view = {500, 400};
    grid.rowHeader = 100;
    grid.columnHeader = 80;
    grid.cell = 20;
    grid.rows = 60;
    grid.columns = 40;
    return grid;
}

TEST(MatrixGrid, APointIsOnTheCellThatIsDrawnThere) {
    for (const QPointF scroll : {QPointF(0, 0), QPointF(37, 113), QPointF(1e6, 1e6)}) {
        const MatrixGrid at = grid().scrolled(scroll);
        const auto rows = at.visibleRows();
        const auto columns = at.visibleColumns();
        for (int row = rows.begin; row < rows.end; ++row) {
            for (int column = columns.begin; column < columns.end; ++column) {
                const QPointF middle = at.cellRect({row, column}).center();
                if (!at.body().contains(middle)) continue;
                EXPECT_EQ(at.at(middle), (MatrixPlace{row, column}));
            }
        }
        EXPECT_EQ(rows.end - rows.begin >= 16, true);
    }
}

TEST(MatrixGrid, NamesAreHitAndTheCornerIsNothing) {
    const MatrixGrid at = grid();
    EXPECT_EQ(at.at({50, 95}), (MatrixPlace{0, -1}));
    EXPECT_EQ(at.at({125, 40}), (MatrixPlace{-1, 1}));
    EXPECT_EQ(at.at({50, 40}), std::nullopt);
    MatrixGrid small = grid();
    small.rows = 2;
    small.columns = 2;
    EXPECT_EQ(small.at({450, 90}), std::nullopt) << "beyond the last column";
    EXPECT_EQ(small.at({110, 300}), std::nullopt) << "below the last row";
}

TEST(MatrixGrid, ZoomKeepsWhatIsUnderThePointer) {
    const MatrixGrid before = grid().scrolled({200, 400});
    const QPointF pointer(310, 230);
    const MatrixGrid after = before.zoomedAbout(pointer, 1.7);
    EXPECT_DOUBLE_EQ(after.cell, 34);
    EXPECT_EQ(after.at(pointer), before.at(pointer));
    EXPECT_LE(before.zoomedAbout(pointer, 1000).cell, MatrixGrid::kLargest);
    EXPECT_GE(before.zoomedAbout(pointer, 1e-6).cell, MatrixGrid::kSmallest);
}

TEST(MatrixGrid, ScrollsNoFartherThanTheLastCellAndAsLittleAsShowsOne) {
    const MatrixGrid end = grid().scrolled({1e6, 1e6});
    EXPECT_DOUBLE_EQ(end.cellRect({59, 39}).right(), 500);
    EXPECT_DOUBLE_EQ(end.cellRect({59, 39}).bottom(), 400);
    const MatrixGrid shown = grid().revealing({30, 2});
    EXPECT_TRUE(shown.body().contains(shown.cellRect({30, 2})));
    EXPECT_EQ(shown.scroll.x(), 0) << "the column was visible";
    EXPECT_EQ(shown.revealing({30, 2}).scroll, shown.scroll);
}

TEST(MatrixGrid, FittedShowsAllUnlessCellsWouldVanish) {
    MatrixGrid few = grid();
    few.rows = few.columns = 4;
    EXPECT_EQ(few.fitted(30).cell, 30);
    const MatrixGrid all = grid().fitted(30);
    EXPECT_EQ(all.scrollable(), QSizeF(0, 0));
    MatrixGrid many = grid();
    many.rows = 5000;
    EXPECT_EQ(many.fitted(30).cell, MatrixGrid::kSmallest);
}

TEST(ColourScale, LinearAndLogarithmicRunFromNothingToFull) {
    const Colours& c = colours(true);
    for (const bool logarithmic : {false, true}) {
        const ColourScale scale = probabilityScale(c, 1, logarithmic);
        EXPECT_EQ(scale.colourOf(0), scale.nothing);
        EXPECT_EQ(scale.colourOf(1), scale.full);
        EXPECT_EQ(scale.colourOf(7), scale.full) << "beyond the end";
        EXPECT_EQ(scale.colourOf(std::nan("")), scale.nothing);
        double last = -1;
        for (double p = 0.0005; p <= 1; p *= 1.5) {
            EXPECT_GE(scale.position(p), last);
            last = scale.position(p);
        }
        EXPECT_GE(scale.ticks().size(), 4U);
    }
    const ColourScale log = probabilityScale(c, 0, true);
    EXPECT_NEAR(log.position(0.01) - log.position(0.001), log.position(0.1) - log.position(0.01),
                1e-12);
    EXPECT_GT(log.position(0.01), 3 * probabilityScale(c, 0, false).position(0.01));
}

TEST(ColourScale, EndsWhereTheValuesDo) {
    EXPECT_DOUBLE_EQ(scaleTop(0), 0.01);
    EXPECT_DOUBLE_EQ(scaleTop(0.071), 0.1);
    EXPECT_DOUBLE_EQ(scaleTop(0.51), 1);
    const ColourScale scale = probabilityScale(colours(true), 0, false, 0.2);
    EXPECT_EQ(scale.colourOf(0.2), scale.full);
    EXPECT_EQ(scale.ticks().back().text, QString("0.2"));
}

TEST(ColourScale, DifferencesHaveTwoSidesAndNothingInTheMiddle) {
    const ColourScale scale = differenceScale(colours(false), 0.4);
    EXPECT_EQ(scale.colourOf(0), scale.nothing);
    EXPECT_EQ(scale.colourOf(0.4), scale.full);
    EXPECT_EQ(scale.colourOf(-0.4), scale.below);
    EXPECT_EQ(scale.colourOf(-9), scale.below);
    EXPECT_NE(scale.full, scale.below);
    EXPECT_EQ(scale.ticks().front().text, QString("−0.4"));
    EXPECT_EQ(scale.ticks().back().text, QString("+0.4"));
}

TEST(ColourScale, InkCanBeReadOnEveryColour) {
    for (const bool dark : {false, true}) {
        const ColourScale scale = probabilityScale(colours(dark), 0, false);
        for (double p = 0; p <= 1; p += 0.05) {
            const QColor ground = scale.colourOf(p);
            const int contrast = std::abs(inkOn(ground).lightness() - ground.lightness());
            EXPECT_GT(contrast, 60) << p << " on " << ground.name().toStdString();
        }
    }
}

MatrixTable table() {
    MatrixTable table;
    table.rows = {{"kick", 3}, {"punch", 9}, {"jump", 3}};
    table.columns = {{"b", 1}, {"a", 2}};
    table.values = Eigen::MatrixXd(3, 2);
    table.values << 0.9, 0.1, 0.1, 0.9, 0.8, 0.2;
    table.counts = Eigen::MatrixXi::Zero(3, 2);
    return table;
}

TEST(MatrixOrder, SortsByCountByNameAndByLikeness) {
    EXPECT_EQ(orderOf(table(), MatrixSort::Count).rows, (std::vector<int>{1, 0, 2}));
    EXPECT_EQ(orderOf(table(), MatrixSort::Count).columns, (std::vector<int>{1, 0}));
    EXPECT_EQ(orderOf(table(), MatrixSort::Name).rows, (std::vector<int>{2, 0, 1}));
    const MatrixOrder alike = orderOf(table(), MatrixSort::Similarity);
    const auto kick = std::find(alike.rows.begin(), alike.rows.end(), 0) - alike.rows.begin();
    const auto jump = std::find(alike.rows.begin(), alike.rows.end(), 2) - alike.rows.begin();
    EXPECT_EQ(std::abs(kick - jump), 1);
    EXPECT_EQ(alike.groups.size(), 1U) << "punches lead elsewhere";
}

TEST(MatrixOrder, PlacesGoThereAndBack) {
    const MatrixOrder order = orderOf(table(), MatrixSort::Count);
    for (int row = -1; row < 3; ++row) {
        for (int column = -1; column < 2; ++column) {
            const MatrixPlace place{row, column};
            EXPECT_EQ(order.inTable(order.shown(place)), place);
        }
    }
    EXPECT_EQ(order.inTable({7, 7}), MatrixPlace());
}

GraphScene scene() {
    GraphScene scene;
    const char* names[] = {"left", "right", "above"};
    const Eigen::Vector3d places[] = {{-0.5, 0, 0}, {0.5, 0, 0}, {0, 0.8, 0}};
    for (int i = 0; i < 3; ++i) {
        GraphScene::Node node;
        node.name = names[i];
        node.place = places[i];
        node.radius = 0.06;
        node.fill = Qt::red;
        scene.nodes.push_back(node);
    }
    scene.edges = {{0, 1, 0.03, Qt::red, 1}, {1, 0, 0.03, Qt::red, 1}, {2, 2, 0.03, Qt::red, 1}};
    scene.grounds = {{Eigen::Vector3d::Zero(), "fighter 1", Qt::red}};
    return scene;
}

class GraphGeometry : public testing::Test {
protected:
    GraphGeometry() {
        camera.lookFrom(0, 0);
        camera.frame(extentOf(scene()), viewport);
    }
    QPointF at(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d place = camera.project(point, viewport);
        return {place.x(), place.y()};
    }
    CameraController camera;
    Viewport viewport{600, 500};
};

TEST_F(GraphGeometry, NodesAndEdgesArePickedWhereTheyAreDrawn) {
    const GraphScene graph = scene();
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(pickGraph(graph, camera, viewport, at(graph.nodes[std::size_t(i)].place)),
                  (GraphPick{GraphPick::Kind::Node, i}));
    }
    for (int i = 0; i < 3; ++i) {
        const auto path = edgePath(graph, graph.edges[std::size_t(i)]);
        EXPECT_EQ(pickGraph(graph, camera, viewport, at(path[path.size() / 2])),
                  (GraphPick{GraphPick::Kind::Edge, i}))
            << "there and back do not cover each other";
    }
    EXPECT_EQ(pickGraph(graph, camera, viewport, {2, 2}), std::nullopt);
}

TEST_F(GraphGeometry, EdgesGoFromRimToRim) {
    const GraphScene graph = scene();
    const auto path = edgePath(graph, graph.edges[0]);
    EXPECT_NEAR((path.front() - graph.nodes[0].place).norm(), 0.06, 0.02);
    EXPECT_NEAR((path.back() - graph.nodes[1].place).norm(), 0.06, 0.02);
}

TEST_F(GraphGeometry, MeshHasAColourForEachCornerAndFacesTheCamera) {
    const ColouredMesh mesh = graphMesh(scene(), camera, colours(true));
    EXPECT_EQ(mesh.colours.size(), 3 * mesh.points.size());
    ASSERT_GT(mesh.triangles.size(), 300U);
    for (const int corner : mesh.triangles)
        ASSERT_LT(corner, static_cast<int>(mesh.points.size()));
    for (const auto& point : mesh.points)
        ASSERT_TRUE(point.allFinite());
}

TEST_F(GraphGeometry, NamesDoNotCoverEachOther) {
    GraphScene graph = scene();
    for (int i = 0; i < 40; ++i) {
        GraphScene::Node node = graph.nodes[0];
        node.name = QString("label number %1").arg(i);
        node.place = Eigen::Vector3d(std::cos(i * 0.7) * 0.9, std::sin(i * 0.7) * 0.9, 0);
        node.rank = i;
        graph.nodes.push_back(node);
    }
    const QFontMetrics metrics{QGuiApplication::font()};
    const auto names = placeNames(graph, camera, viewport, metrics);
    EXPECT_GT(names.size(), 5U);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(names[i].box.intersects(names[j].box));
        EXPECT_TRUE(QRectF(0, 0, 600, 500).contains(names[i].box));
    }
    EXPECT_EQ(names.front().node, 42) << "the weightiest first";
    const auto wanted = placeNames(graph, camera, viewport, metrics, 3);
    EXPECT_EQ(wanted.front().node, 3) << "what is pointed at always has its name";
}

}  // namespace
}  // namespace kumite::studio
