#pragma once

namespace kumite::studio {

class CommandTable;
class SequencePanel;
class SequenceSession;
class SequenceStrip;
class StageView;

/// Adds what the Sequence workspace does.
void addSequenceCommands(CommandTable& commands, SequenceSession& sequence, SequencePanel& panel,
                         SequenceStrip& strip, StageView& stage);

}  // namespace kumite::studio
