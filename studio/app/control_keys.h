#pragma once

class QKeyEvent;
class QObject;
class QWidget;

namespace kumite::studio {

/// Whether a key works the control that has the focus, so that it is no command's: Space and
/// Return press a button; arrows, Home, End and the keys of pages lead through sliders, fields of
/// numbers, boxes of choices, tabs, lists and tables, with Shift too; ← and → stay commands where
/// rows alone are chosen. Combined with Ctrl or Alt they stay commands, but for what opens a box of
/// choices.
bool worksControl(const QWidget& focused, const QKeyEvent& key);

/// Whether a widget takes keys for itself as fields, buttons and lists do, wherever it stands; the
/// views, and what is drawn as they are, leave them to commands.
bool isControl(const QWidget& widget);

/// Return and Enter press the button that has the focus, as Space does: true where one did.
bool pressesButton(QObject* focused, const QKeyEvent& key);

}  // namespace kumite::studio
