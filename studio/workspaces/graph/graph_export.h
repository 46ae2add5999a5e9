#pragma once

#include <QString>

namespace kumite::studio {

class GraphCentre;
class GraphSession;

/// Writes what the workspace shows by the file's suffix: `.csv` edges with their probabilities,
/// `.json` and `.graphml` the coupled graph, `.png` and `.svg` the matrix (all of it) or the graph
/// as seen. Gives a sentence where that fails, else nothing.
QString exportGraph(GraphCentre& centre, const GraphSession& graph, const QString& path);

}  // namespace kumite::studio
