#pragma once

#include <QDialog>

#include <vector>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPrinter;
class QScrollArea;

namespace kumite::studio {

class CommandTable;

/// A section of the page of keys: a menu's commands, or what the mouse does somewhere.
struct KeyGroup {
    struct Row {
        QString keys;
        QString text;
    };
    QString title;
    std::vector<Row> rows;
};

/// Those in force in the workspace that is shown, or those of all workspaces.
enum class KeysOf { ShownWorkspace, Everything };
/// Keys in the order of the menus, and what the mouse does.
std::vector<KeyGroup> keyGroups(const CommandTable& commands,
                                KeysOf which = KeysOf::ShownWorkspace);

/// All commands that have keys, in groups, and what the mouse does: made from the command table.
/// As many columns as there is room for; can be searched, printed and written to a PDF for the
/// wall, with the keys of all workspaces.
class KeysPage : public QDialog {
    Q_OBJECT

public:
    KeysPage(const CommandTable& commands, QWidget* parent);

    /// Writes the whole sheet; false where the file cannot be written.
    bool saveTo(const QString& pdf) const;
    /// The same on paper; false where the printer does not take it.
    bool printTo(QPrinter& printer) const;

Q_SIGNALS:
    /// The user wants other keys.
    void remapWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    int columnCount() const;
    void fill();
    void askForFile();
    void askForPrinter();

    const CommandTable& commands_;
    QLineEdit* search_;
    QScrollArea* scroll_;
    QLabel* problem_;
    int columns_ = 1;
};

}  // namespace kumite::studio
