#pragma once

#include <QString>

class QWidget;

namespace kumite::studio {

class CommandTable;

/// What a widget is, as rich text: its name, what it does and by which key, and for the numbers
/// that it shows how they are computed, with links into the help ("help:method#margin"). Made from
/// its name, tip and command when it is asked for, so that keys and language are those in force.
/// Empty where nothing is known of it.
QString whatsThisOf(const QWidget& widget, const CommandTable& commands);

}  // namespace kumite::studio
