#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QLineEdit;
class QListWidget;

namespace kumite::studio {

class CommandTable;

/// Runs any command by its name: a field over the window's content and the commands that answer
/// to what is typed, best first, with the menu where each lives and its keys. With nothing typed,
/// what was run from here lately comes first.
class CommandPalette : public QFrame {
    Q_OBJECT

public:
    CommandPalette(CommandTable& commands, QWidget* over);

    void open();
    void dismiss();
    /// Ids of the commands shown, from the top.
    QStringList shownCommands() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void place();
    void step(int rows);
    void runCurrent();

    CommandTable& commands_;
    QLineEdit* field_;
    QListWidget* list_;
    QLabel* nothing_;
    QPointer<QWidget> focusBefore_;
};

}  // namespace kumite::studio
