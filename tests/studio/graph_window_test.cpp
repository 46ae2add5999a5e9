// The Graph workspace in the real window: matrix, graph, what comes next, what is behind it.

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QListView>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QSlider>
#include <QTableView>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <set>

#include "core/project/labels.h"
#include "studio/app/commands.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/graph_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/graph/graph_centre.h"
#include "studio/workspaces/graph/graph_export.h"
#include "studio/workspaces/graph/graph_panel.h"
#include "studio/workspaces/graph/matrix_page.h"
#include "studio/workspaces/graph/matrix_view.h"
#include "studio/workspaces/graph/node_page.h"
#include "studio/workspaces/graph/surprise_strip.h"
#include "studio/workspaces/graph/trace_box.h"
#include "studio/workspaces/graph/what_if_box.h"
#include "studio/workspaces/graph/what_if_model.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class GraphTest : public WindowTest {
protected:
    /// Labels every action in turn, so that all is known of what follows on what.
    void labelAll() {
        const char* const spelled[] = {"left_punch:fwd+move:L-L", "right_punch:fwd+move:L-R",
                                       "left_kick:up+move:R-R", "jump:up+move:L-R"};
        for (const int player : {0, 1}) {
            const auto count = session().fighter(player)->segmentation->actions.size();
            for (std::size_t i = 0; i < count; ++i) {
                // The second fighter does only three of them, and one moment is odd.
                std::size_t kind = i % (player == 0 ? 4 : 3);
                if (player == 0 && i == count / 2) kind = (kind + 2) % 4;
                session().document().apply([&](const Project& project, const Analysis& analysis) {
                    const int action = static_cast<int>(i);
                    return setWholeLabel(project, analysis, {0, player}, std::span(&action, 1),
                                         parseLabel(kickboxing(), spelled[kind]));
                });
            }
        }
        settle();
    }
    void openGraph() {
        openBout();
        labelAll();
        window_->workspaces().show("graph");
        settle();
        ASSERT_TRUE(graph().hasGraph());
    }
    GraphSession& graph() { return window_->graph(); }
    GraphCentre& centre() { return window_->graphCentre(); }
    MatrixView& matrix() { return centre().matrix().view(); }
    template <typename Widget>
    Widget& part() {
        return *window_->findChild<Widget*>();
    }
    void clickCell(MatrixView& view, const MatrixPlace& inTable) {
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {},
                          view.rectOf(inTable).center().toPoint());
    }
    /// The cell with the highest count.
    MatrixPlace busiest() {
        Eigen::Index row = 0;
        Eigen::Index column = 0;
        matrix().table().counts.maxCoeff(&row, &column);
        return {int(row), int(column)};
    }
};

TEST_F(GraphTest, WithoutLabelsItSaysWhatAppearsHere) {
    openBout();
    window_->workspaces().show("graph");
    settle();
    EXPECT_FALSE(graph().hasGraph());
    bool said = false;
    for (const auto* label : centre().findChildren<QLabel*>()) {
        said = said || (label->isVisible() && label->text().contains("label"));
    }
    EXPECT_TRUE(said);
    EXPECT_FALSE(part<SurpriseStrip>().isVisible());
    EXPECT_FALSE(part<WhatIfBox>().isVisible());
    for (auto* button : centre().findChildren<QPushButton*>()) {
        if (button->text() == "Label actions") QTest::mouseClick(button, Qt::LeftButton);
    }
    EXPECT_EQ(window_->workspaces().current(), "label");
    window_->workspaces().show("graph");
    labelAll();
    EXPECT_TRUE(graph().hasGraph()) << "labels bring the graph";
    EXPECT_TRUE(part<SurpriseStrip>().isVisible());
}

TEST_F(GraphTest, TheWorkspaceBringsItsViewsAndTakesThemAway) {
    openGraph();
    EXPECT_TRUE(centre().isVisible());
    EXPECT_TRUE(window_->stage().isVisible());
    EXPECT_GT(window_->stage().width(), 250);
    EXPECT_GT(matrix().width(), 350);
    window_->workspaces().show("segment");
    EXPECT_FALSE(centre().isVisible());
    EXPECT_FALSE(part<SurpriseStrip>().isVisible());
    EXPECT_GT(window_->stage().width(), 600);
}

