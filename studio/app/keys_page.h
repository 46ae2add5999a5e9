#pragma once

#include <QDialog>

namespace kumite::studio {

class CommandTable;

/// All commands that have keys, in groups, and what the mouse does: made from the command table.
class KeysPage : public QDialog {
    Q_OBJECT

public:
    KeysPage(const CommandTable& commands, QWidget* parent);
};

}  // namespace kumite::studio
