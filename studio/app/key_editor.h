#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace kumite::studio {

class CommandTable;
class KeyField;

/// The page of the preferences on which commands get other keys. A key that another command
/// listens to is named with that command, and taken from it only on purpose.
class KeyEditor : public QWidget {
    Q_OBJECT

public:
    explicit KeyEditor(CommandTable& commands, QWidget* parent = nullptr);

    void chooseCommand(const QString& id);

private:
    void fill();
    QString chosen() const;
    void showChosen();
    void assign();

    CommandTable& commands_;
    QLineEdit* search_;
    QTreeWidget* tree_;
    KeyField* field_;
    QPushButton* assign_;
    QPushButton* remove_;
    QPushButton* reset_;
    QPushButton* resetAll_;
    QLabel* conflict_;
};

}  // namespace kumite::studio
