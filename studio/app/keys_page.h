#pragma once

#include <QDialog>

#include <vector>

class QHBoxLayout;
class QLabel;
class QLineEdit;
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

/// The keys in force, in the order of the menus, and what the mouse does.
std::vector<KeyGroup> keyGroups(const CommandTable& commands);

/// All commands that have keys, in groups, and what the mouse does: made from the command table.
/// As many columns as there is room for; can be searched and written to a PDF for the wall.
class KeysPage : public QDialog {
    Q_OBJECT

public:
    KeysPage(const CommandTable& commands, QWidget* parent);

    /// Writes the whole sheet; false where the file cannot be written.
    bool saveTo(const QString& pdf) const;

Q_SIGNALS:
    /// The user wants other keys.
    void remapWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    int columnCount() const;
    void fill();
    void askForFile();

    const CommandTable& commands_;
    QLineEdit* search_;
    QScrollArea* scroll_;
    QLabel* problem_;
    int columns_ = 1;
};

}  // namespace kumite::studio
