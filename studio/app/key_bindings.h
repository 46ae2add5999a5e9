#pragma once

#include <QKeySequence>
#include <QString>

#include <vector>

namespace kumite::studio {

struct Command;
class CommandTable;

/// The keys that users gave to commands. They are kept per user, as far as they differ from what
/// the studio brings.

/// Puts the user's keys in force. A default key that would now mean two things gives way.
void loadKeys(CommandTable& commands);
/// Gives a command other keys, now and in later runs.
void rebind(CommandTable& commands, const QString& id, const QList<QKeySequence>& keys);
/// Back to the keys that the studio brings; all of them for an empty id. Commands that took one of
/// these keys lose it.
void resetKeys(CommandTable& commands, const QString& id = {});

/// The commands other than `id` that would hear the key where `id` hears it. Keys of two
/// workspaces, or of two parts of the window that do not contain each other, do not meet.
std::vector<const Command*> conflictsOf(const CommandTable& commands, const QString& id,
                                        const QKeySequence& key);

}  // namespace kumite::studio
