#pragma once

namespace kumite::studio {

class CommandTable;
class Session;
class StageView;

/// Adds what the 3D view offers to the table (menu "3D view"), and the view's own buttons with
/// the same commands.
void addStageCommands(CommandTable& commands, StageView& stage, const Session& session);

}  // namespace kumite::studio
