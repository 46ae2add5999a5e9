#pragma once

namespace kumite::studio {

class CommandTable;
class HitSession;
class KeySession;
class StageView;

/// Adds what the Keyframe workspace does.
void addKeyCommands(CommandTable& commands, KeySession& keys, HitSession& hit, StageView& stage);

}  // namespace kumite::studio