TEST_F(GraphTest, FromAProbabilityToTheRecordingInTwoClicks) {
    openGraph();
    const MatrixPlace place = busiest();
    clickCell(matrix(), place);
    ASSERT_TRUE(graph().selection());
    EXPECT_EQ(int(graph().selected().size()), matrix().table().counts(place.row, place.column));
    QTableView* list = part<TraceBox>().table();
    ASSERT_TRUE(list->isVisible());
    EXPECT_EQ(list->model()->rowCount(), int(graph().selected().size()));
    const QRect row = list->visualRect(list->model()->index(1, 0));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row.center());
    const TransitionRef expected{0, graph().selected()[1]};
    EXPECT_EQ(graph().current(), expected);
    const Transition& t = graph().transitionOf(expected);
    Transport& transport = session().transport();
    EXPECT_TRUE(transport.isPlaying());
    EXPECT_TRUE(transport.isLooping());
    EXPECT_DOUBLE_EQ(*transport.loopIn(), graph().graph().action(0, t.own).beginSeconds);
    EXPECT_DOUBLE_EQ(*transport.loopOut(), graph().graph().action(0, t.next).endSeconds);
    transport.setPlaying(false);
}

TEST_F(GraphTest, KeysWalkOverCellsAndReturnPlays) {
    openGraph();
    const MatrixPlace place = busiest();
    clickCell(matrix(), place);
    const MatrixPlace shown = matrix().order().shown(place);
    matrix().setFocus();
    QTest::keyClick(&matrix(), Qt::Key_Right);
    QTest::keyClick(&matrix(), Qt::Key_Left);
    EXPECT_EQ(matrix().chosen(), place);
    const int down = shown.row + 1 < matrix().grid().rows ? Qt::Key_Down : Qt::Key_Up;
    QTest::keyClick(&matrix(), Qt::Key(down));
    EXPECT_NE(matrix().chosen(), place);
    EXPECT_EQ(session().transport().playhead(), 0.0) << "arrows do not step frames in here";
    clickCell(matrix(), place);
    QTest::keyClick(&matrix(), Qt::Key_Return);
    ASSERT_TRUE(graph().current());
    EXPECT_EQ(graph().current()->index, graph().selected()[0]);
    QTest::keyClick(&matrix(), Qt::Key_Return);
    EXPECT_EQ(graph().current()->index, graph().selected()[1]);
    session().transport().setPlaying(false);
}

TEST_F(GraphTest, RowsKnowTheOwnTheOpponentsOrBothLabels) {
    openGraph();
    EXPECT_EQ(int(matrix().table().rows.size()), graph().graph().nodeCount(0));
    for (const auto& [key, kind] : {std::pair{Qt::Key_2, TableRows::Opponent},
                                    {Qt::Key_3, TableRows::Pairs},
                                    {Qt::Key_1, TableRows::Own}}) {
        press(key);
        const TransitionTable table =
            transitionTable(graph().graph(), 0, graph().model(0).labels, kind);
        ASSERT_EQ(matrix().table().rows.size(), table.rows.size());
        EXPECT_EQ(matrix().table().counts, table.counts);
        EXPECT_TRUE(matrix().table().values.isApprox(table.probabilities));
    }
}

