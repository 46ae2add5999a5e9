#pragma once

namespace kumite::studio {

class BoutSession;
class CommandTable;
class MessageStrip;
class StageView;

/// Commands of the Bout workspace: playback, modes, the avatar's keys, keeping and exporting.
void addBoutCommands(CommandTable& commands, BoutSession& bout, StageView& stage);

/// How many keys an avatar has.
inline constexpr int kAvatarKeys = 9;

}  // namespace kumite::studio
