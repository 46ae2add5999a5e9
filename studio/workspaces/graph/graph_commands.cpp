#include "studio/workspaces/graph/graph_commands.h"

#include <QApplication>
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
QString text(const char* source) {
    return QApplication::translate("kumite::studio::GraphCommands", source);
}

void askForExport(GraphCentre& centre, GraphSession& graph) {
    const QString name = QFileInfo(graph.session().document().name()).completeBaseName();
    const QString path = fileToSave(
        centre.window(), text("Export transitions"),
        startFolder(graph.session().document()) + QLatin1Char('/') + name +
            QStringLiteral("-graph.csv"),
        text("Edges as a table (*.csv);;Graph and model (*.json);;Graph (*.graphml);;Picture "
             "(*.png);;Picture of lines (*.svg)"));
    if (path.isEmpty()) return;
    rememberFolder(path);
    const QString failure = exportGraph(centre, graph, path);
    if (failure.isEmpty()) {
        Q_EMIT graph.session().hinted(text("Written: %1").arg(path));
    } else {
        Q_EMIT graph.session().document().failed(failure);
    }
}

}  // namespace

void addGraphCommands(CommandTable& commands, GraphSession& graph, GraphCentre& centre,
                      const QList<QWidget*>& views) {
    const QString menu = text("&Graph");
    const QString group = QLatin1Char('-') + menu;
    GraphSession* session = &graph;
    GraphCentre* page = &centre;
    const auto any = [session] { return session->hasGraph(); };
    const auto selected = [session] { return !session->selected().empty(); };
    commands.add({"graph.view",
                  menu,
                  text("&Matrix or graph"),
                  {QKeySequence("V")},
                  [page] { page->showMatrix(!page->showsMatrix()); },
                  any});
    commands.add({"graph.space",
                  menu,
                  text("Graph in &space"),
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
                  text("&Play what is behind it, the next each time"),
                  {QKeySequence("Return"), QKeySequence("Enter")},
                  [session] { session->playNext(); },
                  selected,
                  {},
                  {},
                  views});
    commands.add({"graph.nextSurprise",
                  menu,
                  text("&Next surprise"),
                  {QKeySequence("N")},
                  [session] { session->stepSurprise(1); },
                  any});
    commands.add({"graph.previousSurprise",
                  menu,
                  text("Pre&vious surprise"),
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
    surprise("graph.surpriseBoth", text("Surprise of bo&th terms"), SurpriseKind::Both);
    surprise("graph.surpriseLabel", text("Surprise of the label &term"), SurpriseKind::Label);
    surprise("graph.surpriseGeometry", text("Surprise of the geo&metry term"),
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
    rows("graph.rowsOwn", text("Rows by &own label"), "1", TableRows::Own, group);
    rows("graph.rowsOpponent", text("Rows by o&pponent's label"), "2", TableRows::Opponent, menu);
    rows("graph.rowsBoth", text("Rows by &both labels"), "3", TableRows::Pairs, menu);
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
    sort("graph.sortCount", text("Sort by &count"), MatrixSort::Count, group);
    sort("graph.sortName", text("Sort by n&ame"), MatrixSort::Name, menu);
    sort("graph.sortLikeness", text("Sort by &likeness"), MatrixSort::Similarity, menu);
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
    zoom("graph.larger", text("Lar&ger cells"), {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")},
         1.25, group);
    zoom("graph.smaller", text("&Smaller cells"), {QKeySequence("Ctrl+-")}, 0.8, menu);
    zoom("graph.fit", text("Show &everything"), {QKeySequence("Ctrl+0")}, 0, menu);
    commands.add({"graph.export",
                  group,
                  text("E&xport transitions…"),
                  {QKeySequence("Ctrl+Shift+E")},
                  [page, session] { askForExport(*page, *session); },
                  any});
    QObject::connect(&graph, &GraphSession::valuesChanged, &commands, &CommandTable::refresh);
    QObject::connect(&graph, &GraphSession::selectionChanged, &commands, &CommandTable::refresh);
}

}  // namespace kumite::studio
