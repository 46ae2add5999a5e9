#pragma once

#include <QList>

class QWidget;

namespace kumite::studio {

class CommandTable;
class GraphCentre;
class GraphSession;

/// Adds the commands of the Graph workspace. In `views` Return plays what is behind the selection.
void addGraphCommands(CommandTable& commands, GraphSession& graph, GraphCentre& centre,
                      const QList<QWidget*>& views);

}  // namespace kumite::studio
