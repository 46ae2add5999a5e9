#pragma once

#include <QString>

class QLabel;
class QToolButton;
class QWidget;

namespace kumite::studio {

class CommandTable;

/// The title of a part of a panel.
QLabel* headingLabel(const QString& text, QWidget* parent);
/// A command of the table as a button with its icon alone; its tip says the key.
QToolButton* iconButton(CommandTable& commands, const char* command, QWidget* parent);
/// Makes a label show a moment of time, large, in a bar of playback.
void showAsClock(QLabel* label, const QString& name);

}  // namespace kumite::studio
