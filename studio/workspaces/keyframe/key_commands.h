#pragma once

namespace kumite::studio {

class CommandTable;
class KeySession;
class StageView;

/// Adds what the Keyframe workspace does.
void addKeyCommands(CommandTable& commands, KeySession& keys, StageView& stage);

}  // namespace kumite::studio
