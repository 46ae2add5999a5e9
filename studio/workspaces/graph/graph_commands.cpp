#include "studio/workspaces/graph/graph_commands.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFileInfo>

#include "studio/app/commands.h"
#include "studio/app/folders.h"
#include "studio/app/questions.h"
#include "studio/view3d/graph_view.h"
#include "studio/workspaces/graph/graph_centre.h"
#include "studio/workspaces/graph/graph_export.h"
#include "studio/workspaces/graph/matrix_page.h"
#include "studio/workspaces/graph/matrix_view.h"
#include "studio/workspaces/graph/node_page.h"

namespace kumite::studio {

namespace {

/// Translations of this file.
struct GraphCommands {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::GraphCommands)
};

void askForExport(GraphCentre& centre, GraphSession& graph) {
    const QString name = QFileInfo(graph.session().document().name()).completeBaseName();
    const QString path = fileToSave(
        centre.window(), GraphCommands::tr("Export transitions"),
        startFolder(graph.session().document()) + QLatin1Char('/') + name +
            QStringLiteral("-graph.csv"),
        GraphCommands::tr(
            "Edges as a table (*.csv);;Graph and model (*.json);;Graph (*.graphml);;Picture "
            "(*.png);;Picture of lines (*.svg)"));
    if (path.isEmpty()) return;
    rememberFolder(path);
    const QString failure = exportGraph(centre, graph, path);
    if (failure.isEmpty()) {
        Q_EMIT graph.session().hinted(GraphCommands::tr("Written: %1").arg(path));
    } else {
        Q_EMIT graph.session().document().failed(failure);
    }
}

}  // namespace

void addGraphCommands(CommandTable& commands, GraphSession& graph, GraphCentre& centre,
                      const QList<QWidget*>& views) {
    const QString menu = GraphCommands::tr("&Graph");
    const QString group = QLatin1Char('-') + menu;
    GraphSession* session = &graph;
    GraphCentre* page = &centre;
    const auto any = [session] { return session->hasGraph(); };
    const auto selected = [session] { return !session->selected().empty(); };
    commands.add({"graph.view",
                  menu,
                  GraphCommands::tr("&Matrix or graph"),
                  {QKeySequence("V")},
                  [page] { page->showMatrix(!page->showsMatrix()); },
                  any});
    commands.add({"graph.space",
                  menu,
                  GraphCommands::tr("Graph in &space"),
                  {QKeySequence("Shift+V")},
                  [page] {
                      const bool space = page->nodes().options().inSpace;
                      page->nodes().setInSpace(page->showsMatrix() || !space);
                      page->showMatrix(false);
                  },
                  any,
                  [page] { return page->nodes().options().inSpace; }});
    commands.add({"graph.play",
                  group,
                  GraphCommands::tr("&Play what is behind it, the next each time"),
                  {QKeySequence("Return"), QKeySequence("Enter")},
                  [session] { session->playNext(); },
                  selected,
                  {},
                  {},
                  views});
    commands.add({"graph.nextSurprise",
                  menu,
                  GraphCommands::tr("&Next surprise"),
                  {QKeySequence("N")},
                  [session] { session->stepSurprise(1); },
                  any});
    commands.add({"graph.previousSurprise",
                  menu,
                  GraphCommands::tr("Pre&vious surprise"),
                  {QKeySequence("Shift+N")},
                  [session] { session->stepSurprise(-1); },
                  any});
    const auto surprise = [&](const char* id, const QString& title, SurpriseKind kind) {
        commands.add({id,
                      menu,
                      title,
                      {},
                      [session, kind] { session->setSurpriseKind(kind); },
                      any,
                      [session, kind] { return session->surpriseKind() == kind; }});
    };
    surprise("graph.surpriseBoth", GraphCommands::tr("Surprise of bo&th terms"),
             SurpriseKind::Both);
    surprise("graph.surpriseLabel", GraphCommands::tr("S&urprise of the label term"),
             SurpriseKind::Label);
    surprise("graph.surpriseGeometry", GraphCommands::tr("Su&rprise of the geometry term"),
             SurpriseKind::Geometry);
    const auto rows = [&](const char* id, const QString& title, const char* key, TableRows kind,
                          const QString& where) {
        commands.add({id,
                      where,
                      title,
                      {QKeySequence(key)},
                      [page, kind] {
                          page->showMatrix(true);
                          page->matrix().setRows(kind);
                      },
                      any});
    };
    rows("graph.rowsOwn", GraphCommands::tr("Rows by &own label"), "1", TableRows::Own, group);
    rows("graph.rowsOpponent", GraphCommands::tr("Ro&ws by opponent's label"), "2",
         TableRows::Opponent, menu);
    rows("graph.rowsBoth", GraphCommands::tr("Rows by &both labels"), "3", TableRows::Pairs, menu);
    const auto sort = [&](const char* id, const QString& title, MatrixSort how,
                          const QString& where) {
        commands.add({id,
                      where,
                      title,
                      {},
                      [page, how] {
                          page->showMatrix(true);
                          page->matrix().setSort(how);
                      },
                      any});
    };
    sort("graph.sortCount", GraphCommands::tr("Sort by &count"), MatrixSort::Count, group);
    sort("graph.sortName", GraphCommands::tr("Sort by n&ame"), MatrixSort::Name, menu);
    sort("graph.sortLikeness", GraphCommands::tr("Sort by &likeness"), MatrixSort::Similarity,
         menu);
    const auto zoom = [&](const char* id, const QString& title, const QList<QKeySequence>& keys,
                          double factor, const QString& where) {
        commands.add(
            {id, where, title, keys,
             [page, factor] {
                 for (MatrixView* view : {&page->matrix().view(), &page->matrix().otherView()}) {
                     factor > 0 ? view->zoom(factor) : view->fit();
                 }
                 if (factor == 0) page->nodes().view().showAll();
             },
             any});
    };
    zoom("graph.larger", GraphCommands::tr("Lar&ger cells"),
         {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")}, 1.25, group);
    zoom("graph.smaller", GraphCommands::tr("Smaller cells"), {QKeySequence("Ctrl+-")}, 0.8, menu);
    zoom("graph.fit", GraphCommands::tr("Show &everything"), {QKeySequence("Ctrl+0")}, 0, menu);
    commands.add({"graph.export",
                  group,
                  GraphCommands::tr("E&xport transitions…"),
                  {QKeySequence("Ctrl+Shift+E")},
                  [page, session] { askForExport(*page, *session); },
                  any});
    QObject::connect(&graph, &GraphSession::valuesChanged, &commands, &CommandTable::refresh);
    QObject::connect(&graph, &GraphSession::selectionChanged, &commands, &CommandTable::refresh);
}

}  // namespace kumite::studio
