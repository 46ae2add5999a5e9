#pragma once

#include <QWidget>

#include <vector>

#include "core/project/project.h"

class QListWidget;
class QPushButton;

namespace kumite::studio {

class Session;

/// Corrections of the shown take that no longer mean any minimum, for decision: forget one, or put
/// a boundary where it had one. Not shown while there is none.
class UnmatchedBox : public QWidget {
    Q_OBJECT

public:
    explicit UnmatchedBox(Session& session, QWidget* parent);

    void refresh();

private:
    void showChoices();
    void decide(bool add);

    struct Row {
        int player = 0;
        Correction correction;
    };

    Session& session_;
    QListWidget* list_;
    QPushButton* add_;
    QPushButton* forget_;
    std::vector<Row> rows_;
};

}  // namespace kumite::studio
