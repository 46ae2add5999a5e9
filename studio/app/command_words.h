#pragma once

namespace kumite::studio {

class CommandTable;

/// Gives commands the words that people bring from other programs, so that the palette finds
/// "delete" and "screenshot", too. Commands of workspaces may bring their own in their entries.
void addCommandWords(CommandTable& commands);

}  // namespace kumite::studio