TEST_F(GraphTest, HoverTellsProbabilityAndCounts) {
    openGraph();
    QStringList told;
    const auto listening = QObject::connect(&session(), &Session::hovered,
                                            [&told](const QString& text) { told.append(text); });
    const MatrixPlace place = busiest();
    // Not by the real pointer, which the display moves when it likes.
    const QPointF at = matrix().rectOf(place).center();
    QMouseEvent move(QEvent::MouseMove, at, matrix().viewport()->mapToGlobal(at), Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(matrix().viewport(), &move);
    QObject::disconnect(listening);
    const int count = matrix().table().counts(place.row, place.column);
    const QStringList cells = told.filter(QString("seen %1 of").arg(count));
    ASSERT_FALSE(cells.isEmpty()) << told.join('\n').toStdString();
    EXPECT_TRUE(cells.front().contains("P 0.") || cells.front().contains("P 1"))
        << cells.front().toStdString();
}

TEST_F(GraphTest, AnEditIsInTheMatrixAndTheSelectionStays) {
    openGraph();
    clickCell(matrix(), busiest());
    const TransitionFilter filter = graph().selection()->filter;
    const Label own = graph().graph().node(0, filter.own).label;
    const auto before = graph().graph().transitionsOf(0).size();
    session().toggleBoundary(someBoundary(0));
    settle();
    EXPECT_LT(graph().graph().transitionsOf(0).size(), before);
    ASSERT_TRUE(graph().selection());
    EXPECT_EQ(graph().graph().node(0, graph().selection()->filter.own).label, own);
    press(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(graph().graph().transitionsOf(0).size(), before);
}

TEST_F(GraphTest, NothingIsLearntWhileNobodyLooks) {
    openGraph();
    window_->workspaces().show("segment");
    const GraphValues* values = graph().values();
    session().toggleBoundary(someBoundary(0));
    settle();
    EXPECT_EQ(graph().values(), values);
    window_->workspaces().show("graph");
    settle();
    EXPECT_NE(graph().values(), values);
}

TEST_F(GraphTest, WhatComesNextFollowsThePlayheadUntilAHandAsks) {
    openGraph();
    auto& box = part<WhatIfBox>();
    ASSERT_TRUE(box.isFollowing());
    const BasicAction& action = graph().graph().action(0, 3);
    session().transport().setPlayhead(0.5 * (action.beginSeconds + action.endSeconds));
    const GraphMoment& moment = graph().moment(0);
    EXPECT_EQ(moment.decision.own, action.node);
    EXPECT_EQ(moment.next, graph().graph().action(0, action.next).node);
    const auto& rows = box.model().rows();
    ASSERT_FALSE(rows.empty());
    double sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        sum += rows[i].product;
        EXPECT_GE(rows[i == 0 ? 0 : i - 1].product, rows[i].product);
    }
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_TRUE(box.model().hasGeometry()) << "places and poses are known there";
    const auto actual = std::find_if(rows.begin(), rows.end(),
                                     [&](const NextLabel& row) { return row.node == moment.next; });
    ASSERT_NE(actual, rows.end());
    EXPECT_GT(actual->examples, 0);
    // The moment stands out in the matrix, too.
    const QImage here = matrix().grab().toImage();
    const BasicAction& later = graph().graph().action(0, 5);
    session().transport().setPlayhead(0.5 * (later.beginSeconds + later.endSeconds));
    EXPECT_NE(matrix().grab().toImage(), here);

    clickCell(matrix(), busiest());
    EXPECT_FALSE(box.isFollowing()) << "a chosen cell is a question";
    EXPECT_EQ(box.list()->currentIndex().row(),
              box.model().rowOf(graph().selection()->filter.next));
    // A row leads back to what is behind it.
    QTest::mouseClick(box.list()->viewport(), Qt::LeftButton, {},
                      box.list()->visualRect(box.model().index(0, 0)).center());
    EXPECT_EQ(graph().selection()->filter.next, box.model().rows()[0].node);
}

TEST_F(GraphTest, NodesAndEdgesAreChosenInTheGraph) {
    openGraph();
    press(Qt::Key_V);
    ASSERT_FALSE(centre().showsMatrix());
    NodePage& page = centre().nodes();
    QTest::qWait(50);
    for (const int node : {0, graph().graph().nodeCount(0)}) {
        const auto at = page.view().positionOf(node);
        ASSERT_TRUE(at);
        QTest::mouseClick(&page.view(), Qt::LeftButton, {}, at->toPoint());
        ASSERT_TRUE(graph().selection());
        EXPECT_EQ(graph().selection()->mover, page.drawing().nodes[std::size_t(node)].player);
        EXPECT_EQ(graph().selection()->filter.own, page.drawing().nodes[std::size_t(node)].node);
        EXPECT_TRUE(page.drawing().scene.nodes[std::size_t(node)].ringed);
        EXPECT_FALSE(graph().selected().empty());
    }
    QTest::mouseClick(&page.view(), Qt::LeftButton, {}, QPoint(3, 3));
    EXPECT_FALSE(graph().selection());
    const QImage flat = page.view().grab().toImage();
    std::set<QRgb> shades;
    for (int y = 0; y < flat.height(); y += 2) {
        for (int x = 0; x < flat.width(); x += 2)
            shades.insert(flat.pixel(x, y));
    }
    EXPECT_GT(shades.size(), 20U) << "something is drawn";
    press(Qt::Key_V, Qt::ShiftModifier);
    QTest::qWait(30);
    EXPECT_TRUE(page.options().inSpace);
    EXPECT_NE(page.view().grab().toImage(), flat);
}

TEST_F(GraphTest, SlidersAndEditsDoNotMakeTheGraphJump) {
    openGraph();
    press(Qt::Key_V);
    NodePage& page = centre().nodes();
    const auto places = [&] {
        std::map<std::string, Eigen::Vector3d> found;
        for (const auto& node : page.drawing().nodes) {
            const auto index = std::size_t(&node - page.drawing().nodes.data());
            found[std::to_string(node.player) + graph().graph().node(node.player, node.node).text] =
                page.drawing().scene.nodes[index].place;
        }
        return found;
    };
    const auto before = places();
    const auto edges = page.drawing().scene.edges.size();
    for (auto* slider : page.findChildren<QSlider*>())
        slider->setValue(slider->maximum());
    EXPECT_NE(page.drawing().scene.edges.size(), edges);
    EXPECT_EQ(places(), before);
    session().toggleBoundary(someBoundary(1));
    settle();
    for (const auto& [name, place] : places()) {
        ASSERT_TRUE(before.count(name));
        EXPECT_LE((place - before.at(name)).norm(), kLayoutStep + 1e-9) << name;
    }
}

TEST_F(GraphTest, SurpriseLeadsToTheOddMoment) {
    openGraph();
    press(Qt::Key_N);
    ASSERT_TRUE(graph().current());
    const TransitionRef worst = *graph().current();
    // By labels alone nothing is as odd as what labelAll() made so.
    const auto& first = graph().values()->surprises[0];
    const auto oddest =
        std::max_element(first.begin(), first.end(),
                         [](const Surprise& a, const Surprise& b) { return a.label < b.label; });
    const Transition& odd = graph().transitionOf({0, int(oddest - first.begin())});
    const int half = int(session().fighter(0)->segmentation->actions.size() / 2);
    EXPECT_TRUE(odd.own == half || odd.next == half) << odd.own << " " << odd.next;
    for (const int mover : {0, 1}) {
        for (const Surprise& each : graph().values()->surprises[std::size_t(mover)]) {
            EXPECT_LE(each.both, graph().surpriseOf(worst).both);
        }
    }
    EXPECT_NEAR(session().transport().playhead(), graph().placeOf(worst).seconds, 1e-9);
    press(Qt::Key_N);
    EXPECT_NE(graph().current(), worst);
    press(Qt::Key_N, Qt::ShiftModifier);
    EXPECT_EQ(graph().current(), worst);

    auto& strip = part<SurpriseStrip>();
    session().showAll();
    const TransitionRef other{1, 2};
    const QRectF bar = strip.barOf(other);
    ASSERT_FALSE(bar.isEmpty());
    QTest::mouseClick(&strip, Qt::LeftButton, {}, bar.center().toPoint());
    EXPECT_EQ(graph().current(), other);
    EXPECT_NEAR(session().transport().playhead(), graph().placeOf(other).seconds, 1e-9);
    EXPECT_EQ(session().activePlayer(), 1);
}

TEST_F(GraphTest, WhichSurpriseIsShownIsAChoice) {
    openGraph();
    QTableView* list = part<TraceBox>().table();
    press(Qt::Key_N);
    ASSERT_TRUE(graph().current());
    const int row = part<TraceBox>().model().rowOf(*graph().current());
    ASSERT_GE(row, 0);
    const auto shown = [&] {
        return list->model()->index(row, TraceModel::SurpriseColumn).data().toString();
    };
    const Surprise surprise = graph().surpriseOf(*graph().current());
    EXPECT_EQ(shown(), QString::number(surprise.both, 'f', 1));
    window_->commands().run("graph.surpriseLabel");
    EXPECT_EQ(shown(), QString::number(surprise.label, 'f', 1));
    window_->commands().run("graph.surpriseGeometry");
    EXPECT_EQ(shown(), QString::number(surprise.geometry, 'f', 1));
    // The next surprise is that of the kind that is chosen: no other lies between.
    const auto geometry = [&](const TransitionRef& t) { return graph().surpriseOf(t).geometry; };
    const double from = geometry(*graph().current());
    press(Qt::Key_N);
    const double to = geometry(*graph().current());
    EXPECT_LE(to, from);
    for (const int mover : {0, 1}) {
        const int count = int(graph().graph().transitionsOf(mover).size());
        for (int i = 0; i < count; ++i)
            EXPECT_FALSE(geometry({mover, i}) < from && geometry({mover, i}) > to);
    }
    window_->commands().run("graph.surpriseBoth");
    EXPECT_EQ(graph().surpriseKind(), SurpriseKind::Both);
}

TEST_F(GraphTest, TwoModelsStandBesideEachOtherInTheGraph) {
    openGraph();
    centre().showMatrix(false);
    GraphOptions options = graph().options();
    options.versus = Versus::Estimator;
    options.versusEstimator = LabelEstimator::Equ5;
    graph().setOptions(options);
    settle();
    NodePage& page = centre().nodes();
    const GraphDrawing& drawing = page.drawing();
    EXPECT_EQ(drawing.sides[0].name, "EQU7");
    EXPECT_EQ(drawing.sides[1].name, "EQU5");
    EXPECT_EQ(drawing.sides[0].mover, drawing.sides[1].mover);
    const int mover = graph().mover();
    ASSERT_EQ(int(drawing.nodes.size()), 2 * graph().graph().nodeCount(mover));
    // What is chosen in the other model's graph is the same label.
    const auto at = page.view().positionOf(int(drawing.nodes.size()) - 1);
    ASSERT_TRUE(at);
    QTest::mouseClick(&page.view(), Qt::LeftButton, {}, at->toPoint());
    ASSERT_TRUE(graph().selection());
    EXPECT_EQ(graph().selection()->filter.own, page.drawing().nodes.back().node);
    EXPECT_TRUE(page.drawing().scene.nodes.back().ringed);
    graph().select(std::nullopt);
    const auto all = page.drawing().edges.size();
    for (auto* box : page.findChildren<QCheckBox*>()) {
        if (box->text() == "difference") box->click();
    }
    for (const auto& edge : page.drawing().edges) {
        const TransitionFilter& of = edge.meaning.filter;
        const auto p = [&](int side) {
            return page.drawing().sides[std::size_t(side)].model().labels.probabilities(
                of.own, of.opponent)[std::size_t(of.next)];
        };
        EXPECT_NEAR(edge.probability, p(edge.side) - p(1 - edge.side), 1e-12);
        EXPECT_GT(edge.probability, 0);
    }
    EXPECT_LT(page.drawing().edges.size(), all) << "only what one side does more often";
}

TEST_F(GraphTest, TwoFightersStandSideBySideOrAsADifference) {
    openGraph();
    GraphOptions options = graph().options();
    options.versus = Versus::OtherFighter;
    graph().setOptions(options);
    settle();
    MatrixView& other = centre().matrix().otherView();
    EXPECT_TRUE(other.isVisible());
    EXPECT_EQ(matrix().order().rows, other.order().rows) << "the same label in the same row";
    EXPECT_EQ(matrix().table().rows.size(), other.table().rows.size());
    matrix().zoom(3);
    other.zoom(3);
    matrix().verticalScrollBar()->setValue(15);
    EXPECT_EQ(other.verticalScrollBar()->value(), matrix().verticalScrollBar()->value());
    centre().matrix().setDifference(true);
    EXPECT_FALSE(other.isVisible());
    EXPECT_TRUE(matrix().table().isDifference);
    EXPECT_LT(matrix().table().values.minCoeff(), 0);
    EXPECT_GT(matrix().table().values.maxCoeff(), 0);

    options.versus = Versus::Estimator;
    options.versusEstimator = LabelEstimator::Equ6;
    graph().setOptions(options);
    settle();
    EXPECT_TRUE(graph().values()->other);
    options.versus = Versus::HandLabels;
    graph().setOptions(options);
    settle();
    EXPECT_LT(matrix().table().values.cwiseAbs().maxCoeff(), 1e-9) << "all labels are by hand";
}

TEST_F(GraphTest, PicturesAreWritten) {
    openGraph();
    for (const bool asMatrix : {true, false}) {
        centre().showMatrix(asMatrix);
        QTest::qWait(30);
        const QString png = file(asMatrix ? "matrix.png" : "graph.png");
        EXPECT_EQ(exportGraph(centre(), graph(), png), QString());
        EXPECT_GT(QImage(png).width(), 100);
        const QString svg = file(asMatrix ? "matrix.svg" : "graph.svg");
        EXPECT_EQ(exportGraph(centre(), graph(), svg), QString());
        QFile written(svg);
        ASSERT_TRUE(written.open(QIODevice::ReadOnly));
        const QByteArray text = written.readAll();
        EXPECT_TRUE(text.contains("left punch fwd")) << "names are text";
        QXmlStreamReader xml(text);
        while (!xml.atEnd())
            xml.readNext();
        EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    }
    for (const char* name : {"graph.csv", "graph.json", "graph.graphml"}) {
        EXPECT_EQ(exportGraph(centre(), graph(), file(name)), QString());
        EXPECT_GT(QFileInfo(file(name)).size(), 500) << name;
    }
    EXPECT_FALSE(exportGraph(centre(), graph(), file("no/such/folder.png")).isEmpty());
    EXPECT_FALSE(exportGraph(centre(), graph(), file("graph.doc")).isEmpty());
}

TEST_F(GraphTest, NothingIsCutOffInASmallWindow) {
    openGraph();
    for (const bool asMatrix : {true, false}) {
        centre().showMatrix(asMatrix);
        QTest::qWait(20);
        for (const auto* widget : centre().findChildren<QWidget*>()) {
            if (!widget->isVisible() || widget->parentWidget() == nullptr) continue;
            const QRect inside(widget->mapTo(&centre(), QPoint()), widget->size());
            EXPECT_LE(inside.right(), centre().width()) << widget->metaObject()->className() << " "
                                                        << widget->accessibleName().toStdString();
        }
    }
}

}  // namespace
}  // namespace kumite::studio
